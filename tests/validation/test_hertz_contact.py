# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic contact against Hertz theory in closed form (Johnson 1985, chapter 4), R = 10 mm.

Cells of uniform pressure resolve its smooth part to second order; at the edge, where it falls like
a square root, only a strip of one cell errs, which is first order in the L2 norm. The errors are in
docs/validation.md.

The position of the edge in its cells changes these errors by a factor of two, so the order uses
their rms over eight contacts of a/dx = m, m + 1/8, ..., m + 7/8.
"""

import numpy as np
import pytest

import samcontact as sc
from samcontact import hertz, surfaces

RADIUS, LOAD = 10e-3, 500.0
STEEL = sc.Material.elastic(210e9, 0.3)
TABLE = "Hertz contact"
# Relative tolerances of p0, approach and pressure (L2) at a/dx: what the refined cells must reach.
TOLERANCE = {
    8: (4e-3, 1.2e-3, 3e-2),
    16: (1e-3, 3e-4, 1.5e-2),
    32: (2.5e-4, 7.5e-5, 7.5e-3),
    64: (1e-4, 3e-5, 3.75e-3),
}
# The axis lies on a cell centre, the count being odd, or between four.
PLACES = {"on a point": 1, "between points": 2}


def solve(ball, cells, place):
    """Return the Hertz contact, the solution, and the relative L2 error of its pressure."""
    exact = hertz.point(R=RADIUS, E_star=hertz.effective_modulus(ball, STEEL), load=LOAD)
    n = 2 * int(1.15 * cells) + PLACES[place]
    grid = sc.Grid(n, n, exact.a / cells, exact.a / cells)
    solution = sc.ContactSolver(grid, ball, STEEL).solve(
        surfaces.paraboloid(grid, RADIUS), load=LOAD
    )
    pressure = exact.pressure(grid.x[:, None], grid.y[None, :])
    difference = np.linalg.norm(solution.pressure - pressure) / np.linalg.norm(pressure)
    return exact, solution, difference


def errors(ball, cells, place):
    """Return relative errors of maximum pressure, approach, and pressure in the L2 norm."""
    exact, solution, difference = solve(ball, cells, place)
    found = (solution.pressure.max() / exact.p0 - 1, solution.approach / exact.approach - 1)
    return np.array([*found, difference])


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("cells", TOLERANCE)
def test_pressure_and_approach(cells, place, measured):
    exact, solution, difference = solve(STEEL, cells, place)
    mesh = f"a/{cells}"
    of_pressure, of_approach, of_norm = TOLERANCE[cells]
    found, expected = 1e-9 * solution.pressure.max(), 1e-9 * exact.p0
    measured.close(TABLE, f"maximum pressure, {place}", found, expected, unit="GPa",
                   rel=of_pressure, mesh=mesh)  # fmt: skip
    found, expected = 1e6 * solution.approach, 1e6 * exact.approach
    measured.close(TABLE, f"approach, {place}", found, expected, unit="µm", rel=of_approach,
                   mesh=mesh)  # fmt: skip
    measured.close(TABLE, f"pressure, L2 norm, {place}", 100 * difference, 0, unit="%",
                   abs=100 * of_norm, mesh=mesh)  # fmt: skip
    # only the contact modulus counts
    rigid = errors(sc.Material.rigid(), cells, place)
    np.testing.assert_allclose(rigid, errors(STEEL, cells, place), rtol=0, atol=1e-7)


@pytest.mark.parametrize("place", PLACES)
def test_order_of_convergence(place, measured):
    cells = (8, 16, 32, 64)
    table = [[errors(STEEL, m + part, place) for part in np.arange(8) / 8] for m in cells]
    rms = np.sqrt(np.mean(np.square(table), axis=1))
    orders = np.log2(rms[:-1] / rms[1:])
    assert orders[:, :2].min() > 1.7  # p0 and approach; measured 1.90 to 2.16
    assert orders[:, 2].min() > 0.8  # L2; measured 0.86 to 1.14
    assert orders[:, 2].max() < 1.3
    names = ("maximum pressure", "approach", "pressure, L2 norm")
    for name, order, expected in zip(names, orders.mean(axis=0), (2, 2, 1), strict=True):
        measured.close("Hertz contact, order of convergence", f"{name}, {place}", order, expected,
                       abs=0.2, mesh="a/8 to a/64")  # fmt: skip


@pytest.mark.parametrize("long_axis", ["x", "y"])
@pytest.mark.parametrize("aspect", [1, 2])
def test_elliptic_contact(long_axis, aspect, measured):
    """The ratio of radii is 5, the exact ellipticity 2.890181; cells are dx x aspect dx.

    The edge of a contact of cells is known to half a cell on either side.
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
    mesh = f"b/12, cells 1:{aspect}, long axis {long_axis}"
    found, expected = 1e-9 * solution.pressure.max(), 1e-9 * exact.p0
    measured.close("Elliptic contact", "maximum pressure", found, expected, unit="GPa", rel=0.01,
                   mesh=mesh)  # fmt: skip
    found, expected = 1e6 * solution.approach, 1e6 * exact.approach
    measured.close("Elliptic contact", "approach", found, expected, unit="µm", rel=1e-3, mesh=mesh)
