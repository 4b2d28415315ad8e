# SPDX-License-Identifier: GPL-3.0-or-later
"""Influence of a heat source against point sources, frequency responses, and thermoelasticity.

Inside this file lengths are in units of LENGTH, ages are kappa t / LENGTH^2 and speeds V LENGTH /
kappa, as the oracles take them; `temperature`, `displacement` and `stress` below translate to SI.
Tolerances on tables are those asked for, relative to the largest value; the oracles are better.
"""

import itertools
import signal

import numpy as np
import pytest
from scipy.special import erfc

from oracles import heat, quadrature
from samcontact import heat_kernels

LENGTH = 2.5e-5
E, NU, EXPANSION = 210e9, 0.3, 1.2e-5
CONDUCTIVITY, DIFFUSIVITY = 45.0, 1.25e-5
INF = float("inf")
AT_REST = (0.0, 0.0)
STRESS_SCALE = E * EXPANSION / (1 - NU) / CONDUCTIVITY * LENGTH
DISPLACEMENT_SCALE = EXPANSION * (1 + NU) / CONDUCTIVITY * LENGTH**2
# Sign of each component under x -> -x and y -> -y, and components after exchange of x and y.
MIRROR_X = np.array([1, 1, 1, 1, -1, -1])[:, None, None]
MIRROR_Y = np.array([1, 1, 1, -1, 1, -1])[:, None, None]
SWAP = [1, 0, 2, 4, 3, 5]

HALF = (0.5, 0.35)
# Offsets on, in, next to and far from a source of these half sizes.
X = np.array([-3.0, -1.0, -0.5, 0.0, 0.2, 1.0, 4.0])
Y = np.array([-2.0, 0.0, 0.35, 1.5])
# (age, speed): young and old at rest; moving transient; moving steady with Peclet numbers V a/kappa
# of 0.1, 1 and 10, along an axis and not.
REGIMES = [
    (0.02, AT_REST),
    (3.0, AT_REST),
    (400.0, AT_REST),
    (0.1, (1.0, 0.5)),
    (2.0, (-8.0, 3.0)),
    (INF, (0.2, 0.0)),
    (INF, (0.0, 2.0)),
    (INF, (16.0, -12.0)),
]
MOVING = REGIMES[3:]


def history(age, speed):
    return {
        "diffusivity": DIFFUSIVITY,
        "time": age * LENGTH**2 / DIFFUSIVITY,
        "velocity": tuple(s * DIFFUSIVITY / LENGTH for s in speed),
    }


def metres(*values):
    return [LENGTH * np.asarray(v) for v in values]


def sizes(half):
    return {"a": LENGTH * half[0], "b": LENGTH * half[1]}


def temperature(x, y, z, half, age, speed, tol=1e-6):
    values = heat_kernels.temperature(
        *metres(x, y, z), **sizes(half), conductivity=CONDUCTIVITY, **history(age, speed), tol=tol
    )
    return values * CONDUCTIVITY / LENGTH


def displacement(x, y, half, age, speed, tol=1e-6):
    values = heat_kernels.displacement(
        *metres(x, y),
        **sizes(half),
        nu=NU,
        expansion=EXPANSION,
        conductivity=CONDUCTIVITY,
        **history(age, speed),
        tol=tol,
    )
    return values / DISPLACEMENT_SCALE


def stress(x, y, z, half, age, speed, tol=1e-6, nu=NU):
    values = heat_kernels.stress(
        *metres(x, y, z),
        **sizes(half),
        E=E,
        nu=nu,
        expansion=EXPANSION,
        conductivity=CONDUCTIVITY,
        **history(age, speed),
        tol=tol,
    )
    return values / STRESS_SCALE * (1 - nu) / (1 - NU)


def steady_temperature(x, y, z, half):
    values = heat_kernels.steady_temperature(
        *metres(x, y, z), **sizes(half), conductivity=CONDUCTIVITY
    )
    return values * CONDUCTIVITY / LENGTH


def steady_stress(x, y, z, half):
    values = heat_kernels.steady_stress(
        *metres(x, y, z), **sizes(half), E=E, expansion=EXPANSION, conductivity=CONDUCTIVITY
    )
    return values / STRESS_SCALE


