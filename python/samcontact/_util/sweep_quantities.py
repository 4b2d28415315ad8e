# SPDX-License-Identifier: GPL-3.0-or-later
"""Names and units of the results of a sweep with one value for each case."""

from __future__ import annotations

from .quantities import Quantity as Q

_CRITERIA = {
    "dang_van": "Pa", "crossland": "Pa", "findley": "Pa", "fatemi_socie": "1",
    "orthogonal_shear": "Pa",
}  # fmt: skip
_EXPOSURES = ("yield", "dang_van", "orthogonal_shear")
SWEEP = {
    "found_load": Q(
        "N", "load at which the quantity reaches its value", "N", "load found", "load\nfound", 6
    ),
    "found_load_error": Q("N", "estimated error of the load found", "N", "error", "error", 2),
    "found_value": Q("", "value of the quantity at the load found [SI unit]", "", "value", "value"),
    "found_value_error": Q("", "estimated grid error of this value [SI unit]"),
    "life_log_integral": Q(
        "1", "logarithm of the integral for the life, SI units", "", "ln(integral)",
        "ln(integral)\nof life", 6,
    ),
    "shakedown_response": Q(
        "1", "response to repeated cycles", "", "response", "response", 1,
    ),
    "shakedown_rate": Q(
        "1", "maximum magnitude of the plastic strain change over the last cycle", "%",
        "plastic strain per cycle", "strain\nper cycle", 4,
    ),
    "shakedown_flow": Q("1", "maximum equivalent plastic strain added by the last cycle"),
    "shakedown_cycles": Q("1", "number of the last cycle", "", "cycles", "cycles", 4),
    "shakedown_yield_strain": Q("1", "yield stress divided by Young's modulus"),
} | {
    name: quantity
    for criterion in _EXPOSURES
    for name, quantity in (
        (
            f"exposure_{criterion}",
            Q("1", f"largest exposure to {criterion}, stress / local strength", "",
              f"exposure, {criterion.replace('_', ' ')}",
              f"exposure\n{criterion.replace('_', ' ')}", 4),
        ),
        (
            f"exposure_depth_{criterion}",
            Q("m", f"depth of the largest exposure to {criterion}", "µm", "depth", "depth", 4),
        ),
    )
} | {
    name: quantity
    for criterion, unit in _CRITERIA.items()
    for name, quantity in (
        (
            f"fatigue_{criterion}",
            Q(
                unit, f"maximum of the fatigue criterion {criterion}", "MPa" * (unit == "Pa"),
                criterion.replace("_", " "), criterion.replace("_", "\n", 1),
            ),
        ),
        (
            f"fatigue_margin_{criterion}",
            Q("1", f"margin of the fatigue criterion {criterion} from its limit", "%",
              "margin", "margin", 4),
        ),
    )
}  # fmt: skip
"""Results of a sweep with one value for each case."""
