# SPDX-License-Identifier: GPL-3.0-or-later
"""Frictional heat in the contact, the stress, and elastic-plastic increments."""

import math
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


def grid_of(cells, width=1.3, **volume):
    d = 2 * width * HERTZ.a / cells
    return sc.Grid(cells, cells, d, d, **volume)


def solver(grid, heat_factor, body1=COLD, body2=WARM, **settings):
    return sc.ContactSolver(grid, body1, body2, heat_factor=heat_factor, **settings)


def ball(grid):
    return sc.surfaces.paraboloid(grid, RADIUS)


def von_mises(s):
    normal = (s[0] - s[1]) ** 2 + (s[1] - s[2]) ** 2 + (s[2] - s[0]) ** 2
    return np.sqrt(0.5 * normal + 3 * (s[3:] ** 2).sum(axis=0))


def disc(grid, a, power):
    """Cell means of (1 - r^2/a^2)^power inside the radius a."""
    fine = (np.arange(16) - 7.5) / 16 * grid.dx
    x, y = (c[:, None] + fine for c in (grid.x, grid.y))
    r2 = (x[:, :, None, None] ** 2 + y[None, None] ** 2) / a**2
    return np.where(r2 < 1, np.maximum(1 - r2, 0) ** power, 0).mean(axis=(1, 3))


class TestTemperature:
    @pytest.mark.parametrize(("power", "expected"), [(0, 1.0), (0.5, math.pi / 4)])
    def test_of_a_disc(self, power, expected):
        """Maximum q a/K of a uniform, pi q0 a/(4 K) of a semi-ellipsoidal source."""
        a, q = 0.3e-3, 2e7
        grid = sc.Grid(121, 121, 6e-6, 6e-6)
        pressure = disc(grid, a, power) * q / 0.1
        rise = solver(grid, 0.1).temperature(pressure)
        assert rise.shape == (121, 121, 1)
        assert rise.max() == rise[60, 60, 0] == pytest.approx(expected * q * a / K, rel=1e-3)

    def test_shape_decay_and_body(self):
        grid = grid_of(41)
        heated = solver(grid, (0.0, 0.1))
        pressure = heated.solve(ball(grid), load=LOAD).pressure
        z = np.array([0.0, 0.5, 2.0, 20.0]) * HERTZ.a
        rise = heated.temperature(pressure, z)
        assert (np.diff(rise.max(axis=(0, 1))) < 0).all()
        total = 0.1 * pressure.sum() * grid.cell_area
        assert rise[20, 20, 3] == pytest.approx(total / (2 * np.pi * K * z[3]), rel=1e-2)
        assert not heated.temperature(pressure, z, body=1).any()

    def test_warms_up_like_the_square_root_of_time(self):
        """Early, under a wide source, heat flows in one dimension: 2 q sqrt(kappa t/pi)/K."""
        grid = sc.Grid(61, 61, 1e-5, 1e-5)
        time, q = 1e-5, 1e7
        rise = solver(grid, 0.1, heating_time=time).temperature(np.full((61, 61), q / 0.1))
        expected = 2 * q * math.sqrt(KAPPA * time / math.pi) / K
        assert rise[30, 30, 0] == pytest.approx(expected, rel=1e-6)

    @pytest.mark.parametrize("speed", [0.05, 0.5, 5.0])
    def test_leans_with_the_motion_and_mirrors(self, speed):
        grid = grid_of(33)
        pressure = HERTZ.pressure(grid.x[:, None], grid.y)
        one, back, along_y = (
            solver(grid, 0.1, velocity=v).temperature(pressure)[..., 0]
            for v in ((speed, 0.0), (-speed, 0.0), (0.0, speed))
        )
        scale = one.max()
        np.testing.assert_allclose(back, one[::-1], atol=1e-9 * scale)
        np.testing.assert_allclose(along_y, one.T, atol=1e-9 * scale)
        np.testing.assert_allclose(one[:, ::-1], one, atol=1e-9 * scale)
        at = np.unravel_index(one.argmax(), one.shape)
        assert grid.x[at[0]] > 0
        still = solver(grid, 0.1).temperature(pressure)
        assert scale < still.max()


