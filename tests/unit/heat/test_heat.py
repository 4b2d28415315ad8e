# SPDX-License-Identifier: GPL-3.0-or-later
"""Frictional heat in contact and stress; heat factors."""

import math
import pickle
import re

import numpy as np
import pytest
from heat_setups import (
    ALPHA,
    COLD,
    HERTZ,
    KAPPA,
    LOAD,
    NU,
    RADIUS,
    WARM,
    E,
    K,
    ball,
    grid_of,
    solver,
)

import samcontact as sc


def disc(grid, a, power):
    """Return cell means of (1 - r^2/a^2)^power inside the radius a."""
    fine = (np.arange(16) - 7.5) / 16 * grid.dx
    x, y = (c[:, None] + fine for c in (grid.x, grid.y))
    r2 = (x[:, :, None, None] ** 2 + y[None, None] ** 2) / a**2
    return np.where(r2 < 1, np.maximum(1 - r2, 0) ** power, 0).mean(axis=(1, 3))


class TestTemperature:
    @pytest.mark.parametrize(("power", "expected"), [(0, 1.0), (0.5, math.pi / 4)])
    def test_temperature_of_a_disc(self, power, expected):
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

    def test_temperature_grows_with_the_square_root_of_time(self):
        """Early, under a wide source, heat flows in one dimension: 2 q sqrt(kappa t/pi)/K."""
        grid = sc.Grid(61, 61, 1e-5, 1e-5)
        time, q = 1e-5, 1e7
        rise = solver(grid, 0.1, time=time).temperature(np.full((61, 61), q / 0.1))
        expected = 2 * q * math.sqrt(KAPPA * time / math.pi) / K
        assert rise[30, 30, 0] == pytest.approx(expected, rel=1e-6)

    @pytest.mark.parametrize("speed", [0.05, 0.5, 5.0])
    def test_temperature_is_mirrored_with_the_motion(self, speed):
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
            {"time": 1e-4},
            {"time": 1e-2},
            {"velocity": (0.3, 0.0)},
            {"velocity": (0.2, -0.3), "time": 2e-3},
        ],
    )
    def test_leaves_the_surface_free(self, settings):
        grid = grid_of(25)
        stress, _, _ = self.difference(grid, [0.0, 1e-4], **settings)
        largest = np.abs(stress).max()
        assert np.abs(stress[2:5, :, :, 0]).max() <= 1e-10 * largest
        assert np.abs(stress[2:5, :, :, 1]).max() > 1e-4 * largest

    def test_the_transient_tends_to_the_steady_state(self):
        grid = grid_of(25)
        z = [0.0, 1e-4]
        steady, _, _ = self.difference(grid, z)
        late, _, _ = self.difference(grid, z, time=1e4)
        np.testing.assert_allclose(late, steady, atol=1e-3 * np.abs(steady).max())


class TestContact:
    """Two balls under 1500 N, with heat into one of them."""

    def test_heat_does_not_increase_the_number_of_applications(self):
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
            solver(grid, 0.1, reference=r).solve(ball(grid), load=LOAD) for r in (1e-3, 10.0)
        )
        np.testing.assert_allclose(near.pressure, far.pressure, atol=1e-6 * near.pressure.max())
        shift = 0.1 * LOAD * ALPHA * (1 + NU) / (2 * np.pi * K) * np.log(1e4)
        assert near.approach - far.approach == pytest.approx(shift, rel=1e-6)

    def test_by_approach(self):
        grid = grid_of(33)
        heated = solver(grid, 0.05, reference=2e-3)
        found = heated.solve(ball(grid), load=200.0)
        again = heated.solve(ball(grid), approach=found.approach)
        assert again.load == pytest.approx(200.0, rel=1e-6)

    def test_moving_heat_makes_the_pressure_asymmetric(self):
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
            solver(grid, 0.1, velocity=(v, 0.0), time=1e-3).solve(ball(grid), load=LOAD)
            for v in (0.0, 1e-6)
        )
        np.testing.assert_allclose(slow.pressure, still.pressure, atol=1e-5 * still.pressure.max())


