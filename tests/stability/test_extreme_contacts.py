# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact of one cell and of all cells, distant contacts, sharp edges, friction up to one."""

import numpy as np
import pytest

import samcontact as sc

E, NU, RADIUS = 210e9, 0.3, 7.5e-3
STEEL = sc.Material.elastic(E, NU)
CORK = sc.Material.elastic(E, 0.0)
RIGID = sc.Material.rigid()
E_STAR = E / (1 - NU**2)

border = pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")


def assert_solved(solver, gap, found, tol):
    """Complementarity and equilibrium, with the displacement from the operators."""
    grid, p = solver.grid, found.pressure
    u = np.zeros(grid.surface_shape)
    for body, sign in ((solver.body1, -1.0), (solver.body2, 1.0)):
        if not body.is_rigid:
            shear = sign * solver.friction * p
            u += sc.operators.surface_displacement(grid, p, body.E, body.nu, shear)
    g = gap + u - found.approach
    assert p.min() >= 0
    # rounding of u
    assert np.abs(np.minimum(p / p.max(), g / np.abs(u).max())).max() <= tol + 1e-13
    assert p.sum() * grid.cell_area == pytest.approx(found.load, rel=1e-12)


@pytest.mark.parametrize("load", [10.0**n for n in range(-20, 1, 4)])
@pytest.mark.parametrize("friction", [0.0, 1.0])
def test_one_cell(load, friction):
    """One loaded cell is displaced by its own coefficient; the approach reproduces the load."""
    grid = sc.Grid(9, 9, 1e-4, 1e-4)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    solver = sc.ContactSolver(grid, RIGID, STEEL, friction)
    found = solver.solve(gap, load=load)
    assert np.count_nonzero(found.pressure) == 1
    own = sc.kernels.pressure_displacement(0.0, 0.0, 5e-5, 5e-5, E, NU)
    assert found.approach == pytest.approx(load / grid.cell_area * own, rel=1e-12)
    assert solver.solve(gap, approach=found.approach).load == pytest.approx(load, rel=1e-12)


def flat(grid):
    return np.zeros(grid.surface_shape)


def wavy(grid):
    """Return the gap of a wavy surface that the larger loads below flatten completely."""
    waves = np.cos(2 * np.pi * grid.x[:, None] / 3.1e-4) * np.cos(2 * np.pi * grid.y / 3.1e-4)
    return 1e-7 * (1 - waves)


def conforming(grid):
    return sc.surfaces.paraboloid(grid, 1.0)


def step(grid):
    """Return a gap that is 10 nm larger in half of the surface."""
    return np.where(grid.x[:, None] > 0, 1e-8, 0.0) + flat(grid)


def rough(grid):
    return sc.surfaces.rough_self_affine(grid, 2e-8, 0.5, seed=1)


@border
@pytest.mark.parametrize("tol", [1e-8, 1e-13])
@pytest.mark.parametrize("friction", [0.0, 1.0])
@pytest.mark.parametrize("shape", [(31, 31), (64, 64), (61, 17)])
@pytest.mark.parametrize("surface", [flat, wavy, conforming, step, rough])
def test_every_cell_loaded(surface, shape, friction, tol):
    """Tolerances down to the minimum, which requires an accurate mean gap."""
    grid = sc.Grid(*shape, 1e-5, 1e-5)
    solver = sc.ContactSolver(grid, RIGID, CORK, friction, tol=tol, on_border="warn")
    gap = surface(grid)
    found = solver.solve(gap, load=1e4)
    assert (found.pressure > 0).all()
    assert_solved(solver, gap, found, tol)
    assert found.iterations < 120
    by_approach = solver.solve(gap, approach=found.approach)
    assert by_approach.load == pytest.approx(1e4, rel=1e2 * tol + 1e-12)


@border
@pytest.mark.parametrize("side", [100, 128, 200, 256])
def test_every_cell_of_large_surfaces_loaded(side):
    grid = sc.Grid(side, side, 1e-5, 1e-5)
    solver = sc.ContactSolver(grid, RIGID, CORK, tol=1e-13, on_border="warn")
    found = solver.solve(flat(grid), load=10.0)
    assert found.error <= 1e-13
    assert found.iterations < 40


