# SPDX-License-Identifier: GPL-3.0-or-later
"""Setups of elastic contact with a ball, and conditions of a solution."""

import numpy as np
import pytest

import samcontact as sc
from samcontact import hertz, operators, surfaces

STEEL = sc.Material.elastic(210e9, 0.3)
RIGID = sc.Material.rigid()
RADIUS, CELLS = 10e-3, 12
TOL = 1e-8


def scene(body1, body2, p0_over_E=0.02, n=31):
    """Grid of n x n cells, CELLS of them per contact radius, ball gap, and load of that pressure.

    The y cells are longer by a tenth, so that nothing hides behind the symmetry of the grid.
    """
    E_star = hertz.effective_modulus(body1, body2)
    exact = hertz.point(R=RADIUS, E_star=E_star, p0=p0_over_E * E_star)
    dx = exact.a / CELLS
    grid = sc.Grid(n, n, dx, 1.1 * dx)
    return grid, surfaces.paraboloid(grid, RADIUS), exact


def penetration(grid, pressure, body1, body2, friction=0.0):
    """Return the sum of u_z of both bodies [m], from the operators of one half-space."""
    total = np.zeros(grid.surface_shape)
    for body, sign in ((body1, -1.0), (body2, 1.0)):
        if not body.is_rigid:
            shear = sign * friction * pressure
            total += operators.surface_displacement(grid, pressure, body.E, body.nu, shear)
    return total


def assert_complementary(grid, solution, gap, displacement, tol):
    """p >= 0, g >= 0, p g = 0 and the load, with g from `displacement`, scaled as documented.

    Both sides of the gap are differences of terms as large as max u: a hundred ulp of that more.
    """
    p, scale = solution.pressure, displacement.max()
    g = gap + displacement - solution.approach
    slack = tol + 1e-13
    np.testing.assert_allclose(solution.gap, g, rtol=0, atol=slack * scale)
    assert p.min() >= 0
    assert np.abs(np.minimum(p / p.max(), g / scale)).max() <= slack
    assert p.sum() * grid.cell_area == pytest.approx(solution.load, rel=1e-12)
