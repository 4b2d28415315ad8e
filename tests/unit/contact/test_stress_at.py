# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress at arbitrary points; elastic solutions of bodies that would yield."""

import math
import warnings

import numpy as np
import pytest

import samcontact as sc

STEEL, RIGID = sc.Material.elastic(210e9, 0.3), sc.Material.rigid()
SOFT = sc.Material.perfect_plastic(210e9, 0.3, 1e9)
R = 5e-3
E_STAR = sc.hertz.effective_modulus(STEEL, STEEL)
ONSET = sc.critical.onset(R, E_STAR, 0.3, 1e9)
ROLLING = {"friction": sc.Coulomb(0.3), "creepage": (1e-3, 0.0)}


def ball(load, cells=10):
    a = sc.hertz.point(R, E_STAR, load=load).a
    n = 2 * math.ceil(1.3 * cells) + 1
    grid = sc.Grid(n, n, a / cells, a / cells)
    return grid, sc.surfaces.paraboloid(grid, R)


@pytest.mark.parametrize("body", [1, 2])
@pytest.mark.parametrize("friction", [0.0, 0.25, sc.Coulomb(0.3)])
def test_stress_at_centres_is_that_of_the_grid(friction, body):
    grid, gap = ball(50.0)
    solver = sc.ContactSolver(grid, STEEL, STEEL, friction)
    sticks = isinstance(friction, sc.Coulomb)
    found = solver.solve(gap, load=50.0, **({"tangential_load": (8.0, 2.0)} if sticks else {}))
    depths = np.array([0.5, 2.0, 11.0]) * grid.dx
    shear = found.shear if sticks else None
    expected = solver.stress(found.pressure, depths, body, shear=shear)[:, 3::7, 2::9]
    x, y = grid.x[3::7, None, None], grid.y[None, 2::9, None]
    points = solver.stress_at(found, x, y, depths, body)
    assert points.shape == expected.shape
    np.testing.assert_allclose(points, expected, rtol=0, atol=1e-11 * found.pressure.max())


def test_stress_between_and_outside_cells_is_that_of_hertz():
    load, friction = 50.0, 0.25
    grid, gap = ball(load, cells=24)
    hertz = sc.hertz.point(R, E_STAR, load=load)
    solver = sc.ContactSolver(grid, STEEL, STEEL, friction)
    found = solver.solve(gap, load=load)
    x, y, z = (np.array(s) * hertz.a for s in ([0.11, 0.53, -1.7, 4.0], [0.07, -0.3, 0.2, 1.0],
                                                [0.48, 0.31, 0.9, 2.0]))  # fmt: skip
    expected = hertz.stress(x, y, z, nu=0.3, friction=friction)
    actual = solver.stress_at(found, x, y, z)
    np.testing.assert_allclose(actual, expected, rtol=0, atol=5e-4 * hertz.p0)
    state = sc.Simulation(grid, STEEL, STEEL, gap, friction).step(load=load)
    np.testing.assert_allclose(state.stress_at(x, y, z), actual, rtol=0, atol=1e-5 * hertz.p0)
    mirrored = state.stress_at(-x, y, z, body=1)  # shear the other way round
    signs = np.array([1, 1, 1, 1, -1, -1])[:, None]
    np.testing.assert_allclose(mirrored, signs * actual, rtol=0, atol=1e-5 * hertz.p0)


def test_stress_is_independent_of_the_block_size(monkeypatch):
    grid, gap = ball(50.0, 4)
    solver = sc.ContactSolver(grid, STEEL, STEEL)
    found = solver.solve(gap, load=50.0)
    x = np.linspace(-2, 2, 13) * grid.dx
    expected = solver.stress_at(found, x, 0.0, grid.dx)
    monkeypatch.setattr("samcontact.solutions.stress_at_points._BLOCK_PAIRS", 17)
    again = solver.stress_at(found, x, 0.0, grid.dx)
    np.testing.assert_allclose(again, expected, rtol=0, atol=1e-14 * found.pressure.max())


def test_points_and_bodies_without_stress_are_refused():
    grid, gap = ball(50.0, 4)
    solver = sc.ContactSolver(grid, RIGID, STEEL)
    found = solver.solve(gap, load=50.0)
    for points, text in (
        ((0.0, 0.0, -1e-6), "z must be >= 0"),
        ((math.nan, 0.0, 0.0), "x must be finite"),
        ((np.zeros(3), np.zeros(2), 0.0), "equal or compatible shapes"),
    ):
        with pytest.raises(ValueError, match=text):
            solver.stress_at(found, *points)
    with pytest.raises(ValueError, match="body1 is rigid"):
        solver.stress_at(found, 0.0, 0.0, 0.0, body=1)
    layers = sc.Layered([(STEEL, 1e-5)], STEEL)
    coated = sc.ContactSolver(grid, RIGID, layers)
    with pytest.raises(ValueError, match="body2 must be homogeneous"):
        coated.stress_at(coated.solve(gap, load=50.0), 0.0, 0.0, 0.0)
    joined = sc.ContactSolver(sc.Grid(16, 1, 1e-5, 1e-5, periodic="y"), RIGID, STEEL)
    line = joined.solve((joined.grid.x**2 / 2 / R)[:, None], load=0.01)
    with pytest.raises(ValueError, match="must not be periodic"):
        joined.stress_at(line, 0.0, 0.0, 0.0)
    with pytest.raises(TypeError, match="solution"):
        solver.stress_at(found.pressure, 0.0, 0.0, 0.0)


