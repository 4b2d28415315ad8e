# SPDX-License-Identifier: GPL-3.0-or-later
"""Adhesive rough contact: stored times, iterations, and pressures of other codes."""

import importlib

import pytest

from benchmarks.adhesion_peers.code_samcontact import Contact
from benchmarks.adhesion_peers.page import STUDY, path_of
from benchmarks.adhesion_peers.problems import Path, errors

STORED = STUDY.records()
pytestmark = pytest.mark.filterwarnings("ignore::UserWarning")


@pytest.mark.parametrize("of", ["periodic", "free"])
def test_other_codes_take_three_times_as_long_on_fine_grids(of):
    rows = [row for row in STORED if row["of"] == of and row["n"] >= 256]
    assert len(rows) > 1
    for row in rows:
        assert row["code"] == "samcontact" or row["ratio"] >= 3.0


@pytest.mark.parametrize(("n", "distance", "most"), [(128, 1.0, 60), (256, 0.8, 100)])
def test_a_cold_start_takes_few_iterations(n, distance, most):
    """A fifth to a third of the cells are in contact."""
    (state,) = Contact(Path(n, "xy", 0.5, (distance,)), 1e-9).solve()
    assert 0.2 < (state.gap <= 0).mean() < 0.45
    assert state.iterations <= most


@pytest.mark.parametrize("of", ["periodic", "free"])
@pytest.mark.parametrize(("code", "package"), [("tamaas", "tamaas"), ("adhesion", "Adhesion")])
def test_other_codes_find_the_same_states(code, package, of):
    pytest.importorskip(package)
    if (code, of) == ("tamaas", "free"):
        pytest.skip("tamaas has no such solver")
    module = importlib.import_module(f"benchmarks.adhesion_peers.code_{code}")
    path = path_of(of, 32)
    pressure, energy, same = errors(
        path, module.Contact(path, 1e-9).solve(), Contact(path, 1e-11).solve()
    )
    assert same == len(path.distances)
    assert pressure < 1e-7
    assert energy < 1e-8
