# SPDX-License-Identifier: GPL-3.0-or-later
"""Differences between cases solved in SI units and in other systems of units."""

from __future__ import annotations

from functools import partial
from typing import Any

from . import interface_setups, scaled_setups, sliding_setups
from .scaled_setups import POWERS_OF_TWO, UNITS, Units
from .table import Column, Table, relative_difference


def _slid(case: Any, unit: Units) -> dict[str, Any]:
    found: dict[str, Any] = case(sliding_setups.Setup(unit))
    return found


SLIDING = {name: partial(_slid, case) for name, case in sliding_setups.CASES.items()}
CASES = SLIDING | scaled_setups.CASES | interface_setups.CASES


def differences(name: str) -> dict[str, float]:
    """Return the maximum difference of any field from the SI solution, by system of units."""
    expected = CASES[name](Units())

    def worst(system: tuple[float, ...]) -> float:
        found = CASES[name](Units(*system))
        return max(relative_difference(values, expected[field]) for field, values in found.items())

    others = {f"system {n}": worst(system) for n, system in enumerate(UNITS.values(), 1)}
    return others | {"powers": worst(POWERS_OF_TWO)}


TABLE = Table(
    "units", "case", tuple(CASES), differences,
    (*(Column(f"system {n}", str(n), at_most=1e-12) for n in range(1, len(UNITS) + 1)),
     Column("powers", "powers of two", at_most=1e-13)),
    "elastic",
)  # fmt: skip
