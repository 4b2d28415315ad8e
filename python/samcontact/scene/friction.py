# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction laws."""

from __future__ import annotations

from dataclasses import dataclass

from .._util.checks import number
from .._util.display import Shown


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