@pytest.mark.parametrize("cells", [60, 100, 300])
def test_two_asperities_far_apart(cells):
    """Each carries half the load and is displaced by the other: P/(pi E* d), Boussinesq."""
    size, distance = 5e-6, cells * 5e-6
    one_grid, grid = sc.Grid(41, 41, size, size), sc.Grid(cells + 41, 41, size, size)
    x, y = grid.x[:, None], grid.y
    gap = (np.minimum((x - distance / 2) ** 2, (x + distance / 2) ** 2) + y**2) / (2 * RADIUS)
    solver = sc.ContactSolver(grid, RIGID, STEEL, tol=1e-12)
    both = solver.solve(gap, load=2.0)
    alone = sc.ContactSolver(one_grid, RIGID, STEEL, tol=1e-12).solve(
        sc.surfaces.paraboloid(one_grid, RADIUS), load=1.0
    )
    half = both.pressure[: (cells + 41) // 2].sum() * grid.cell_area
    middle = both.pressure[(cells + 41) // 2].sum() * grid.cell_area  # empty, of an odd number
    assert half + 0.5 * middle == pytest.approx(1.0, rel=1e-12)
    a = sc.hertz.point(RADIUS, E_STAR, load=1.0).a
    sunk = both.approach - alone.approach
    assert sunk == pytest.approx(1.0 / (np.pi * E_STAR * distance), rel=(a / distance) ** 2)


def test_unequal_asperities_share_the_load():
    """Each follows Hertz at the common approach less the displacement due to the other."""
    size, distance, high = 5e-6, 2e-3, 3e-8
    grid = sc.Grid(441, 41, size, size)
    x, y = grid.x[:, None], grid.y
    left, right = (((x + s * distance / 2) ** 2 + y**2) / (2 * RADIUS) for s in (1, -1))
    found = sc.ContactSolver(grid, RIGID, STEEL, tol=1e-12).solve(
        np.minimum(left, right + high), load=2.0
    )
    loads = [part.sum() * grid.cell_area for part in (found.pressure[:220], found.pressure[221:])]
    assert loads[0] > 1.1 * loads[1] > 0
    for load, other, lower in ((loads[0], loads[1], 0.0), (loads[1], loads[0], high)):
        moved = other / (np.pi * E_STAR * distance)
        alone = sc.hertz.point(RADIUS, E_STAR, approach=found.approach - lower - moved)
        assert load == pytest.approx(alone.load, rel=5e-3)


@pytest.mark.parametrize("cells", [8, 16, 32, 64])
def test_sharp_edge(cells):
    """Flat punch: P/(2 E* a), and p = P/(2 pi a^2)/sqrt(1 - r^2/a^2) inside; edges never cycle."""
    radius = 1e-4
    grid = sc.Grid(2 * cells + 20, 2 * cells + 20, radius / cells, radius / cells)
    r = np.hypot(grid.x[:, None], grid.y)
    gap = np.where(r <= radius, 0.0, radius)
    with pytest.warns(sc.SingularPressureWarning):
        found = sc.ContactSolver(grid, RIGID, STEEL).solve(gap, load=1.0)
    np.testing.assert_array_equal(found.pressure > 0, r <= radius)
    assert found.approach == pytest.approx(1.0 / (2 * E_STAR * radius), rel=0.05 / np.sqrt(cells))
    inside = r < 0.5 * radius
    exact = 1.0 / (2 * np.pi * radius**2) / np.sqrt(1 - (r[inside] / radius) ** 2)
    assert np.abs(found.pressure[inside] / exact - 1).max() < 0.04 / np.sqrt(cells)
    assert found.iterations < 30


@pytest.mark.filterwarnings("ignore::samcontact.SingularPressureWarning")
@pytest.mark.parametrize("friction", [0.0, 1.0])
@pytest.mark.parametrize("height", [1e-12, 1e-9, 1e-7, 1e-6, 1e-4])
def test_step_in_a_ball(height, friction):
    """Across a step in the contact of any height, both sides or one side carry the load."""
    grid = sc.Grid(41, 40, 1.4e-5, 1.4e-5)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    gap = gap + np.where(grid.x[:, None] > 0, height, 0.0)
    solver = sc.ContactSolver(grid, RIGID, CORK, friction)
    found = solver.solve(gap, load=200.0)
    assert_solved(solver, gap, found, 1e-8)
    assert found.iterations < 100
    left, right = (
        part.sum() * grid.cell_area for part in (found.pressure[:20], found.pressure[21:])
    )
    assert right <= left * (1 + 1e-6)
    assert (right == 0) == (height == 1e-4)


@pytest.mark.parametrize("friction", [0.0, 0.1, 0.3, 0.6, 1.0])
@pytest.mark.parametrize("pair", [(RIGID, CORK), (CORK, RIGID), (STEEL, CORK), (STEEL, STEEL)])
def test_friction_up_to_one(pair, friction):
    """The pressure is symmetric in x without friction or coupling; otherwise the shear tilts it."""
    grid = sc.Grid(37, 31, 1.5e-5, 1.8e-5)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    solver = sc.ContactSolver(grid, *pair, friction)
    found = solver.solve(gap, load=150.0)
    assert_solved(solver, gap, found, 1e-8)
    lean = (found.pressure * grid.x[:, None]).sum() / found.pressure.sum() / 1e-4
    if friction == 0 or pair == (STEEL, STEEL):
        assert abs(lean) < 1e-7
    else:
        # shear towards +x raises the surface behind it (Cerruti); on body 1 it is reversed
        sign = 1 if pair == (CORK, RIGID) else -1
        assert sign * lean > (0.02 if STEEL in pair else 0.05) * friction


@border
@pytest.mark.parametrize(("seed", "load"), [(20, 1e70), (40, 1e-3), (53, 1.0)])
def test_an_infinite_complementarity_error_ends_the_iteration(seed, load):
    """The complementarity error of these gaps is infinite and does not decrease."""
    rng = np.random.default_rng(seed)
    gap = np.zeros((7, 6))
    count = rng.integers(1, 42)
    cells = rng.choice(gap.size, count, replace=False)
    gap.flat[cells] = rng.choice([1e299, -1e299, 1e200, 1e308, -1e308, 1.0, 1e-300], count)
    start = rng.choice([0, 0, 1.0, 1e300, 1e-300, -1], gap.shape)
    grid = sc.Grid(7, 6, 1e-5, 1e-5)
    solver = sc.ContactSolver(grid, STEEL, STEEL, max_iterations=2, on_border="warn")
    with pytest.raises((sc.ConvergenceError, ValueError)):
        solver.solve(gap, load=load, initial_pressure=start)
