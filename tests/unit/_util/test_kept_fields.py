# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields of states are computed once, and kept only while memory permits."""

import gc
from collections import Counter

import numpy as np
import pytest

import samcontact as sc
from case_texts import MINIMAL, MOVING
from command import invoke
from samcontact import _core
from samcontact._util import field_cache, memory
from samcontact.cases import load_case

STRESSES = ("stress", "residual_stress", "residual_stress_in")


@pytest.fixture
def computed(monkeypatch):
    """Count how often the core computes each stress, by state and body."""
    counts = Counter()

    def counting(name):
        compute = getattr(_core.State, name)

        def count(state, body, *place):
            flow = state.max_equivalent_plastic_strain(body)
            moment = (state.load, state.approach, *state.travel, flow)
            counts[(name, body, *moment)] += 1
            return compute(state, body, *place)

        return count

    for name in STRESSES:
        monkeypatch.setattr(_core.State, name, counting(name))
    return counts


def run(text, folder):
    file = folder / "case.toml"
    file.write_text(text)
    assert invoke("run", file, "--output", folder / "out").exit_code == 0
    assert invoke("report", folder / "out").exit_code == 0


@pytest.fixture
def states(tmp_path):
    file = tmp_path / "case.toml"
    file.write_text(MINIMAL)
    simulation, path = load_case(file).build()
    return simulation.run(path, progress=False)


def test_a_run_with_figures_and_report_computes_each_stress_once(tmp_path, computed, undrawn):
    run(MINIMAL, tmp_path)
    assert {key[0] for key in computed} == {"stress", "residual_stress"}
    assert set(computed.values()) == {1}


def test_a_moving_contact_computes_each_stress_once(tmp_path, computed, undrawn):
    run(MOVING, tmp_path)
    assert sum(key[0] == "residual_stress_in" for key in computed) == 1
    assert set(computed.values()) == {1}


def test_invariants_are_those_of_the_stress(states):
    state = states[1]
    stress = state.stress(2)
    assert state.stress(2) is stress
    np.testing.assert_array_equal(state.hydrostatic(2), stress[:3].mean(axis=0))
    xx, yy, zz, yz, xz, xy = stress
    squares = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2 + 6 * (yz**2 + xz**2 + xy**2)
    difference = state.von_mises(2) - np.sqrt(0.5 * squares)
    assert np.abs(difference).max() < 1e-14 * state.von_mises(2).max()
    with pytest.raises(ValueError, match="read-only"):
        stress *= 1e-6


def test_kept_fields_are_released_with_their_state(states):
    states[0].stress(2)
    kept = len(field_cache._fields)
    del states[0]
    gc.collect()
    assert len(field_cache._fields) == kept - 1


def test_the_oldest_kept_fields_are_released_first(states, monkeypatch):
    first, last = states[0], states[-1]
    size = first.stress(2).nbytes
    monkeypatch.setattr(field_cache, "MAX_BYTES", 1.5 * size)
    stress = last.stress(2)
    assert last.stress(2) is stress
    held = [field for mine in field_cache._fields.values() for field in mine.values()]
    assert any(field is stress for field in held)
    assert sum(field.nbytes for field in held) <= field_cache.MAX_BYTES
    monkeypatch.setattr(field_cache, "MAX_BYTES", 0.0)
    assert first.stress(2) is not first.stress(2)


def test_kept_fields_are_released_if_memory_is_short(states, monkeypatch):
    stress = states[0].stress(2)
    answers = iter([1e8, 1e10])
    monkeypatch.setattr(memory, "available", lambda: next(answers))
    memory.require("something", 1e9)
    monkeypatch.undo()
    assert states[0].stress(2) is not stress


def test_a_progress_bar_collects_no_track(monkeypatch, tmp_path):
    def gathered(*_):
        raise AssertionError("the whole track of an increment was gathered")

    monkeypatch.setattr(sc.State, "track", gathered)
    file = tmp_path / "case.toml"
    file.write_text(MINIMAL)
    simulation, _ = load_case(file).build()
    simulation.run([{"load": 500.0}, {"load": 0.0}], progress=True)
    assert simulation.state.max_equivalent_plastic_strain() > 0
