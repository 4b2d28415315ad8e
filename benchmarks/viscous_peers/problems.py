# SPDX-License-Identifier: GPL-3.0-or-later
"""Creep of a rough contact that both codes solve.

Lengths are in sides of the periodic surface, stresses in long-time shear moduli, and times in
relaxation times.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

import samcontact as sc

from ..roughness import heights, wave_amplitudes

SIDE, MODULUS, RELAXATION_TIME = 1e-3, 1e6, 1e-2  # m, Pa, s; of the contact in samcontact
WAVELENGTH_MIN = 8  # cells on the shortest wave
RMS = 0.005
RELAXING = 9.0  # modulus that relaxes / long-time modulus
MEAN_PRESSURE = 0.1
DURATION = 1.0
RIGID = sc.Material.rigid()
RUBBER = sc.Material.elastic(2 * MODULUS * (1 + RELAXING), 0.0).with_relaxation(
    times=[RELAXATION_TIME], shares=[RELAXING / (1 + RELAXING)]
)
"""Poisson's ratio is 0, so Young's modulus is twice the shear modulus."""


@dataclass(frozen=True)
class Creep:
    """Rigid rough surface on a standard linear solid under a load that is applied at once."""

    n: int

    @property
    def grid(self) -> sc.Grid:
        cell = SIDE / self.n
        return sc.Grid(self.n, self.n, cell, cell, periodic="xy")

    @cached_property
    def gap(self) -> np.ndarray:
        """Gap of the undeformed surfaces, with lowest value 0."""
        waves = wave_amplitudes(self.n // WAVELENGTH_MIN, 0.8, seed=5, lowest=2)
        gap = -heights(self.n, waves, RMS)
        return np.asarray(gap - gap.min())

    @cached_property
    def spectrum(self) -> np.ndarray:
        """Long-time displacement of each wave due to its pressure; zero at the mean."""
        pressure = np.zeros((self.n, self.n))
        pressure[0, 0] = MODULUS
        soft = sc.Material.elastic(2 * MODULUS, 0.0)
        moved = sc.ContactSolver(self.grid, RIGID, soft).displacement(pressure)[2] / SIDE
        found = np.fft.rfft2(moved).real
        found[0, 0] = 0.0
        return np.asarray(found)


def error(pressure: np.ndarray, exact: np.ndarray) -> float:
    """Return the rms difference of two pressures, relative to the rms of the exact one."""
    return float(np.linalg.norm(pressure - exact) / np.linalg.norm(exact))
