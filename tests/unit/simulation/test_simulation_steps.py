# SPDX-License-Identifier: GPL-3.0-or-later
"""Increments that fail, are halved or refused; drivers: load, approach, paths."""

import math
import re
import warnings

import numpy as np
import pytest
from simulation_setups import (
    BALL,
    EXACT,
    GRID,
    LOAD,
    PRESSURE,
    RADIUS,
    RIGID,
    SIZE,
    SOFT,
    STEEL,
    assert_close,
    assert_same,
    simulation,
    snapshot,
)

import samcontact as sc
from samcontact import surfaces


class TestGridTooSmall:
    shallow = sc.Grid(19, 21, SIZE, 0.9 * SIZE, 6, SIZE)
    narrow = sc.Grid(7, 9, SIZE, SIZE, 12, SIZE)

    def test_plastic_strain_outside_the_fields_causes_one_warning(self):
        sim = simulation(grid=self.shallow)
        deep = r"body 2 extends to a depth of .*, below the output layers .*; omit nz"
        with pytest.warns(sc.GridTooSmallWarning, match=deep):
            state = sim.step(load=LOAD)
        assert state.equivalent_plastic_strain()[..., -1].any()
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            sim.step(load=1.01 * LOAD)

    def test_flow_outside_the_grid(self):
        """Under uniform pressure on a narrow grid, yield occurs below the edge of the load."""
        pressure = np.full(self.narrow.surface_shape, 2.3e9)
        gap = np.zeros(self.narrow.surface_shape)
        sim = simulation(SOFT, STEEL, gap, self.narrow)
        with pytest.warns(sc.GridTooSmallWarning, match="body 1 extends outside the grid along"):
            narrow = sim.step(pressure=pressure)
        wide_grid = sc.Grid(13, 15, SIZE, SIZE, 12, SIZE)
        wide = simulation(SOFT, STEEL, np.zeros((13, 15)), wide_grid)
        expected = wide.step(pressure=np.pad(pressure, 3))
        inner = expected.plastic_strain(1)[:, 3:-3, 3:-3]
        assert_close(narrow.plastic_strain(1), inner, 1e-4)

    def test_contact(self):
        gap = surfaces.paraboloid(self.narrow, RADIUS)
        text = r"at load .* N the contact reaches the edge .* enlarge nx dx .*, or "
        for body in (STEEL, SOFT):
            with pytest.raises(sc.GridTooSmallError, match=text):
                simulation(STEEL, body, gap, self.narrow).step(load=LOAD)
        warned = simulation(STEEL, STEEL, gap, self.narrow, on_border="warn")
        with pytest.warns(sc.GridTooSmallWarning, match="contact reaches the edge"):
            assert warned.step(load=LOAD).load == LOAD


FAILURES = {
    "bad load": ({"load": -1.0}, ValueError),
    "no target": ({}, ValueError),
    "two targets": ({"load": 1.0, "approach": 1.0}, ValueError),
    "bad pressure": ({"pressure": np.full(GRID.surface_shape, np.nan)}, ValueError),
    "shear with load": ({"load": 1.0, "shear": BALL}, ValueError),
    "contact at the border": ({"load": 40 * LOAD}, sc.GridTooSmallError),
}


class TestFailedStep:
    """After any failure the previous state and later increments are unchanged bit by bit."""

    @pytest.fixture(scope="class")
    @staticmethod
    def untroubled():
        sim = simulation()
        return [sim.step(load=part * LOAD) for part in (0.7, 1.0, 0.0)]

    @pytest.mark.parametrize("case", FAILURES)
    def test_a_failed_step_leaves_the_state_intact(self, case, untroubled):
        arguments, error = FAILURES[case]
        sim = simulation()
        sim.step(load=0.7 * LOAD)
        before = snapshot(sim.state)
        with pytest.raises(error):
            sim.step(**arguments)
        for name, values in snapshot(sim.state).items():
            np.testing.assert_array_equal(values, before[name], err_msg=name)
        for part, expected in ((1.0, untroubled[1]), (0.0, untroubled[2])):
            assert_same(sim.step(load=part * LOAD), expected)

    def test_no_convergence(self):
        """One iteration is never enough for flow, however often the increment is halved."""
        sim = simulation(max_iterations=1)
        first = sim.step(load=0.1 * LOAD)
        before = snapshot(first)
        with pytest.raises(
            sc.ConvergenceError, match="plastic strain did not converge at load"
        ) as caught:
            sim.step(load=LOAD)
        assert caught.value.iterations == 1
        assert caught.value.residual > 1e-6
        assert sim.counters["halvings"] > 1
        for name, values in snapshot(sim.state).items():
            np.testing.assert_array_equal(values, before[name], err_msg=name)
        elastic = sim.step(load=0.2 * LOAD)
        expected = simulation(STEEL, STEEL).step(load=0.2 * LOAD)
        assert_close(elastic.pressure, expected.pressure, 1e-6)


