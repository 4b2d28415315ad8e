# SPDX-License-Identifier: GPL-3.0-or-later
"""Pickled or copied simulations and states are independent and bit-identical."""

import copy
import pickle
import warnings
from pathlib import Path

import numpy as np
import pytest

import samcontact as sc
from checkpoint_setups import GAP, GRID, LOAD, MATERIALS, assert_same, halved, simulation

CASES = Path(__file__).parents[3] / "cases"
COPIES = {
    "pickle": lambda thing: pickle.loads(pickle.dumps(thing)),
    "deepcopy": copy.deepcopy,
    "copy": copy.copy,
}


def moving():
    """Two elastic-plastic bodies with a dent, friction, transient heat and an unstorable law."""
    steel = MATERIALS["swift"].with_thermal(50.0, 1e-5, 1.4e-5).with_softening(halved)
    velocity = [[0.0, 0.0], [GRID.dx / 1e-3, 0.0]]
    heat = sc.Heat([0.0, 1e-4], velocity, history=(1e-3, 0.1))
    dent = sc.dents.spherical(GRID, 1e-7, 3 * GRID.dx)
    return sc.Simulation(
        GRID, MATERIALS["linear"], steel, GAP, 0.1, heat=heat, relief2=dent,
        on_border="warn",
    )  # fmt: skip


STEP = {"load": 0.5 * LOAD, "advance": (0.0, GRID.dx), "duration": 1e-3}


@pytest.fixture(scope="module")
def stepped():
    """Return a simulation with all features, its two states, and the next, of a deep copy."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", sc.GridTooSmallWarning)
        sim = moving()
        first = sim.step(**STEP)
        second = sim.step(**STEP | {"heat_factor": 0.0})
        return sim, first, second, copy.deepcopy(sim).step(**STEP)


@pytest.mark.parametrize("copied", COPIES.values(), ids=COPIES)
@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
def test_copies_of_a_simulation_with_all_features(copied, stepped):
    sim, first, second, third = stepped
    assert second.plastic_cells() > 0
    other = copied(sim)
    assert repr(other) == repr(sim)
    assert_same(other.state, second)
    for state in (first, second):  # the first, although the simulation has gone on
        again = copied(state)
        assert_same(again, state)
        assert again.heat_factor == state.heat_factor
        np.testing.assert_array_equal(again.temperature(2), state.temperature(2))
    assert_same(other.step(**STEP), third)
    assert_same(sim.state, second)  # no copy moves what it was made of


def test_states_travel_between_processes_in_a_list():
    sim = simulation()
    states = sim.run([{"load": 0.5 * LOAD}, {"load": LOAD}, {"load": 0.0}], progress=False)
    for one, other in zip(pickle.loads(pickle.dumps(states)), states, strict=True):
        assert_same(one, other)


def test_issued_warnings_are_not_repeated_by_copies():
    sim = simulation()
    sim.monitor.strain_warned = True
    assert copy.deepcopy(sim).monitor.strain_warned


def test_a_law_that_cannot_be_pickled_is_reported():
    steel = MATERIALS["linear"].with_thermal(50.0, 1e-5, 1.4e-5).with_softening(lambda rise: 1.0)
    sim = sc.Simulation(GRID, MATERIALS["elastic"], steel, GAP)
    with pytest.raises((pickle.PicklingError, AttributeError), match="lambda"):
        pickle.dumps(sim)


@pytest.mark.parametrize("copied", COPIES.values(), ids=COPIES)
@pytest.mark.parametrize("friction", [0.2, sc.Coulomb(0.3)])
def test_copies_of_solvers_are_independent(copied, friction):
    coated = sc.Layered([(MATERIALS["elastic"], 2 * GRID.dx)], sc.Material.elastic(70e9, 0.2))
    solver = sc.ContactSolver(GRID, MATERIALS["elastic"], coated, friction, tol=1e-6)
    other = copied(solver)
    assert repr(other) == repr(solver)
    solved = [one.solve(GAP, load=0.5 * LOAD).pressure for one in (solver, other)]
    np.testing.assert_array_equal(*solved)


@pytest.mark.parametrize("copied", COPIES.values(), ids=COPIES)
def test_copies_of_cases_are_independent(copied):
    for file in sorted(CASES.glob("*.toml")):
        case = sc.cases.load_case(file)
        assert copied(case) == case


@pytest.mark.parametrize("copied", COPIES.values(), ids=COPIES)
def test_copies_of_wear_results_are_independent(copied):
    path = [{"load": LOAD}, {"load": 0.0}]
    bodies = MATERIALS["elastic"], MATERIALS["linear"]
    found = sc.wear.run(
        GRID, *bodies, GAP, cycle=path, threshold=1e-4, window=3, cycles=1, progress=False
    )
    other = copied(found)
    np.testing.assert_array_equal(other.heights[2], found.heights[2])
    assert_same(other.first[-1], found.first[-1])
