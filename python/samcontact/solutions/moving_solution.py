# SPDX-License-Identifier: GPL-3.0-or-later
"""Solutions for viscoelastic bodies that roll or slide steadily without shear traction."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._util.checks import FloatArray
from .._util.display import Rows, quantity
from ..problem.grid import Grid
from .contact_solution import ContactSolution


@dataclass(frozen=True, repr=False, eq=False)
class SlidingSolution(ContactSolution):
    """Solution of a contact in steady sliding; a kind of `ContactSolution`.

    Attributes
    ----------
    velocity : float
        Velocity of body 1 relative to body 2 along x [m/s].
    tangential_load : ndarray, shape (2,)
        Force on body 2 along x and y [N]. It arises because the pressure acts normal to the
        inclined surface. The force along x has the sign of the velocity. The opposite force on body
        1 resists the sliding.
    """

    velocity: float
    tangential_load: FloatArray

    @property
    def friction(self) -> float:
        """Hysteretic friction coefficient [-]; positive if the force resists the sliding."""
        along = float(np.sign(self.velocity) * self.tangential_load[0]) + 0.0  # -0.0 becomes 0.0
        return along / self.load if self.load > 0 else 0.0

    @property
    def power(self) -> float:
        """Power dissipated in the bodies [W]."""
        return float(self.tangential_load[0]) * self.velocity

    def _rows(self) -> Rows:
        return [
            *super()._rows(),
            ("velocity", quantity(self.velocity, "m/s")),
            ("friction", quantity(self.friction)),
        ]


@dataclass(frozen=True, repr=False, eq=False)
class FreeRollingSolution(ContactSolution):
    """Solution of a contact in steady rolling without friction; a kind of `ContactSolution`.

    Attributes
    ----------
    speed : float
        Speed at which the surfaces pass through the contact [m/s]; the contact rolls towards +x.
    """

    speed: float

    @property
    def rolling_resistance(self) -> float:
        """Moment that resists the rolling [N m], the integral of pressure times x.

        If it is positive, the centre of pressure is ahead of the origin of the grid, and work has
        to be done. For a wheel, the moment divided by the rolling radius R is the force that keeps
        it rolling. For two rollers, the work per distance rolled is the moment times 1/R1 + 1/R2.
        """
        return -float(self.moment[1])

    def _rows(self) -> Rows:
        return [
            *super()._rows(),
            ("speed", quantity(self.speed, "m/s")),
            ("rolling resistance", quantity(self.rolling_resistance, "N m")),
        ]


def slope_along_x(grid: Grid, displacement: FloatArray) -> FloatArray:
    """Return the slope along x [-] of a surface displacement [m].

    On a grid periodic along x, the slope is the derivative of the Fourier series without its
    shortest wave. On other grids, it is the derivative of polynomials through five cells (through
    three or two cells near the edge of the grid). Both operators are antisymmetric away from an
    edge, so the pressure on an elastic half-space causes no net force along x.
    """
    if grid.nx == 1:
        return np.zeros_like(displacement)
    if not grid.along_x:
        u = displacement
        slope: FloatArray = np.gradient(u, grid.dx, axis=0)
        slope[2:-2] = (8 * (u[3:-1] - u[1:-3]) - (u[4:] - u[:-4])) / (12 * grid.dx)
        return slope
    wavenumber = 2 * np.pi * np.fft.rfftfreq(grid.nx, grid.dx)
    wavenumber[grid.nx // 2] = 0.0
    waves = 1j * wavenumber[:, None] * np.fft.rfft(displacement, axis=0)
    return np.fft.irfft(waves, grid.nx, axis=0)
