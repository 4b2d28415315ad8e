# SPDX-License-Identifier: GPL-3.0-or-later
"""A ball on viscoelastic bodies."""

import numpy as np

import samcontact as sc

RIGID = sc.Material.rigid()
E, NU, RADIUS = 10e6, 0.4, 10e-3
SOFT = sc.Material.elastic(E, NU)
PLANE = E / (1 - NU**2)
SLS = SOFT.with_relaxation([1.0], [0.9])
POLYMER = SOFT.with_relaxation([1e-2, 1.0, 1e2], [0.3, 0.3, 0.3])
RADII = np.sqrt(RADIUS * 2.5e-5)  # about the contact radius [m]
GRID = sc.Grid(32, 30, 3.2 * RADII / 32, 3.2 * RADII / 30)
LOAD = 4 / 3 * PLANE * RADII**3 / RADIUS


def ball(grid):
    return sc.surfaces.paraboloid(grid, RADIUS)


def simulation(body2, body1=RIGID, grid=GRID, **settings):
    settings = {"on_border": "warn", "tol": 1e-9} | settings
    return sc.Simulation(grid, body1, body2, ball(grid), **settings)


def scaled(material, factor):
    return sc.Material.elastic(factor * material.E, material.nu)
