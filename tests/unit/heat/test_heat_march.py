# SPDX-License-Identifier: GPL-3.0-or-later
"""Transient frictional heating with load history against closed solutions."""

import re

import numpy as np
import pytest

import samcontact as sc

E, NU = 210e9, 0.3
K, ALPHA, KAPPA = 50.2, 11.7e-6, 1.367e-5
RADIUS, LOAD = 7.5e-3, 1500.0
COLD = sc.Material.elastic(E, NU)
WARM = COLD.with_thermal(K, ALPHA, KAPPA)
STEEL = sc.Material.swift(E, NU, 945e6, 20.0, 0.121).with_thermal(K, ALPHA, KAPPA)
HERTZ = sc.hertz.point(RADIUS, sc.hertz.effective_modulus(COLD, COLD), load=LOAD)
CELLS = 19
SIZE = 2.9 * HERTZ.a / CELLS
GRID = sc.Grid(CELLS, CELLS, SIZE, SIZE, 11, 60e-6)
BALL = sc.surfaces.paraboloid(GRID, RADIUS)
PRESSURE = HERTZ.pressure(GRID.x[:, None], GRID.y)
FIELDS = ("temperature", "surface_temperature", "stress", "surface_displacement")
STEP = 1e-3  # sqrt(kappa t) = 0.28 contact radii


def heated(body2=WARM, body1=COLD, factor=0.05, longest=100.0, velocity=None, **settings):
    heat = sc.Heat(factor, velocity, history=(STEP, longest))
    return sc.Simulation(GRID, body1, body2, BALL, heat=heat, **settings)


def at_once(time, body2=WARM, factor=0.05, velocity=None):
    return sc.Simulation(GRID, COLD, body2, BALL, heat=sc.Heat(factor, velocity, time))


def assert_fields(a, b, tolerance, body=2):
    for name in FIELDS:
        x, y = getattr(a, name)(body), getattr(b, name)(body)
        np.testing.assert_allclose(x, y, rtol=0, atol=tolerance * np.abs(y).max(), err_msg=name)


class TestGivenFlux:
    @pytest.mark.parametrize("velocity", [(0.0, 0.0), (0.05, 0.0), (-0.5, 0.3)])
    def test_constant_flux_in_many_steps_or_one(self, velocity):
        simulation = heated(velocity=velocity)
        for _ in range(8):
            state = simulation.step(pressure=PRESSURE, duration=STEP)
        assert state.time == pytest.approx(8 * STEP)
        once = at_once(8 * STEP, velocity=velocity).step(pressure=PRESSURE)
        assert_fields(state, once, 1e-5)

    def test_shortest_and_longest_may_be_equal(self):
        state = heated(longest=STEP).step(pressure=PRESSURE, duration=STEP)
        assert_fields(state, at_once(STEP).step(pressure=PRESSURE), 1e-5)

    @pytest.mark.parametrize("velocity", [(0.0, 0.0), (0.2, 0.0)])
    def test_any_flux_is_a_sum_of_constant_ones(self, velocity):
        simulation = heated(velocity=velocity)
        rng = np.random.default_rng(3)
        steps = [(PRESSURE * rng.uniform(0, 1), STEP * rng.uniform(1, 4)) for _ in range(6)]
        for pressure, duration in steps:
            state = simulation.step(pressure=pressure, duration=duration)
        ends = np.cumsum([duration for _, duration in steps])
        last = steps[-1][0]
        # heat since t1 less heat since t2: the temperature is linear in the pressure
        expected = at_once(steps[-1][1], velocity=velocity).step(pressure=last)
        rise = expected.temperature()
        for n, (pressure, duration) in enumerate(steps[:-1]):
            age = ends[-1] - ends[n]
            older, newer = (
                at_once(t, velocity=velocity).step(pressure=pressure).temperature()
                for t in (age + duration, age)
            )
            rise = rise + older - newer
        np.testing.assert_allclose(state.temperature(), rise, atol=1e-5 * rise.max())

    def test_zero_flux_changes_nothing(self):
        cold = heated(factor=0.0)
        for duration in (STEP, 5 * STEP):
            state = cold.step(load=LOAD, duration=duration)
        plain = sc.Simulation(GRID, COLD, WARM, BALL).step(load=LOAD)
        assert not state.temperature().any()
        np.testing.assert_allclose(state.pressure, plain.pressure, atol=1e-6 * 4e9)

    def test_cools_down_to_nothing(self):
        simulation = heated(longest=1e4)
        state = simulation.step(pressure=PRESSURE, duration=20 * STEP)
        hot = state.surface_temperature().max()
        last = hot
        for n in range(20):
            state = simulation.step(pressure=0 * PRESSURE, duration=STEP * 2**n)
            now = state.surface_temperature().max()
            assert 0 <= now < last
            last = now
        # a source of short duration fades like t^(-3/2)
        assert last < 1e-6 * hot
        assert np.abs(state.stress()).max() < 1e-5 * E * ALPHA * hot
        assert state.surface_temperature().min() > -1e-9 * hot


