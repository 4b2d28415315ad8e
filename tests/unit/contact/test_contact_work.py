# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic contact: number of transforms, and equal pressure from other solvers."""

import math
import warnings

import numpy as np
import pytest
import scipy.optimize
import scipy.signal
from contact_setups import RADIUS, RIGID, STEEL, TOL, assert_complementary, scene

import samcontact as sc
from samcontact import hertz, surfaces


def convolved(grid, pressure, body):
    """Return u_z by SciPy's convolution with coefficients of `sc.kernels`, without the solver."""
    i, j = np.arange(1 - grid.nx, grid.nx), np.arange(1 - grid.ny, grid.ny)
    X, Y = np.meshgrid(i * grid.dx, j * grid.dy, indexing="ij")
    K = sc.kernels.pressure_displacement(X, Y, grid.dx / 2, grid.dy / 2, body.E, body.nu)
    return scipy.signal.fftconvolve(K, pressure, mode="valid")


def rough_scene(n, hurst=0.8, cutoff=4, fraction=0.1, seed=1):
    """Return a rough flat of n x n cells, roll-off at n/8 cells, and the load for this fraction.

    The real contact is 2 W/(E* rms slope) of the area (Persson 2001: 1.6 to 2, low loads).
    """
    grid = sc.Grid(n, n, 1e-6, 1e-6)
    heights = surfaces.rough_self_affine(
        grid, 1e-7, hurst, wavelength_min=cutoff * 1e-6, roll_off=n / 8 * 1e-6, seed=seed
    )
    slope = math.sqrt(2) * np.diff(heights, axis=0).std() / grid.dx
    E_star = hertz.effective_modulus(RIGID, STEEL)
    load = fraction * E_star * slope * (n * 1e-6) ** 2 / 2
    return grid, heights - heights.min(), load


