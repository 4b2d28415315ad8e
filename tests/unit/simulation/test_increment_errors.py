# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors due to increments are estimated, listed in tables and cause warnings."""

import warnings
from types import SimpleNamespace

import numpy as np
import pytest

import samcontact as sc
from benchmarks.increment_errors import (
    ALUMINIUM,
    PERFECT,
    RIGID,
    SETUPS,
    STEEL,
    SWIFT,
    ball,
    errors,
    pressed,
)  # fmt: skip
from command import fields, invoke
from samcontact import report
from samcontact.report.tables import errors_table
from samcontact.simulation import increment_errors
from samcontact.simulation.increment_paths import doubled, halved


def silent(sim):
    """Return a simulation without its own error estimates."""
    sim.monitor.checks_increments = False
    return sim


@pytest.mark.parametrize("name", SETUPS)
def test_stated_errors_are_the_true_ones(name):
    """Estimated errors agree within a factor of two, rather too large, or both are small."""
    problem = SETUPS[name]
    for field, pairs in errors(problem, problem.counts[1:2], problem.many // 2).items():
        ((true, stated),) = pairs
        assert 0.3 < true / stated < 1.5 or max(true, stated) < 0.01, (field, true, stated)


def warned(call):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        call()
    return [str(w.message) for w in caught if w.category is sc.IncrementWarning]


class TestWarning:
    def dissimilar(self):
        return ball(RIGID, ALUMINIUM, 50.0, sc.Coulomb(0.3))

    @pytest.mark.parametrize("by_hand", [True, False])
    def test_one_large_increment_causes_one_warning(self, by_hand):
        sim = self.dissimilar()
        calls = [
            lambda: sim.step(load=50.0) if by_hand else sim.run([{"load": 50.0}], progress=False),
            lambda: sim.run(pressed(50.0, 4), progress=False),
        ]
        (text,) = warned(calls[0])
        assert text.startswith("more increments would change the shear by about ")
        assert "twice as many increments" in text
        assert "times as many for 5 %" in text
        assert warned(calls[1]) == []

    def test_accumulated_manual_steps_cause_a_warning(self):
        """Errors are estimated at the first, fourth and sixteenth increment."""
        sim = ball(RIGID, PERFECT, 2000.0)
        texts = [warned(lambda s=s: sim.step(**s)) for s in pressed(2000.0, 4)]
        assert sum(map(len, texts)) == 1

    def test_small_increments_cause_no_warning(self):
        sim = ball(STEEL, SWIFT, 1000.0, 0.1)
        assert warned(lambda: sim.run(pressed(1000.0, 4), progress=False)) == []
        assert sim.engine.history.checked == 4  # it was looked at

    def test_a_continued_run_causes_a_warning(self):
        """The estimate covers the whole path, whose first part is not path-dependent."""
        sim = ball(RIGID, PERFECT, 2000.0)
        assert warned(lambda: sim.run([{"load": 10.0}], progress=False)) == []
        assert len(warned(lambda: sim.run([{"load": 2000.0}], progress=False))) == 1

    def test_the_estimate_does_not_change_the_simulation(self):
        loud, quiet = self.dissimilar(), silent(self.dissimilar())
        for sim in (loud, quiet):
            warned(lambda sim=sim: sim.run(pressed(50.0, 2), progress=False))
        np.testing.assert_array_equal(loud.state.shear, quiet.state.shear)
        assert loud.counters == quiet.counters


@pytest.mark.parametrize(
    ("sim", "path"),
    [
        (lambda: ball(STEEL, ALUMINIUM, 50.0), pressed(50.0, 1)),
        (lambda: ball(STEEL, STEEL, 50.0, sc.Coulomb(0.3)), pressed(50.0, 1)),
        (lambda: ball(RIGID, PERFECT, 2000.0, increment_tol=0.1), pressed(400.0, 1)),
        (lambda: ball(STEEL, SWIFT, 1000.0), pressed(10.0, 1)),
    ],
    ids=["elastic", "like bodies", "controlled", "no flow"],
)
def test_path_independent_increments_are_not_repeated(sim, path, monkeypatch):
    monkeypatch.setattr(increment_errors, "_compared", None)  # would be called
    made, states = sim(), []
    assert warned(lambda: states.extend(made.run(path, progress=False))) == []
    assert not increment_errors.is_path_dependent(made.engine.setup, states)


def test_nothing_is_estimated_if_the_warning_is_ignored(monkeypatch):
    calls = []
    monkeypatch.setattr(increment_errors, "_compared", lambda *given: calls.append(given))
    for action in ("ignore", "always"):
        with warnings.catch_warnings():
            warnings.simplefilter("always")
            warnings.filterwarnings("ignore", "a text", sc.IncrementWarning)  # not all of them
            warnings.filterwarnings(action, category=sc.IncrementWarning)
            ball(RIGID, PERFECT, 2000.0).run(pressed(2000.0, 1), progress=False)
        assert len(calls) == (action == "always")


def test_errors_of_an_unknown_history_are_not_estimated():
    sim = ball(RIGID, PERFECT, 2000.0)
    sim.set_plastic_strain(2, np.zeros((6, *sim.grid.surface_shape, 2)))
    assert warned(lambda: sim.step(load=2000.0)) == []
    assert sim.engine.history.steps is None


def test_strain_of_cells_that_a_void_fills_partly_is_omitted():
    """The matrix in such a cell carries little load, and its strain depends on the increments."""
    share = np.zeros((3, 3, 2))
    share[0, 0, 0], share[1, 1, 1] = 0.9, 1.0

    def state(**strain):
        found = np.full(share.shape, 0.01)
        found[0, 0, 0] = strain.get("cut", 0.05)
        found[2, 2, 0] = strain.get("matrix", 0.02)
        return SimpleNamespace(
            pressure=np.ones((3, 3)),
            share=lambda body: share * (body == 2),
            equivalent_plastic_strain=lambda body: found,
            max_equivalent_plastic_strain=lambda body: 0.05 * (body == 2),
        )

    setup = ball(RIGID, PERFECT, 50.0).engine.setup
    for other, error in ((state(cut=0.03), 0.0), (state(matrix=0.019), 0.05)):
        pairs = [(state(), other)]
        found = increment_errors._field_differences(setup, pairs, pairs)
        assert found["equivalent_plastic_strain_body2"] == pytest.approx(error)


class State:
    """State that contains only the targets reached along a path."""

    def __init__(self, load, force=0.0):
        self.load, self.approach, self.torque = load, 1e-9 * load, 0.0
        self.tangential_load = (force, 1e-17)


class TestPaths:
    HEAT = sc.Heat(0.0)

    def test_twice_as_many(self):
        path = [{"load": 2.0}, {"load": 2.0, "shift": (4e-6, None)}, {"approach": 3e-9},
                {"load": 0.0, "advance": (2.0, 2.0)},
                {"load": 1.0, "advance": (1.0, 1.0)}]  # fmt: skip
        states = [State(2.0), State(2.0), State(4.0), State(0.0), State(1.0)]
        found, ends = doubled(path, states, 0.0, (1.0, None), self.HEAT)
        assert found == [
            {"load": 1.0}, {"load": 2.0},
            {"load": 2.0, "shift": (2e-6, None)}, {"load": 2.0, "shift": (2e-6, None)},
            {"approach": 2.5e-9}, {"approach": 3e-9},
            {"load": 2.0, "advance": (1.0, 1.0)}, {"load": 0.0, "advance": (1.0, 1.0)},
            {"load": 1.0, "advance": (1.0, 1.0)},  # half a cell is not exact
        ]  # fmt: skip
        assert ends == [(0, 1), (1, 3), (2, 5), (3, 7), (4, 8)]

    def test_half_as_many_without_reversals(self):
        loads = [1.0, 2.0, 3.0, 4.0, 3.5, 3.0, 3.0]
        path = [{"load": load} for load in loads]
        found, ends = halved(path, [State(load) for load in loads], 0.0) or ([], [])
        assert found == [{"load": 2.0}, {"load": 4.0}, {"load": 3.0}, {"load": 3.0}]
        assert ends == [(1, 0), (3, 1), (5, 2), (6, 3)]

    @pytest.mark.parametrize("loads", [[0.1, 2.0], [0.1, 0.2, 0.3, 0.4, 5.0], [1.0, 2.0, 0.0]])
    def test_no_halving_if_one_increment_dominates(self, loads):
        """A dominant increment gives no estimate, merged with a small increment or not."""
        path = [{"load": load} for load in loads]
        assert halved(path, [State(load) for load in loads], 0.0) is None

    def test_half_as_many_of_motions_and_forces(self):
        path = [{"load": 1.0, "tangential_load": (q, 0.0)} for q in (1.0, 2.0, 1.0, 0.0)]
        path += [{"load": 1.0, "shift": (s, None)} for s in (1e-6, 2e-6, -1e-6)]
        path = [{"load": 0.5}, {"load": 1.0}, *path]
        found, _ = halved(path, [State(0.5), *[State(1.0)] * 8], 0.0)
        assert [tuple(step.values()) for step in found] == [
            (1.0,), (1.0, (2.0, 0.0)), (1.0, (0.0, 0.0)), (1.0, (3e-6, None)), (1.0, (-1e-6, None)),
        ]  # fmt: skip


CASE = """
title = "dissimilar bodies"
grid = {nx = 25, ny = 25, dx = 15e-6, dy = 15e-6}
body1 = {law = "elastic", E = 210e9, nu = 0.3}
body2 = {law = "elastic", E = 70e9, nu = 0.2}
surface = {shape = "paraboloid", Rx = 7.5e-3}
contact = {friction = {coulomb = 0.3}}
path = [{load = 20.0, increments = 1}]
output = {figures = false}
"""


def test_table_results_and_report_state_increment_errors(tmp_path):
    (tmp_path / "case.toml").write_text(CASE)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        outcome = invoke("run", tmp_path / "case.toml", "--output", tmp_path / "out")
    assert outcome.exit_code == 0
    assert [w.category for w in caught].count(sc.IncrementWarning) <= 1
    assert "Estimated grid errors" in outcome.stdout
    data = fields(tmp_path / "out")
    shear = data.attrs["increment_error_shear"]
    assert shear > 0.3
    assert f"the shear by about {float(f'{100 * shear:.2g}'):g} %" in " ".join(
        outcome.stdout.split()
    )
    assert 0 < data["max_pressure_error"].attrs["by_increments"] < 0.05
    found = {v.name: v for v in report.checks(data)}
    (name,) = (
        n for n in found if n.startswith("maximum estimated relative error due to increments")
    )
    assert not found[name].passed
    assert found[name].value == pytest.approx(shear)
    table = errors_table(data)
    assert "increment error [%]" in table.headings
    assert "More increments would change the shear" in table.note


def test_shares_are_written_without_powers_of_ten():
    shares = {"shear": 0.999, "pressure": 12.34, "gap": 0.004567}
    shown = increment_errors.error_summary(shares)
    expected = "the pressure by about 1200 %, the shear by about 100 %, the gap by about 0.46 %"
    assert shown == f"more increments would change {expected}"
