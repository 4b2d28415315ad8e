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
    """Return a grid of n x n cells (CELLS per contact radius), a ball gap, and the Hertz contact.

    The cells are longer along y by a tenth, so that no error is hidden by symmetry.
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
    """Assert p >= 0, g >= 0, p g = 0 and the load, with g from `displacement`.

    The gap is a difference of terms as large as max u, so a hundred ulp of max u are added.
    """
    p, scale = solution.pressure, displacement.max()
    g = gap + displacement - solution.approach
    slack = tol + 1e-13
    np.testing.assert_allclose(solution.gap, g, rtol=0, atol=slack * scale)
    assert p.min() >= 0
    assert np.abs(np.minimum(p / p.max(), g / scale)).max() <= slack
    assert p.sum() * grid.cell_area == pytest.approx(solution.load, rel=1e-12)
