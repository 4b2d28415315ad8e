# SPDX-License-Identifier: GPL-3.0-or-later
"""Two steel balls used by several parts: 15 mm radius each, AISI 52100, one elastic-plastic."""

from __future__ import annotations

import samcontact as sc

RADIUS = 7.5e-3  # equivalent radius [m]
LOAD = 1500.0  # N
HEAVY_LOAD = 11179.0  # N: Hertz pressure 8 GPa
ELASTIC = sc.Material.elastic(210e9, 0.3)
STEEL = sc.Material.swift(210e9, 0.3, B=945e6, C=20, n=0.121)


def hertz(load: float = LOAD) -> sc.hertz.PointContact:
    """Return the Hertz contact of the two balls."""
    modulus = sc.hertz.effective_modulus(ELASTIC, STEEL)
    return sc.hertz.point(R=RADIUS, E_star=modulus, load=load)


def balls(
    across: int,
    load: float = LOAD,
    width: float = 1.25,
    depth: float = 1.6,
    lower: sc.Material = STEEL,
    **settings: object,
) -> sc.Simulation:
    """Return a simulation with `across` cells per Hertz radius at the given load.

    width, depth: half of the grid width, and the depth of the grid, in Hertz radii.
    """
    d = hertz(load).a / across
    n = 2 * int(width * across) + 1
    grid = sc.Grid(n, n, d, d, int(depth * across), d)
    return sc.Simulation(grid, ELASTIC, lower, sc.surfaces.paraboloid(grid, RADIUS), **settings)
