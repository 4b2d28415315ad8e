# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts with adhesion along paths: branches, jumps, closed forms, and least energy."""

import numpy as np
import pytest
from scipy.optimize import minimize

import samcontact as sc

R, W, RANGE = 1e-6, 0.05, 2.5e-9
TIP, POLYMER = sc.Material.rigid(), sc.Material.elastic(1e8, 0.4)
E_STAR = 1e8 / 0.84
FORCE = np.pi * W * R
LENGTH = float(np.cbrt(9 * np.pi**2 * W**2 * R / (16 * E_STAR**2)))
"""Approach at the end of the JKR branch is -0.909 of this length."""


def along(solver, gap, approaches, solution=None):
    """Return solutions along a path of approaches, from one branch."""
    found = []
    for approach in approaches:
        start = None if solution is None else solution.pressure
        solution = solver.solve(gap, approach=approach, initial_pressure=start)
        found.append(solution)
    return found


def sphere(cells, size, law):
    grid = sc.Grid(cells, cells, size / cells, size / cells)
    solver = sc.ContactSolver(grid, TIP, POLYMER, adhesion=law)
    return solver, sc.surfaces.paraboloid(grid, R)


@pytest.fixture(scope="module")
def cycle():
    """Return approaches, and loads of approach and retraction, at a Tabor number of 2.2."""
    solver, gap = sphere(80, 480e-9, sc.Adhesion.exponential(W, RANGE))
    approaches = LENGTH * np.array([-1.2, -1.0, -0.9, -0.85, -0.8, -0.6, -0.45, -0.3, 0.0, 0.3])
    there = along(solver, gap, approaches)
    back = along(solver, gap, approaches[::-1], there[-1])[::-1]
    return approaches, *(np.array([s.load for s in part]) for part in (there, back))


def test_surfaces_jump_in_later_than_they_jump_apart(cycle):
    approaches, there, back = cycle
    between = (approaches > -0.91 * LENGTH) & (approaches < -0.79 * LENGTH)
    assert np.all(there[between] > -0.2 * FORCE)  # separated, until the pull-in
    assert np.all(back[between] < -1.0 * FORCE)  # in contact, until the pull-off
    same = ~between
    np.testing.assert_allclose(there[same], back[same], rtol=0, atol=1e-6 * FORCE)


def test_the_force_on_the_branch_in_contact_is_that_of_jkr(cycle):
    """A finite range raises the tension by 5 % at a Tabor number of 2."""
    approaches, _, back = cycle
    jkr = sc.adhesion.jkr(R, W, E_STAR)
    radius = np.linspace(jkr.radius_at_pull_off * 0.7, 4 * jkr.radius_at_pull_off, 4000)
    in_contact = approaches > -0.7 * LENGTH
    expected = np.interp(approaches, jkr.approach(radius), jkr.load(radius))
    excess = (expected - back)[in_contact] / FORCE
    assert np.all(excess > 0.0)
    assert np.all(excess < 0.13)
    assert 1.03 < -back.min() / jkr.pull_off < 1.06


def test_separated_surfaces_follow_the_force_between_rigid_bodies():
    solver, gap = sphere(96, 720e-9, sc.Adhesion.exponential(W, RANGE))
    far = np.array([-20e-9, -18e-9, -15e-9])
    for approach, solution in zip(far, along(solver, gap, far), strict=True):
        rigid = 2 * FORCE * np.exp(approach / RANGE)
        np.testing.assert_allclose(-solution.load, rigid, rtol=0.02)
        assert not solution.in_contact.any()
        assert solution.iterations < 10


