# SPDX-License-Identifier: GPL-3.0-or-later
"""Temperature of moving surfaces that a lubricant film heats."""

from __future__ import annotations

import math

import numpy as np

from .. import heat_kernels
from .._core import ConvergenceError
from .._util.checks import FloatArray
from .._util.lazy_scipy import scipy
from ..bodies.layered import Body
from ..bodies.material import Material
from ..problem.grid import Grid

EXCHANGE_TOL = 1e-8
"""Tolerance on the relative residual for the heat that crosses the film between the bodies."""
MAX_CORRECTIONS, RESTART = 10, 60
"""Maximum number of calls of GMRES, and number of vectors after which it restarts."""


class SurfaceHeat:
    """Temperature rise of a surface due to a steady heat flux, shape (nx, ny)."""

    def __init__(self, grid: Grid, body: Body, velocity: FloatArray) -> None:
        assert isinstance(body, Material)
        assert body.thermal is not None
        conductivity, _, diffusivity = body.thermal
        nx, ny = self._shape = grid.surface_shape
        x = np.arange(1.0 - nx, nx) * grid.dx
        if grid.ny == 1:
            kernel = line_source(x, 0.5 * grid.dx, conductivity, diffusivity, float(velocity[0]))
            kernel = kernel[:, None]
        else:
            kernel = heat_kernels.temperature(
                x, np.arange(1 - ny, ny) * grid.dy, 0.0, 0.5 * grid.dx, 0.5 * grid.dy,
                conductivity=conductivity, diffusivity=diffusivity,
                velocity=(float(velocity[0]), float(velocity[1])),
            )  # fmt: skip
        self._size = [
            scipy.fft.next_fast_len(n + m - 1, real=True)
            for n, m in zip(kernel.shape, self._shape, strict=True)
        ]
        self._spectrum = np.fft.rfft2(kernel, self._size)

    def rise(self, flux: FloatArray) -> FloatArray:
        """Return the temperature rise [K] due to a flux into the body [W/m^2]."""
        nx, ny = self._shape
        full = np.fft.irfft2(np.fft.rfft2(flux, self._size) * self._spectrum, self._size)
        found: FloatArray = full[nx - 1 : 2 * nx - 1, ny - 1 : 2 * ny - 1]
        return found


def line_source(
    x: FloatArray, a: float, conductivity: float, diffusivity: float, velocity: float
) -> FloatArray:
    """Return the temperature rise per heat flux [K m^2/W] due to a moving strip of width 2 a.

    x: distances of surface points from the middle of the strip [m]. Source: Carslaw & Jaeger
    (1959), section 10.7, with the integral of exp(s) K_0(abs(s)) in closed form.
    """
    speed = velocity / (2.0 * diffusivity)

    def primitive(s: FloatArray) -> FloatArray:
        u = np.maximum(np.abs(s), 1e-300)
        k0, k1 = scipy.special.k0e(u), scipy.special.k1e(u)
        behind, ahead = u * (k0 + k1) - 1.0, -u * np.exp(-2.0 * u) * (k0 - k1) - 1.0
        found: FloatArray = np.where(s > 0.0, behind, np.where(s < 0.0, ahead, 0.0))
        return found

    ends = primitive(speed * (x + a)) - primitive(speed * (x - a))
    found: FloatArray = ends / (math.pi * conductivity * speed)
    return found


class HeatedSurfaces:
    """Temperature rises of both surfaces of a film, which exchange heat across the film."""

    def __init__(self, grid: Grid, bodies: tuple[Body, Body], velocities: FloatArray) -> None:
        self._surfaces = [
            SurfaceHeat(grid, body, velocity)
            for body, velocity in zip(bodies, velocities, strict=True)
        ]
        self._last: FloatArray | None = None

    def fluxes(self, heat: FloatArray, resistance: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return heat fluxes into both bodies [W/m^2] and temperature rises [K], shape (2, nx, ny).

        heat: heat generated in the film per area [W/m^2], half of which flows to each surface if
        both have the same temperature; resistance: film thickness divided by conductivity
        [K m^2/W].
        """
        one, two = (surface.rise(0.5 * heat) for surface in self._surfaces)
        shape, difference = heat.shape, one - two
        crossing = np.zeros(shape)
        if np.abs(difference).max() > 1e-12 * max(np.abs(one).max(), 1e-300):
            crossing = self._crossing(difference, resistance)
        flux = np.array([0.5 * heat - crossing, 0.5 * heat + crossing])
        moved = [s.rise(q) for s, q in zip(self._surfaces, flux, strict=True)]
        return flux, np.array(moved)

    def _crossing(self, difference: FloatArray, resistance: FloatArray) -> FloatArray:
        """Return the heat per area that crosses the film from body 1 to body 2 [W/m^2].

        difference: temperature of surface 1 minus temperature of surface 2 [K], both computed
        without this heat.
        """
        shape = difference.shape
        own = sum(float(s.rise(_unit(shape)).max()) for s in self._surfaces)

        def apply(flat: FloatArray) -> FloatArray:
            s = flat.reshape(shape) / (resistance + own)
            total = resistance * s + self._surfaces[0].rise(s) + self._surfaces[1].rise(s)
            return total.ravel()

        operator = scipy.sparse.linalg.LinearOperator((difference.size,) * 2, matvec=apply)
        # start from the last call, whose heat was nearly the same
        found = np.zeros(difference.size) if self._last is None else self._last
        missing = difference.ravel() - apply(found)
        for _ in range(MAX_CORRECTIONS):
            found = (
                found + scipy.sparse.linalg.gmres(operator, missing, restart=RESTART, atol=0.0)[0]
            )
            missing = difference.ravel() - apply(found)
            if np.abs(missing).max() <= EXCHANGE_TOL * np.abs(difference).max():
                break
        else:
            raise ConvergenceError(
                "the heat conducted across the film did not converge: use a grid with fewer cells "
                "outside the contact"
            )
        self._last = found
        crossing: FloatArray = found.reshape(shape) / (resistance + own)
        return crossing


def _unit(shape: tuple[int, ...]) -> FloatArray:
    unit = np.zeros(shape)
    unit[tuple(n // 2 for n in shape)] = 1.0
    return unit


__all__ = ["HeatedSurfaces", "SurfaceHeat", "line_source"]