class TestHalving:
    def test_halving_equals_smaller_increments(self):
        whole = simulation(residual_stress="exact").step(load=LOAD)
        limit = whole.iterations - 1
        sim = simulation(max_iterations=limit, residual_stress="exact")
        state = sim.step(load=LOAD)
        assert whole.substeps == 1
        assert sim.counters["halvings"] >= 1
        assert limit < state.iterations <= state.substeps * limit
        by_hand = simulation(residual_stress="exact")
        for part in {2: (0.5, 1.0), 3: (0.5, 0.75, 1.0)}[state.substeps]:
            expected = by_hand.step(load=part * LOAD)
        np.testing.assert_array_equal(state.plastic_strain(), expected.plastic_strain())
        np.testing.assert_array_equal(state.pressure, expected.pressure)
        # first order in the increment: two differ from one, but not by much
        change = np.abs(state.pressure - whole.pressure).max() / whole.pressure.max()
        assert 1e-6 < change < 0.03

    @pytest.mark.parametrize("driver", ["approach", "pressure"])
    def test_other_drivers(self, driver):
        goal = {"approach": EXACT.approach, "pressure": PRESSURE}[driver]
        whole = simulation().step(**{driver: goal})
        sim = simulation(max_iterations=whole.iterations - 1)
        state = sim.step(**{driver: goal})
        assert state.substeps > 1
        change = np.abs(state.plastic_strain() - whole.plastic_strain()).max()
        assert 0 < change < 0.1 * np.abs(whole.plastic_strain()).max()
        np.testing.assert_allclose(getattr(state, driver), goal, rtol=1e-12)

    def test_too_many_sub_increments_state_a_feasible_tolerance(self):
        """A tolerance of 1e-5 requires 41 parts; their number varies with its fourth root."""
        grid = sc.Grid(7, 7, 1e-5, 1e-5, 3, 1e-5)
        gap = surfaces.paraboloid(grid, 10e-3)
        soft = sc.Material.linear_hardening(210e9, 0.3, 1e9, 21e9)
        options = {"increment_tol": 1e-6, "tol": 1e-8, "on_border": "warn"}
        sim = sc.Simulation(grid, sc.Material.elastic(210e9, 0.3), soft, gap, **options)
        with pytest.raises(
            ValueError, match="would require more than 64 sub-increments"
        ) as refused:
            sim.step(load=20.0)
        assert sim.state.load == 0.0
        enough = float(re.search(r"or increment_tol >= (\S+)$", str(refused.value))[1])
        assert enough == pytest.approx(1e-5 * (41 / 64) ** 4, rel=0.5)


class TestDrivers:
    def test_load_and_approach_agree(self):
        by_load, by_approach = simulation(tol=1e-8), simulation(tol=1e-8)
        for part in (0.5, 1.0, 0.4):
            one = by_load.step(load=part * LOAD)
            other = by_approach.step(approach=one.approach)
            assert other.load == pytest.approx(one.load, rel=1e-6)
            assert_close(other.pressure, one.pressure, 1e-6)
            assert_close(other.plastic_strain(), one.plastic_strain(), 1e-6)

    def test_apart(self):
        state = simulation().step(approach=-1e-6)
        assert (state.load, state.approach) == (0.0, -1e-6)
        assert not state.pressure.any()
        assert_close(state.gap, BALL + 1e-6, 1e-14)


class TestRun:
    path = ({"load": 0.5 * LOAD}, {"approach": EXACT.approach}, {"load": 0.0})

    def test_run_equals_successive_steps(self, capsys):
        sim, by_hand = simulation(), simulation()
        states = sim.run(iter(self.path), progress=False)
        assert capsys.readouterr().err == ""
        assert len(states) == 3
        for state, arguments in zip(states, self.path, strict=True):
            assert_same(state, by_hand.step(**arguments))

    def test_progress_bar(self, capsys):
        simulation().run([{"load": 1.0}])
        assert capsys.readouterr().err == "increment 1 of 1\n"

    def test_a_failure_keeps_the_reached_states(self):
        sim = simulation()
        path = [*self.path[:2], {"pressure": np.zeros((2, 2))}, {"load": 0.0}]
        with pytest.raises(ValueError, match="pressure must have shape") as caught:
            sim.run(path, progress=False)
        assert len(caught.value.states) == 2
        assert_same(sim.state, caught.value.states[-1])

    def test_empty_path(self):
        assert simulation().run([], progress=False) == []


