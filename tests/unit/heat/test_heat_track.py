# SPDX-License-Identifier: GPL-3.0-or-later
"""Transient heat of bodies that stop, turn and return unloaded."""

import copy
import warnings

import numpy as np
import pytest
from heat_setups import ALPHA, COLD, KAPPA, NU, WARM, E, K, ball

import samcontact as sc

SIZE = 60e-6
GRID = sc.Grid(12, 12, SIZE, SIZE, 2, SIZE)
BUMP = 2e9 * np.exp(-(GRID.x[:, None] ** 2 + GRID.y**2) / (3 * SIZE) ** 2)
SPEED, STEP = 0.12, 1e-3  # two cells in a step
MOVE = (0.0, SPEED * STEP)
STEEL = sc.Material.linear_hardening(E, NU, 900e6, 20e9).with_thermal(K, ALPHA, KAPPA)


def simulation(body2=WARM, track=16 * SIZE, grid=GRID, **heat):
    heat = {"history": (STEP, 1.0)} | ({} if track is None else {"track": track}) | heat
    return sc.Simulation(grid, COLD, body2, ball(grid), heat=sc.Heat(0.05, **heat))


def fields(state):
    return [state.temperature(2), state.surface_displacement(2), state.stress(2)]


def assert_equal(state, expected, tol):
    for found, field in zip(fields(state), fields(expected), strict=True):
        np.testing.assert_allclose(found, field, rtol=0, atol=tol * np.abs(field).max())


def test_heat_on_a_track_equals_heat_at_constant_speed():
    """The heat of a body at constant speed is kept in generations, that on a track as a whole."""
    track, passing = simulation(), simulation(track=None, velocity=(SPEED, 0.0))
    for scale in (1.0, 0.4, 0.0, 0.8):
        step = {"pressure": scale * BUMP, "advance": MOVE, "duration": STEP}
        found, expected = track.step(**step), passing.step(**step)
    assert expected.temperature(2).max() > 50.0
    assert_equal(found, expected, 1e-5)


def test_a_return_equals_a_motion_at_once_and_waiting_steps():
    run = simulation()
    for _ in range(3):
        run.step(pressure=BUMP, advance=MOVE, duration=STEP)
    hot = run.step(load=0.0, duration=STEP)
    back = {"load": 0.0, "advance": (0.0, -3 * SPEED * STEP)}
    waits = copy.deepcopy(run)
    cooled = run.step(**back, duration=4 * STEP)
    moved = waits.step(**back, duration=0.0)
    assert moved.time == hot.time
    # The heat moves with the body, by six cells.
    before, after = hot.temperature(2), moved.temperature(2)
    np.testing.assert_allclose(after[:-6], before[6:], rtol=0, atol=1e-6 * before.max())
    for _ in range(4):
        expected = waits.step(load=0.0, duration=STEP)
    assert_equal(cooled, expected, 1e-10)
    assert cooled.temperature(2).max() < 0.8 * after.max()
    for each in (run, waits):
        state = each.step(pressure=BUMP, advance=MOVE, duration=STEP)
    assert_equal(run.state, state, 1e-10)


def passes(wait, cells=4, **given):
    return sc.paths.rolling(
        load=300.0, distance=-cells * SIZE, step=2 * SIZE, increments=1, speed=SPEED,
        return_time=wait, **given,
    )  # fmt: skip


def test_the_second_pass_is_hotter_the_shorter_the_return():
    peaks = {}
    for wait in (0.0, 20 * STEP):
        states = simulation().run(passes(wait, passes=2), progress=False)
        peaks[wait] = [states[n].surface_temperature(2).max() for n in (2, 7)]
        assert states[4].time == pytest.approx(states[3].time + wait)
    assert peaks[0.0][0] == peaks[20 * STEP][0]
    assert peaks[0.0][1] > peaks[20 * STEP][1] + 1.0 > peaks[0.0][0] + 1.0


def test_a_cycle_of_shakedown_equals_one_with_waiting_steps(tmp_path):
    back = {"load": 0.0, "advance": (-2 * SIZE, -2 * SIZE)}
    cycles = [
        [*passes(None, cells=2), back | {"duration": 3 * STEP}],
        [*passes(None, cells=2), back | {"duration": 0.0}, *[{"load": 0.0, "duration": STEP}] * 3],
    ]
    grid = sc.Grid(10, 10, SIZE, SIZE, dz=SIZE)
    runs = [simulation(STEEL, grid=grid) for _ in cycles]
    strains = []
    for run, cycle in zip(runs, cycles, strict=True):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", sc.shakedown.NotSteadyWarning)
            result = sc.shakedown.run(run, cycle, cycles=2, progress=False)
        strains.append(result.state.plastic_strain(2))
    assert result.cycles[-1].flow > 1e-4
    np.testing.assert_allclose(*strains, rtol=0, atol=1e-8 * np.abs(strains[0]).max())
    runs[0].save(tmp_path / "run.h5")
    loaded = sc.Simulation.load(tmp_path / "run.h5")
    step = {"load": 300.0, "advance": (SIZE, SIZE), "duration": STEP}
    found, expected = loaded.step(**step), runs[0].step(**step)
    assert np.array_equal(found.temperature(2), expected.temperature(2))
    assert np.array_equal(found.plastic_strain(2), expected.plastic_strain(2))


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: sc.Heat(0.1, track=1e-3), "track requires history"),
        (lambda: simulation(velocity=(0.1, 0.0)), "velocity cannot be combined with track"),
        (
            lambda: simulation(track=None).step(load=0.0, advance=MOVE, duration=STEP),
            "set heat.track instead of heat.velocity",
        ),
        (lambda: simulation().step(load=1.0, duration=0.0), "duration must be a finite number > 0"),
        (
            lambda: sc.paths.rolling(load=1.0, distance=1e-3, step=1e-4, passes=2, return_time=1.0),
            "return_time requires speed",
        ),
    ],
)
def test_invalid_motion_of_heat_is_refused(make, text):
    with pytest.raises(ValueError, match=text):
        make()


def test_a_path_beyond_the_track_is_refused():
    run = simulation(track=5 * SIZE)
    run.step(pressure=BUMP, duration=STEP)
    with pytest.raises(ValueError, match="duration must be > 0 for an increment that unloads"):
        run.step(load=0.0, advance=MOVE, duration=0.0)
    with pytest.raises(ValueError, match=r"heat.track must be at least the length of the path"):
        run.step(load=0.0, advance=(0.0, 6 * SIZE), duration=STEP)
