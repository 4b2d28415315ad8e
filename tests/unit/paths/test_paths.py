# SPDX-License-Identifier: GPL-3.0-or-later
"""Loading paths: exact end points, monotonicity, strict arguments."""

import doctest
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import samcontact as sc
from samcontact import paths
from samcontact.paths import passes, ramps


def test_ramp_linear():
    assert paths.ramp(load=300.0, increments=3) == [{"load": 100}, {"load": 200}, {"load": 300}]
    assert paths.ramp(approach=-1e-6, start=1e-6, increments=2) == [
        {"approach": 0.0},
        {"approach": -1e-6},
    ]


def test_ramp_power_starts_with_small_steps():
    values = [step["load"] for step in paths.ramp(load=8.0, increments=2, spacing="power")]
    assert values == [2.0, 8.0]
    values = [s["load"] for s in paths.ramp(load=8, increments=2, spacing="power", exponent=3)]
    assert values == [1.0, 8.0]


@given(
    target=st.floats(1e-9, 1e12),
    start=st.floats(0.0, 1e12),
    increments=st.integers(1, 50),
    spacing=st.sampled_from(["linear", "power"]),
)
def test_ramp_ends_exactly_and_is_monotone(target, start, increments, spacing):
    if abs(start - target) < 1e-6 * max(start, target):
        return
    path = paths.ramp(load=target, start=start, increments=increments, spacing=spacing)
    values = np.array([start] + [step["load"] for step in path])
    assert len(path) == increments
    assert values[-1] == target
    assert np.all(np.diff(values) * np.sign(target - start) > 0)