def beyond_yield(solve):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        solve()
    return [str(w.message) for w in caught if w.category is sc.ElasticStrainWarning]


@pytest.mark.parametrize("share", [0.93, 1.07])
def test_elastic_solutions_above_first_yield_cause_a_warning(share):
    """Closed forms of first yield: at rest, sliding, in line contact, with a hard surface."""
    expected = int(share > 1)
    for onset, friction, soft in (
        (ONSET, 0.0, SOFT),
        (sc.critical.onset_sliding(R, E_STAR, 0.3, 1e9, 0.5), 0.5, SOFT),
        (sc.critical.onset_over_depth(R, E_STAR, hard := hardened()), 0.0, hard),
    ):
        load = onset.load * share**3
        grid, gap = ball(load)
        for bodies in ((STEEL, soft), (soft, STEEL)):
            solver = sc.ContactSolver(grid, *bodies, friction)
            texts = beyond_yield(lambda s=solver, g=gap, n=load: s.solve(g, load=n))
            assert len(texts) == expected
            assert all("would yield" in text for text in texts)
    grid, gap = ball(ONSET.load * share**3)
    load = ONSET.load * share**3
    steady = beyond_yield(lambda: sc.rolling.steady(grid, STEEL, SOFT, gap, load=load, **ROLLING))
    assert len(steady) >= expected
    line = sc.critical.onset_cylinder(R, E_STAR, 0.3, 1e9).load_per_length * share**2
    b = sc.hertz.line(R, E_STAR, line).b
    strip = sc.Grid(33, 2, b / 12, b / 12, periodic="y")
    solver = sc.ContactSolver(strip, STEEL, SOFT)
    gap = sc.surfaces.paraboloid(strip, R, math.inf)
    assert len(beyond_yield(lambda: solver.solve(gap, load=line * 2 * strip.dy))) == expected


def hardened():
    return SOFT.with_yield_profile([0.0, 1e-4, 2e-4], [3.0, 3.0, 1.0])


def test_a_body_without_a_yield_stress_causes_no_warning(monkeypatch):
    monkeypatch.setattr("samcontact.diagnostics.yield_check.main_spot", None)  # would be an error
    grid, gap = ball(ONSET.load)
    for body in (STEEL, sc.Material.perfect_plastic(210e9, 0.3, 9e9)):
        assert sc.ContactSolver(grid, STEEL, body).solve(gap, load=ONSET.load).converged


@pytest.mark.parametrize("friction", [0.0, 0.25])
def test_stress_where_cells_meet_at_the_surface_is_that_of_hertz(friction):
    """Uniform cells have an infinite stress there; the middle of an even grid is such a point."""
    a = sc.hertz.point(R, E_STAR, load=50.0).a
    grid = sc.Grid(50, 50, a / 20, a / 20)
    solver = sc.ContactSolver(grid, STEEL, STEEL, friction)
    found = solver.solve(sc.surfaces.paraboloid(grid, R), load=50.0)
    hertz = sc.hertz.point(R, E_STAR, load=50.0)
    x = np.array([0.0, 0.0, 0.5, 0.25, 0.325]) * hertz.a  # corners, then the middle of an edge
    y = np.array([0.0, 0.3, -0.2, 0.5, -0.4]) * hertz.a
    expected = hertz.stress(x, y, 0.0, nu=0.3, friction=friction)
    for z in (0.0, -0.0, 5e-324, 1e-30):
        actual = solver.stress_at(found, x, y, z)
        np.testing.assert_allclose(actual, expected, rtol=0, atol=5e-3 * hertz.p0)
        nudged = solver.stress_at(found, x + 1e-12 * grid.dx, y - 1e-12 * grid.dx, z)
        np.testing.assert_allclose(nudged, actual, rtol=0, atol=1e-9 * hertz.p0)


def test_points_too_far_for_numbers_are_refused():
    grid, gap = ball(50.0)
    solver = sc.ContactSolver(grid, STEEL, STEEL)
    found = solver.solve(gap, load=50.0)
    far = solver.stress_at(found, 0.0, 0.0, 1e9)
    assert far[2] == pytest.approx(-3 * 50.0 / (2 * math.pi * 1e18), rel=1e-9)
    with pytest.raises(ValueError, match="x must be finite, and <="):
        solver.stress_at(found, 1e160, 0.0, 1.0)