@pytest.mark.parametrize("parameter", [0.5, 1.0])
def test_constant_attraction_follows_maugis(parameter):
    K = 4 * E_STAR / 3
    stress = parameter / 2 / float(np.cbrt(R / (np.pi * W * K**2)))
    maugis = sc.adhesion.maugis(R, W, E_STAR, stress)
    unit = float(np.cbrt(np.pi * W * R**2 / K))
    radius = unit * np.array([2.0, 1.6, 1.2, 0.8])
    size = 2.2 * float(maugis.outer_radius(radius).max())
    solver, gap = sphere(80, size, sc.Adhesion.dugdale(W, stress))
    found = [s.load for s in along(solver, gap, maugis.approach(radius))]
    np.testing.assert_allclose(found, maugis.load(radius), rtol=0, atol=0.019 * FORCE)


@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
def test_a_rough_contact_has_least_energy():
    """L-BFGS-B in the gap, with a dense stiffness and from another start, ends in this state."""
    n, work, length = 16, 0.02, 4e-9
    grid = sc.Grid(n, n, 1e-8, 1e-8)
    heights = sc.surfaces.rough_self_affine(grid, 1.5e-9, 0.8, wavelength_min=4e-8, seed=3)
    gap = sc.surfaces.paraboloid(grid, 0.5e-6) + heights.max() - heights
    law = sc.Adhesion.exponential(work, length)
    solver = sc.ContactSolver(grid, TIP, POLYMER, adhesion=law, tol=1e-10)
    approach = 1.0e-9
    solution = solver.solve(gap, approach=approach)
    corner = np.zeros((n, n))
    corner[0, 0] = 1.0
    column = solver.displacement(corner)[2]
    i, j = np.divmod(np.arange(n * n), n)
    stiffness = np.linalg.inv(column[abs(i[:, None] - i), abs(j[:, None] - j)])
    height = (gap - approach).ravel()

    def energy(scaled):
        """Energy per cell area and work of adhesion, with its gradient; gaps in nm."""
        g = scaled * 1e-9
        pressure = stiffness @ (g - height)
        value = 0.5 * (g - height) @ pressure - work * np.exp(-g / length).sum()
        return value / work, (pressure + work / length * np.exp(-g / length)) * 1e-9 / work

    options = {"ftol": 1e-16, "gtol": 1e-11, "maxiter": 20000, "maxfun": 50000, "maxcor": 50}
    other = minimize(energy, np.maximum(height, 0.0) * 1e9, jac=True, method="L-BFGS-B",
                     bounds=[(0, None)] * n**2, options=options)  # fmt: skip
    here = energy(solution.gap.ravel() * 1e9)[0]
    assert 0 < np.count_nonzero(solution.in_contact) < n * n
    np.testing.assert_allclose(here, other.fun, rtol=1e-8)
    stored = solution.pressure.sum() * grid.dx * grid.dy
    pressure = stiffness @ (other.x * 1e-9 - height)
    np.testing.assert_allclose(pressure.sum() * grid.dx * grid.dy, stored, rtol=1e-4)


def rough_heights(n, slope=0.1):
    """Return heights of a self-affine surface (Hurst exponent 0.8) with side 1 and a rms slope."""
    rng = np.random.default_rng(5)
    q = np.hypot(*np.meshgrid(np.fft.fftfreq(n, 1 / n), np.fft.fftfreq(n, 1 / n), indexing="ij"))
    amplitude = np.where((q >= 2) & (q <= n / 8), np.maximum(q, 1e-9) ** -1.8, 0)
    z = np.fft.ifft2(amplitude * np.exp(2j * np.pi * rng.random((n, n)))).real
    steps = (np.roll(z, -1, 0) - z) ** 2 + (np.roll(z, -1, 1) - z) ** 2
    return z * slope / (np.sqrt(steps.mean()) * n)