class TestBadInput:
    @pytest.mark.parametrize(
        ("arguments", "error", "text"),
        [
            ({"grid": (19, 21)}, TypeError, "grid must be a samcontact.Grid, got (19, 21)"),
            (
                {"body1": 210e9},
                TypeError,
                "body1 must be a samcontact.Material, samcontact.Layered or "
                "samcontact.Heterogeneous, got 2",
            ),
            (
                {"body2": None},
                TypeError,
                "body2 must be a samcontact.Material, samcontact.Layered or "
                "samcontact.Heterogeneous, got None",
            ),
            ({"body1": RIGID, "body2": RIGID}, ValueError, "body1 and body2 are both rigid"),
            ({"gap": BALL[1:]}, ValueError, "gap must have shape (19, 21), got (18, 21)"),
            (
                {"gap": BALL * np.nan},
                ValueError,
                "gap must be finite everywhere, or +inf where there is no body, got nan at index",
            ),
            ({"gap": "ball"}, TypeError, "gap must be an array of numbers, got texts"),
            ({"friction": -0.1}, ValueError, "friction must be a finite number >= 0, got -0.1"),
            ({"friction": math.nan}, ValueError, "friction must be a finite number >= 0, got nan"),
            ({"friction": "much"}, TypeError, "friction must be a number, got 'much'"),
            ({"tol": 0.0}, ValueError, "tol must be in [1e-11, 1), got 0"),
            ({"tol": 2.0}, ValueError, "tol must be in [1e-11, 1), got 2"),
            ({"tol": math.nan}, ValueError, "tol must be in [1e-11, 1), got nan"),
            ({"increment_tol": 5e-6}, ValueError, "increment_tol must be in [10 tol, 1) with tol"),
            ({"increment_tol": 1.0}, ValueError, "increment_tol must be in (0, 1), got 1.0"),
            ({"increment_tol": "1 %"}, TypeError, "increment_tol must be a number, got '1 %'"),
            ({"on_border": "stop"}, ValueError, "on_border must be one of 'error', 'warn', got 's"),
            ({"max_iterations": 0}, ValueError, "max_iterations must be an integer >= 1, got 0"),
            (
                {"grid": sc.Grid(19, 21, SIZE, SIZE)},
                ValueError,
                "dz is required for an elastic-plastic body; the number of layers is chosen",
            ),
        ],
    )
    def test_bad_arguments_of_the_simulation(self, arguments, error, text):
        good = {"grid": GRID, "body1": STEEL, "body2": SOFT, "gap": BALL}
        with pytest.raises(error, match=re.escape(text)):
            sc.Simulation(**(good | arguments))

    @pytest.mark.parametrize(
        ("arguments", "error", "text"),
        [
            ({}, ValueError, "one of load, approach, pressure must be given"),
            (
                {"load": 1.0, "approach": 0.0},
                ValueError,
                "pressure must be given, got load, approach",
            ),
            (
                {"load": 1.0, "pressure": BALL},
                ValueError,
                "pressure must be given, got load, pressure",
            ),
            ({"load": -1.0}, ValueError, "load must be a finite number >= 0 [N], got -1"),
            ({"load": math.nan}, ValueError, "load must be a finite number >= 0 [N], got nan"),
            ({"load": math.inf}, ValueError, "load must be a finite number >= 0 [N], got inf"),
            ({"load": "1 kN"}, TypeError, "load must be a number, got '1 kN'"),
            ({"approach": math.inf}, ValueError, "approach must be a finite number [m], got inf"),
            ({"approach": None, "load": None}, ValueError, "pressure must be given, got none"),
            ({"pressure": BALL.T}, ValueError, "pressure must have shape (19, 21), got (21, 19)"),
            (
                {"pressure": BALL + np.inf},
                ValueError,
                "pressure must be finite everywhere, got inf",
            ),
            ({"pressure": BALL, "shear": BALL[1:]}, ValueError, "shear must have shape (19, 21)"),
            (
                {"pressure": BALL, "shear": np.zeros((3, 19, 21))},
                ValueError,
                "shear must have shape (2, 19, 21), got (3, 19, 21)",
            ),
            ({"pressure": BALL, "shear": BALL * np.nan}, ValueError, "shear must be finite every"),
            ({"load": 1.0, "shear": BALL}, ValueError, "shear cannot be combined with load"),
            ({"shear": BALL}, ValueError, "one of load, approach, pressure must be given"),
        ],
    )
    def test_of_a_step(self, arguments, error, text):
        with pytest.raises(error, match=re.escape(text)):
            simulation().step(**arguments)

    def test_the_gap_is_copied(self):
        gap = BALL.copy()
        sim = simulation(gap=gap)
        gap[...] = np.nan
        assert_same(sim.step(load=LOAD), simulation().step(load=LOAD))