class TestInstability:
    def test_the_radius_saturates(self):
        """The contact radius stays below 2.4/w* at any load: the bulge carries it."""
        w = 0.2 * ALPHA * (1 + NU) / K * E / (4 * (1 - NU**2))
        for load, expected in ((1500.0, 1.13), (5e3, 1.46), (2e4, 1.79), (1e5, 1.96)):
            a = sc.hertz.point(RADIUS, HERTZ.E_star, load=load).a
            grid = sc.Grid(97, 97, 1.8 * a / 97, 1.8 * a / 97)
            found = solver(grid, 0.2).solve(ball(grid), load=load)
            radius = math.sqrt(np.count_nonzero(found.pressure) * grid.cell_area / np.pi)
            assert radius * w == pytest.approx(expected, rel=2e-2)

    def test_converges_through_negative_curvature(self):
        """An initial contact so wide that the operator is indefinite on it."""
        grid = sc.Grid(65, 65, 3e-3 / 65, 3e-3 / 65)
        heated = solver(grid, 0.2)
        wide = heated.solve(ball(grid), load=LOAD, initial_pressure=np.full((65, 65), 1e8))
        near = heated.solve(ball(grid), load=LOAD)
        np.testing.assert_allclose(wide.pressure, near.pressure, atol=1e-6 * near.pressure.max())

    def test_thermoelastic_instability_is_reported(self):
        grid = grid_of(65)
        heated = solver(grid, 0.1, reference=0.1)
        with pytest.raises(sc.ConvergenceError, match="thermoelastic instability at approach"):
            heated.solve(ball(grid), approach=5e-6)


class TestBadInput:
    @pytest.mark.parametrize(
        ("settings", "text"),
        [
            ({"factor": -0.1}, "factor must be a finite number >= 0, got -0.1"),
            ({"factor": np.nan}, "factor must be"),
            ({"factor": (0.1, 0.1, 0.1)}, "factor must be a number, or a pair"),
            ({"time": -1.0}, "time must be a finite number > 0, got -1.0"),
            ({"time": 0.0}, "time must be"),
            ({"reference": 0.0}, "reference must be"),
            ({"velocity": (1.0, np.inf)}, "velocity must be finite"),
            ({"velocity": (1.0,)}, "velocity must have shape"),
        ],
    )
    def test_refused(self, settings, text):
        with pytest.raises(ValueError, match=re.escape(text)):
            sc.Heat(**{"factor": 0.1, **settings})

    @pytest.mark.parametrize(
        ("factor", "bodies", "text"),
        [
            ((0.1, 0.0), {}, "heat.factor of body1 must be 0 without thermal constants, got 0.1"),
            (0.1, {"body2": COLD}, "heat.factor of body2 must be 0 without thermal"),
            ((0.1, 0.0), {"body1": sc.Material.rigid()}, "must be 0 for rigid body"),
        ],
    )
    @pytest.mark.parametrize("kind", ["solver", "simulation"])
    def test_refused_by_the_bodies(self, kind, factor, bodies, text):
        grid = grid_of(9, nz=2, dz=1e-5)
        arguments = {"body1": COLD, "body2": WARM, "heat": sc.Heat(factor), **bodies}
        make = sc.ContactSolver
        if kind == "simulation":
            make, arguments["gap"] = sc.Simulation, ball(grid)
        with pytest.raises(ValueError, match=re.escape(text)):
            make(grid, **arguments)
        with pytest.raises(TypeError, match=r"heat must be a samcontact.Heat, got 0\.1"):
            make(grid, **arguments | {"heat": 0.1})

    def test_heat_is_a_frozen_object(self):
        heat = sc.Heat([0, 0.1], [[0, 0], [1, 0]], history=[1e-3, 1])
        same = sc.Heat(0.1, (1.0, 0.0), history=(1e-3, 1.0))
        assert heat == same
        assert hash(heat) == hash(same)
        assert repr(sc.Heat(0.1)) == "Heat(factor=(0.0, 0.1))"
        for again in (eval(repr(heat), {"Heat": sc.Heat}), pickle.loads(pickle.dumps(heat))):
            assert again == heat

    def test_an_approach_needs_the_reference(self):
        grid = grid_of(33)
        with pytest.raises(ValueError, match=r"heat\.reference is required under approach control"):
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
        with pytest.raises(ValueError, match="body1 must have thermal constants"):
            sc.heat.partition(COLD, other, 1e-3)
        with pytest.raises(ValueError, match="velocity2 must be a finite number, got nan"):
            sc.heat.partition(WARM, other, 1e-3, 0.0, np.nan)
