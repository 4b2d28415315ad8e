# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic contact: complementarity checked apart from the solver, drivers, friction, bad input."""

import math
import re
import warnings

import numpy as np
import pytest
import scipy.optimize
import scipy.signal

import samcontact as sc
from samcontact import hertz, operators, surfaces

STEEL = sc.Material.elastic(210e9, 0.3)
CERAMIC = sc.Material.elastic(310e9, 0.29)
RUBBER = sc.Material.elastic(1e7, 0.49)
RIGID = sc.Material.rigid()
PAIRS = {
    "rigid on steel": (RIGID, STEEL),
    "steel on rigid": (STEEL, RIGID),
    "ceramic on steel": (CERAMIC, STEEL),
    "rubber on steel": (RUBBER, STEEL),
    "steel on steel": (STEEL, STEEL),
}
RADIUS, CELLS = 10e-3, 12
TOL = 1e-8


def scene(body1, body2, p0_over_E=0.02, n=31):
    """Grid of n x n cells, CELLS of them per contact radius, ball gap, and load of that pressure.

    The y cells are longer by a tenth, so that nothing hides behind the symmetry of the grid.
    """
    E_star = hertz.effective_modulus(body1, body2)
    exact = hertz.point(R=RADIUS, E_star=E_star, p0=p0_over_E * E_star)
    dx = exact.a / CELLS
    grid = sc.Grid(n, n, dx, 1.1 * dx)
    return grid, surfaces.paraboloid(grid, RADIUS), exact


def penetration(grid, pressure, body1, body2, friction=0.0):
    """u_z of both bodies added [m]: what closes the gap, from the operators of one half-space."""
    total = np.zeros(grid.surface_shape)
    for body, sign in ((body1, -1.0), (body2, 1.0)):
        if not body.is_rigid:
            shear = sign * friction * pressure
            total += operators.surface_displacement(grid, pressure, body.E, body.nu, shear)
    return total


def assert_complementary(grid, solution, gap, displacement, tol):
    """p >= 0, g >= 0, p g = 0 and the load, with g from `displacement`, scaled as documented.

    Both sides of the gap are differences of terms as large as max u: a hundred ulp of that more.
    """
    p, scale = solution.pressure, displacement.max()
    g = gap + displacement - solution.approach
    slack = tol + 1e-13
    np.testing.assert_allclose(solution.gap, g, rtol=0, atol=slack * scale)
    assert p.min() >= 0
    assert np.abs(np.minimum(p / p.max(), g / scale)).max() <= slack
    assert p.sum() * grid.cell_area == pytest.approx(solution.load, rel=1e-12)


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


