# SPDX-License-Identifier: GPL-3.0-or-later
"""Loading paths: end points exact, monotone, strict about their arguments."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from samcontact import paths


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
        (lambda: paths.ramp(), "exactly one of load, approach; got none"),
        (lambda: paths.ramp(load=1.0, approach=1.0), "exactly one .*; got load, approach"),
        (lambda: paths.ramp(load=-1.0), "load must be a finite number >= 0, got -1.0"),
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

    @pytest.mark.parametrize("duration", [0.0, -1.0, float("nan")])
    def test_bad_duration(self, duration):
        with pytest.raises(ValueError, match="duration must be"):
            paths.hold(load=1.0, duration=duration)
