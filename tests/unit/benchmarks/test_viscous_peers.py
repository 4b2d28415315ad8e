# SPDX-License-Identifier: GPL-3.0-or-later
"""Creep of rough surfaces: stored times and errors, order of the rules, pressures of tamaas."""

import importlib

import numpy as np
import pytest

from benchmarks.viscous_peers.code_samcontact import pressure_after
from benchmarks.viscous_peers.page import STUDY
from benchmarks.viscous_peers.problems import Creep, error

STORED = STUDY.records()
pytestmark = pytest.mark.filterwarnings("ignore::UserWarning")


def test_tamaas_takes_five_times_as_long_for_equal_errors():
    rows = [row for row in STORED if row["code"] == "tamaas"]
    assert len(rows) == len(STUDY.points(False))
    for row in STORED:
        assert row["error"] <= row["allowed"]
    assert all(row["ratio"] >= 5 for row in rows)


def test_the_rule_is_of_second_order():
    coarse, fine, finest = (pressure_after(Creep(32), steps, 1e-9) for steps in (4, 8, 16))
    assert error(coarse, finest) > 3.5 * error(fine, finest)


def test_tamaas_converges_to_the_same_pressure():
    """The error of the backward Euler rule is halved with the steps."""
    pytest.importorskip("tamaas")
    tamaas = importlib.import_module("benchmarks.viscous_peers.code_tamaas")
    problem = Creep(32)
    exact = pressure_after(problem, 64, 1e-9)
    coarse, fine = (tamaas.pressure_after(problem, steps, 1e-9) for steps in (32, 64))
    assert error(2 * fine - coarse, exact) < 3e-3
    assert error(fine, exact) < 0.6 * error(coarse, exact)
    assert np.all(fine >= 0)