def test_load_unload_mirrors():
    path = paths.load_unload(load=8.0, increments=4, spacing="power")
    values = [0.0] + [step["load"] for step in path]
    assert values == [0.0, 0.5, 2.0, 4.5, 8.0, 4.5, 2.0, 0.5, 0.0]
    short = paths.load_unload(approach=4.0, increments=2, unload_increments=4, end=2.0)
    assert [s["approach"] for s in short] == [2.0, 4.0, 3.5, 3.0, 2.5, 2.0]


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: paths.ramp(), "exactly one of load, approach must be given, got none"),
        (
            lambda: paths.ramp(load=1.0, approach=1.0),
            "exactly one .* must be given, got load, approach",
        ),
        (lambda: paths.ramp(load=float("inf")), "load must be a finite number, got inf"),
        (lambda: paths.ramp(approach=float("inf")), "approach must be a finite number, got inf"),
        (lambda: paths.ramp(load=1.0, increments=0), "increments must be an integer >= 1, got 0"),
        (lambda: paths.ramp(load=1.0, start=1.0), "start must differ from load, got 1.0"),
        (lambda: paths.ramp(load=1.0, spacing="log"), "spacing must be one of 'linear', 'power'"),
        (
            lambda: paths.ramp(load=1.0, spacing="power", exponent=0.0),
            "exponent must be a finite number > 0",
        ),
        (lambda: paths.load_unload(load=1.0, end=2.0), "load must be > 2.0, got 1.0"),
        (
            lambda: paths.load_unload(load=1.0, unload_increments=0),
            "unload_increments must be an integer >= 1",
        ),
    ],
)
def test_bad_input_is_named(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_increments_must_be_an_integer():
    with pytest.raises(TypeError, match=r"increments must be an integer, got 2\.5"):
        paths.ramp(load=1.0, increments=2.5)


class TestHeat:
    def test_hold(self):
        assert paths.hold(load=5.0, increments=2, duration=3.0, heat_factor=0.1) == [
            {"load": 5.0, "duration": 1.5, "heat_factor": 0.1},
            {"load": 5.0, "duration": 1.5},
        ]
        assert paths.hold(approach=-1e-6) == [{"approach": -1e-6}]

    def test_ramp_with_duration(self):
        assert paths.ramp(load=2.0, increments=2, duration=1.0, heat_factor=(0.0, 0.2)) == [
            {"load": 1.0, "duration": 0.5, "heat_factor": (0.0, 0.2)},
            {"load": 2.0, "duration": 0.5},
        ]

    @pytest.mark.parametrize("duration", [-1.0, float("nan")])
    def test_bad_duration(self, duration):
        with pytest.raises(ValueError, match="duration must be"):
            paths.hold(load=1.0, duration=duration)

    @pytest.mark.parametrize("factor", [math.nan, -1.0, (0.0, math.inf)])
    def test_bad_heat_factor(self, factor):
        passes = {"distance": 1.0, "step": 0.5, "heat_factor": factor}
        for call in (
            lambda: paths.hold(load=1.0, heat_factor=factor),
            lambda: paths.ramp(load=1.0, heat_factor=factor),
            lambda: paths.rolling(load=1.0, **passes),
            lambda: paths.sliding(load=1.0, **passes),
        ):
            with pytest.raises(ValueError, match="heat_factor must be a finite number >= 0"):
                call()


def moved(path, body):
    return math.fsum(step.get("advance", (0.0, 0.0))[body - 1] for step in path)


class TestRolling:
    def test_one_pass(self):
        path = paths.rolling(load=8.0, distance=0.75, step=0.5, increments=2, unload_increments=4)
        assert path == [
            {"load": 4.0},
            {"load": 8.0},
            {"load": 8.0, "advance": (-0.5, -0.5)},
            {"load": 8.0, "advance": (-0.25, -0.25)},
            {"load": 6.0},
            {"load": 4.0},
            {"load": 2.0},
            {"load": 0.0},
        ]

    def test_passes_start_from_the_same_place_unloaded(self):
        options = {"load": 8.0, "distance": -1.0, "step": 0.5, "increments": 1}
        once, thrice = paths.rolling(**options), paths.rolling(**options, passes=3)
        back = {"load": 0.0, "advance": (-1.0, -1.0)}
        assert once[1] == {"load": 8.0, "advance": (0.5, 0.5)}
        assert thrice == [*once, back, *once, back, *once]

    def test_back_and_forth_is_loaded_once(self):
        path = paths.rolling(
            approach=1e-6, distance=1.0, step=1.0, increments=1, passes=3, back_and_forth=True
        )
        travels = [step["advance"][0] for step in path if "advance" in step]
        assert travels == [-1.0, 1.0, -1.0]
        assert [step.get("approach") for step in path] == [1e-6] * 4 + [None]
        assert path[-1] == {"load": 0.0}

    @given(
        distance=st.floats(1e-6, 1e-2),
        sign=st.sampled_from([-1, 1]),
        parts=st.floats(1.0, 60.0),
        ratio=st.floats(-2.0, 2.0),
        passes=st.integers(1, 3),
    )
    def test_advances_add_up_to_the_distance(self, distance, sign, parts, ratio, passes):
        path = paths.rolling(
            load=1.0,
            distance=sign * distance,
            step=distance / parts,
            slide_to_roll=ratio,
            passes=passes,
        )
        # the ways back undo all passes but the last
        travels = [moved(path, body) for body in (1, 2)]
        expected = [-sign * distance * (1 + s * ratio / 2) for s in (1, -1)]
        np.testing.assert_allclose(travels, expected, rtol=1e-12, atol=1e-12 * distance)
        loaded = [step for step in path if step["load"] > 0 and "advance" in step]
        assert len(loaded) in (passes * math.ceil(parts), passes * math.floor(parts + 1e-6))
        np.testing.assert_allclose(moved(loaded, 1), passes * expected[0], atol=1e-11 * distance)

    def test_whole_steps_are_exactly_whole(self):
        # 0.3/0.1 is a little less than 3 in floating point, and 0.3 - 0.2 is not 0.1
        path = paths.rolling(load=1.0, distance=0.3, step=0.1)
        assert [s["advance"] for s in path if "advance" in s] == [(-0.1, -0.1)] * 3

    def test_slide_to_roll(self):
        path = paths.rolling(load=1.0, distance=1.0, step=1.0, slide_to_roll=-0.1)
        first, second = next(step["advance"] for step in path if "advance" in step)
        assert (first - second) / ((first + second) / 2) == pytest.approx(-0.1, rel=1e-14)
        assert (first + second) / 2 == -1.0

    def test_durations_follow_the_speed(self):
        path = paths.rolling(
            load=1.0,
            distance=0.75,
            step=0.5,
            increments=1,
            passes=2,
            speed=2.0,
            heat_factor=(0.0, 0.1),
        )
        one = [0.25, 0.25, 0.125, 0.25]
        assert [step["duration"] for step in path] == [*one, 0.375, *one]
        assert [step.get("heat_factor") for step in path] == [(0.0, 0.1)] + [None] * 8


def test_sliding_keeps_the_contact_on_the_slider():
    options = {"load": 1.0, "distance": 1.0, "step": 0.5, "increments": 1}
    path = paths.sliding(**options)
    assert [s["advance"] for s in path if "advance" in s] == [(0.0, -0.5)] * 2
    path = paths.sliding(**options, slider=2, passes=2)
    assert (moved(path, 1), moved(path, 2)) == (-1.0, 0.0)
    # no minus zeros, which would be written into files
    assert all(math.copysign(1.0, s.get("advance", (0, 0))[1]) == 1.0 for s in path)
    # the limit of rolling: the mean of the ways over both bodies is half of that over one
    options |= {"distance": 0.5, "step": 0.25}
    assert paths.rolling(**options, slide_to_roll=-2.0) == paths.sliding(
        **{**options, "distance": 1.0, "step": 0.5}
    )


def test_passes_are_executed():
    grid = sc.Grid(9, 9, 2e-5, 2e-5)
    steel = sc.Material.elastic(210e9, 0.3)
    path = paths.rolling(load=2.0, distance=5e-5, step=2e-5, increments=2, passes=2)
    sim = sc.Simulation(grid, steel, steel, sc.surfaces.paraboloid(grid, 7.5e-3))
    states = sim.run(path, progress=False)
    np.testing.assert_allclose(states[4].travel, [-5e-5, -5e-5], rtol=1e-12)
    np.testing.assert_allclose(states[7].travel, 0.0, atol=1e-18)
    np.testing.assert_allclose(states[-1].travel, [-5e-5, -5e-5], rtol=1e-12)


def test_ramp_and_hold_while_the_bodies_move():
    assert paths.ramp(load=2.0, increments=2, advance=(-1.0, 3.0)) == [
        {"load": 1.0, "advance": (-0.5, 1.5)},
        {"load": 2.0, "advance": (-0.5, 1.5)},
    ]
    assert paths.hold(load=0.0, advance=(1.0, 1.0)) == [{"load": 0.0, "advance": (1.0, 1.0)}]
    with pytest.raises(ValueError, match=r"advance must be a pair \(body 1, body 2\)"):
        paths.hold(load=1.0, advance=(1.0, 2.0, 3.0))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"load": None}, "exactly one of load, approach must be given, got none"),
        ({"load": 0.0}, r"load must be > 0, got 0\.0"),
        ({"load": None, "approach": -1.0}, r"approach must be > 0, got -1\.0"),
        ({"distance": 0.0}, "distance must not be 0"),
        ({"distance": math.inf}, "distance must be a finite number, got inf"),
        ({"step": -0.5}, r"step must be a finite number > 0, got -0\.5"),
        ({"step": 2.0}, r"step must be <= the distance, 1\.0, got 2\.0"),
        ({"passes": 0}, "passes must be an integer >= 1, got 0"),
        ({"increments": 0}, "increments must be an integer >= 1, got 0"),
        ({"unload_increments": 0}, "unload_increments must be an integer >= 1, got 0"),
        ({"slide_to_roll": 2.5}, r"slide_to_roll must be in \[-2, 2\], got 2\.5"),
        ({"slide_to_roll": math.nan}, r"slide_to_roll must be in \[-2, 2\], got nan"),
        ({"speed": 0.0}, r"speed must be a finite number > 0, got 0\.0"),
    ],
)
def test_bad_passes_are_named(arguments, message):
    with pytest.raises(ValueError, match=message):
        paths.rolling(**{"load": 1.0, "distance": 1.0, "step": 0.5, **arguments})
    if "slide_to_roll" not in arguments:
        with pytest.raises(ValueError, match=message):
            paths.sliding(**{"load": 1.0, "distance": 1.0, "step": 0.5, **arguments})


