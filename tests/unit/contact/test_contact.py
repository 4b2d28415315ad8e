# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic contact: independently checked complementarity, drivers, friction, stress."""

import math
import re

import numpy as np
import pytest
from contact_setups import RADIUS, RIGID, STEEL, TOL, assert_complementary, penetration, scene

import samcontact as sc
from samcontact import hertz, operators, surfaces

CERAMIC = sc.Material.elastic(310e9, 0.29)
RUBBER = sc.Material.elastic(1e7, 0.49)
PAIRS = {
    "rigid on steel": (RIGID, STEEL),
    "steel on rigid": (STEEL, RIGID),
    "ceramic on steel": (CERAMIC, STEEL),
    "rubber on steel": (RUBBER, STEEL),
    "steel on steel": (STEEL, STEEL),
}


@pytest.mark.parametrize("friction", [0.0, 0.3])
@pytest.mark.parametrize("pair", PAIRS)
def test_complementarity_and_load(pair, friction):
    body1, body2 = PAIRS[pair]
    grid, gap, exact = scene(body1, body2)
    solution = sc.ContactSolver(grid, body1, body2, friction, tol=TOL).solve(gap, load=exact.load)
    displacement = penetration(grid, solution.pressure, body1, body2, friction)
    assert_complementary(grid, solution, gap, displacement, TOL)
    assert solution.converged
    assert solution.error <= TOL
    assert solution.load == exact.load
    assert solution.iterations > 1


@pytest.mark.parametrize("friction", [2.0, 4.0])
@pytest.mark.parametrize("drive", ["load", "approach"])
def test_strongly_coupled_friction_is_solved(friction, drive):
    """Above mu beta = 1 (beta = 1/2 here) alternating solutions for pressure and shear diverge."""
    soft = sc.Material.elastic(210e9, 0.0)
    grid, gap, exact = scene(RIGID, soft)
    solver = sc.ContactSolver(grid, RIGID, soft, friction, tol=1e-10)
    solution = solver.solve(gap, **{drive: 0.05 * getattr(exact, drive)})
    displacement = penetration(grid, solution.pressure, RIGID, soft, friction)
    assert_complementary(grid, solution, gap, displacement, 1e-10)


@pytest.mark.parametrize("friction", [0.0, 0.3])
@pytest.mark.parametrize("pair", PAIRS)
def test_load_and_approach_give_the_same_pressure(pair, friction):
    body1, body2 = PAIRS[pair]
    grid, gap, exact = scene(body1, body2)
    solver = sc.ContactSolver(grid, body1, body2, friction, tol=1e-10)
    by_load = solver.solve(gap, load=exact.load)
    by_approach = solver.solve(gap, approach=by_load.approach)
    difference = np.abs(by_approach.pressure - by_load.pressure).max()
    assert difference < 1e-6 * by_load.pressure.max()
    assert by_approach.load == pytest.approx(by_load.load, rel=1e-7)
    assert by_approach.approach == by_load.approach


def test_only_the_contact_modulus_matters_without_friction():
    E_star = hertz.effective_modulus(CERAMIC, STEEL)
    grid, gap, exact = scene(CERAMIC, STEEL)
    one_body = sc.Material.elastic(E_star, 0.0)
    pairs = [(CERAMIC, STEEL), (STEEL, CERAMIC), (one_body, RIGID), (RIGID, one_body)]
    solutions = [sc.ContactSolver(grid, *pair).solve(gap, load=exact.load) for pair in pairs]
    for other in solutions[1:]:
        np.testing.assert_allclose(other.pressure, solutions[0].pressure, rtol=1e-9)
        assert other.approach == pytest.approx(solutions[0].approach, rel=1e-12)