class TestThermalStress:
    def difference(self, grid, z, **settings):
        pressure = HERTZ.pressure(grid.x[:, None], grid.y)
        heated = solver(grid, 0.1, **settings)
        cold = sc.ContactSolver(grid, COLD, COLD)
        return heated.stress(pressure, z) - cold.stress(pressure, z), heated, pressure

    def test_steady_heat_at_rest_is_plane_stress(self):
        grid = grid_of(33)
        z = [0.0, 3e-5, 3e-4]
        stress, heated, pressure = self.difference(grid, z)
        largest = np.abs(stress).max()
        assert largest > 1e9
        assert np.abs(stress[2:5]).max() <= 1e-10 * largest
        rise = heated.temperature(pressure, z)
        np.testing.assert_allclose(
            stress[0] + stress[1], -E * ALPHA * rise, rtol=0, atol=1e-9 * largest
        )

    @pytest.mark.parametrize(
        "settings",
        [
            {"heating_time": 1e-4},
            {"heating_time": 1e-2},
            {"velocity": (0.3, 0.0)},
            {"velocity": (0.2, -0.3), "heating_time": 2e-3},
        ],
    )
    def test_leaves_the_surface_free(self, settings):
        grid = grid_of(25)
        stress, _, _ = self.difference(grid, [0.0, 1e-4], **settings)
        largest = np.abs(stress).max()
        assert np.abs(stress[2:5, :, :, 0]).max() <= 1e-10 * largest
        assert np.abs(stress[2:5, :, :, 1]).max() > 1e-4 * largest

    def test_the_transient_ends_in_the_steady_state(self):
        grid = grid_of(25)
        z = [0.0, 1e-4]
        steady, _, _ = self.difference(grid, z)
        late, _, _ = self.difference(grid, z, heating_time=1e4)
        np.testing.assert_allclose(late, steady, atol=1e-3 * np.abs(steady).max())


class TestContact:
    """Two balls, 1500 N, heat into one."""

    def test_costs_as_many_applications_as_without_heat(self):
        grid = grid_of(129)
        cold, hot = (solver(grid, Q).solve(ball(grid), load=LOAD) for Q in (0.0, 0.12))
        assert hot.operator_applications <= cold.operator_applications
        assert hot.work <= 1.2 * cold.work

    def test_a_factor_of_zero_is_no_heat(self):
        grid = grid_of(33)
        none = sc.ContactSolver(grid, COLD, COLD).solve(ball(grid), load=LOAD)
        zero = solver(grid, 0.0, velocity=(1.0, 2.0)).solve(ball(grid), load=LOAD)
        assert np.array_equal(none.pressure, zero.pressure)

    def test_heat_into_either_body_or_both(self):
        grid = grid_of(33)
        pressures = [
            solver(grid, pair, WARM, WARM).solve(ball(grid), load=LOAD).pressure
            for pair in ((0.0, 0.1), (0.1, 0.0), (0.03, 0.07))
        ]
        for pressure in pressures[1:]:
            np.testing.assert_allclose(pressure, pressures[0], atol=1e-7 * pressures[0].max())

    def test_the_reference_shifts_the_approach_only(self):
        grid = grid_of(33)
        near, far = (
            solver(grid, 0.1, heat_reference=r).solve(ball(grid), load=LOAD) for r in (1e-3, 10.0)
        )
        np.testing.assert_allclose(near.pressure, far.pressure, atol=1e-6 * near.pressure.max())
        shift = 0.1 * LOAD * ALPHA * (1 + NU) / (2 * np.pi * K) * np.log(1e4)
        assert near.approach - far.approach == pytest.approx(shift, rel=1e-6)

    def test_by_approach(self):
        grid = grid_of(33)
        heated = solver(grid, 0.05, heat_reference=2e-3)
        found = heated.solve(ball(grid), load=200.0)
        again = heated.solve(ball(grid), approach=found.approach)
        assert again.load == pytest.approx(200.0, rel=1e-6)

    def test_moving_heat_leans_the_pressure(self):
        grid = grid_of(49)
        forward, back = (
            solver(grid, 0.1, velocity=(v, 0.0)).solve(ball(grid), load=LOAD) for v in (0.1, -0.1)
        )
        assert forward.converged
        np.testing.assert_allclose(
            back.pressure, forward.pressure[::-1], atol=1e-6 * forward.pressure.max()
        )
        assert (grid.x[:, None] * forward.pressure).sum() > 1e-3 * HERTZ.a * forward.pressure.sum()

    def test_no_motion_is_the_limit_of_slow_motion(self):
        grid = grid_of(25)
        still, slow = (
            solver(grid, 0.1, velocity=(v, 0.0), heating_time=1e-3).solve(ball(grid), load=LOAD)
            for v in (0.0, 1e-6)
        )
        np.testing.assert_allclose(slow.pressure, still.pressure, atol=1e-5 * still.pressure.max())


