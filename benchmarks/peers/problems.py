# SPDX-License-Identifier: GPL-3.0-or-later
"""Problems solved by every code: arrays and numbers in SI units, independent of the codes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

import samcontact as sc

from ..roughness import heights, wave_amplitudes

E, NU = 210e9, 0.3
E_STAR = E / (1 - NU**2)
RADIUS = 7.5e-3  # m
HERTZ_LOAD = 1500.0  # N
ROUGH_SIDE = 1e-3  # m
ROUGH_RMS = 1e-6  # m
# Crown radius [m], load [N]: contact fractions of a few per cent and of about a quarter.
ROUGH_CASES = {"light": (0.02, 15.0), "heavy": (0.02, 600.0)}
YIELD_STRESS = 0.01 * E_STAR
HARDENING = 0.1 * E
# Width (plastic, stress) and depth of the possibly periodic domain, in elastic contact radii.
PLASTIC_SIDE, STRESS_SIDE, DEPTH = 6.0, 12.0, 2.0
INCREMENTS = 2
# Shortest wave of the periodic rough surface as a fraction of its side. Loads [N] for
# contact fractions of about a tenth, a half and almost one.
WAVES = 32
PERIODIC_CASES = {"light": 165.0, "half": 1060.0, "nearly full": 4500.0}
PLASTIC = ("plastic", "periodic_plastic")
FRICTION, PULL = 0.3, 0.5  # friction coefficient, and fraction of the friction limit
PULLED = ("force given", "shift given")


@dataclass(frozen=True)
class Elastic:
    """A rigid body with a given gap, pressed on an elastic half-space."""

    gap: np.ndarray
    side: float
    load: float
    periodic: str = ""
    """Periodic directions, as in sc.Grid."""

    @property
    def n(self) -> int:
        return self.gap.shape[0]

    @property
    def cell(self) -> float:
        return self.side / self.n

    @property
    def grid(self) -> sc.Grid:
        return sc.Grid(self.n, self.n, self.cell, self.cell, periodic=self.periodic)


@dataclass(frozen=True)
class Slipping(Elastic):
    """Contact pressed, then loaded along x; pressure and shear are uncoupled."""

    force: float | None = None
    shift: float | None = None


@dataclass(frozen=True)
class Plastic:
    """A rigid paraboloid on a half-space with linear isotropic hardening."""

    n: int
    layers: int
    side: float
    depth: float
    radius: float
    load: float
    periodic: str = ""

    @property
    def gap(self) -> np.ndarray:
        return sc.surfaces.paraboloid(self.grid, self.radius)

    @property
    def grid(self) -> sc.Grid:
        d = self.side / self.n
        return sc.Grid(
            self.n, self.n, d, d, self.layers, self.depth / self.layers, periodic=self.periodic
        )


def hertz_theory() -> sc.hertz.PointContact:
    return sc.hertz.point(R=RADIUS, E_star=E_STAR, load=HERTZ_LOAD)


def hertz(n: int) -> Elastic:
    """Return the contact of a ball on n x n cells; the contact covers four fifths of the width."""
    side = 2 * hertz_theory().a / 0.8
    grid = sc.Grid(n, n, side / n, side / n)
    return Elastic(sc.surfaces.paraboloid(grid, RADIUS), side, HERTZ_LOAD)


def slipping(n: int, case: str) -> Slipping:
    """Return the ball contact under half the friction limit, or the corresponding displacement."""
    given, theory = hertz(n), hertz_theory()
    limit = FRICTION * HERTZ_LOAD
    if case == "force given":
        return Slipping(given.gap, given.side, given.load, force=PULL * limit)
    softness = 2 * (2 - NU) * (1 + NU) / E  # (2 - nu)/G; Mindlin (1949)
    shift = 3 * limit * softness / (16 * theory.a) * (1 - (1 - PULL) ** (2 / 3))
    return Slipping(given.gap, given.side, given.load, shift=shift)


def rough(n: int, case: str) -> Elastic:
    """Return the contact of a self-affine surface with a shortest wavelength of eight cells.

    The Hurst exponent is 0.8. Each grid has another surface, with shorter waves on finer grids.
    """
    crown, load = ROUGH_CASES[case]
    grid = sc.Grid(n, n, ROUGH_SIDE / n, ROUGH_SIDE / n)
    gap = sc.surfaces.paraboloid(grid, crown)
    gap -= heights(n, wave_amplitudes(n // 8, 0.8, seed=1), ROUGH_RMS)
    return Elastic(gap, ROUGH_SIDE, load)


def periodic(n: int, case: str) -> Elastic:
    """Return the contact of a periodic self-affine surface that is equal on all grids.

    Heights are evaluated at i/n of the side, so that a grid with a multiple of n cells contains all
    points of this grid.
    """
    amplitudes = wave_amplitudes(WAVES, 0.8, seed=1)
    k = np.arange(-WAVES, WAVES + 1)[:, None] + np.arange(WAVES + 1)[None, :]
    gap = -heights(n, amplitudes * np.exp(-1j * np.pi / n * k), ROUGH_RMS)
    return Elastic(gap, ROUGH_SIDE, PERIODIC_CASES[case], periodic="xy")


def elastic(problem: str, case: str, n: int) -> Elastic:
    if problem == "periodic":
        return periodic(n, case)
    if problem == "slip":
        return slipping(n, case)
    return hertz(n) if problem == "hertz" else rough(n, case)


def plastic(n: int, side: float = PLASTIC_SIDE, periodic: str = "") -> Plastic:
    """Return a contact of a paraboloid and an elastic-plastic half-space on cubic cells.

    In an elastic contact, the maximum pressure would be four times the yield stress, and the
    contact radius 1 mm. `side` is the width of the grid divided by this radius.
    """
    a, p0 = 1e-3, 4 * YIELD_STRESS
    layers = round(n * DEPTH / side)
    radius = 2 * E_STAR * a / (np.pi * p0)
    load = 2 / 3 * np.pi * p0 * a**2
    return Plastic(n, layers, side * a, DEPTH * a, radius, load, periodic)
