# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases solved in other systems of units."""

from __future__ import annotations

from functools import partial
from typing import Any

from . import scaled_setups, sliding_setups
from .scaled_setups import POWERS_OF_TWO, UNITS, Units
from .table import Column, Table, apart


def _slid(scene: Any, unit: Units) -> dict[str, Any]:
    found: dict[str, Any] = scene(sliding_setups.Setup(unit))
    return found


SLIDING = {name: partial(_slid, scene) for name, scene in sliding_setups.SCENES.items()}
SCENES = SLIDING | scaled_setups.SCENES


def differences(name: str) -> dict[str, float]:
    """Return the largest difference of all fields from those in SI units, for each system."""
    expected = SCENES[name](Units())

    def worst(system: tuple[float, ...]) -> float:
        found = SCENES[name](Units(*system))
        return max(apart(values, expected[field]) for field, values in found.items())

    others = {f"system {n}": worst(system) for n, system in enumerate(UNITS.values(), 1)}
    return others | {"powers": worst(POWERS_OF_TWO)}


TABLE = Table(
    "units", "case", tuple(SCENES), differences,
    (*(Column(f"system {n}", str(n), at_most=1e-12) for n in range(1, len(UNITS) + 1)),
     Column("powers", "powers of two", at_most=1e-13)),
    "elastic",
)  # fmt: skip