class TestContact:
    def test_the_march_tends_to_the_steady_state(self):
        simulation = heated(longest=1e6)
        for n in range(32):
            state = simulation.step(load=LOAD, duration=STEP * 2**n)
        steady = sc.Simulation(GRID, COLD, WARM, BALL, heat=sc.Heat(0.05)).step(load=LOAD)
        np.testing.assert_allclose(
            state.pressure, steady.pressure, atol=1e-3 * steady.pressure.max()
        )
        for name in ("temperature", "stress"):
            a, b = getattr(state, name)(), getattr(steady, name)()
            np.testing.assert_allclose(a, b, atol=1e-3 * np.abs(b).max())

    def test_few_steps_are_sufficient(self):
        """The flux of a step is that at its end; the error due to its change is small."""
        found = []
        for parts in (2, 16):
            simulation = heated(factor=0.1)
            for _ in range(parts):
                state = simulation.step(load=LOAD, duration=16 * STEP / parts)
            found.append([state.pressure.max(), state.surface_temperature().max()])
        few, many = np.array(found)
        once = at_once(16 * STEP, factor=0.1).step(load=LOAD)
        assert (np.abs(few / many - 1) < 1e-3).all()
        assert once.pressure.max() == pytest.approx(many[0], rel=2e-3)

    def test_cost_and_memory_do_not_grow(self):
        simulation = heated()
        sizes = []
        for _ in range(30):
            state = simulation.step(load=LOAD, duration=STEP)
            sizes.append(0 if state._core.past2 is None else state._core.past2.size)
        assert sizes[0] == 0
        assert len(set(sizes[1:])) == 1
        assert state._core.past1 is None

    def test_heat_into_both_bodies_with_speeds_of_their_own(self):
        simulation = heated(
            WARM, WARM, (0.04, 0.02), velocity=[[0.0, 0.0], [0.3, 0.0]], on_border="warn"
        )
        for _ in range(4):
            state = simulation.step(load=LOAD, duration=2 * STEP)
        first, second = (state.surface_temperature(body) for body in (1, 2))
        assert first.max() > second.max() > 0
        assert GRID.x[second.argmax() // CELLS] > GRID.x[first.argmax() // CELLS]


class TestPlasticity:
    def test_load_hold_and_cool(self):
        simulation = heated(STEEL, factor=0.08)
        cold = sc.Simulation(GRID, COLD, STEEL, BALL).step(load=LOAD)
        for n in range(8):
            held = simulation.step(load=LOAD, duration=STEP * 2**n)
        assert held.max_equivalent_plastic_strain() > cold.max_equivalent_plastic_strain()
        off = simulation.step(load=LOAD, heat_factor=0.0, duration=STEP)
        assert 0 < off.temperature().max() < held.temperature().max()
        free = simulation.step(load=0.0, duration=STEP)
        assert free.temperature().max() > 1.0
        for n in range(14):
            free = simulation.step(load=0.0, duration=STEP * 2**n)
        assert free.temperature().max() < 0.5
        residual = free.residual_stress()
        thermal = E * ALPHA * free.temperature().max()
        np.testing.assert_allclose(free.stress(), residual, rtol=0, atol=3 * thermal)
        assert free.von_mises().max() > 50e6

    def test_fast_and_exact_and_mirrors(self):
        states = []
        for method in ("exact", "fast"):
            simulation = heated(STEEL, residual_stress=method)
            for _ in range(3):
                state = simulation.step(load=LOAD, duration=3 * STEP)
            states.append(state)
        exact, fast = (s.plastic_strain() for s in states)
        assert np.abs(fast - exact).max() < 0.05 * np.abs(exact).max()
        assert states[1]._core.history2["mirrored"] == 2

    def test_yield_condition(self):
        simulation = heated(STEEL, factor=0.06, velocity=(0.1, 0.0))
        for _ in range(3):
            state = simulation.step(load=LOAD, duration=3 * STEP)
        limit = STEEL.yield_stress(state.equivalent_plastic_strain())
        assert (state.von_mises() <= limit * (1 + 2e-6)).all()
        assert state.max_equivalent_plastic_strain() > 1e-3

    def test_automatic_increments(self):
        plain, load = heated(STEEL), 0.5 * LOAD
        for _ in range(12):
            expected = plain.step(load=load * (plain.state.time / STEP + 1) / 12, duration=STEP)
        simulation = heated(STEEL, increment_tol=4e-3)
        state = simulation.step(load=load, duration=12 * STEP)
        assert state.substeps > 1
        assert state.time == pytest.approx(12 * STEP)
        np.testing.assert_allclose(
            state.plastic_strain(),
            expected.plastic_strain(),
            atol=0.03 * np.abs(expected.plastic_strain()).max(),
        )

    def test_identical_bodies(self):
        simulation = heated(STEEL, STEEL, (0.03, 0.03))
        for _ in range(3):
            state = simulation.step(load=LOAD, duration=STEP)
        for name in ("stress", "plastic_strain", "temperature"):
            assert np.array_equal(getattr(state, name)(1), getattr(state, name)(2))
        assert np.array_equal(state._core.past1, state._core.past2)

    def test_softening_includes_past_heat(self):
        law = sc.softening.JohnsonCook(1800.0, 1.0)
        simulation = heated(STEEL.with_softening(law))
        for _ in range(4):
            state = simulation.step(load=LOAD, duration=5 * STEP)
        np.testing.assert_allclose(state.softening(), law(state.temperature()), atol=5e-3)
        off = simulation.step(load=LOAD, heat_factor=0.0, duration=STEP)
        assert off.softening().min() < 0.9


class TestCheckpoint:
    @pytest.mark.parametrize("velocity", [(0.0, 0.0), (0.2, 0.1)])
    def test_continuation_is_bit_identical(self, velocity, tmp_path):
        simulation = heated(STEEL, velocity=velocity)
        for load in (0.6 * LOAD, LOAD):
            simulation.step(load=load, duration=2 * STEP)
        simulation.save(tmp_path / "saved.h5")
        resumed = sc.Simulation.load(tmp_path / "saved.h5")
        assert resumed.state.time == simulation.state.time
        for name in FIELDS:
            a, b = (getattr(s.state, name)() for s in (simulation, resumed))
            assert np.array_equal(a, b)
        for load in (LOAD, 0.0):
            a, b = (s.step(load=load, duration=STEP) for s in (simulation, resumed))
            for name in (*FIELDS, "plastic_strain"):
                assert np.array_equal(getattr(a, name)(), getattr(b, name)())
            assert np.array_equal(a.pressure, b.pressure)


class TestBadInput:
    @pytest.mark.parametrize(
        ("settings", "text"),
        [
            ({"history": (0.0, 1.0)}, "history must be a finite number > 0, got 0.0"),
            ({"history": (1e-3, -1.0)}, "history must be a finite number > 0, got -1.0"),
            ({"history": (1.0, 1e-3)}, "with shortest <= longest"),
            ({"history": (1.0,)}, "history must be a pair"),
            ({"history": (1e-3, 1.0), "time": 1.0}, "history and time cannot be combined"),
        ],
    )
    def test_of_heat(self, settings, text):
        with pytest.raises(ValueError, match=re.escape(text)):
            sc.Heat(0.1, **settings)

    def test_a_single_contact_has_no_history(self):
        with pytest.raises(ValueError, match=r"heat\.history must be None for a single contact"):
            sc.ContactSolver(GRID, COLD, WARM, heat=sc.Heat(0.1, history=(1e-3, 1.0)))

    def test_steps_too_short_for_the_cells_are_refused_before_any_work(self):
        minimum = (0.02 * SIZE) ** 2 / KAPPA
        heat = sc.Heat(0.05, history=(1.001 * minimum, 1.0))
        sc.Simulation(GRID, COLD, WARM, BALL, heat=heat)
        heat = sc.Heat(0.05, history=(0.999 * minimum, 1.0))
        with pytest.raises(ValueError, match=r"heat\.history must have a shortest step"):
            sc.Simulation(GRID, COLD, WARM, BALL, heat=heat)
        with pytest.raises(ValueError, match=r"for body 1, .* of the cell length"):
            sc.Simulation(GRID, WARM, COLD, BALL, heat=sc.Heat((0.05, 0.0), history=heat.history))
        off = sc.Heat(0.0, history=heat.history)  # heats nothing yet
        simulation = sc.Simulation(GRID, COLD, WARM, BALL, heat=off)
        with pytest.raises(ValueError, match=r"heat\.history must have a shortest step"):
            simulation.step(load=LOAD, duration=STEP, heat_factor=0.05)
        assert simulation.state.time == 0

    @pytest.mark.parametrize(
        ("duration", "text"),
        [
            (None, "duration is required because heat.history is set"),
            (-1.0, "duration must be"),
            (0.0, "duration must be"),
            (np.nan, "duration must be"),
            (1e300, "duration must be <="),
            (0.5 * STEP, "duration must be >= the shortest step of heat.history, 0.001 s"),
        ],
    )
    def test_of_a_step(self, duration, text):
        simulation = heated()
        simulation.step(load=LOAD, duration=STEP)
        with pytest.raises(ValueError, match=re.escape(text)):
            simulation.step(load=LOAD, duration=duration)
        assert simulation.state.time == STEP

    def test_a_duration_without_history(self):
        with pytest.raises(ValueError, match=r"duration has no effect without heat\.history"):
            at_once(None).step(load=LOAD, duration=1.0)

    def test_a_failed_step_changes_nothing(self):
        simulation = heated()
        simulation.step(load=LOAD, duration=STEP)
        with pytest.raises(sc.GridTooSmallError):
            simulation.step(load=10 * LOAD, duration=STEP)
        assert simulation.state.time == STEP
        again = heated()
        for s in (simulation, again):
            state = s.step(load=LOAD, duration=STEP)
            if s is again:
                state = s.step(load=LOAD, duration=STEP)
        assert np.array_equal(simulation.state.pressure, state.pressure)
