# SPDX-License-Identifier: GPL-3.0-or-later
"""Paths of adhesive rough contacts that every code solves, and their errors.

Lengths are in sides of the surface, stresses in contact moduli of the elastic half-space.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

import samcontact as sc

from ..roughness import heights, wave_amplitudes

SIDE, MODULUS = 1e-6, 1e9  # m and Pa; of the contacts that samcontact solves
WAVELENGTH_MIN = 8  # cells on the shortest wave
RMS = 0.005
RANGE = 0.2  # range of the attraction / rms
# Height of the crown of a free surface at the middle of its edges / rms
CROWN = 8.0
# Error of the pressure above which a state is in another minimum
DIFFERENT = 1e-2
ELASTIC = sc.Material.elastic(MODULUS, 0.0)
RIGID = sc.Material.rigid()


@dataclass(frozen=True)
class Path:
    """An approach and retraction of a rigid rough surface and an elastic half-space."""

    n: int
    periodic: str
    kappa: float
    """Resolution number of the attraction."""
    distances: tuple[float, ...]
    """Mean gaps of a periodic surface; distances of the highest point of a free one / rms."""

    @property
    def cell(self) -> float:
        return 1.0 / self.n

    @cached_property
    def gap(self) -> np.ndarray:
        """Gap of the undeformed surfaces, with lowest value 0."""
        waves = wave_amplitudes(self.n // WAVELENGTH_MIN, 0.8, seed=5, lowest=2)
        gap: np.ndarray = -heights(self.n, waves, RMS)
        if not self.periodic:
            x = (np.arange(self.n) + 0.5) / self.n - 0.5
            gap = gap + 4 * CROWN * RMS * (x[:, None] ** 2 + x[None, :] ** 2)
        return gap - gap.min()

    @cached_property
    def compliance(self) -> np.ndarray:
        """Displacement of all cells due to a unit pressure on the first one, padded if free."""
        m = self.n if self.periodic else 2 * self.n
        grid = sc.Grid(m, m, SIDE * self.cell, SIDE * self.cell, periodic=self.periodic)
        pressure = np.zeros((m, m))
        pressure[0, 0] = 1.0
        found = sc.ContactSolver(grid, RIGID, ELASTIC).displacement(pressure)[2]
        found *= MODULUS / SIDE
        if self.periodic:
            return found - found.mean()
        offset = np.minimum(np.arange(m), m - np.arange(m))
        return np.asarray(found[np.ix_(offset, offset)])

    @cached_property
    def spectrum(self) -> np.ndarray:
        """Displacement of each wave due to its pressure; zero at the mean of periodic surfaces."""
        found = np.fft.rfft2(self.compliance).real
        if self.periodic:
            found[0, 0] = 0.0
        return found

    @property
    def range(self) -> float:
        return RANGE * RMS

    @property
    def work(self) -> float:
        """Work of adhesion, from the resolution number."""
        return float(self.kappa * self.range**2 / self.compliance[0, 0])

    @property
    def peak(self) -> float:
        return self.work / self.range

    def approach(self, distance: float) -> float:
        """Return the approach at which the surfaces have a distance."""
        mean = self.gap.mean() if self.periodic else 0.0
        return float(mean - distance * RMS)

    def energy(self, gap: np.ndarray, pressure: np.ndarray, approach: float) -> float:
        """Return elastic and surface energy per cell, relative to the work of adhesion."""
        moved = gap - self.gap + approach
        elastic = 0.5 * np.sum((pressure - self.mean(pressure)) * moved)
        return float(elastic / self.work - np.exp(-gap / self.range).sum()) / gap.size

    def mean(self, pressure: np.ndarray) -> float:
        """Return the mean pressure of periodic surfaces, which does no work on the mean gap."""
        return float(pressure.mean()) if self.periodic else 0.0


@dataclass(frozen=True)
class State:
    """Result of one step of a path."""

    gap: np.ndarray
    pressure: np.ndarray
    iterations: int


def errors(path: Path, states: list[State], exact: list[State]) -> tuple[float, float, int]:
    """Return the largest error of the pressure (rms) and of the energy, and a number of states.

    The errors are relative to the largest rms pressure, and the largest energy, of the path. They
    are those of the states in the same minimum as the exact solution; the third number counts them.
    """
    approaches = [path.approach(distance) for distance in path.distances]
    scale = max(float(np.sqrt(np.mean(right.pressure**2))) for right in exact)
    energies = [path.energy(s.gap, s.pressure, at) for s, at in zip(exact, approaches, strict=True)]
    largest = max(map(abs, energies))
    pressure, energy, same = 0.0, 0.0, 0
    for at, state, right, least in zip(approaches, states, exact, energies, strict=True):
        error = float(np.sqrt(np.mean((state.pressure - right.pressure) ** 2))) / scale
        if error > DIFFERENT:
            continue
        pressure = max(pressure, error)
        energy = max(energy, abs(path.energy(state.gap, state.pressure, at) - least) / largest)
        same += 1
    return pressure, energy, same
