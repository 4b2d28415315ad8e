# SPDX-License-Identifier: GPL-3.0-or-later
"""Frictional heat in elastic-plastic increments, and thermal softening."""

import re

import numpy as np
import pytest
from heat_setups import ALPHA, COLD, KAPPA, LOAD, NU, WARM, E, K, ball, grid_of, solver

import samcontact as sc

STEEL = sc.Material.swift(E, NU, 945e6, 20.0, 0.121).with_thermal(K, ALPHA, KAPPA)


def simulation(grid, factor, body1=COLD, body2=STEEL, settings=None, **heat):
    heat = sc.Heat(factor, **heat)
    return sc.Simulation(grid, body1, body2, ball(grid), heat=heat, **(settings or {}))


VOLUME = {"nz": 20, "dz": 33e-6}


class TestSimulation:
    def test_elastic_state_is_that_of_the_solver(self):
        grid = grid_of(31, 1.4, nz=6, dz=5e-5)
        settings = {"velocity": (0.2, 0.0), "time": 1e-2}
        for extra in ({}, settings):
            state = simulation(grid, 0.05, body2=WARM, **extra).step(load=LOAD)
            direct = solver(grid, 0.05, **extra)
            found = direct.solve(ball(grid), load=LOAD)
            p = found.pressure
            np.testing.assert_allclose(state.pressure, p, atol=1e-6 * p.max())
            assert state.approach == pytest.approx(found.approach, rel=1e-5, abs=1e-10)
            stress = direct.stress(state.pressure, grid.z)
            np.testing.assert_allclose(state.stress(), stress, atol=1e-10 * np.abs(stress).max())
            rise = direct.temperature(state.pressure, grid.z)
            np.testing.assert_allclose(state.temperature(), rise, atol=1e-10 * rise.max())
            flash = direct.temperature(state.pressure)[..., 0]
            np.testing.assert_allclose(state.surface_temperature(), flash, atol=1e-9 * flash.max())
            np.testing.assert_allclose(state.gap, found.gap, atol=1e-6 * found.gap.max())
            gap = ball(grid) - state.approach
            gap = gap + state.surface_displacement(1) + state.surface_displacement(2)
            np.testing.assert_allclose(state.gap, gap, atol=1e-9 * gap.max())

    def test_cold_after_unloading(self):
        heated = simulation(grid_of(25, 1.5, **VOLUME), 0.05)
        assert heated.step(load=LOAD).temperature().max() > 100
        cooled = heated.step(load=0.0)
        assert not cooled.temperature().any()
        np.testing.assert_allclose(cooled.stress(), cooled.residual_stress(), atol=1.0)

    @pytest.mark.parametrize("extra", [{}, {"velocity": (0.3, 0.0)}, {"time": 1e-3}])
    def test_fast_and_exact_residual_stress(self, extra):
        grid = grid_of(25, 1.5, nz=20, dz=45e-6)
        states = []
        for method in ("exact", "fast"):
            heated = simulation(grid, 0.04, settings={"residual_stress": method}, **extra)
            states.append(heated.run([{"load": 1000.0}, {"load": LOAD}], progress=False)[-1])
        exact, fast = (s.plastic_strain() for s in states)
        assert np.abs(exact).max() > 3e-4
        assert np.abs(fast - exact).max() < 0.05 * np.abs(exact).max()
        mirrored = states[1]._core.history2["mirrored"]
        assert mirrored == (1 if "velocity" in extra else 2)

    def test_load_hold_switch_off_unload(self):
        grid = grid_of(31, 1.4, **VOLUME)
        heated = simulation(grid, 0.03)
        hot = heated.step(load=LOAD)
        hold = heated.step(load=LOAD)
        np.testing.assert_allclose(hold.plastic_strain(), hot.plastic_strain(), rtol=0, atol=1e-8)
        off = heated.step(load=LOAD, heat_factor=0.0)
        assert heated.heat.factor == (0.0, 0.0)
        assert hot.temperature().max() > 100
        assert not off.temperature().any()
        # without heat the maximum stress is higher, so the steel yields further
        assert off.max_equivalent_plastic_strain() > hot.max_equivalent_plastic_strain()
        free = heated.step(load=0.0)
        assert free.von_mises().max() > 50e6

    def test_a_failed_step_keeps_the_heat_factor(self):
        heated = simulation(grid_of(9, 0.5, **VOLUME), 0.03)
        with pytest.raises(sc.GridTooSmallError):
            heated.step(load=LOAD, heat_factor=0.01)
        assert heated.heat.factor == (0.0, 0.03)

    def test_identical_heated_bodies(self):
        grid = grid_of(25, 1.5, **VOLUME)
        again = sc.Material.swift(E, NU, 945e6, 20.0, np.nextafter(0.121, 1)).with_thermal(
            K, ALPHA, KAPPA
        )
        one, two = (
            simulation(grid, (0.02, 0.02), STEEL, other, {"tol": 1e-9}).step(load=LOAD)
            for other in (STEEL, again)
        )
        for body in (1, 2):
            a, b = one.plastic_strain(body), two.plastic_strain(body)
            assert np.abs(a).max() > 1e-4
            np.testing.assert_allclose(a, b, atol=1e-8 * np.abs(b).max())
        different = simulation(grid, (0.02, 0.05), STEEL, STEEL).step(load=LOAD)
        assert not np.array_equal(different.plastic_strain(1), different.plastic_strain(2))

    def test_prescribed_pressure_heats(self):
        grid = grid_of(25, 1.5, **VOLUME)
        contact = simulation(grid, 0.05).step(load=LOAD)
        given = simulation(grid, 0.05).step(pressure=contact.pressure)
        np.testing.assert_allclose(
            given.plastic_strain(), contact.plastic_strain(), rtol=0, atol=1e-8
        )

    def test_a_simulation_without_heat_builds_no_heat_operators(self):
        grid = grid_of(25, 1.5, **VOLUME)
        cold = sc.Simulation(grid, COLD, STEEL, ball(grid))
        zero = simulation(grid, 0.0, velocity=(1.0, 0.0), time=1.0)
        for s in (cold, zero):
            s.step(load=LOAD)
        assert cold.counters == zero.counters
        assert np.array_equal(cold.state.plastic_strain(), zero.state.plastic_strain())

    @pytest.mark.parametrize("extra", [{}, {"velocity": (0.3, 0.1), "time": 2e-3}])
    def test_continuation_from_a_checkpoint_is_bit_identical(self, extra, tmp_path):
        grid = grid_of(21, 1.5, nz=16, dz=45e-6)
        heated = simulation(grid, 0.05, reference=0.3, **extra)
        heated.step(load=1000.0)
        heated.step(load=1100.0, heat_factor=0.04)
        heated.save(tmp_path / "saved.h5")
        resumed = sc.Simulation.load(tmp_path / "saved.h5")
        assert resumed.body2 == STEEL
        assert resumed.heat.factor == (0.0, 0.04)
        for field in ("stress", "temperature"):
            a, b = (getattr(s.state, field)() for s in (heated, resumed))
            assert np.array_equal(a, b)
        for load in (LOAD, 0.0):
            a, b = heated.step(load=load), resumed.step(load=load)
            assert np.array_equal(a.pressure, b.pressure)
            assert np.array_equal(a.plastic_strain(), b.plastic_strain())