def steady_displacement(x, y, half, r0):
    values = heat_kernels.steady_displacement(
        *metres(x, y),
        **sizes(half),
        nu=NU,
        expansion=EXPANSION,
        conductivity=CONDUCTIVITY,
        r0=r0 * LENGTH,
    )
    return values / DISPLACEMENT_SCALE


def error(actual, expected):
    return float(np.abs(actual - expected).max() / np.abs(expected).max())


def over(x, y, function):
    return np.array([[function(i, j) for j in y] for i in x])


RECTANGLES = ((0.5, 0.5), (0.5, 4.0), (4.0, 0.5), (0.5, 0.35))
# In half sides: centre, inside, on an edge, on a corner, just off, above an edge line, far on both
# sides of the change to Gauss points at 30 sizes, 1000 cells away.
PLACES = (
    (0.0, 0.0),
    (0.3, -0.6),
    (1.0, 0.3),
    (-1.0, 1.0),
    (1.001, 0.5),
    (1.0, 1.7),
    (-20.0, 21.0),
    (22.0, 21.0),
    (2000.0, -300.0),
)


@pytest.mark.parametrize("half", RECTANGLES)
class TestSteadyAtRest:
    def test_temperature(self, half):
        for (p, q), z in itertools.product(PLACES, (0.0, 0.01, 0.7, 30.0)):
            x, y = p * half[0], q * half[1]
            expected = heat.temperature(x, y, z, *half, INF, AT_REST)
            np.testing.assert_allclose(steady_temperature(x, y, z, half), expected, rtol=1e-11)

    def test_stress(self, half):
        """The point source's Airy function, integrated; in the surface it is sigma = E alpha/(2 pi
        k) times -x^2/r^3, -y^2/r^3, -x y/r^3."""
        for (p, q), z in itertools.product(PLACES, (0.0, 0.01, 0.7, 30.0)):
            x, y = p * half[0], q * half[1]
            height = max(z, quadrature.LIMIT_HEIGHT * min(half))
            u, v, weight = quadrature.points(
                -half[0] - x, half[0] - x, -half[1] - y, half[1] - y, height
            )
            R = np.sqrt(u * u + v * v + height**2)
            cube = 1 / (R * (R + height) ** 2)
            plane = np.array([u * u * cube, v * v * cube, u * v * cube])
            plane[:2] += height / (R * (R + height))
            expected = -plane @ weight * (1 - NU) / (2 * np.pi)
            actual = steady_stress(x, y, z, half)
            # xy vanishes on the axes
            np.testing.assert_allclose(
                actual[[0, 1, 5]], expected, rtol=1e-10, atol=1e-11 * np.abs(expected).max()
            )
            assert not actual[2:5].any()

    def test_displacement(self, half):
        for (p, q), r0 in itertools.product(PLACES, (0.3, 100.0)):
            x, y = p * half[0], q * half[1]
            u, v, weight = quadrature.points(
                -half[0] - x, half[0] - x, -half[1] - y, half[1] - y, 1e-14 * min(half)
            )
            expected = np.log(np.hypot(u, v) / r0) @ weight / (2 * np.pi)
            np.testing.assert_allclose(
                steady_displacement(x, y, half, r0), expected, rtol=1e-10, atol=1e-13
            )

    def test_trace(self, half):
        x, y = np.linspace(-50, 50, 37)[:, None], np.linspace(-50, 50, 41)
        for z in (0.0, 0.3, 8.0):
            trace = steady_stress(x, y, z, half)[:2].sum(axis=0)
            np.testing.assert_allclose(
                trace, -(1 - NU) * steady_temperature(x, y, z, half), rtol=1e-10
            )


def test_steady_stress_against_its_frequency_response():
    points = [(0.0, 0.0), (0.7, 0.3), (-1.2, 0.9)]
    expected = heat.stress(points, 0.8, *HALF, NU, INF, AT_REST)
    x, y = np.transpose(points)
    assert error(steady_stress(x, y, 0.8, HALF), expected) < 1e-9


def test_round_sources():
    """Centre of a uniform disc, q a/k; centre of a semi-ellipsoid of flux, pi q0 a/4 k."""
    n, radius = 240, 20.0
    cell = 2 * radius / n
    at = (np.arange(n) - (n - 1) / 2) * cell
    r2 = at[:, None] ** 2 + at**2
    rise = steady_temperature(at[:, None], at, 0.0, (cell / 2, cell / 2))
    disc = (rise * (r2 < radius**2)).sum()
    # the jump on the rim is resolved to about a cell, in both directions
    assert disc == pytest.approx(radius, rel=1e-3)
    ellipsoid = (rise * np.sqrt(np.maximum(1 - r2 / radius**2, 0.0))).sum()
    assert ellipsoid == pytest.approx(np.pi * radius / 4, rel=2e-4)