def test_only_the_contact_modulus_counts_without_friction():
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
    def test_few_cells_whose_coupling_is_uniform(self, pair):
        """Two by two cells: what the shear adds to their gaps is the same, and still moves them."""
        grid = sc.Grid(8, 8, 1.5e-5, 1.5e-5)
        gap = surfaces.paraboloid(grid, RADIUS)
        solution = sc.ContactSolver(grid, *pair, 1.0).solve(gap, load=0.1)
        assert np.count_nonzero(solution.pressure) == 4
        displacement = penetration(grid, solution.pressure, *pair, 1.0)
        assert_complementary(grid, solution, gap, displacement, TOL)

    def test_incompressible_on_rigid_is_not_coupled(self):
        """The coupling has the factor 1 - 2 nu, so it fades as nu goes to 0.5."""
        shifts = []
        for nu in (0.3, 0.4, 0.4999):
            body = sc.Material.elastic(210e9, nu)
            grid, gap, exact = scene(RIGID, body)
            p = sc.ContactSolver(grid, RIGID, body, 0.4).solve(gap, load=exact.load).pressure
            shifts.append(abs((p * grid.x[:, None]).sum() / p.sum()) / exact.a)
        assert shifts[0] > shifts[1] > 100 * shifts[2]
        # Dundurs' beta, (1 - 2 nu)/(2 (1 - nu)), rules the shift.
        assert shifts[1] / shifts[0] == pytest.approx((0.2 / 1.2) / (0.4 / 1.4), rel=0.05)

    def test_exchange_of_the_bodies_mirrors_in_x(self):
        """Body 2 is dragged in +x by body 1; seen from the other side, body 1 in -x."""
        grid, gap, exact = scene(RIGID, STEEL)
        below = sc.ContactSolver(grid, RIGID, STEEL, 0.4).solve(gap, load=exact.load).pressure
        above = sc.ContactSolver(grid, STEEL, RIGID, 0.4).solve(gap, load=exact.load).pressure
        np.testing.assert_allclose(above, below[::-1], rtol=0, atol=1e-6 * below.max())
        assert np.abs(below - below[::-1]).max() > 0.01 * below.max()

    def test_pressure_moves_the_way_the_coupling_says(self):
        """Where u_z of the shear raises the surface (u_z < 0), the pressure grows."""
        grid, gap, exact = scene(RIGID, STEEL)
        free = sc.ContactSolver(grid, RIGID, STEEL).solve(gap, load=exact.load).pressure
        rubbed = sc.ContactSolver(grid, RIGID, STEEL, 0.4).solve(gap, load=exact.load).pressure
        shear = 0.4 * free
        both = operators.surface_displacement(grid, free, STEEL.E, STEEL.nu, shear)
        lift = operators.surface_displacement(grid, free, STEEL.E, STEEL.nu) - both
        assert ((rubbed - free) * lift).sum() > 0


class TestWarmStart:
    def test_same_answer_in_fewer_iterations(self):
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

    def test_any_start_is_good(self):
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


class TestLimits:
    def test_zero_load_just_touches(self):
        grid, gap, _ = scene(RIGID, STEEL)
        solution = sc.ContactSolver(grid, RIGID, STEEL).solve(gap + 1e-6, load=0.0)
        assert solution.approach == (gap + 1e-6).min()
        assert not solution.pressure.any()
        assert (solution.load, solution.converged) == (0.0, True)
        np.testing.assert_allclose(solution.gap, gap - gap.min(), rtol=0, atol=1e-20)

    @pytest.mark.parametrize("approach", [-3e-6, 0.0, 1e-6])
    def test_approach_that_does_not_touch(self, approach):
        grid, gap, _ = scene(RIGID, STEEL)
        solution = sc.ContactSolver(grid, RIGID, STEEL).solve(gap + 1e-6, approach=approach)
        assert not solution.pressure.any()
        assert (solution.load, solution.approach, solution.converged) == (0.0, approach, True)
        np.testing.assert_allclose(solution.gap, gap + 1e-6 - approach, rtol=0, atol=1e-20)

    def test_one_cell_contact(self):
        """A spike: one cell carries all, and sinks in by its own Love coefficient."""
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
        """A ball is self-similar: lengths scale with W^(1/3), so the same cells, scaled, agree."""
        grid, gap, exact = scene(RIGID, STEEL)
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
        """Two spikes far apart share the load; one deeper than the other carries more."""
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
    text = "the contact touches the border of the grid"

    def test_error_by_default(self):
        grid, gap, exact = scene(RIGID, STEEL)
        solver = sc.ContactSolver(grid, RIGID, STEEL)
        with pytest.raises(sc.GridTooSmallError, match=self.text) as caught:
            solver.solve(gap, load=8 * exact.load)
        assert isinstance(caught.value, ValueError)
        assert re.search(
            r"at load .* N .*enlarge nx dx and ny dy.*on_border=\"warn\"", str(caught.value)
        )
        assert solver.solve(gap, load=exact.load).converged

    def test_warning_on_request(self):
        grid, gap, exact = scene(RIGID, STEEL)
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


class TestStress:
    depths = (0.0, 2e-5, 1e-3)

    def test_is_that_of_the_tractions_on_each_body(self):
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

    def test_given_shear_replaces_friction(self):
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
            (lambda: solver.stress(gap, [0.0], 1), "body 1 is rigid: it has no stress"),
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