@pytest.mark.usefixtures("steps_alone")
class TestSoftening:
    LAW = sc.softening.JohnsonCook(melting=1800.0, m=1.0)

    def test_johnson_cook(self):
        law = sc.softening.JohnsonCook(1793.15, 2.0)
        rise = np.array([[0.0, 750.0], [1500.0, 3000.0]])
        np.testing.assert_allclose(law(rise), [[1.0, 0.75], [0.01, 0.01]])
        shifted = sc.softening.JohnsonCook(1500.0, 1.0, reference=500.0, ambient=300.0, floor=0.2)
        np.testing.assert_allclose(shifted([100.0, 700.0, 1190.0]), [1.0, 0.5, 0.2])

    @pytest.mark.parametrize(
        ("arguments", "error", "text"),
        [
            ((200.0, 1.0), ValueError, "melting must be > reference"),
            ((1800.0, 0.0), ValueError, "m must be"),
            ((1800.0, 1.0, 293.0, 293.0, 0.0), ValueError, "floor must be in (0, 1]"),
            (("hot", 1.0), TypeError, "melting must be a number"),
        ],
    )
    def test_johnson_cook_refuses(self, arguments, error, text):
        with pytest.raises(error, match=re.escape(text)):
            sc.softening.JohnsonCook(*arguments)

    def test_yield_stress_falls_with_the_temperature(self):
        grid = grid_of(31, 1.5, nz=24, dz=33e-6)
        states = [
            simulation(grid, 0.02, body2=body).step(load=LOAD)
            for body in (STEEL, STEEL.with_softening(self.LAW))
        ]
        hard, soft = states
        assert soft.max_equivalent_plastic_strain() > 2 * hard.max_equivalent_plastic_strain()
        factor = soft.softening()
        assert 0.6 < factor.min() < 0.8
        # softening uses the temperature of the first contact solution, which differs from the last
        np.testing.assert_allclose(factor, self.LAW(soft.temperature()), atol=0.02)
        limit = factor * STEEL.yield_stress(soft.equivalent_plastic_strain())
        assert (soft.von_mises() <= limit * (1 + 1e-5)).all()
        assert (hard.softening() == 1).all()

    def test_a_temperature_rise_that_is_nan(self):
        with pytest.raises(ValueError, match=r"rise must be finite everywhere, got nan$"):
            self.LAW(np.nan)
        with pytest.raises(ValueError, match=r"rise must be finite everywhere, got nan at index"):
            self.LAW([1.0, np.nan])

    def test_softening_without_heat_changes_nothing(self):
        grid = grid_of(21, 1.5, nz=16, dz=45e-6)
        plain = simulation(grid, 0.0).step(load=LOAD)
        soft = simulation(grid, 0.0, body2=STEEL.with_softening(self.LAW)).step(load=LOAD)
        assert np.array_equal(plain.plastic_strain(), soft.plastic_strain())

    def test_a_softening_function_is_called_once_per_increment(self):
        grid = grid_of(21, 1.5, nz=16, dz=45e-6)
        calls = []

        def law(rise):
            calls.append(rise.shape)
            return 1 - 1e-4 * np.minimum(rise, 5000.0)

        heated = simulation(grid, 0.02, body2=STEEL.with_softening(law))
        heated.run([{"load": 1000.0}, {"load": LOAD}], progress=False)
        assert calls == [grid.volume_shape] * 2
        assert heated.state.softening().min() < 0.97

    @pytest.mark.parametrize(
        ("value", "text"),
        [
            (0.0, "softening of body 2 must be in (0, 1], got 0"),
            (1.5, "softening of body 2 must be in (0, 1], got 1.5"),
            (np.nan, "factor of softening must be finite"),
        ],
    )
    def test_bad_factors(self, value, text):
        grid = grid_of(21, 1.5, nz=16, dz=45e-6)
        body = STEEL.with_softening(lambda rise: np.full(rise.shape, value))
        heated = simulation(grid, 0.02, body2=body)
        with pytest.raises(ValueError, match=re.escape(text)):
            heated.step(load=LOAD)
        assert heated.state.load == 0.0

    def test_an_error_of_the_softening_law_is_raised(self):
        grid = grid_of(21, 1.5, nz=16, dz=45e-6)

        def law(rise):
            raise KeyError("lost")

        with pytest.raises(KeyError, match="lost"):
            simulation(grid, 0.02, body2=STEEL.with_softening(law)).step(load=LOAD)

    def test_material(self):
        soft = STEEL.with_softening(self.LAW)
        assert soft == STEEL.with_softening(sc.softening.JohnsonCook(1800.0, 1.0))
        assert soft != STEEL
        assert hash(soft) == hash(STEEL.with_softening(self.LAW))
        with pytest.raises(TypeError, match="law must be a function of the temperature"):
            STEEL.with_softening(0.5)
        with pytest.raises(ValueError, match="softening requires an elastic-plastic material"):
            WARM.with_softening(self.LAW)

    def test_checkpoint(self, tmp_path):
        grid = grid_of(21, 1.5, nz=16, dz=45e-6)
        heated = simulation(grid, 0.02, body2=STEEL.with_softening(self.LAW))
        heated.step(load=1000.0)
        heated.save(tmp_path / "saved.h5")
        resumed = sc.Simulation.load(tmp_path / "saved.h5")
        assert resumed.body2.softening == self.LAW
        assert np.array_equal(heated.state.softening(), resumed.state.softening())
        a, b = heated.step(load=LOAD), resumed.step(load=LOAD)
        assert np.array_equal(a.plastic_strain(), b.plastic_strain())

    def test_checkpoint_of_any_function(self, tmp_path):
        grid = grid_of(21, 1.5, nz=16, dz=45e-6)

        def law(rise):
            return 1 - 1e-4 * np.minimum(rise, 5000.0)

        heated = simulation(grid, 0.02, body2=STEEL.with_softening(law))
        heated.step(load=1000.0)
        heated.save(tmp_path / "saved.h5")
        with pytest.raises(sc.CheckpointError, match="body2 has the softening law"):
            sc.Simulation.load(tmp_path / "saved.h5")
        resumed = sc.Simulation.load(tmp_path / "saved.h5", softening=(None, law))
        a, b = heated.step(load=LOAD), resumed.step(load=LOAD)
        assert np.array_equal(a.plastic_strain(), b.plastic_strain())