class TestWork:
    """Counts of exact displacements and of all transforms.

    Bounds are the measured counts (table in docs/theory/contact.md) plus one application, a fifth
    of the steps and a quarter of the work: on another machine only rounding can change them. The
    plain conjugate gradient takes 107 applications for the ball, 148 for the rough surface, 685 at
    1024 x 1024.
    """

    def test_ball(self):
        grid = sc.Grid(256, 256, 1e-6, 1e-6)
        gap = surfaces.paraboloid(grid, 10e-3)
        solver = sc.ContactSolver(grid, RIGID, STEEL)
        by_approach = solver.solve(gap, approach=(64e-6) ** 2 / 10e-3)
        by_load = solver.solve(gap, load=by_approach.load)
        for solution in (by_approach, by_load):
            assert solution.operator_applications <= 4
            assert solution.iterations <= 12
            assert solution.work <= 12
            assert solution.error <= 1e-8

    @pytest.mark.parametrize("hurst", [0.3, 0.8])
    def test_rough(self, hurst):
        grid, gap, load = rough_scene(256, hurst)
        solver = sc.ContactSolver(grid, RIGID, STEEL, on_border="warn")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", sc.GridTooSmallWarning)
            by_load = solver.solve(gap, load=load)
            by_approach = solver.solve(gap, approach=by_load.approach)
        for solution in (by_load, by_approach):
            assert 0.07 < (solution.pressure > 0).mean() < 0.14
            assert solution.operator_applications <= 5
            assert solution.work <= 50
            displacement = convolved(grid, solution.pressure, STEEL)
            assert_complementary(grid, solution, gap, displacement, TOL)
        difference = np.abs(by_load.pressure - by_approach.pressure).max()
        assert difference < 1e-6 * by_load.pressure.max()

    @pytest.mark.slow
    @pytest.mark.parametrize("hurst", [0.3, 0.8])
    def test_rough_at_1024(self, hurst):
        grid, gap, load = rough_scene(1024, hurst)
        solver = sc.ContactSolver(grid, RIGID, STEEL, on_border="warn")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", sc.GridTooSmallWarning)
            by_load = solver.solve(gap, load=load)
            by_approach = solver.solve(gap, approach=by_load.approach)
        for solution in (by_load, by_approach):
            assert 0.07 < (solution.pressure > 0).mean() < 0.14
            assert solution.operator_applications <= 5
            assert solution.work <= 80
            displacement = convolved(grid, solution.pressure, STEEL)
            assert_complementary(grid, solution, gap, displacement, TOL)

    @pytest.mark.parametrize("n", [31, 128])
    def test_warm_start(self, n):
        grid, gap, exact = scene(RIGID, STEEL, n=n)
        solver = sc.ContactSolver(grid, RIGID, STEEL)
        cold = solver.solve(gap, load=exact.load)
        again = solver.solve(gap, load=exact.load, initial_pressure=cold.pressure)
        assert (again.operator_applications, again.iterations, again.work) == (1, 0, 1.0)
        # as in a plastic fixed point: the gap changes slightly, and two digits are sufficient
        steps = []
        start = cold.pressure
        loose = sc.ContactSolver(grid, RIGID, STEEL, tol=1e-6)
        for k in range(1, 6):
            bent = gap * (1 + 1e-4 * np.sin(k * gap / gap.max()))
            solution = loose.solve(bent, load=exact.load, initial_pressure=start)
            start = solution.pressure
            steps.append(solution.iterations)
            assert solution.operator_applications <= 3
        assert np.mean(steps) <= 5

    def test_friction_starts_from_the_last_pressure(self):
        grid, gap, exact = scene(RIGID, STEEL)
        free = sc.ContactSolver(grid, RIGID, STEEL).solve(gap, load=exact.load)
        rubbed = sc.ContactSolver(grid, RIGID, STEEL, 0.3).solve(gap, load=exact.load)
        assert rubbed.operator_applications > free.operator_applications
        # measured: 18 steps for all solves of the fixed point, 10 for the first alone
        assert rubbed.iterations <= 2.5 * free.iterations

    def test_separated_bodies_cost_nothing(self):
        grid, gap, _ = scene(RIGID, STEEL)
        solution = sc.ContactSolver(grid, RIGID, STEEL).solve(gap, load=0.0)
        assert (solution.iterations, solution.operator_applications, solution.work) == (0, 0, 0.0)


class TestAgainstOtherSolvers:
    @pytest.mark.parametrize("shape", [(7, 9), (12, 6)])
    @pytest.mark.parametrize("seed", [1, 2, 3])
    def test_non_negative_least_squares(self, shape, seed):
        """min |L' p - L^-1 (d - h)| over p >= 0, K = L L', has the conditions of contact."""
        grid = sc.Grid(*shape, 1e-6, 1.3e-6)
        gap = 1e-8 * np.random.default_rng(seed).random(shape)
        approach = 6e-9
        unit = np.eye(gap.size).reshape(-1, *shape)
        K = np.array([convolved(grid, p, STEEL).ravel() for p in unit])
        L = np.linalg.cholesky((K + K.T) / 2)
        expected, _ = scipy.optimize.nnls(L.T, np.linalg.solve(L, approach - gap.ravel()))
        solver = sc.ContactSolver(grid, RIGID, STEEL, tol=1e-12, on_border="warn")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", sc.GridTooSmallWarning)
            solution = solver.solve(gap, approach=approach)
            by_load = solver.solve(gap, load=solution.load)
        assert 0 < (expected > 0).sum() < gap.size
        for found in (solution, by_load):
            np.testing.assert_allclose(
                found.pressure.ravel(), expected, rtol=0, atol=1e-8 * expected.max()
            )

    @pytest.mark.parametrize("shape", [(128, 66), (101, 65), (300, 9)])
    @pytest.mark.parametrize("aspect", [0.2, 1.0, 6.0])
    def test_white_noise(self, shape, aspect):
        """White noise has no smooth part, so coarser grids give no information."""
        grid = sc.Grid(*shape, 1e-6, aspect * 1e-6)
        gap = 1e-8 * np.random.default_rng(5).random(shape)
        load = 0.002 * STEEL.E * grid.cell_area * gap.size
        solver = sc.ContactSolver(grid, RIGID, STEEL, on_border="warn")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", sc.GridTooSmallWarning)
            solution = solver.solve(gap, load=load)
        displacement = convolved(grid, solution.pressure, STEEL)
        assert_complementary(grid, solution, gap, displacement, TOL)
        assert 0.05 < (solution.pressure > 0).mean() < 0.95
        assert solution.operator_applications <= 12

    def test_full_contact(self):
        grid = sc.Grid(70, 80, 1e-6, 1e-6)
        gap = surfaces.sinusoidal(grid, 1e-10, 35e-6, 20e-6)
        gap -= gap.min()
        solver = sc.ContactSolver(grid, RIGID, STEEL, on_border="warn")
        with pytest.warns(sc.GridTooSmallWarning):
            solution = solver.solve(gap, approach=1e-6)
        assert solution.pressure.min() > 0
        displacement = convolved(grid, solution.pressure, STEEL)
        np.testing.assert_allclose(gap + displacement, 1e-6, rtol=0, atol=TOL * 1e-6)

    def test_full_contact_to_the_smallest_tol(self):
        """The mean gap of thousands of loaded cells must be rounded by less than tol."""
        grid = sc.Grid(100, 100, 1e-5, 1e-5)
        solver = sc.ContactSolver(grid, RIGID, STEEL, tol=1e-13, on_border="warn")
        with pytest.warns(sc.GridTooSmallWarning):
            solution = solver.solve(np.zeros(grid.surface_shape), load=10.0)
        assert solution.error <= 1e-13
        assert solution.iterations < 40