class TestInstability:
    def test_the_radius_saturates(self):
        """However high the load, a stays below 2.4/w*: the bulge carries it."""
        w = 0.2 * ALPHA * (1 + NU) / K * E / (4 * (1 - NU**2))
        for load, expected in ((1500.0, 1.13), (5e3, 1.46), (2e4, 1.79), (1e5, 1.96)):
            a = sc.hertz.point(RADIUS, HERTZ.E_star, load=load).a
            grid = sc.Grid(97, 97, 1.8 * a / 97, 1.8 * a / 97)
            found = solver(grid, 0.2).solve(ball(grid), load=load)
            radius = math.sqrt(np.count_nonzero(found.pressure) * grid.cell_area / np.pi)
            assert radius * w == pytest.approx(expected, rel=2e-2)

    def test_converges_through_negative_curvature(self):
        """From a start so wide that the operator is indefinite on it."""
        grid = sc.Grid(65, 65, 3e-3 / 65, 3e-3 / 65)
        heated = solver(grid, 0.2)
        wide = heated.solve(ball(grid), load=LOAD, initial_pressure=np.full((65, 65), 1e8))
        near = heated.solve(ball(grid), load=LOAD)
        np.testing.assert_allclose(wide.pressure, near.pressure, atol=1e-6 * near.pressure.max())

    def test_a_contact_that_grows_by_itself_is_named(self):
        grid = grid_of(65)
        heated = solver(grid, 0.1, heat_reference=0.1)
        with pytest.raises(sc.ConvergenceError, match="thermoelastically unstable at approach"):
            heated.solve(ball(grid), approach=5e-6)


class TestBadInput:
    @pytest.mark.parametrize(
        ("settings", "text"),
        [
            ({"heat_factor": -0.1}, "heat_factor must be"),
            ({"heat_factor": np.nan}, "heat_factor must be"),
            ({"heat_factor": (0.1, 0.1, 0.1)}, "heat_factor must be a number or a pair, got 3"),
            ({"heat_factor": (0.1, 0.0)}, "heat_factor of body1 is 0.1, but the body has no therm"),
            ({"heat_factor": 0.1, "body2": COLD}, "heat_factor of body2 is 0.1, but the body has"),
            ({"heat_factor": (0.1, 0.0), "body1": sc.Material.rigid()}, "but the body is rigid"),
            ({"heat_factor": 0.1, "heating_time": -1.0}, "heating_time must be"),
            ({"heat_factor": 0.1, "heating_time": 0.0}, "heating_time must be"),
            ({"heat_factor": 0.1, "heat_reference": 0.0}, "heat_reference must be"),
            ({"heat_factor": 0.1, "velocity": (1.0, np.inf)}, "velocity must be finite"),
            ({"heat_factor": 0.1, "velocity": (1.0,)}, "velocity must have shape"),
        ],
    )
    @pytest.mark.parametrize("kind", ["solver", "simulation"])
    def test_refused(self, kind, settings, text):
        grid = grid_of(9, nz=2, dz=1e-5)
        arguments = {"body1": COLD, "body2": WARM, **settings}
        make = sc.ContactSolver
        if kind == "simulation":
            make, arguments["gap"] = sc.Simulation, ball(grid)
        with pytest.raises(ValueError, match=re.escape(text)):
            make(grid, **arguments)

    def test_an_approach_needs_the_reference(self):
        grid = grid_of(33)
        with pytest.raises(ValueError, match="heat_reference must be given with an approach"):
            solver(grid, 0.1).solve(ball(grid), approach=1e-6)
        moving = solver(grid, 0.1, velocity=(1.0, 0.0))
        assert moving.solve(ball(grid), approach=1e-5).converged

    @pytest.mark.parametrize(
        ("constants", "error", "text"),
        [
            ((0.0, ALPHA, KAPPA), ValueError, "conductivity must be a finite number > 0"),
            ((K, -1e-6, KAPPA), ValueError, "expansion must be a finite number >= 0"),
            ((K, ALPHA, 0.0), ValueError, "diffusivity must be a finite number > 0"),
            ((K, ALPHA, np.nan), ValueError, "diffusivity must be a finite number > 0"),
            (("k", ALPHA, KAPPA), TypeError, "conductivity must be a number"),
        ],
    )
    def test_thermal_constants(self, constants, error, text):
        with pytest.raises(error, match=text):
            COLD.with_thermal(*constants)
        with pytest.raises(ValueError, match="rigid"):
            sc.Material.rigid().with_thermal(K, ALPHA, KAPPA)


