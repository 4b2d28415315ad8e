# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies below a ball, heated by friction."""

import numpy as np

import samcontact as sc

E, NU = 210e9, 0.3
K, ALPHA, KAPPA = 50.2, 11.7e-6, 1.367e-5
RADIUS, LOAD = 7.5e-3, 1500.0
COLD = sc.Material.elastic(E, NU)
WARM = COLD.with_thermal(K, ALPHA, KAPPA)
HERTZ = sc.hertz.point(RADIUS, sc.hertz.effective_modulus(COLD, COLD), load=LOAD)


def grid_of(cells, width=1.3, **volume):
    d = 2 * width * HERTZ.a / cells
    return sc.Grid(cells, cells, d, d, **volume)


def solver(grid, factor, body1=COLD, body2=WARM, **heat):
    return sc.ContactSolver(grid, body1, body2, heat=sc.Heat(factor, **heat))


def ball(grid):
    return sc.surfaces.paraboloid(grid, RADIUS)


def von_mises(s):
    normal = (s[0] - s[1]) ** 2 + (s[1] - s[2]) ** 2 + (s[2] - s[0]) ** 2
    return np.sqrt(0.5 * normal + 3 * (s[3:] ** 2).sum(axis=0))