@pytest.mark.parametrize(("age", "speed"), REGIMES)
@pytest.mark.parametrize("tol", [1e-3, 1e-6, 1e-9])
class TestTablesAgainstPointSources:
    def test_temperature(self, age, speed, tol):
        for z in (0.0, 0.05, 0.8):
            expected = over(X, Y, lambda x, y, z=z: heat.temperature(x, y, z, *HALF, age, speed))
            assert error(temperature(X, Y, z, HALF, age, speed, tol), expected) < tol

    def test_displacement(self, age, speed, tol):
        expected = over(X[2:5], Y[1:3], lambda x, y: heat.displacement(x, y, *HALF, age, speed))
        actual = displacement(X, Y, HALF, age, speed, tol)
        assert error(actual[2:5, 1:3], expected) < tol


@pytest.mark.parametrize(("age", "speed", "z"), [(*r, 0.8) for r in REGIMES[1:]])
def test_stress_against_frequency_response(age, speed, z):
    points = [(X[i], Y[j]) for i, j in ((3, 1), (4, 2), (1, 1), (5, 3))]
    expected = heat.stress(points, z, *HALF, NU, age, speed)
    for tol in (1e-3, 1e-6, 1e-9):
        table = stress(X, Y, z, HALF, age, speed, tol)
        actual = np.transpose([table[:, i, j] for i, j in ((3, 1), (4, 2), (1, 1), (5, 3))])
        assert error(actual, expected) < tol


# Central differences of eighth order: first and second derivative on nine points.
FIRST = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 0, 4 / 5, -1 / 5, 4 / 105, -1 / 280])
SECOND = np.array([-1 / 560, 8 / 315, -1 / 5, 8 / 5, -205 / 72, 8 / 5, -1 / 5, 8 / 315, -1 / 560])
TENSOR = np.array([[0, 5, 4], [5, 1, 3], [4, 3, 2]])


@pytest.mark.parametrize(("age", "speed"), [REGIMES[n] for n in (1, 3, 4, 5, 7)])
def test_thermoelastic_equations(age, speed):
    """Equilibrium, and Beltrami-Michell compatibility with the temperature: lap sigma_ij +
    s_kk,ij/(1 + nu) + E alpha (T,ij/(1 + nu) + delta_ij lap T/(1 - nu)) = 0. The tolerances are the
    errors of the differences in the thermal layer of the fastest source."""
    step, centre = 0.04, (0.4, -0.3, 0.8)
    x, y, z = (c + step * np.arange(-4, 5) for c in centre)
    s = np.stack([stress(x, y, d, HALF, age, speed, 1e-11) for d in z], axis=-1) / (1 - NU)
    T = np.stack([temperature(x, y, d, HALF, age, speed, 1e-11) for d in z], axis=-1)
    first, second = FIRST / step, SECOND / step**2
    here = np.eye(9)[4]

    def derivative(field, *axes):
        stencils = [here, here, here]
        for axis in set(axes):
            stencils[axis] = second if axes.count(axis) == 2 else first
        return np.einsum("...ijk,i,j,k->...", field, *stencils)

    terms = np.array([derivative(s[TENSOR[n]], n) for n in range(3)])
    assert np.abs(terms.sum(axis=0)).max() < 1e-6 * np.abs(terms).max()

    def laplacian(field):
        return sum(derivative(field, n, n) for n in range(3))

    trace, lap_T = s[:3].sum(axis=0), laplacian(T)
    for i, j in itertools.combinations_with_replacement(range(3), 2):
        parts = [
            laplacian(s[TENSOR[i, j]]),
            derivative(trace, i, j) / (1 + NU),
            derivative(T, i, j) / (1 + NU),
            lap_T / (1 - NU) if i == j else 0.0,
        ]
        assert abs(sum(parts)) < 1e-6 * np.abs(derivative(s, 0, 0)).max()


