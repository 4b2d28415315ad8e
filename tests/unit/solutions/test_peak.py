# SPDX-License-Identifier: GPL-3.0-or-later
"""The peak of a run is the state of maximum stress, not the start of a constant load."""

import numpy as np
import pytest

import samcontact as sc
from core_fakes import ELASTIC, SWIFT
from samcontact import report, results
from samcontact.solutions.peak import peak, peak_of_dataset

NONE = [np.nan] * 4


@pytest.mark.parametrize(
    ("stress", "pressure", "load", "expected"),
    [
        ([1.0, 3.0, 2.0, 0.1], [1.0, 2.0, 4.0, 0.0], [5.0, 5.0, 5.0, 0.0], 1),
        # flow without hardening: the same stress but for the tolerance
        ([1.0, 2.0001, 2.0, 2.0005], [1.0, 2.0, 3.0, 0.0], [5.0, 5.0, 5.0, 0.0], 2),
        (None, [1.0, 2.0, 4.0, 0.0], [5.0, 5.0, 5.0, 0.0], 2),
        (None, [2.0, 2.0, 2.0, 0.0], [4.0, 5.0, 5.0, 0.0], 1),
        ([1.0, np.nan, 0.5, np.nan], [1.0, np.nan, 2.0, np.nan], NONE, 0),  # of a sweep
        (NONE, [0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0], 0),
    ],
)
def test_choice(stress, pressure, load, expected):
    assert peak(stress, pressure, load) == expected


def test_the_last_of_many_small_increments_is_the_peak():
    load = np.linspace(1e-3, 1.0, 10_000)
    assert peak(load ** (1 / 3), load ** (1 / 3), load) == load.size - 1


@pytest.fixture(scope="module")
def over_a_dent():
    """Return a run under constant load over a dent whose rim yields."""
    grid = sc.Grid(25, 23, 14e-6, 14e-6, 12, 10e-6)
    dent = sc.dents.spherical(grid, 6e-6, 60e-6, x=140e-6)
    gap = sc.surfaces.paraboloid(grid, 4.7625e-3)
    simulation = sc.Simulation(grid, ELASTIC, SWIFT, gap, relief2=dent)
    roll = {"load": 79.0, "advance": (-28e-6, -28e-6)}
    path = [{"load": 79.0}, *[roll] * 8, {"load": 0.0}]
    return simulation, simulation.run(path, progress=False)


def test_rolling_over_a_dent(over_a_dent):
    simulation, states = over_a_dent
    dataset = results.to_dataset(simulation, states)
    stress = dataset["max_von_mises_body2"].values
    expected = peak_of_dataset(dataset)
    assert stress[expected] > 0.999 * stress.max()
    assert 0 < expected < len(states) - 2
    assert stress[expected] > 1.3 * stress[0]  # the first of the largest load tells nothing
    assert dataset["output_increment"].values.tolist() == [expected + 1, len(states)]
    captions = [f.caption for f in report.contact.content(dataset)["figures"]]
    assert f"Pressure along x, increment {expected + 1}, 79 N" in captions
    assert f"Von Mises stress, body 2, increment {expected + 1}, 79 N" in captions