def test_unknown_slider():
    with pytest.raises(ValueError, match="slider must be one of 1, 2, got 3"):
        paths.sliding(load=1.0, distance=1.0, step=0.5, slider=3)


def test_examples_of_the_docstrings():
    for module, count in ((ramps, 1), (passes, 2)):
        results = doctest.testmod(module)
        assert (results.failed, results.attempted) == (0, count)


def test_a_fretting_loop_closes():
    """Shear under constant load is periodic (Mindlin and Deresiewicz), exactly for nu = 0."""
    grid = sc.Grid(24, 24, 40e-6, 40e-6)
    body = sc.Material.elastic(210e9, 0.0)
    run = sc.Simulation(grid, body, body, sc.surfaces.paraboloid(grid, 7.5e-3), sc.Coulomb(0.3))
    run.step(load=300.0)
    loop = paths.fretting_loop(load=300.0, force=(60.0, 0.0), cycles=2, increments=3)
    states = run.run(loop, progress=False)
    assert len(states) == 27
    assert [s.tangential_load[0] for s in states[2::6]] == pytest.approx([60, -60, 60, -60, 60])
    bound = 0.3 * states[0].pressure.max()
    np.testing.assert_allclose(states[14].shear, states[2].shear, atol=1e-9 * bound)
    np.testing.assert_allclose(states[8].shear, -states[2].shear, atol=1e-6 * bound)
    first, second = (states[n + 12].friction_work - states[n].friction_work for n in (2, 14))
    assert second == pytest.approx(first, rel=1e-6)
    travel = states[2].shift
    by_motion = paths.fretting_loop(load=300.0, shift=tuple(travel), increments=1)
    assert [step["shift"][0] / travel[0] for step in by_motion] == pytest.approx([1, -1, -1, 1, 1])


