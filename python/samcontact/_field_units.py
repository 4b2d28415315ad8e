# SPDX-License-Identifier: GPL-3.0-or-later
"""Units of the fields of a case file, by the last part of their names."""

from __future__ import annotations

import re

_NAMES_BY_UNIT = {
    "m": (
        "dx dy dz Rx Ry R R1 R2 interference x y position radius half_width depth amplitude "
        "wavelength_x wavelength_y rms_height wavelength_min wavelength_max roll_off "
        "approach advance distance step reach heat_reference"
    ),
    "m/s": "speed velocity heat_factor",
    "s": "duration heating_time heat_history",
    "N": "load",
    "Pa": "E yield_stress tangent_modulus B modulus",
    "microstrain": "C",
    "K": "melting reference ambient",
    "W/(m K)": "conductivity",
    "1/K": "expansion",
    "m2/s": "diffusivity",
    "1": (
        "nu n recovery m floor hurst friction tol increment_tol image_tol exponent slide_to_roll "
        "width"
    ),
}
_UNITS = {name: unit for unit, names in _NAMES_BY_UNIT.items() for name in names.split()}
# "start" of a segment has the unit of its load or approach: none can be given here
NO_UNIT = frozenset({"start"})


def field_unit(name: str) -> str | None:
    """Unit of a dotted field, e.g. "Pa" of "body2.yield_stress"; None for counts and words."""
    if name == "tugging.depth":  # unlike that of a dent, over the radius of the disc
        return "1"
    return _UNITS.get(re.sub(r"\[\d+\]$", "", name.rpartition(".")[2]))
