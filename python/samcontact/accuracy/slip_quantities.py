# SPDX-License-Identifier: GPL-3.0-or-later
"""Quantities of partial slip for which errors can be estimated, by their names in results files."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .._util.travels import both_axes
from ..simulation.error_controlled_quantities import peak_value
from ..solutions.tangential_quantities import TANGENTIAL_QUANTITIES, along_surface

if TYPE_CHECKING:
    from ..solutions.state import State

WORK, SHEAR, STICK = "friction_work", "max_shear", "stick_fraction"
SLIP_QUANTITIES = (*TANGENTIAL_QUANTITIES, WORK, SHEAR, STICK)
_DIRECTIONS = (("shift", 0), ("shift", 1), ("twist", None))
_FORCES = ("tangential_load", "tangential_load", "torque")


def orders_of(names: Sequence[str], *, moves: bool) -> dict[str, float]:
    """Return the lowest orders of convergence in the cell size, for quantities with orders below 2.

    The shear traction has a cusp at the edge of the stick zone, where it changes as the square root
    of the distance to this edge. The von Mises stress may have its maximum at this edge. The stick
    fraction changes by whole cells. The frictional work of moving bodies converges with order 1.
    """
    stresses = [name for name in names if name.startswith("max_von_mises")]
    return {SHEAR: 0.5, STICK: 1.0} | dict.fromkeys([*stresses, *[WORK] * moves], 1.0)


def driven(steps: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return the names of quantities that respond to prescribed tangential motions and forces."""
    found = []
    for n, ((motion, axis), force) in enumerate(zip(_DIRECTIONS, _FORCES, strict=True)):
        if any(_component(step.get(motion), axis) for step in steps):
            found.append(TANGENTIAL_QUANTITIES[n])
        if any(_component(step.get(force), axis) for step in steps):
            found.append(TANGENTIAL_QUANTITIES[3 + n])
    moves = (both_axes(s.get("advance", (0.0, 0.0))) for s in steps)
    rolls = any(first != second for first, second in (each[:, 0].tolist() for each in moves))
    if rolls and TANGENTIAL_QUANTITIES[0] not in found:
        found.insert(0, TANGENTIAL_QUANTITIES[0])
    return [*found, WORK] if found else []


def _component(given: Any, axis: int | None) -> float:
    value = given if axis is None or given is None else given[axis]
    return 0.0 if value is None else float(value)


def values_of(states: Sequence[State], name: str, tol: float) -> list[float]:
    """Return the value of a quantity in each state [SI units].

    A force, motion or work is returned as 0 if it is a rounding error, i.e. below `tol` times its
    scale: the load for forces, the load times the contact size for the torque, the approach for
    displacements, the approach divided by the contact size for the rotation, and the load times the
    approach for work.
    """
    if name == SHEAR:
        return [peak_value(np.hypot(*state.shear)) for state in states]
    if name == STICK:
        return [_stick_fraction(state) for state in states]
    p, d, area = (
        max((abs(float(getattr(s, one))) for s in states), default=0.0)
        for one in ("load", "approach", "contact_area")
    )
    size = area**0.5
    scales = (p, p, p * size, d, d, d / size if size > 0 else 0.0, p * d)
    scale = dict(zip((*TANGENTIAL_QUANTITIES, WORK), scales, strict=True))[name]
    return [v if abs(v) > tol * scale else 0.0 for v in along_surface(states)[name].tolist()]


def _stick_fraction(state: State) -> float:
    cells = np.count_nonzero(state.in_contact)
    return float(state.sticking.sum() / cells) if cells else 0.0
