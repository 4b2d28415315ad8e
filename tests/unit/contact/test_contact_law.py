# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact laws of single contacts: a tensile limit is hard contact of a repulsion.

With p = r - limit, the repulsion r is that of hard contact between surfaces displaced by the
limit, under a load increased by the limit.
"""

import pickle
import re

import numpy as np
import pytest
from contact_setups import STEEL, penetration

import samcontact as sc
from samcontact import surfaces

SOFT = sc.Material.elastic(20e9, 0.2)
PERIODIC = sc.Grid(32, 24, 1e-6, 1.2e-6, periodic="xy")
FREE = sc.Grid(33, 29, 1e-6, 1.2e-6)
LIMIT = 5e7
TOL = 1e-10


def rough(grid, seed=1):
    return -surfaces.rough_self_affine(grid, 2e-8, 0.8, wavelength_min=6e-6, seed=seed)


def ball(grid):
    return surfaces.paraboloid(grid, 1e-3) + 0.3 * rough(grid)


def area(grid):
    return grid.nx * grid.ny * grid.cell_area


def solver(grid, law, friction=0.0, bodies=(STEEL, SOFT), **more):
    return sc.ContactSolver(grid, *bodies, friction, tol=TOL, adhesion=law, **more)


def same(found, expected, rtol=1e-7):
    """Assert that fields are equal within the tolerance of both solutions."""
    np.testing.assert_allclose(found, expected, rtol=0, atol=rtol * np.abs(expected).max())


@pytest.mark.parametrize("share", [-0.9, -0.3, 0.0, 0.7])
@pytest.mark.parametrize("friction", [0.0, 0.2])
def test_periodic_tensile_limit_is_hard_contact_under_a_larger_load(share, friction):
    gap, pull = rough(PERIODIC), LIMIT * area(PERIODIC)
    found = solver(PERIODIC, sc.TensileLimit(LIMIT), friction).solve(gap, load=share * pull)
    hard = solver(PERIODIC, sc.HardContact(), friction).solve(gap, load=(1 + share) * pull)
    same(found.pressure + LIMIT, hard.pressure)
    same(found.repulsion, hard.pressure)
    same(found.gap, hard.gap)
    assert found.approach == pytest.approx(hard.approach, rel=1e-7)
    assert found.load == share * pull
    assert found.pressure.sum() * PERIODIC.cell_area == pytest.approx(share * pull, abs=1e-9 * pull)
    assert found.contact_area == pytest.approx(hard.contact_area, rel=1e-6)
    np.testing.assert_array_equal(found.in_contact, found.repulsion > 0)
    assert 0 < np.count_nonzero(found.in_contact) < found.pressure.size


@pytest.mark.parametrize("driver", ["load", "approach"])
def test_free_tensile_limit_is_hard_contact_over_attracted_surfaces(driver):
    gap, pull = ball(FREE), LIMIT * area(FREE)
    raised = penetration(FREE, np.full(FREE.surface_shape, LIMIT), STEEL, SOFT)
    given = -0.5 * pull if driver == "load" else 2e-9
    found = solver(FREE, sc.TensileLimit(LIMIT)).solve(gap, **{driver: given})
    more = given + pull if driver == "load" else given
    hard = solver(FREE, sc.HardContact()).solve(gap - raised, **{driver: more})
    same(found.pressure + LIMIT, hard.pressure)
    same(found.gap, hard.gap)
    assert found.load == pytest.approx(hard.load - pull, rel=1e-7)
    assert found.approach == pytest.approx(hard.approach, rel=1e-7)


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("grid", [PERIODIC, FREE], ids=["periodic", "free"])
def test_bounds_of_pressure_and_gap_are_kept(grid, seed):
    """p >= -limit, g >= 0, (p + limit) g = 0, with a gap from the definition of displacement."""
    draw = np.random.default_rng(seed)
    limit = 10 ** draw.uniform(6.5, 7.5)
    gap = rough(grid, seed) if grid.periodic else surfaces.paraboloid(grid, 1e-3)
    load = draw.uniform(-0.8, 1.5) * limit * area(grid)
    law = sc.TensileLimit(limit)
    of = solver(grid, law, bodies=(STEEL, SOFT), on_border="warn" if grid.periodic else "error")
    found = of.solve(gap, load=load)
    u = sum(of.displacement(found.pressure, body=body)[2] for body in (1, 2))
    opened = gap + u - found.approach
    scale = np.abs(u).max()
    same(found.gap, opened, 1e-9 * scale / np.abs(opened).max() + 1e-9)
    assert found.pressure.min() >= -limit
    r = (found.pressure + limit) / (found.pressure + limit).max()
    assert np.abs(np.minimum(r, opened / scale)).max() < 10 * TOL
    assert found.pressure.sum() * grid.cell_area == pytest.approx(load, rel=1e-9)


@pytest.mark.parametrize("friction", [0.0, 0.3, sc.Coulomb(0.3)])
def test_no_limit_is_hard_contact_to_every_digit(friction):
    gap = surfaces.paraboloid(FREE, 1e-3)
    none, hard = (
        solver(FREE, law, friction).solve(gap, load=0.02)
        for law in (sc.TensileLimit(0.0), sc.HardContact())
    )
    for name in ("pressure", "repulsion", "gap", "approach", "error", "work"):
        np.testing.assert_array_equal(getattr(none, name), getattr(hard, name))
    assert hard.repulsion is hard.pressure


def test_a_load_below_the_pull_off_force_is_refused():
    gap, pull = rough(PERIODIC), LIMIT * area(PERIODIC)
    of = solver(PERIODIC, sc.TensileLimit(LIMIT))
    separated = of.solve(gap, load=-pull)
    np.testing.assert_array_equal(separated.pressure, -LIMIT)
    assert not separated.in_contact.any()
    assert separated.contact_area == 0
    assert separated.gap.min() == pytest.approx(0, abs=1e-15)
    with pytest.raises(ValueError, match=r"load must be at least -.* N, the maximum tensile force"):
        of.solve(gap, load=-pull * (1 + 1e-9))
    with pytest.raises(ValueError, match="load must be a finite number >= 0"):
        solver(PERIODIC, sc.HardContact()).solve(gap, load=-1e-3)


def test_cells_without_a_body_have_no_tension():
    gap = surfaces.paraboloid(FREE, 1e-3)
    gap[:4] = np.inf
    found = solver(FREE, sc.TensileLimit(LIMIT)).solve(gap, load=0.01)
    assert not found.pressure[:4].any()
    assert not found.in_contact[:4].any()
    pull = LIMIT * FREE.cell_area * np.isfinite(gap).sum()
    assert found.repulsion.sum() * FREE.cell_area == pytest.approx(0.01 + pull, rel=1e-9)


def test_friction_acts_on_the_repulsion():
    """A tangential force without a load is possible; the shear is that of hard contact."""
    gap, pull, mu = rough(PERIODIC), LIMIT * area(PERIODIC), 0.3
    identical = (STEEL, STEEL)
    law = sc.TensileLimit(LIMIT)
    of = solver(PERIODIC, law, sc.Coulomb(mu), identical)
    held = solver(PERIODIC, sc.HardContact(), sc.Coulomb(mu), identical)
    force = (0.6 * mu * pull, 0.0)
    found = of.solve(gap, load=0.0, tangential_load=force)
    hard = held.solve(gap, load=pull, tangential_load=force)
    same(found.pressure + LIMIT, hard.pressure)
    same(found.shear, hard.shear, 1e-6)
    beyond = np.hypot(*found.shear) > mu * np.maximum(found.pressure, 0.0)
    assert beyond[found.in_contact].any()  # cells under tension hold some
    assert (np.hypot(*found.shear) <= mu * found.repulsion * (1 + 1e-9)).all()
    on = of.solve(gap, load=0.2 * pull, tangential_load=(0.0, 0.0), previous=found)
    more = held.solve(gap, load=1.2 * pull, tangential_load=(0.0, 0.0), previous=hard)
    same(on.shear, more.shear, 1e-6)
    np.testing.assert_array_equal(on.sticking, more.sticking)
    with pytest.raises(ValueError, match="the friction limit"):
        of.solve(gap, load=0.0, tangential_load=(1.01 * mu * pull, 0.0))


def test_an_initial_guess_is_a_pressure():
    gap, load = rough(PERIODIC), -0.3 * LIMIT * area(PERIODIC)
    of = solver(PERIODIC, sc.TensileLimit(LIMIT))
    cold = of.solve(gap, load=load)
    warm = of.solve(gap, load=load, initial_pressure=cold.pressure)
    assert warm.iterations == 0
    same(warm.pressure, cold.pressure)


def test_options_unsupported_with_attraction_are_refused():
    law = sc.TensileLimit(LIMIT)
    warm = sc.Material.elastic(210e9, 0.3).with_thermal(50.0, 1e-5, 1e-5)
    heat = sc.Heat(0.1)
    with pytest.raises(ValueError, match="heat is not supported with adhesion"):
        solver(FREE, law, 0.1, (warm, SOFT), heat=heat)
    of = solver(FREE, law, sc.Coulomb(0.3))
    first = of.solve(surfaces.paraboloid(FREE, 1e-3), load=0.01)
    with pytest.raises(ValueError, match=re.escape("advance must be (0, 0) with adhesion")):
        of.solve(surfaces.paraboloid(FREE, 1e-3), load=0.01, previous=first, advance=(-1e-6, -1e-6))
    with pytest.raises(ValueError, match=r"shear is required with friction = 0\.2 and adhesion"):
        solver(FREE, law, 0.2).displacement(np.ones(FREE.surface_shape))


def test_the_grid_of_attracting_bodies_is_not_enlarged():
    grid = sc.Grid(9, 9, 1e-6, 1e-6)
    of = solver(grid, sc.TensileLimit(LIMIT))
    with pytest.raises(sc.GridTooSmallError, match="reaches the edge"):
        of.solve(lambda over: surfaces.paraboloid(over, 1e-3), load=0.05)


@pytest.mark.parametrize("limit", [-1.0, float("nan"), float("inf")])
def test_limits_are_checked(limit):
    with pytest.raises(ValueError, match="limit must be a finite number >= 0"):
        sc.TensileLimit(limit)


def test_laws_are_types():
    with pytest.raises(TypeError, match=r"adhesion must be a samcontact\.ContactLaw"):
        solver(FREE, 5e7)
    of = pickle.loads(pickle.dumps(solver(FREE, sc.TensileLimit(LIMIT))))
    assert of.adhesion == sc.TensileLimit(LIMIT)
    assert "adhesion=TensileLimit(limit=50000000.0)" in repr(of)