class TestFriction:
    def test_identical_bodies_are_not_coupled(self):
        grid, gap, exact = scene(STEEL, STEEL)
        free = sc.ContactSolver(grid, STEEL, STEEL).solve(gap, load=exact.load)
        rubbed = sc.ContactSolver(grid, STEEL, STEEL, 0.5).solve(gap, load=exact.load)
        np.testing.assert_array_equal(rubbed.pressure, free.pressure)
        assert rubbed.approach == free.approach

    @pytest.mark.parametrize("pair", [(RIGID, CERAMIC), (CERAMIC, RIGID)])
    def test_few_cells_with_uniform_coupling(self, pair):
        """On 2 x 2 cells the shear adds equal amounts to all gaps and changes the approach."""
        grid = sc.Grid(8, 8, 1.5e-5, 1.5e-5)
        gap = surfaces.paraboloid(grid, RADIUS)
        solution = sc.ContactSolver(grid, *pair, 1.0).solve(gap, load=0.1)
        assert np.count_nonzero(solution.pressure) == 4
        displacement = penetration(grid, solution.pressure, *pair, 1.0)
        assert_complementary(grid, solution, gap, displacement, TOL)

    @pytest.mark.parametrize("part", [None, 1e-4, 0.01])
    def test_displacement_due_to_shear_vanishes_with_the_shear(self, part):
        """Unloading, or a small approach, from a pressure whose shear separated the surfaces."""
        grid, gap, exact = scene(RIGID, CERAMIC)
        gap = gap + 1e-9 * np.cos(1e6 * grid.x[:, None])
        solver = sc.ContactSolver(grid, RIGID, CERAMIC, 1.0)
        loaded = solver.solve(gap, load=exact.load)
        lowest = gap.min()
        if part is None:
            drive = {"load": 0.0}
        else:
            drive = {"approach": lowest + part * (loaded.approach - lowest)}
        alone = solver.solve(gap, **drive)
        after = solver.solve(gap, **drive, initial_pressure=loaded.pressure)
        assert after.approach == alone.approach
        scale = abs(alone.gap).max()
        np.testing.assert_allclose(after.gap, alone.gap, rtol=0, atol=1e-7 * scale)
        assert after.load == pytest.approx(alone.load, rel=1e-6)
        assert (after.load > 0) == (part is not None)

    def test_incompressible_on_rigid_is_not_coupled(self):
        """The coupling has the factor 1 - 2 nu, so it fades as nu goes to 0.5."""
        shifts = []
        for nu in (0.3, 0.4, 0.4999):
            body = sc.Material.elastic(210e9, nu)
            grid, gap, exact = scene(RIGID, body)
            p = sc.ContactSolver(grid, RIGID, body, 0.4).solve(gap, load=exact.load).pressure
            shifts.append(abs((p * grid.x[:, None]).sum() / p.sum()) / exact.a)
        assert shifts[0] > shifts[1] > 100 * shifts[2]
        # The shift is determined by Dundurs' beta, (1 - 2 nu)/(2 (1 - nu)).
        assert shifts[1] / shifts[0] == pytest.approx((0.2 / 1.2) / (0.4 / 1.4), rel=0.05)

    def test_exchange_of_the_bodies_mirrors_in_x(self):
        """Body 1 drags body 2 in +x; in the swapped problem the drag is in -x."""
        grid, gap, exact = scene(RIGID, STEEL)
        below = sc.ContactSolver(grid, RIGID, STEEL, 0.4).solve(gap, load=exact.load).pressure
        above = sc.ContactSolver(grid, STEEL, RIGID, 0.4).solve(gap, load=exact.load).pressure
        np.testing.assert_allclose(above, below[::-1], rtol=0, atol=1e-6 * below.max())
        assert np.abs(below - below[::-1]).max() > 0.01 * below.max()

    def test_pressure_shifts_in_the_direction_of_the_coupling(self):
        """The pressure increases where the shear raises the surface (u_z < 0)."""
        grid, gap, exact = scene(RIGID, STEEL)
        free = sc.ContactSolver(grid, RIGID, STEEL).solve(gap, load=exact.load).pressure
        rubbed = sc.ContactSolver(grid, RIGID, STEEL, 0.4).solve(gap, load=exact.load).pressure
        shear = 0.4 * free
        both = operators.surface_displacement(grid, free, STEEL.E, STEEL.nu, shear)
        lift = operators.surface_displacement(grid, free, STEEL.E, STEEL.nu) - both
        assert ((rubbed - free) * lift).sum() > 0


