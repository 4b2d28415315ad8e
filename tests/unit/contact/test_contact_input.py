# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic contact: limits, grid edges, refused arguments, and arrays of any kind."""

import math
import re
import warnings

import numpy as np
import pytest
from contact_setups import RADIUS, RIGID, STEEL, TOL, assert_complementary, penetration, problem

import samcontact as sc
from samcontact import hertz, operators, surfaces


class TestLimits:
    def test_zero_load_just_touches(self):
        grid, gap, _ = problem(RIGID, STEEL)
        solution = sc.ContactSolver(grid, RIGID, STEEL).solve(gap + 1e-6, load=0.0)
        assert solution.approach == (gap + 1e-6).min()
        assert not solution.pressure.any()
        assert (solution.load, solution.converged) == (0.0, True)
        np.testing.assert_allclose(solution.gap, gap - gap.min(), rtol=0, atol=1e-20)

    @pytest.mark.parametrize("approach", [-3e-6, 0.0, 1e-6])
    def test_approach_without_contact(self, approach):
        grid, gap, _ = problem(RIGID, STEEL)
        solution = sc.ContactSolver(grid, RIGID, STEEL).solve(gap + 1e-6, approach=approach)
        assert not solution.pressure.any()
        assert (solution.load, solution.approach, solution.converged) == (0.0, approach, True)
        np.testing.assert_allclose(solution.gap, gap + 1e-6 - approach, rtol=0, atol=1e-20)

    def test_one_cell_contact(self):
        """One cell carries the whole load and is displaced by its own Love coefficient."""
        grid = sc.Grid(7, 9, 1e-6, 2e-6)
        gap = np.full(grid.surface_shape, 1e-6)
        gap[3, 4] = 0.0
        solution = sc.ContactSolver(grid, RIGID, STEEL).solve(gap, load=1e-3)
        expected = np.zeros(grid.surface_shape)
        expected[3, 4] = 1e-3 / grid.cell_area
        np.testing.assert_allclose(solution.pressure, expected, rtol=1e-12)
        sunk = operators.surface_displacement(grid, expected, STEEL.E, STEEL.nu)[3, 4]
        assert solution.approach == pytest.approx(sunk, rel=1e-12)

    @pytest.mark.parametrize("load_factor", [1e-6, 1e-3, 1e3])
    def test_hertz_scaling_over_decades(self, load_factor):
        """Lengths of a ball scale with W^(1/3), so solutions on scaled cells agree."""
        grid, gap, exact = problem(RIGID, STEEL)
        reference = sc.ContactSolver(grid, RIGID, STEEL).solve(gap, load=exact.load)
        k = load_factor ** (1 / 3)
        other = sc.Grid(grid.nx, grid.ny, k * grid.dx, k * grid.dy)
        solution = sc.ContactSolver(other, RIGID, STEEL).solve(
            surfaces.paraboloid(other, RADIUS), load=load_factor * exact.load
        )
        np.testing.assert_allclose(
            solution.pressure / k, reference.pressure, rtol=0, atol=1e-7 * exact.p0
        )

    def test_disjoint_asperities(self):
        """Two distant spikes share the load; the higher one carries more."""
        grid = sc.Grid(61, 21, 1e-6, 1e-6)
        x, y = grid.x[:, None], grid.y[None, :]
        balls = [((x - s) ** 2 + y**2) / 2e-4 for s in (-18e-6, 18e-6)]
        solver = sc.ContactSolver(grid, RIGID, STEEL)
        gap = np.minimum(*balls)
        solution = solver.solve(gap, load=0.05)
        assert_complementary(
            grid, solution, gap, penetration(grid, solution.pressure, RIGID, STEEL), TOL
        )
        left, right = solution.pressure[:30].sum(), solution.pressure[31:].sum()
        assert left == pytest.approx(right, rel=1e-6)
        assert not solution.pressure[30].any()
        uneven = np.minimum(balls[0], balls[1] + 1e-8)
        solution = solver.solve(uneven, load=0.05)
        assert solution.pressure[:30].sum() > 1.05 * solution.pressure[31:].sum() > 0

    @pytest.mark.filterwarnings("ignore::samcontact.SingularPressureWarning")  # as is right
    def test_flat_punch(self):
        """W = 2 E* a delta, p = W/(2 pi a^2) at the centre (Johnson 1985, 3.34 and 3.36).

        The pressure is infinite at the rim, so uniform cells there err in proportion to their
        size: measured 1.6, 0.8, 0.4, 0.2 % of the load for 8, 16, 32, 64 cells per radius.
        """
        E_star = hertz.effective_modulus(RIGID, STEEL)
        errors = []
        for cells in (8, 16, 32):
            n = 2 * cells + 5
            grid = sc.Grid(n, n, 1.6e-4 / cells, 1.6e-4 / cells)
            inside = np.hypot(grid.x[:, None], grid.y[None, :]) < 1.6e-4
            radius = math.sqrt(inside.sum() * grid.cell_area / math.pi)
            gap = np.where(inside, 0.0, 1e-3)
            solution = sc.ContactSolver(grid, RIGID, STEEL).solve(gap, approach=1e-6)
            assert np.array_equal(solution.pressure > 0, inside)
            load = solution.load / (2 * E_star * radius * 1e-6) - 1
            centre = solution.pressure[n // 2, n // 2]
            pressure = centre * 2 * math.pi * radius**2 / solution.load - 1
            errors.append((load, pressure))
        errors = np.abs(errors)
        assert (errors[-1] < [0.004, 0.008]).all()
        order = np.log2(errors[0] / errors[-1]) / 2
        assert (order > 0.9).all()


class TestBorder:
    text = "the contact reaches the edge of the grid"

    def test_error_by_default(self):
        grid, gap, exact = problem(RIGID, STEEL)
        solver = sc.ContactSolver(grid, RIGID, STEEL)
        with pytest.raises(sc.GridTooSmallError, match=self.text) as caught:
            solver.solve(gap, load=8 * exact.load)
        assert isinstance(caught.value, ValueError)
        assert re.search(
            r"at load .* N .*enlarge nx dx and ny dy.*on_border=\"warn\"", str(caught.value)
        )
        assert solver.solve(gap, load=exact.load).converged

    def test_warning_on_request(self):
        grid, gap, exact = problem(RIGID, STEEL)
        solver = sc.ContactSolver(grid, RIGID, STEEL, on_border="warn")
        with pytest.warns(sc.GridTooSmallWarning, match="^at load .*" + self.text):
            solution = solver.solve(gap, load=8 * exact.load)
        displacement = penetration(grid, solution.pressure, RIGID, STEEL)
        assert_complementary(grid, solution, gap, displacement, TOL)
        with pytest.warns(sc.GridTooSmallWarning, match="^at approach .*" + self.text):
            solver.solve(gap, approach=4 * exact.approach)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            solver.solve(gap, load=exact.load)


class TestBadInput:
    @pytest.mark.parametrize(
        ("arguments", "error", "text"),
        [
            ({"grid": 5}, TypeError, "grid must be a samcontact.Grid, got 5"),
            (
                {"body1": "steel"},
                TypeError,
                "body1 must be a samcontact.Material, samcontact.Layered or "
                "samcontact.Heterogeneous, got 'steel'",
            ),
            (
                {"body2": None},
                TypeError,
                "body2 must be a samcontact.Material, samcontact.Layered or "
                "samcontact.Heterogeneous, got None",
            ),
            ({"body2": RIGID}, ValueError, "body1 and body2 are both rigid"),
            ({"friction": -0.1}, ValueError, "friction must be a finite number >= 0, got -0.1"),
            ({"friction": math.nan}, ValueError, "friction must be a finite number >= 0, got nan"),
            ({"friction": math.inf}, ValueError, "friction must be a finite number >= 0, got inf"),
            ({"friction": "0.1"}, TypeError, "friction must be a number, got '0.1'"),
            ({"tol": 0.0}, ValueError, "tol must be in [1e-13, 1), got 0.0"),
            ({"tol": 1.0}, ValueError, "tol must be in [1e-13, 1), got 1.0"),
            ({"tol": math.nan}, ValueError, "tol must be in [1e-13, 1), got nan"),
            ({"tol": "tight"}, TypeError, "tol must be a number, got 'tight'"),
            ({"on_border": "ignore"}, ValueError, "on_border must be one of 'error', 'warn', got"),
            ({"max_iterations": 0}, ValueError, "max_iterations must be an integer >= 1, got 0"),
            ({"max_iterations": 1.5}, TypeError, "max_iterations must be an integer, got 1.5"),
        ],
    )
    def test_of_the_solver(self, arguments, error, text):
        good = {"grid": sc.Grid(5, 5, 1.0, 1.0), "body1": RIGID, "body2": STEEL}
        with pytest.raises(error, match=re.escape(text)):
            sc.ContactSolver(**(good | arguments))

    @staticmethod
    def spoiled(value):
        field = np.ones((5, 4))
        field[2, 3] = value
        return field

    @pytest.mark.parametrize(
        ("arguments", "error", "text"),
        [
            ({}, ValueError, "exactly one of load, approach must be given, got none"),
            (
                {"load": 1.0, "approach": 1.0},
                ValueError,
                "exactly one of load, approach must be given, got load, approach",
            ),
            ({"load": -1.0}, ValueError, "load must be a finite number >= 0 [N], got -1"),
            ({"load": math.nan}, ValueError, "load must be a finite number >= 0 [N], got nan"),
            ({"load": math.inf}, ValueError, "load must be a finite number >= 0 [N], got inf"),
            ({"load": "1"}, TypeError, "load must be a number, got '1'"),
            ({"load": [1.0]}, TypeError, "load must be a number, got [1.0]"),
            ({"load": True}, TypeError, "load must be a number, got True"),
            ({"approach": math.nan}, ValueError, "approach must be a finite number [m], got nan"),
            ({"approach": -math.inf}, ValueError, "approach must be a finite number [m], got -inf"),
            (
                {"gap": np.ones((4, 5)), "load": 1.0},
                ValueError,
                "gap must have shape (5, 4), got (4, 5)",
            ),
            (
                {"gap": np.ones(20), "load": 1.0},
                ValueError,
                "gap must have shape (5, 4), got (20,)",
            ),
            (
                {"gap": spoiled(math.nan), "load": 1.0},
                ValueError,
                "or +inf where there is no body, got nan at index (2, 3)",
            ),
            (
                {"gap": spoiled(-math.inf), "load": 1.0},
                ValueError,
                "or +inf where there is no body, got -inf at index (2, 3)",
            ),
            ({"gap": "flat", "load": 1.0}, TypeError, "gap must be an array of numbers, got texts"),
            (
                {"load": 1.0, "initial_pressure": spoiled(math.nan)},
                ValueError,
                "initial_pressure must be finite everywhere, got nan at index (2, 3)",
            ),
            (
                {"load": 1.0, "initial_pressure": np.ones(5)},
                ValueError,
                "initial_pressure must have shape (5, 4), got (5,)",
            ),
        ],
    )
    def test_of_solve(self, arguments, error, text):
        solver = sc.ContactSolver(sc.Grid(5, 4, 1.0, 1.0), RIGID, STEEL)
        with pytest.raises(error, match=re.escape(text)):
            solver.solve(**({"gap": np.zeros((5, 4))} | arguments))


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_no_convergence(friction):
    grid, gap, exact = problem(RIGID, STEEL)
    solver = sc.ContactSolver(grid, RIGID, STEEL, friction, max_iterations=2)
    text = r"contact did not converge at load .* N: error .* after 2 iterations, tol 1e-08"
    with pytest.raises(sc.ConvergenceError, match=text) as caught:
        solver.solve(gap, load=exact.load)
    assert isinstance(caught.value, RuntimeError)
    assert caught.value.iterations == 2
    assert TOL < caught.value.residual <= 1


def test_arrays_of_any_kind_and_layout():
    grid, gap, exact = problem(RIGID, STEEL)
    solver = sc.ContactSolver(grid, RIGID, STEEL)
    expected = solver.solve(gap, load=exact.load).pressure
    for same in (np.asfortranarray(gap), gap.tolist(), np.repeat(gap, 2, axis=0)[::2]):
        np.testing.assert_array_equal(solver.solve(same, load=exact.load).pressure, expected)
    load = np.float64(exact.load)
    np.testing.assert_array_equal(solver.solve(gap, load=load).pressure, expected)
