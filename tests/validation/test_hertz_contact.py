# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic contact against Hertz theory in closed form (Johnson 1985, chapter 4), R = 10 mm.

Cells of uniform pressure resolve its smooth part to second order; at the edge, where it falls like
a square root, only a strip of one cell errs, which is first order in the L2 norm. Relative errors
measured, the same for a rigid and an elastic ball (only the contact modulus counts):

                          a/dx =       8         16         32         64
    point on the axis     p0        1.1e-3     2.5e-4     4.9e-5     1.2e-5
                          approach  2.7e-4     8.3e-5     3.4e-5     8.9e-6
    axis between points   p0        3.6e-3     8.7e-4     2.1e-4     5.4e-5
                          approach  1.1e-3     2.3e-4     4.9e-5     1.3e-5

How the edge cuts the cells makes these errors jump by a factor of two, so the order is observed on
their root mean square over eight contacts of a/dx = m, m + 1/8, ..., m + 7/8.
"""

import numpy as np
import pytest

import samcontact as sc
from samcontact import hertz, surfaces

RADIUS, LOAD = 10e-3, 500.0
STEEL = sc.Material.elastic(210e9, 0.3)
BALLS = {"rigid": sc.Material.rigid(), "elastic": STEEL}
# Relative tolerances of p0 and approach at a/dx: what the refined cells must reach.
TOLERANCE = {16: (1e-3, 3e-4), 64: (1e-4, 3e-5)}


def errors(ball, cells, on_axis):
    """Relative errors of the maximum pressure, the approach, and the pressure in the L2 norm."""
    exact = hertz.point(R=RADIUS, E_star=hertz.effective_modulus(ball, STEEL), load=LOAD)
    n = 2 * int(1.15 * cells) + (1 if on_axis else 2)
    grid = sc.Grid(n, n, exact.a / cells, exact.a / cells)
    solution = sc.ContactSolver(grid, ball, STEEL).solve(
        surfaces.paraboloid(grid, RADIUS), load=LOAD
    )
    pressure = exact.pressure(grid.x[:, None], grid.y[None, :])
    difference = np.linalg.norm(solution.pressure - pressure) / np.linalg.norm(pressure)
    return (
        abs(solution.pressure.max() / exact.p0 - 1),
        abs(solution.approach / exact.approach - 1),
        difference,
    )


@pytest.mark.parametrize("on_axis", [True, False], ids=["point on the axis", "axis between points"])
@pytest.mark.parametrize("ball", BALLS)
@pytest.mark.parametrize("cells", TOLERANCE)
def test_maximum_pressure_and_approach(cells, ball, on_axis):
    pressure, approach, _ = errors(BALLS[ball], cells, on_axis)
    assert pressure < TOLERANCE[cells][0]
    assert approach < TOLERANCE[cells][1]


@pytest.mark.parametrize("on_axis", [True, False], ids=["point on the axis", "axis between points"])
def test_order_of_convergence(on_axis):
    cells = (8, 16, 32, 64)
    table = [
        [errors(BALLS["rigid"], m + part, on_axis) for part in np.arange(8) / 8] for m in cells
    ]
    rms = np.sqrt(np.mean(np.square(table), axis=1))
    orders = np.log2(rms[:-1] / rms[1:])
    assert orders[:, :2].min() > 1.7  # p0 and approach; measured 1.90 to 2.16
    assert orders[:, 2].min() > 0.8  # L2; measured 0.86 to 1.14
    assert orders[:, 2].max() < 1.3


@pytest.mark.parametrize("long_axis", ["x", "y"])
@pytest.mark.parametrize("aspect", [1, 2])
def test_elliptic_contact(long_axis, aspect):
    """Ratio of radii 5, whose exact ellipticity is 2.890181; cells dx x aspect dx.

    A contact seen through cells is known to half a cell on either side.
    """
    long_short = (5 * RADIUS, RADIUS)
    Rx, Ry = long_short if long_axis == "x" else long_short[::-1]
    exact = hertz.elliptic(Rx, Ry, hertz.effective_modulus(STEEL, STEEL), load=LOAD)
    k = exact.k if long_axis == "y" else 1 / exact.k
    assert k == pytest.approx(2.890181, abs=1e-6)

    short = min(exact.a_x, exact.a_y)
    dx = short / 12
    dy = aspect * dx
    grid = sc.Grid(2 * int(1.1 * exact.a_x / dx) + 3, 2 * int(1.1 * exact.a_y / dy) + 3, dx, dy)
    solution = sc.ContactSolver(grid, STEEL, STEEL).solve(
        surfaces.paraboloid(grid, Rx, Ry), load=LOAD
    )
    touching = solution.pressure > 0
    half_x = 0.5 * touching.any(axis=1).sum() * dx
    half_y = 0.5 * touching.any(axis=0).sum() * dy
    assert half_x == pytest.approx(exact.a_x, abs=dx)
    assert half_y == pytest.approx(exact.a_y, abs=dy)
    area = touching.sum() * grid.cell_area
    # the rim cuts cells along its length: half a cell all round is 2 / 12 of the area at most
    assert area == pytest.approx(np.pi * exact.a_x * exact.a_y, rel=0.1)
    assert solution.pressure.max() == pytest.approx(exact.p0, rel=0.01)
    assert solution.approach == pytest.approx(exact.approach, rel=1e-3)