class TestBoundingBox:
    """A contact that fills a small part of the grid is solved on that part."""

    def test_same_pressure_as_on_a_grid_of_its_own(self):
        E_star = hertz.effective_modulus(RIGID, STEEL)
        exact = hertz.point(R=RADIUS, E_star=E_star, p0=0.02 * E_star)
        solutions = []
        for n in (51, 251):
            grid = sc.Grid(n, n, exact.a / 16, exact.a / 16)
            gap = surfaces.paraboloid(grid, RADIUS)
            solver = sc.ContactSolver(grid, RIGID, STEEL, tol=1e-10)
            solutions.append(solver.solve(gap, load=exact.load))
        small, large = solutions
        inner = large.pressure[100:-100, 100:-100]
        np.testing.assert_allclose(inner, small.pressure, rtol=0, atol=1e-7 * exact.p0)
        assert np.count_nonzero(large.pressure) == np.count_nonzero(inner)
        assert large.approach == pytest.approx(small.approach, rel=1e-9)
        assert large.work < 10  # mostly exact evaluations

    def test_off_centre(self):
        grid = sc.Grid(200, 160, 1e-6, 1e-6)
        x, y = grid.x[:, None] - 85e-6, grid.y[None, :] + 60e-6
        gap = (x**2 + y**2) / 2e-2
        solution = sc.ContactSolver(grid, RIGID, STEEL).solve(gap, approach=5e-9)
        assert_complementary(grid, solution, gap, convolved(grid, solution.pressure, STEEL), TOL)

    @pytest.mark.parametrize("height", np.linspace(0.0, 20e-9, 6))
    def test_the_box_is_extended_to_later_contact(self, height):
        """Fine roughness increases the approach after the first estimate of the contact box."""
        grid = sc.Grid(256, 128, 1e-6, 1e-6)
        x, y = grid.x[:, None], grid.y[None, :]
        noise = 20e-9 * np.random.default_rng(3).random(grid.surface_shape)
        ball = ((x + 80e-6) ** 2 + y**2) / 2e-2 + noise
        gap = np.minimum(ball, ((x - 90e-6) ** 2 + y**2) / 2e-2 + height)
        solution = sc.ContactSolver(grid, RIGID, STEEL).solve(gap, load=0.05)
        assert_complementary(grid, solution, gap, convolved(grid, solution.pressure, STEEL), TOL)