class TestBadInput:
    @pytest.mark.parametrize(
        ("arguments", "error", "text"),
        [
            ({"grid": 5}, TypeError, "grid must be a samcontact.Grid, got 5"),
            ({"body1": "steel"}, TypeError, "body1 must be a samcontact.Material, got 'steel'"),
            ({"body2": None}, TypeError, "body2 must be a samcontact.Material, got None"),
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
            ({}, ValueError, "give exactly one of load, approach; got none"),
            (
                {"load": 1.0, "approach": 1.0},
                ValueError,
                "give exactly one of load, approach; got load, approach",
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
                "gap must be finite everywhere, got nan at index (2, 3)",
            ),
            (
                {"gap": spoiled(-math.inf), "load": 1.0},
                ValueError,
                "gap must be finite everywhere, got -inf at index (2, 3)",
            ),
            ({"gap": "flat", "load": 1.0}, TypeError, "gap must be an array of numbers, got str"),
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
    grid, gap, exact = scene(RIGID, STEEL)
    solver = sc.ContactSolver(grid, RIGID, STEEL, friction, max_iterations=2)
    text = r"contact did not converge at load .* N: error .* after 2 iterations, tol 1e-08"
    with pytest.raises(sc.ConvergenceError, match=text) as caught:
        solver.solve(gap, load=exact.load)
    assert isinstance(caught.value, RuntimeError)
    assert caught.value.iterations == 2
    assert TOL < caught.value.residual <= 1


def test_arrays_of_any_kind_and_layout():
    grid, gap, exact = scene(RIGID, STEEL)
    solver = sc.ContactSolver(grid, RIGID, STEEL)
    expected = solver.solve(gap, load=exact.load).pressure
    for same in (np.asfortranarray(gap), gap.tolist(), np.repeat(gap, 2, axis=0)[::2]):
        np.testing.assert_array_equal(solver.solve(same, load=exact.load).pressure, expected)
    load = np.float64(exact.load)
    np.testing.assert_array_equal(solver.solve(gap, load=load).pressure, expected)


def convolved(grid, pressure, body):
    """u_z by SciPy's convolution with coefficients of `sc.kernels`: nothing of the solver's."""
    i, j = np.arange(1 - grid.nx, grid.nx), np.arange(1 - grid.ny, grid.ny)
    X, Y = np.meshgrid(i * grid.dx, j * grid.dy, indexing="ij")
    K = sc.kernels.pressure_displacement(X, Y, grid.dx / 2, grid.dy / 2, body.E, body.nu)
    return scipy.signal.fftconvolve(K, pressure, mode="valid")


def rough_scene(n, hurst=0.8, cutoff=4, fraction=0.1, seed=1):
    """n x n cells of a rough flat, roll-off at n/8 cells, and the load on about that fraction.

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

    Bounds are the measured counts (table in docs/theory.md) plus one application, a fifth of the
    steps and a quarter of the work: on another machine only rounding can change them. The plain
    conjugate gradient takes 107 applications for the ball, 148 for the rough surface, 685 at
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
        # as in a plastic fixed point: the gap changes a little, and two digits are wanted from it
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

    def test_apart_costs_nothing(self):
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
        """Nothing is smooth here: coarser grids know nothing of the contact."""
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

    def test_full_contact_to_the_least_tol(self):
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
    def test_extends_to_what_touches_later(self, height):
        """Fine roughness on the ball lets the approach grow after the first look at the grid."""
        grid = sc.Grid(256, 128, 1e-6, 1e-6)
        x, y = grid.x[:, None], grid.y[None, :]
        noise = 20e-9 * np.random.default_rng(3).random(grid.surface_shape)
        ball = ((x + 80e-6) ** 2 + y**2) / 2e-2 + noise
        gap = np.minimum(ball, ((x - 90e-6) ** 2 + y**2) / 2e-2 + height)
        solution = sc.ContactSolver(grid, RIGID, STEEL).solve(gap, load=0.05)
        assert_complementary(grid, solution, gap, convolved(grid, solution.pressure, STEEL), TOL)
