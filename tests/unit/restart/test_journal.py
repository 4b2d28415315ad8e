# SPDX-License-Identifier: GPL-3.0-or-later
"""Checkpoints of increments: damaged ones are solved again, states keep their heat."""

import re

import numpy as np
import pytest

import samcontact as sc
from checkpoint_setups import GAP, GRID, LOAD, MATERIALS, assert_same, simulation
from samcontact.simulation.journal import Journal, describe

PATH = [{"load": part * LOAD} for part in (0.4, 0.7, 1.0, 0.5)]


@pytest.fixture(scope="module")
def expected():
    return simulation().run(PATH, progress=False)


def hurt(file):
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.write_bytes(content)


@pytest.mark.parametrize("numbers", [[4], [2], [1], [3, 4], [1, 2, 3, 4]], ids=str)
def test_damaged_increments_are_solved_again(tmp_path, expected, numbers):
    simulation().run(PATH, progress=False, checkpoint=tmp_path)
    files = [tmp_path / f"increment_{number:05d}.h5" for number in numbers]
    for file in files:
        hurt(file)
    with pytest.warns(UserWarning, match="is damaged") as stated:
        again = simulation().run(PATH, progress=False, checkpoint=tmp_path)
    damaged = [text for text in (str(one.message) for one in stated) if "is damaged" in text]
    for text, file, number in zip(damaged, files, numbers, strict=True):
        words = f"'{file}' is damaged: .*; therefore, increment {number} is"
        assert re.search(words, text)
    for one, other in zip(again, expected, strict=True):
        assert_same(one, other)
    # and they are whole again
    whole = simulation().run(PATH, progress=False, checkpoint=tmp_path)
    assert_same(whole[-1], expected[-1])


def test_an_empty_file_is_damaged(tmp_path, expected):
    simulation().run(PATH[:1], progress=False, checkpoint=tmp_path / "run")
    (tmp_path / "run" / "increment_00001.h5").write_bytes(b"")
    with pytest.warns(UserWarning, match="is damaged"):
        again = simulation().run(PATH[:1], progress=False, checkpoint=tmp_path / "run")
    assert_same(again[0], expected[0])


def test_states_stored_later_keep_their_own_heat(tmp_path):
    """Stored states keep their own heat source and run description, not those of the last state."""
    steel = sc.Material.elastic(210e9, 0.3).with_thermal(50.0, 1e-5, 1.4e-5)
    heat = {"heat": sc.Heat(1e-3, time=1e-3)}

    def problem():
        return sc.Simulation(GRID, MATERIALS["elastic"], steel, GAP, **heat)

    path = [{"load": LOAD}, {"load": 0.5 * LOAD}, {"load": LOAD, "heat_factor": 0.0}]
    sim = problem()
    run_identity = describe(sim.engine, path=path)
    expected = sim.run(path, progress=False)
    journal = Journal(tmp_path, sim.engine, run_identity)
    journal.add(expected[0])  # the run was interrupted here
    again = problem().run(path, progress=False, checkpoint=tmp_path)
    for one, other in zip(again, expected, strict=True):
        assert one.heat_factor == other.heat_factor
        assert_same(one, other)
        np.testing.assert_array_equal(one.surface_temperature(2), other.surface_temperature(2))
    assert expected[1].surface_temperature(2).max() > 0