@pytest.mark.parametrize(("age", "speed"), REGIMES)
def test_the_surface_is_free(age, speed):
    surface = stress(X, Y, 0.0, HALF, age, speed)
    assert not surface[2:5].any()
    # the limit from below; stress has infinite slope at the edges
    close = stress(X, Y, 1e-6, HALF, age, speed)
    assert error(close, surface) < 1e-4


@pytest.mark.parametrize("nu", [0.0, 0.49])
def test_heat_over_a_large_area_is_one_dimensional(nu):
    """Far inside the source and early: T = 2 sqrt(X/pi) ierfc(z/2 sqrt X), sigma_xx = -E alpha
    T/(1 - nu), u_z = -2 X."""
    root = 1e-3
    x = y = np.array([0.1])
    h = 0.7
    expected = 2 * root * (np.exp(-h * h) / np.sqrt(np.pi) - h * erfc(h))
    z = 2 * root * h
    assert temperature(x, y, z, HALF, root**2, AT_REST).item() == pytest.approx(expected, rel=1e-6)
    s = stress(x, y, z, HALF, root**2, AT_REST, nu=nu).ravel()
    # the bulge strains what is around it, by about the heated depth over the size
    np.testing.assert_allclose(s[:2], -expected, rtol=20 * root)
    assert np.abs(s[2:]).max() < 20 * root * expected
    u = displacement(x, y, HALF, root**2, AT_REST).item()
    assert u == pytest.approx(-2 * root**2, rel=20 * root)


class TestLimits:
    x, y = np.array([-2.0, 0.0, 0.5, 3.0]), np.array([0.0, 1.0])

    def test_late_is_steady(self):
        # T lacks 4 a b/(2 pi^1.5 sqrt X), the same everywhere; the rest falls with X^(-3/2)
        for z in (0.0, 0.6):
            age = 1e8
            steady = temperature(self.x, self.y, z, HALF, INF, AT_REST)
            lack = 4 * HALF[0] * HALF[1] / (2 * np.pi**1.5 * np.sqrt(age))
            late = temperature(self.x, self.y, z, HALF, age, AT_REST, 1e-9)
            assert error(late + lack, steady) < 1e-9
            s = stress(self.x, self.y, z, HALF, INF, AT_REST)
            # so does the stress
            assert error(stress(self.x, self.y, z, HALF, 1e12, AT_REST, 1e-9), s) < 1e-6

    def test_late_displacement_has_a_known_distance(self):
        """r0 = 4 exp(-(1 + gamma)/2) sqrt(X)."""
        age = 1e6
        r0 = 4 * np.exp(-(1 + np.euler_gamma) / 2) * np.sqrt(age)
        late = displacement(self.x, self.y, HALF, age, AT_REST, 1e-9)
        steady = steady_displacement(self.x[:, None], self.y, HALF, r0)
        assert error(late, steady) < 1e-6
        # and falls with 1/X beyond
        assert error(late, steady_displacement(self.x[:, None], self.y, HALF, 1.001 * r0)) > 1e-5

    @pytest.mark.parametrize("age", [1e3, INF])
    def test_slow_is_at_rest(self, age):
        for function in (temperature, stress):
            still = function(self.x, self.y, 0.6, HALF, age, AT_REST, 1e-9)
            slow = function(self.x, self.y, 0.6, HALF, age, (1e-9, -2e-9), 1e-9)
            assert error(slow, still) < 2e-8
        if np.isfinite(age):
            still = displacement(self.x, self.y, HALF, age, AT_REST, 1e-9)
            slow = displacement(self.x, self.y, HALF, age, (1e-9, 0.0), 1e-9)
            assert error(slow, still) < 2e-8

    def test_old_and_moving_is_steady(self):
        for function in (lambda *h: temperature(self.x, self.y, 0.6, HALF, *h), self._stress):
            steady = function(INF, (1.0, 0.3))
            assert error(function(1e3, (1.0, 0.3)), steady) < 1e-4
            assert error(function(1e1, (1.0, 0.3)), steady) > 1e-4

    def _stress(self, *h):
        return stress(self.x, self.y, 0.6, HALF, *h)

    def test_nothing_has_happened_yet(self):
        assert not temperature(X, Y, 0.0, HALF, 0.0, (1.0, 0.0)).any()
        assert not displacement(X, Y, HALF, 0.0, AT_REST).any()
        assert not stress(X, Y, 0.1, HALF, 0.0, AT_REST).any()