class TestFactors:
    def test_share(self):
        assert sc.heat.factors(0.1, 2.0) == (0.0, 0.2)
        assert sc.heat.factors(0.1, 2.0, 0.25) == pytest.approx((0.15, 0.05))

    @pytest.mark.parametrize("beta", [-0.1, 1.1, np.nan])
    def test_share_out_of_range(self, beta):
        with pytest.raises(ValueError, match="partition must be"):
            sc.heat.factors(0.1, 2.0, beta)

    def test_partition(self):
        """Charron's at rest; with it both bodies are equally hot, at rest and at speed."""
        other = COLD.with_thermal(2 * K, ALPHA, 3 * KAPPA)
        assert sc.heat.partition(WARM, other, 1e-3) == pytest.approx(2 / 3)
        grid = grid_of(49)
        pressure = HERTZ.pressure(grid.x[:, None], grid.y)
        for speed, tolerance in ((0.0, 1e-3), (1.0, 0.05)):
            beta = sc.heat.partition(WARM, other, HERTZ.a, 0.0, speed)
            assert 0 < beta < 1
            hot = solver(
                grid, sc.heat.factors(0.1, 1.0, beta), WARM, other, velocity=[[0, 0], [speed, 0]]
            )
            first, second = (hot.temperature(pressure, 0.0, body).max() for body in (1, 2))
            assert first == pytest.approx(second, rel=tolerance)
        with pytest.raises(ValueError, match="body1 has no thermal constants"):
            sc.heat.partition(COLD, other, 1e-3)
        with pytest.raises(ValueError, match="velocity2 must be a finite number, got nan"):
            sc.heat.partition(WARM, other, 1e-3, 0.0, np.nan)


def simulation(grid, heat_factor, body1=COLD, body2=STEEL, **settings):
    return sc.Simulation(grid, body1, body2, ball(grid), heat_factor=heat_factor, **settings)


VOLUME = {"nz": 20, "dz": 33e-6}


