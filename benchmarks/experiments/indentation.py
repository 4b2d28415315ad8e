# SPDX-License-Identifier: GPL-3.0-or-later
"""A rigid ball on a body that yields: mean pressure from first yield to the fully plastic range.

The yield stress is much smaller than E, so that the strains are far smaller than in a hardness
test. The theory of small strains is then exact, and results of perfect plasticity depend on the
number E* a/(Y R) only.
"""

from __future__ import annotations

import math
import warnings
from typing import NamedTuple

import numpy as np

import samcontact as sc

E, NU, RADIUS = 210e9, 0.3, 1.0
E_STAR = E / (1.0 - NU**2)
YIELD_STRAIN = 1e-5
INCREMENTS = 20
REPRESENTATIVE = 0.2
"""Ratio of Tabor's representative strain to a/R (contact radius over ball radius)."""


class Indentation(NamedTuple):
    """Imprint under load, with lengths divided by the ball radius and stresses divided by E*."""

    cells: int
    radius: float
    mean_pressure: float
    max_pressure: float
    max_strain: float
    yield_stress: float

    @property
    def stiffness(self) -> float:
        """Ratio E* a/(Y R), where Y is the yield stress at the representative strain."""
        return self.radius / self.yield_stress

    @property
    def constraint(self) -> float:
        """Constraint factor: mean pressure divided by Y."""
        return self.mean_pressure / self.yield_stress


def press(material: sc.Material, radius: float, mean_pressure: float, cells: int) -> Indentation:
    """Load to about the given contact radius [m] and mean pressure [Pa].

    The contact area is the area of the cells under pressure.
    """
    size, half = radius / cells, int(1.3 * cells)
    grid = sc.Grid(2 * half + 1, 2 * half + 1, size, size, dz=size)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    simulation = sc.Simulation(grid, sc.Material.rigid(), material, gap)
    load = mean_pressure * math.pi * radius**2
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the first contacts are a few cells wide
        for part in np.linspace(0.0, 1.0, INCREMENTS + 1)[1:]:
            state = simulation.step(load=load * part**2)
    area = np.count_nonzero(state.pressure) * grid.cell_area
    reached = math.sqrt(area / math.pi)
    return Indentation(
        cells,
        reached / RADIUS,
        state.load / area / E_STAR,
        float(state.pressure.max()) / E_STAR,
        state.max_equivalent_plastic_strain(),
        float(material.yield_stress(REPRESENTATIVE * reached / RADIUS)) / E_STAR,
    )


def perfect(stiffness: float, cells: int) -> Indentation:
    """Indent a perfectly plastic body to about the given E* a/(Y R)."""
    Y = YIELD_STRAIN * E
    guess = min(float(cavity(stiffness)), 2.9)
    if stiffness < 3.0:
        guess = min(guess, hertz(stiffness))
    radius = stiffness * Y / E_STAR * RADIUS
    return press(sc.Material.perfect_plastic(E, NU, Y), radius, guess * Y, cells)


def hardening(exponent: float, to_radius: float, cells: int) -> Indentation:
    """Indent a body with power-law hardening of the given exponent.

    At a contact radius of 0.02 R, E* a/(Y R) is 40 with Y at the representative strain.
    """
    at = REPRESENTATIVE * 0.02
    Y = E_STAR * 0.02 / 40.0
    C = 1e-2 * at * 1e6  # microstrain
    body = sc.Material.swift(E, NU, B=Y / (C + 1e6 * at) ** exponent, C=C, n=exponent)
    stress = float(body.yield_stress(REPRESENTATIVE * to_radius))
    return press(body, to_radius * RADIUS, 2.8 * stress, cells)


def hertz(stiffness: float) -> float:
    """Return the mean pressure divided by Y of an elastic contact."""
    return 4.0 * stiffness / (3.0 * math.pi)


def first_yield() -> float:
    """Return the mean pressure divided by Y at first yield."""
    Y = YIELD_STRAIN * E
    return 2.0 / 3.0 * sc.critical.onset(RADIUS, E_STAR, NU, Y).p0 / Y


def cavity(stiffness: float | np.ndarray) -> np.ndarray:
    """Return the mean pressure divided by Y by the expanding cavity model.

    A core under uniform pressure below the ball grows by the volume that the ball displaces, with
    tan(beta) = a/R, inside a sphere that yields to the radius c. By Hill, the core bears 2/3 Y (1 +
    ln (c/a)^3). If the core itself yields, the stress along its axis is 2/3 Y larger. K. L.
    Johnson, J. Mech. Phys. Solids 18 (1970) 115-126; Contact Mechanics (1985), 6.3.
    """
    ratio = (1.0 - NU**2) * np.asarray(stiffness)  # E a/(Y R)
    return 2.0 / 3.0 * (2.0 + np.log((ratio + 4.0 * (1.0 - 2.0 * NU)) / (6.0 * (1.0 - NU))))