@pytest.mark.parametrize(
    ("n", "distance", "contact", "most"),
    [(128, 1.0, 0.22, 60), pytest.param(256, 0.8, 0.31, 100, marks=pytest.mark.slow)],
)
def test_rough_contacts_take_few_iterations(n, distance, contact, most):
    """From undeformed surfaces, at kappa = 0.5; distance: mean gap over the rms height."""
    size = 1e-6
    grid = sc.Grid(n, n, size / n, size / n, periodic="xy")
    heights = rough_heights(n) * size
    rms = float(heights.std())
    unit = sc.Adhesion.exponential(1.0, 0.2 * rms)
    law = sc.Adhesion.exponential(0.5 / unit.on(grid, TIP, POLYMER).kappa, 0.2 * rms)
    solver = sc.ContactSolver(grid, TIP, POLYMER, adhesion=law, tol=1e-9)
    gap = heights.max() - heights
    found = solver.solve(gap, approach=gap.mean() - distance * rms)
    assert found.in_contact.mean() == pytest.approx(contact, abs=0.01)
    assert found.iterations <= most


def test_weak_adhesion_is_the_hard_contact():
    grid = sc.Grid(48, 48, 15e-9, 15e-9)
    gap = sc.surfaces.paraboloid(grid, R)
    hard = sc.ContactSolver(grid, TIP, POLYMER).solve(gap, approach=2e-8)
    weak = sc.ContactSolver(grid, TIP, POLYMER, adhesion=sc.Adhesion.exponential(1e-9, RANGE))
    solution = weak.solve(gap, approach=2e-8)
    np.testing.assert_allclose(solution.load, hard.load, rtol=1e-5)
    close = {"rtol": 0, "atol": 1e-4 * hard.pressure.max()}
    np.testing.assert_allclose(solution.pressure, hard.pressure, **close)


def test_a_load_beyond_the_pull_off_is_refused_with_the_largest_tension():
    solver, gap = sphere(64, 640e-9, sc.Adhesion.exponential(W, 4e-9))
    held = solver.solve(gap, load=-0.9 * 1.5 * FORCE)
    assert held.in_contact.any()
    with pytest.raises(sc.PullOffError) as raised:
        solver.solve(gap, load=-2.5 * FORCE)
    assert 1.5 * FORCE < raised.value.pull_off < 2.0 * FORCE


def test_a_retraction_from_compression_ends_past_the_largest_tension():
    grid = sc.Grid(40, 40, 17e-9, 17e-9)
    gap = sc.surfaces.paraboloid(grid, R)
    law = sc.Adhesion.exponential(W, 4e-9)
    simulation = sc.Simulation(grid, TIP, POLYMER, gap, adhesion=law)
    assert simulation.step(load=0.5 * FORCE).load > 0
    found = sc.paths.pull_off(simulation, step=1e-9, until="maximum")
    assert 1.5 * FORCE < found.pull_off < 1.75 * FORCE
    assert found.states[-1].load > -found.pull_off
    assert not found.is_apart


@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
@pytest.mark.parametrize("periodic", ["", "x", "xy"])
@pytest.mark.parametrize("layered", [False, True])
def test_a_load_found_from_a_contact_is_that_of_its_approach(periodic, layered):
    """The descent under a load ends in the state that the descent at its approach finds."""
    grid = sc.Grid(32, 28, 15e-9, 15e-9, periodic=periodic)
    coat = sc.Material.elastic(3e8, 0.3)
    body = sc.Layered([(coat, 4e-8)], POLYMER) if layered else POLYMER
    law = sc.Adhesion.exponential(W, 4e-9)
    solver = sc.ContactSolver(grid, TIP, body, adhesion=law, tol=1e-10, on_border="warn")
    gap = sc.surfaces.paraboloid(grid, R)
    start = solver.solve(gap, approach=0.5 * gap.mean())
    for share in (1.3, 0.5, 0.9):
        load = start.load * share if start.load > 0 else start.load - share * 0.1 * start.load
        found = solver.solve(gap, load=load, initial_pressure=start.pressure)
        assert found.iterations < 80
        assert found.pressure.sum() * grid.cell_area == pytest.approx(load, rel=1e-6)
        same = solver.solve(gap, approach=found.approach, initial_pressure=start.pressure)
        np.testing.assert_allclose(
            found.pressure, same.pressure, rtol=0, atol=1e-6 * abs(same.pressure).max()
        )
        assert same.load == pytest.approx(load, rel=1e-6)