class TestSimulation:
    def test_elastic_state_is_that_of_the_solver(self):
        grid = grid_of(31, 1.4, nz=6, dz=5e-5)
        settings = {"velocity": (0.2, 0.0), "heating_time": 1e-2}
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

    @pytest.mark.parametrize("extra", [{}, {"velocity": (0.3, 0.0)}, {"heating_time": 1e-3}])
    def test_fast_and_exact_residual_stress(self, extra):
        grid = grid_of(25, 1.5, nz=20, dz=45e-6)
        states = []
        for method in ("exact", "fast"):
            heated = simulation(grid, 0.04, residual_stress=method, **extra)
            states.append(heated.run([{"load": 1000.0}, {"load": LOAD}], progress=False)[-1])
        exact, fast = (s.plastic_strain() for s in states)
        assert np.abs(exact).max() > 3e-4
        assert np.abs(fast - exact).max() < 0.05 * np.abs(exact).max()
        mirrored = states[1]._core.history(1)["mirrored"]
        assert mirrored == (1 if "velocity" in extra else 2)

    def test_load_hold_switch_off_unload(self):
        grid = grid_of(31, 1.4, **VOLUME)
        heated = simulation(grid, 0.03)
        hot = heated.step(load=LOAD)
        hold = heated.step(load=LOAD)
        np.testing.assert_allclose(hold.plastic_strain(), hot.plastic_strain(), rtol=0, atol=1e-8)
        off = heated.step(load=LOAD, heat_factor=0.0)
        assert heated.heat_factor == (0.0, 0.0)
        assert hot.temperature().max() > 100
        assert not off.temperature().any()
        # without heat the maximum stress is higher: the steel flows on
        assert off.max_equivalent_plastic_strain() > hot.max_equivalent_plastic_strain()
        free = heated.step(load=0.0)
        assert free.von_mises().max() > 50e6

    def test_a_failed_step_leaves_the_heat_factor(self):
        heated = simulation(grid_of(9, 0.5, **VOLUME), 0.03)
        with pytest.raises(sc.GridTooSmallError):
            heated.step(load=LOAD, heat_factor=0.01)
        assert heated.heat_factor == (0.0, 0.03)

    def test_identical_heated_bodies(self):
        grid = grid_of(25, 1.5, **VOLUME)
        again = sc.Material.swift(E, NU, 945e6, 20.0, np.nextafter(0.121, 1)).with_thermal(
            K, ALPHA, KAPPA
        )
        one, two = (
            simulation(grid, (0.02, 0.02), STEEL, other, tol=1e-9).step(load=LOAD)
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

    def test_a_scene_without_heat_builds_nothing_for_it(self):
        grid = grid_of(25, 1.5, **VOLUME)
        cold = sc.Simulation(grid, COLD, STEEL, ball(grid))
        zero = simulation(grid, 0.0, velocity=(1.0, 0.0), heating_time=1.0)
        for s in (cold, zero):
            s.step(load=LOAD)
        assert cold.counters == zero.counters
        assert np.array_equal(cold.state.plastic_strain(), zero.state.plastic_strain())

    @pytest.mark.parametrize("extra", [{}, {"velocity": (0.3, 0.1), "heating_time": 2e-3}])
    def test_checkpoint_goes_on_bit_for_bit(self, extra, tmp_path):
        grid = grid_of(21, 1.5, nz=16, dz=45e-6)
        heated = simulation(grid, 0.05, heat_reference=0.3, **extra)
        heated.step(load=1000.0)
        heated.step(load=1100.0, heat_factor=0.04)
        heated.save(tmp_path / "saved.h5")
        resumed = sc.Simulation.load(tmp_path / "saved.h5")
        assert resumed.body2 == STEEL
        assert resumed.heat_factor == (0.0, 0.04)
        for field in ("stress", "temperature"):
            a, b = (getattr(s.state, field)() for s in (heated, resumed))
            assert np.array_equal(a, b)
        for load in (LOAD, 0.0):
            a, b = heated.step(load=load), resumed.step(load=load)
            assert np.array_equal(a.pressure, b.pressure)
            assert np.array_equal(a.plastic_strain(), b.plastic_strain())


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
        # of the temperature of the first contact solution, which differs a little from the last
        np.testing.assert_allclose(factor, self.LAW(soft.temperature()), atol=0.02)
        limit = factor * STEEL.yield_stress(soft.equivalent_plastic_strain())
        assert (soft.von_mises() <= limit * (1 + 1e-5)).all()
        assert (hard.softening() == 1).all()

    def test_a_rise_that_is_no_number(self):
        with pytest.raises(ValueError, match=r"rise must be finite everywhere, got nan$"):
            self.LAW(np.nan)
        with pytest.raises(ValueError, match=r"rise must be finite everywhere, got nan at index"):
            self.LAW([1.0, np.nan])

    def test_without_heat_it_changes_nothing(self):
        grid = grid_of(21, 1.5, nz=16, dz=45e-6)
        plain = simulation(grid, 0.0).step(load=LOAD)
        soft = simulation(grid, 0.0, body2=STEEL.with_softening(self.LAW)).step(load=LOAD)
        assert np.array_equal(plain.plastic_strain(), soft.plastic_strain())

    def test_any_function_once_an_increment(self):
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

    def test_an_error_of_the_law_comes_through(self):
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
        with pytest.raises(TypeError, match="law must be callable"):
            STEEL.with_softening(0.5)
        with pytest.raises(ValueError, match="needs a body that yields"):
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
        with pytest.raises(sc.CheckpointError, match=r"body2 softens by .* give it again"):
            sc.Simulation.load(tmp_path / "saved.h5")
        resumed = sc.Simulation.load(tmp_path / "saved.h5", softening=(None, law))
        a, b = heated.step(load=LOAD), resumed.step(load=LOAD)
        assert np.array_equal(a.plastic_strain(), b.plastic_strain())