def test_signs():
    """Heating bulges outwards and compresses; the wake is on the side that the body moves to."""
    x = np.array([-2.0, 0.0, 2.0])
    origin = np.array([0.0])
    rise = temperature(x, origin, 0.0, HALF, INF, (3.0, 0.0)).ravel()
    assert 0 < rise[0] < rise[2] < rise[1]
    assert displacement(x, origin, HALF, 1.0, AT_REST).max() < 0
    assert displacement(x, origin, HALF, INF, (3.0, 0.0)).max() < 0
    assert (stress(origin, origin, 0.0, HALF, 1.0, AT_REST)[:2] < 0).all()


@pytest.mark.parametrize(("age", "speed"), [REGIMES[1], *MOVING[1:]])
def test_symmetry(age, speed):
    vx, vy = speed
    half = HALF[::-1]
    cases = (
        (temperature, 1, 1, slice(None), (0.6,)),
        (stress, MIRROR_X, MIRROR_Y, SWAP, (0.6,)),
        (displacement, 1, 1, slice(None), ()),
    )
    for function, flip_x, flip_y, swap, depth in cases:
        table = function(X, Y, *depth, HALF, age, speed)
        mirrored = function(-X, Y, *depth, HALF, age, (-vx, vy))
        assert error(flip_x * mirrored, table) < 1e-12
        mirrored = function(X, -Y, *depth, HALF, age, (vx, -vy))
        assert error(flip_y * mirrored, table) < 1e-12
        turned = function(Y, X, *depth, half, age, (vy, vx)).swapaxes(-1, -2)
        assert error(turned[swap], table) < 1e-12


def test_parts_add_up_to_the_whole():
    quarter = (HALF[0] / 2, HALF[1] / 2)
    shifts = list(itertools.product((-quarter[0], quarter[0]), (-quarter[1], quarter[1])))
    for age, speed in (REGIMES[1], REGIMES[4], REGIMES[7]):
        for function, depth in ((temperature, (0.3,)), (stress, (0.3,)), (displacement, ())):
            whole = function(X, Y, *depth, HALF, age, speed, 1e-10)
            parts = sum(
                function(X - i, Y - j, *depth, quarter, age, speed, 1e-10) for i, j in shifts
            )
            assert error(parts, whole) < 1e-9
    whole = steady_stress(X[:, None], Y, 0.3, HALF)
    assert (
        error(sum(steady_stress(X[:, None] - i, Y - j, 0.3, quarter) for i, j in shifts), whole)
        < 1e-13
    )


@pytest.mark.parametrize("speed", [(100.0, 40.0), (-1000.0, 0.0)])
def test_fast_sources_keep_the_tolerance(speed):
    """Up to a thousand cells in one diffusion time of a cell, on a lattice of cells; temperature
    against the point source, the others against a tighter tolerance, by which they are within that
    of the oracles at moderate speeds."""
    half = (0.5, 0.5)
    x, y = np.arange(-20.0, 21.0), np.arange(-3.0, 4.0)
    rise = temperature(x, y, 0.3, half, INF, speed)
    some = x[::8]
    expected = over(some, y[3:], lambda i, j: heat.temperature(i, j, 0.3, *half, INF, speed))
    assert np.abs(rise[::8, 3:] - expected).max() < 1e-6 * rise.max()
    for age in (0.02, INF):
        fine = displacement(x, y, half, age, speed, 1e-11)
        assert error(displacement(x, y, half, age, speed), fine) < 1e-6
        fine = stress(x, y, 0.3, half, age, speed, 1e-11)
        assert error(stress(x, y, 0.3, half, age, speed), fine) < 1e-6


def test_far_points_keep_their_digits():
    """Sums over many cells add errors far away: those are relative to what is there."""
    x = np.array([0.0, 30.0, 100.0, 300.0])
    half = (0.5, 0.5)
    steady = temperature(x, x, 0.5, half, INF, AT_REST)
    age = 1e10
    lack = 1 / (2 * np.pi**1.5 * np.sqrt(age))
    np.testing.assert_allclose(temperature(x, x, 0.5, half, age, AT_REST) + lack, steady, rtol=1e-6)
    s = stress(x, x, 0.5, half, 1e22, AT_REST)[:2]
    np.testing.assert_allclose(s, stress(x, x, 0.5, half, INF, AT_REST)[:2], rtol=1e-5)