def test_a_tangential_path_comes_to_its_force():
    path = paths.tangential(load=100.0, force=(20.0, 4.0), start=(10.0, 0.0), increments=2)
    assert path == [
        {"load": 100.0, "tangential_load": (15.0, 2.0)},
        {"load": 100.0, "tangential_load": (20.0, 4.0)},
    ]
    moved = paths.tangential(approach=1e-6, shift=(4e-6, 0.0), increments=4)
    assert moved == [{"approach": 1e-6, "shift": (1e-6, 0.0)}] * 4
    with pytest.raises(ValueError, match="exactly one of force and shift"):
        paths.tangential(load=1.0)
    with pytest.raises(ValueError, match="start must be 0 if shift is given"):
        paths.tangential(load=1.0, shift=(1e-6, 0.0), start=(1.0, 0.0))


class TestTimes:
    def test_creep(self):
        steps = paths.creep(3.0, until=100.0, per_decade=4, first=1.0)
        assert steps[0] == {"load": 3.0, "duration": 0.0}
        times = np.cumsum([step["duration"] for step in steps])
        np.testing.assert_allclose(times[1:], np.logspace(0, 2, 9), rtol=1e-12)

    def test_stress_relaxation(self):
        assert {step["approach"] for step in paths.stress_relaxation(1e-6, until=1.0)} == {1e-6}

    def test_oscillation(self):
        steps = paths.oscillation(2.0, 1.0, frequency=0.5, periods=2, increments=4)
        np.testing.assert_allclose([step["load"] for step in steps], 2 * [3.0, 2.0, 1.0, 2.0])
        assert {step["duration"] for step in steps} == {0.5}
        with pytest.raises(ValueError, match="amplitude must be <= mean"):
            paths.oscillation(1.0, 2.0, frequency=1.0, periods=1)

    def test_first_duration(self):
        steps = paths.hold(load=1.0, increments=3, duration=9.0, first_duration=1.0)
        np.testing.assert_allclose([step["duration"] for step in steps], [1.0, 2.0, 6.0])
        with pytest.raises(ValueError, match="first_duration must be < duration"):
            paths.hold(load=1.0, increments=3, duration=1.0, first_duration=1.0)
