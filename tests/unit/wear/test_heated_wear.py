# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear cycles that continue from the temperatures of the previous cycle."""

import numpy as np
import pytest

import samcontact as sc

BALL = sc.Material.elastic(210e9, 0.3)
SOFT = sc.Material.swift(210e9, 0.3, 1e9, 16.0, 0.067).with_thermal(50.0, 12e-6, 14e-6)
D, LOAD = 60e-6, 200.0
GRID = sc.Grid(13, 11, D, D, dz=D / 2)
HEAT = sc.Heat(factor=(0.0, 0.02), history=(1e-5, 1.0), track=4 * D)


def cycle(wait):
    """Return a cycle that slides by a cell, unloads, and returns within some time."""
    slides = {"load": LOAD, "advance": (0.0, -D), "duration": 2e-3}
    unloads = {"load": 0.0, "duration": 1e-5}
    return [slides, unloads, {"load": 0.0, "advance": (0.0, D), "duration": wait}]


def wears(wait=1e-3, cycles=2, keep_heat=True, **changes):
    given = {"cycle": cycle(wait), "friction": 0.4, "threshold": 4e-5, "window": 1}
    given |= {"heat": HEAT, "cycles": cycles, "keep_heat": keep_heat, "progress": False} | changes
    gap = sc.surfaces.paraboloid(GRID, 7.5e-3)
    return sc.wear.run(GRID, BALL, SOFT, gap, **given)


@pytest.fixture(scope="module")
def checkpoint(tmp_path_factory):
    return tmp_path_factory.mktemp("wear") / "wear.h5"


@pytest.fixture(scope="module")
def warm(checkpoint):
    return wears(checkpoint=checkpoint)


def test_temperatures_are_those_of_all_cycles_with_waiting_steps(warm):
    """Heat of equal pressures, marched through both cycles by one simulation."""
    marched = sc.Simulation(
        GRID, BALL, sc.Material.elastic(210e9, 0.3).with_thermal(50.0, 12e-6, 14e-6),
        sc.surfaces.paraboloid(GRID, 7.5e-3), heat=HEAT,
    )  # fmt: skip
    peaks = warm.first[0], warm.last[0]
    assert len(warm.cycles) == 2
    assert np.abs(peaks[0].pressure - peaks[1].pressure).max() > 0.01 * peaks[0].pressure.max()
    for peak, end in (warm.first, warm.last):
        pressures = [peak.pressure, 0.0 * peak.pressure, 0.0 * peak.pressure]
        steps = [{k: v for k, v in step.items() if k != "load"} for step in cycle(1e-3)]
        states = [
            marched.step(pressure=p, **step) for p, step in zip(pressures, steps, strict=True)
        ]
        for found, expected in ((peak, states[0]), (end, states[2])):
            assert found.time == pytest.approx(expected.time)
            one, other = (state.surface_temperature() for state in (found, expected))
            np.testing.assert_allclose(one, other, atol=1e-9 * other.max(), rtol=0)
            one, other = (state.at_layers(7).temperature() for state in (found, expected))
            np.testing.assert_allclose(one, other, atol=1e-9 * other.max(), rtol=0)


def test_without_heat_of_earlier_cycles_each_cycle_starts_cold(warm):
    cold = wears(keep_heat=False)
    assert cold.cycles[0] == warm.cycles[0]
    rise = [result.last[0].surface_temperature().max() for result in (warm, cold)]
    assert rise[0] > 1.03 * rise[1]


def test_a_return_at_once_leaves_no_time_to_cool(warm):
    at_once = wears(wait=0.0)
    rise = [result.last[0].surface_temperature().max() for result in (at_once, warm)]
    assert rise[0] > 1.02 * rise[1]


def test_a_resumed_run_keeps_the_temperatures(warm, checkpoint):
    """The checkpoint has the state after the first cycle."""
    again = wears(checkpoint=checkpoint)
    assert again.cycles == warm.cycles
    one, other = (result.last[0].surface_temperature() for result in (again, warm))
    np.testing.assert_array_equal(one, other)


def test_heat_is_kept_only_with_a_history():
    with pytest.raises(ValueError, match="keep_heat requires a heat history"):
        wears(heat=sc.Heat(factor=0.02, time=1e-3))