def test_offsets_in_any_order():
    x, y = np.array([3.0, -1.0, 0.0, -1.0]), np.array([0.5, 0.0])
    table = temperature(x, y, 0.2, HALF, 2.0, (1.0, 0.0))
    assert table.shape == (4, 2)
    ordered = temperature(np.sort(x)[1:], np.sort(y), 0.2, HALF, 2.0, (1.0, 0.0))
    np.testing.assert_array_equal(table, ordered[[2, 0, 1, 0]][:, [1, 0]])
    assert stress(x, y, 0.2, HALF, 2.0, (1.0, 0.0)).shape == (6, 4, 2)
    assert displacement(x, y, HALF, 2.0, (1.0, 0.0)).shape == (4, 2)


GOOD = {
    "x": [0.0],
    "y": [0.0],
    "z": 1e-6,
    "a": 1e-5,
    "b": 1e-5,
    "E": E,
    "nu": NU,
    "expansion": EXPANSION,
    "conductivity": CONDUCTIVITY,
    "diffusivity": DIFFUSIVITY,
    "time": 1e-3,
    "velocity": (1.0, 0.0),
}


@pytest.mark.parametrize(
    ("name", "value", "text"),
    [
        ("x", [], "x must be one-dimensional and not empty"),
        ("y", [[0.0]], r"y must be one-dimensional and not empty, got shape \(1, 1\)"),
        ("x", [np.nan], "x must be finite"),
        ("z", -1e-6, "z must be a finite number >= 0, got -1e-06"),
        ("a", 0.0, "a must be a finite number > 0, got 0.0"),
        ("b", -1.0, "b must be a finite number > 0, got -1.0"),
        ("E", 0.0, "E must be"),
        ("nu", 0.5, "nu must be"),
        ("expansion", INF, "expansion must be a finite number, got inf"),
        ("conductivity", 0.0, "conductivity must be a finite number > 0, got 0.0"),
        ("diffusivity", -1.0, "diffusivity must be a finite number > 0, got -1.0"),
        ("time", -1.0, r"time must be a number >= 0 \[s\] \(inf allowed\), got -1.0"),
        ("time", np.nan, "time must be a number >= 0"),
        ("velocity", (1.0, INF), r"velocity\[1\] must be a finite number, got inf"),
        ("velocity", 1.0, "velocity must be two numbers"),
        ("time", 1e80, "time must be <= 1e60"),
        ("velocity", (1e-100, 0.0), "velocity must be 0 or >= 1e-59"),
        ("velocity", (0.0, -1e9), "velocity must be < 1e7 diffusivity"),
        ("tol", 0.1, r"tol must be in \[1e-12, 1e-2\], got 0.1"),
    ],
)
def test_errors_name_the_argument(name, value, text):
    with pytest.raises(ValueError, match=text):
        heat_kernels.stress(**(GOOD | {name: value}))
    arguments = {k: v for k, v in (GOOD | {name: value}).items() if k not in ("E", "z")}
    if name not in ("E", "z"):
        with pytest.raises(ValueError, match=text):
            heat_kernels.displacement(**arguments)


def test_errors_of_the_steady_state():
    with pytest.raises(ValueError, match=r"time must be finite for a source at rest.*steady_disp"):
        displacement(X, Y, HALF, INF, AT_REST)
    with pytest.raises(ValueError, match=r"r0 must be a finite number > 0, got 0\.0"):
        steady_displacement(0.0, 0.0, HALF, 0.0)
    with pytest.raises(ValueError, match="z must be >= 0"):
        steady_temperature(0.0, 0.0, -1.0, HALF)
    with pytest.raises(ValueError, match="conductivity must be"):
        heat_kernels.steady_temperature(0.0, 0.0, 0.0, 1.0, 1.0, conductivity=-1.0)
    with pytest.raises(TypeError, match="time must be a number"):
        heat_kernels.stress(**(GOOD | {"time": "1"}))


def test_a_long_table_can_be_interrupted():
    class Stop(Exception):
        pass

    def stop(*_):
        raise Stop

    x = np.arange(-1e6, 1e6)
    before = signal.signal(signal.SIGALRM, stop)

    def interrupted():
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        stress(x, x, 0.5, (0.5, 0.5), INF, (5.0, 1.0), 1e-12)  # would take hours

    try:
        with pytest.raises(Stop):
            interrupted()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
