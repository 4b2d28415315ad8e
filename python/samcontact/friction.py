# SPDX-License-Identifier: GPL-3.0-or-later
"""Coulomb's law, and what drives a contact along the surface."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ._checks import finite, number, require_type
from ._repr import Shown
from .grid import Grid
from .heat import Heat
from .solution import Before, StickSlipSolution, before_on

_DIRECTIONS = ("x", "y")


@dataclass(frozen=True)
class Coulomb(Shown):
    """Coulomb's law of friction, for `ContactSolver` and `Simulation`: bodies stick and slip.

    The shear is at most mu p. Cells stick where it is less, and slip along it where it is mu p.

    Attributes
    ----------
    coefficient : float
        mu >= 0 [-]; `math.inf`: no slip at all.

    Raises
    ------
    ValueError, TypeError
        A coefficient that is negative, NaN or no number.
    """

    coefficient: float

    def __post_init__(self) -> None:
        mu = number("coefficient", self.coefficient)
        if not mu >= 0:
            raise ValueError(f"coefficient must be a number >= 0, or inf: no slip, got {mu!r}")
        object.__setattr__(self, "coefficient", mu)


def coefficient(friction: float | Coulomb) -> float:
    """Mu of either law [-]."""
    return friction.coefficient if isinstance(friction, Coulomb) else float(friction)


def require_cold(friction: Coulomb, heat: Heat) -> None:
    """Raise ValueError for heat, which needs a slip that is known."""
    if any(heat.factor):
        raise ValueError(
            f"heat.factor must be 0 with friction = {friction!r}, got {heat.factor!r}: heat enters "
            "where bodies slide all over, as they do with a number as friction"
        )


@dataclass(frozen=True)
class Tangential:
    """What drives one increment along the surface: of each direction and the turn, its kind."""

    is_force: tuple[bool, bool, bool]
    values: tuple[float, float, float]
    previous: StickSlipSolution | None

    def before(self, grid: Grid) -> Before:
        """The end of the increment before, on a grid that may be larger."""
        return (None, None, None, 0.0) if self.previous is None else before_on(self.previous, grid)

    def solution(self, grid: Grid, found: dict[str, Any]) -> tuple[StickSlipSolution, str]:
        """Of what the core found, with the totals of the increments before; and the complaint."""
        complaint = found.pop("border_complaint")
        *shift, twist = found.pop("motion")
        *force, torque = found.pop("force")
        del found["fallbacks"]
        before = self.previous
        if before is not None:
            shift = [float(s) + now for s, now in zip(before.shift, shift, strict=True)]
            twist += before.twist
            found["friction_work"] += before.friction_work
        totals = {
            "tangential_load": np.array(force),
            "torque": torque,
            "shift": np.array(shift),
            "twist": twist,
        }
        return StickSlipSolution(grid=grid, **totals, **found), complaint


def tangential_drive(
    friction: float | Coulomb,
    shift: Sequence[float | None] | None,
    tangential_load: Sequence[float | None] | None,
    twist: float | None,
    torque: float | None,
    previous: StickSlipSolution | None,
) -> Tangential:
    """What drives along the surface, checked; nothing where friction is a number."""
    given = {
        "shift": shift,
        "tangential_load": tangential_load,
        "twist": twist,
        "torque": torque,
        "previous": previous,
    }
    if not isinstance(friction, Coulomb):
        for name, value in given.items():
            if value is not None:
                raise ValueError(
                    f"{name} must be left out where friction is a number, which is gross sliding, "
                    f"got {value!r:.80}: make the solver with friction=samcontact.Coulomb(mu)"
                )
        return Tangential((False,) * 3, (0.0,) * 3, None)
    if previous is not None:
        require_type("previous", previous, StickSlipSolution)
    motions = [*_pair("shift", shift), _maybe("twist", twist)]
    forces = [*_pair("tangential_load", tangential_load), _maybe("torque", torque)]
    for name, motion, force in zip((*_DIRECTIONS, "z"), motions, forces, strict=True):
        if motion is not None and force is not None:
            both = "twist and torque" if name == "z" else f"shift and tangential_load along {name}"
            raise ValueError(
                f"{both} cannot both be given, got {motion!r} and {force!r}: the motion follows "
                "from the force; put None in place of one"
            )
    values = [
        (0.0 if motion is None else motion) if force is None else force
        for motion, force in zip(motions, forces, strict=True)
    ]
    x, y, turn = (force is not None for force in forces)
    return Tangential((x, y, turn), (values[0], values[1], values[2]), previous)


def _maybe(name: str, value: Any) -> float | None:
    return None if value is None else finite(name, value)


def _pair(name: str, pair: Any) -> list[float | None]:
    if pair is None:
        return [None, None]
    if isinstance(pair, (str, Mapping)) or not hasattr(pair, "__len__") or np.ndim(pair) == 0:
        raise TypeError(f"{name} must be two numbers, along x and y, got {pair!r:.80}")
    if len(pair) != 2:
        raise ValueError(f"{name} must be two numbers, along x and y, got {len(pair)}")
    return [_maybe(f"{name} along {a}", v) for a, v in zip(_DIRECTIONS, pair, strict=True)]
