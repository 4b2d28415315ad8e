# SPDX-License-Identifier: GPL-3.0-or-later
"""Influence of a heat source: limits, signs, symmetries, tolerance, and what is refused.

Lengths, ages and speeds are those of `heat_scales`.
"""

import itertools
import signal

import numpy as np
import pytest
from heat_scales import (
    AT_REST,
    CONDUCTIVITY,
    DIFFUSIVITY,
    EXPANSION,
    HALF,
    INF,
    NU,
    REGIMES,
    E,
    X,
    Y,
    displacement,
    error,
    over,
    steady_displacement,
    steady_stress,
    steady_temperature,
    stress,
    temperature,
)

from oracles import heat
from samcontact import heat_kernels

# Sign of each component under x -> -x and y -> -y, and components after exchange of x and y.
MIRROR_X = np.array([1, 1, 1, 1, -1, -1])[:, None, None]
MIRROR_Y = np.array([1, 1, 1, -1, 1, -1])[:, None, None]
SWAP = [1, 0, 2, 4, 3, 5]
MOVING = REGIMES[3:]


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

    def test_late_displacement_has_a_known_reference_distance(self):
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

    def test_fields_at_zero_time_are_zero(self):
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


def test_parts_sum_to_the_whole():
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
    """Speeds up to a thousand cells per diffusion time of a cell keep the tolerance.

    Temperature is compared with the point source, other quantities with a tighter tolerance, which
    agrees with the oracles at moderate speeds.
    """
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
    """At far points the error is relative to the local value."""
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


VALID_ARGUMENTS = {
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
        ("time", 1e80, "time must be inf or <= 1e60"),
        ("velocity", (1e-100, 0.0), "velocity must be 0 or have a magnitude >= 1e-59"),
        ("velocity", (0.0, -1e9), "velocity must be < 1e7 diffusivity"),
        ("tol", 0.1, r"tol must be in \[1e-12, 1e-2\], got 0.1"),
    ],
)
def test_errors_name_the_argument(name, value, text):
    with pytest.raises(ValueError, match=text):
        heat_kernels.stress(**(VALID_ARGUMENTS | {name: value}))
    arguments = {k: v for k, v in (VALID_ARGUMENTS | {name: value}).items() if k not in ("E", "z")}
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
        heat_kernels.stress(**(VALID_ARGUMENTS | {"time": "1"}))


def test_a_long_table_can_be_interrupted():
    class Stop(Exception):
        pass

    def stop(*_):
        raise Stop

    x = np.linspace(-1e3, 1e3, 1600)
    before = signal.signal(signal.SIGALRM, stop)

    def interrupted():
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        stress(x, x, 0.5, (0.5, 0.5), INF, (5.0, 1.0), 1e-12)  # would take a minute

    try:
        with pytest.raises(Stop):
            interrupted()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