class TestWarmStart:
    def test_same_solution_in_fewer_iterations(self):
        grid, gap, exact = scene(RIGID, STEEL)
        solver = sc.ContactSolver(grid, RIGID, STEEL, tol=1e-10)
        before = solver.solve(gap, load=0.9 * exact.load)
        cold = solver.solve(gap, load=exact.load)
        warm = solver.solve(gap, load=exact.load, initial_pressure=before.pressure)
        again = solver.solve(gap, load=exact.load, initial_pressure=cold.pressure)
        assert warm.iterations < cold.iterations
        assert again.iterations <= 1
        difference = np.abs(warm.pressure - cold.pressure).max()
        assert difference < 1e-8 * exact.p0

    def test_any_initial_pressure_is_accepted(self):
        grid, gap, exact = scene(RIGID, STEEL)
        solver = sc.ContactSolver(grid, RIGID, STEEL, tol=1e-10)
        cold = solver.solve(gap, load=exact.load)
        start = np.random.default_rng(1).standard_normal(grid.surface_shape) * exact.p0
        for driver in ({"load": exact.load}, {"approach": cold.approach}):
            other = solver.solve(gap, **driver, initial_pressure=start)
            difference = np.abs(other.pressure - cold.pressure).max()
            assert difference < 1e-8 * exact.p0

    def test_does_not_touch_its_arguments(self):
        grid, gap, exact = scene(RIGID, STEEL)
        start = np.full(grid.surface_shape, -1e9)
        gap_before, start_before = gap.copy(), start.copy()
        sc.ContactSolver(grid, RIGID, STEEL).solve(gap, load=exact.load, initial_pressure=start)
        np.testing.assert_array_equal(gap, gap_before)
        np.testing.assert_array_equal(start, start_before)


class TestStress:
    depths = (0.0, 2e-5, 1e-3)

    def test_stress_is_that_of_the_tractions_on_each_body(self):
        grid, gap, exact = scene(CERAMIC, STEEL)
        solver = sc.ContactSolver(grid, CERAMIC, STEEL, 0.3)
        p = solver.solve(gap, load=exact.load).pressure
        for body, material, sign in ((1, CERAMIC, -0.3), (2, STEEL, 0.3)):
            expected = operators.surface_stress(grid, p, self.depths, material.nu, sign * p)
            actual = solver.stress(p, self.depths, body)
            assert actual.shape == (6, grid.nx, grid.ny, 3)
            np.testing.assert_allclose(actual, expected, rtol=0, atol=1e-12 * p.max())
        # sigma_xz = -s on the surface: the sign tells the bodies apart
        inside = p > 0
        for body, sign in ((1, 0.3), (2, -0.3)):
            xz = solver.stress(p, [0.0], body)[4, ..., 0]
            np.testing.assert_allclose(xz[inside], sign * p[inside], rtol=0, atol=1e-9 * p.max())

    def test_prescribed_shear_replaces_friction(self):
        grid, gap, exact = scene(CERAMIC, STEEL)
        solver = sc.ContactSolver(grid, CERAMIC, STEEL, 0.3)
        p = solver.solve(gap, load=exact.load).pressure
        shear = np.stack([0.1 * p, -0.2 * p])
        for body, sign in ((1, -1.0), (2, 1.0)):
            surface = solver.stress(p, [0.0], body, shear=shear)[..., 0]
            np.testing.assert_allclose(surface[4], -sign * shear[0], rtol=0, atol=1e-9 * p.max())
            np.testing.assert_allclose(surface[3], -sign * shear[1], rtol=0, atol=1e-9 * p.max())

    def test_refuses(self):
        grid, gap, _ = scene(RIGID, STEEL)
        solver = sc.ContactSolver(grid, RIGID, STEEL)
        for call, text in (
            (lambda: solver.stress(gap, [0.0], 1), "body 1 is rigid and has no stress"),
            (lambda: solver.stress(gap, [0.0], 3), "body must be one of 1, 2, got 3"),
            (lambda: solver.stress(gap[1:], [0.0]), "pressure must have shape (31, 31), got (30,"),
            (
                lambda: solver.stress(gap, [-1.0]),
                "z must be a one-dimensional array of depths >= 0",
            ),
            (lambda: solver.stress(gap, [math.nan]), "z must be a one-dimensional array"),
            (lambda: solver.stress(gap, [0.0], shear=gap[1:]), "shear must have shape (31, 31)"),
            (
                lambda: solver.stress(gap, [0.0], shear=[gap] * 3),
                "shear must have shape (2, 31, 31",
            ),
        ):
            with pytest.raises(ValueError, match=re.escape(text)):
                call()
