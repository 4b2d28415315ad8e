# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinematic and combined hardening at a point, in a bar, in one cell, and in a contact."""

import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import TypeAdapter, ValidationError

import samcontact as sc
from samcontact.cases.bodies import BodySection

E, NU, YIELD = 210e9, 0.3, 1e9
G = E / (2 * (1 + NU))
PERFECT = sc.Material.perfect_plastic(E, NU, YIELD)
PRAGER = PERFECT.with_kinematic_hardening(30e9)
RECOVERING = PERFECT.with_kinematic_hardening([200e9, 20e9], [400.0, 20.0])
COMBINED = sc.Material.swift(E, NU, 945e6, 20.0, 0.121).with_kinematic_hardening(40e9, 50.0)
MATERIALS = {"Prager": PRAGER, "two, recovering": RECOVERING, "with Swift's law": COMBINED}
materials = pytest.mark.parametrize("name", MATERIALS)


def von_mises(s):
    s = np.asarray(s)
    return np.sqrt(1.5 * (s[:3] ** 2).sum(axis=0) + 3 * (s[3:] ** 2).sum(axis=0))


def deviator(stress):
    out = np.array(stress)
    out[:3] -= out[:3].mean(axis=0)
    return out


class Point:
    """A point of a material under a given deviatoric strain."""

    def __init__(self, material):
        self.material = material
        self.plastic, self.g = np.zeros(6), 0.0
        self.backstress = np.zeros((len(material.kinematic), 6))

    def strain(self, total):
        trial = 2 * G * (total - self.plastic)
        increment, d, after = self.material._core.radial_return(
            list(trial), self.g, [list(x) for x in self.backstress]
        )
        self.plastic = self.plastic + increment
        self.g += d
        self.backstress = np.array(after)
        return 2 * G * (total - self.plastic)


def shear(gamma):
    return np.array([0, 0, 0, 0, 0, gamma])


class TestPoint:
    @materials
    @settings(derandomize=True, max_examples=60, deadline=None, database=None)
    @given(
        steps=st.lists(
            st.tuples(*[st.floats(-0.02, 0.02)] * 5).map(
                lambda e: np.array([e[0], e[1], -e[0] - e[1], e[2], e[3], e[4]])
            ),
            min_size=1,
            max_size=5,
        )
    )
    def test_the_stress_ends_on_or_inside_the_yield_surface(self, name, steps):
        point = Point(MATERIALS[name])
        for total in steps:
            before, g_before = point.plastic, point.g
            centred = point.strain(total) - point.backstress.sum(axis=0)
            radius = point.material.yield_stress(point.g)
            assert von_mises(centred) <= radius * (1 + 1e-12)
            flow = point.plastic - before
            d = point.g - g_before
            assert d == pytest.approx(
                np.sqrt(2 / 3 * (flow[:3] @ flow[:3] + 2 * flow[3:] @ flow[3:]))
            )
            if d > 1e-12:
                assert von_mises(centred) == pytest.approx(radius, rel=1e-12)
                # normal to the surface
                np.testing.assert_allclose(flow, 1.5 * d * centred / radius, atol=1e-12 * d + 1e-18)
            for (modulus, recovery), x in zip(
                point.material.kinematic, point.backstress, strict=True
            ):
                if recovery > 0:
                    assert von_mises(x) <= modulus / recovery * (1 + 1e-12)

    def test_the_loop_of_a_cycle_closes(self):
        point = Point(PRAGER)
        cycle = np.concatenate([np.linspace(0.02, -0.02, 9)[1:], np.linspace(-0.02, 0.02, 9)[1:]])
        point.strain(shear(0.02))
        start = (point.strain(shear(0.02)), point.plastic, point.backstress)
        first = [point.strain(shear(e)) for e in cycle]
        for found, expected in zip(
            (first[-1], point.plastic, point.backstress), start, strict=True
        ):
            np.testing.assert_allclose(found, expected, rtol=0, atol=1e-10 * np.abs(expected).max())
        second = [point.strain(shear(e)) for e in cycle]
        np.testing.assert_allclose(second, first, rtol=0, atol=1e-10 * YIELD)
        assert np.ptp([s[5] for s in second]) > 2 * YIELD / np.sqrt(3)


class TestBar:
    def test_first_loading_is_equal_for_kinematic_and_isotropic_hardening(self):
        Et = 20e9
        isotropic = sc.Material.linear_hardening(E, NU, YIELD, Et)
        kinematic = PERFECT.with_kinematic_hardening(E * Et / (E - Et))
        strain = np.linspace(0, 0.03, 7)
        np.testing.assert_allclose(
            kinematic.uniaxial_stress(strain), isotropic.uniaxial_stress(strain), rtol=1e-13
        )
        expected = np.where(strain < YIELD / E, E * strain, YIELD + Et * (strain - YIELD / E))
        np.testing.assert_allclose(kinematic.uniaxial_stress(strain), expected, rtol=1e-13)

    def test_reversed_yield_comes_after_twice_the_yield_stress(self):
        # isotropic hardening: after twice the stress reached
        top, Et = 0.02, E * 30e9 / (E + 30e9)
        down = top - 2 * YIELD / E - np.array([0.0, 1e-3])
        peak, start, further = PRAGER.uniaxial_stress([top, *down])
        assert start == pytest.approx(peak - 2 * YIELD, rel=1e-12)
        assert further - start == pytest.approx(-Et * 1e-3, rel=1e-9)
        isotropic = sc.Material.linear_hardening(E, NU, YIELD, Et)
        peak, start, further = isotropic.uniaxial_stress([top, *down])
        assert further - start == pytest.approx(-E * 1e-3, rel=1e-9)

    def test_saturation_agrees_with_armstrong_and_frederick(self):
        C, recovery = 100e9, 200.0
        material = PERFECT.with_kinematic_hardening(C, recovery)
        errors = []
        for steps in (200, 400):
            strain = np.linspace(0, 0.03, steps + 1)
            stress = material.uniaxial_stress(strain)
            plastic = strain - stress / E
            expected = YIELD + C / recovery * (1 - np.exp(-recovery * plastic))
            errors.append(np.abs(stress - expected)[plastic > 1e-9].max() / YIELD)
        assert errors[0] < 5e-3
        assert errors[1] < 0.55 * errors[0]  # backward Euler is of first order

    def test_mean_stress_relaxes_with_recovery_only(self):
        strain = np.concatenate([[0.03]] + 60 * [[0.02, 0.03]])
        for material, relaxes in ((PRAGER, False), (RECOVERING, True)):
            stress = material.uniaxial_stress(strain)
            mean = 0.5 * (stress[2::2] + stress[1:-1:2])
            assert mean[0] > 0.05 * YIELD
            assert (mean[-1] < 0.4 * mean[0]) == relaxes
            assert relaxes or mean[-1] == pytest.approx(mean[0], rel=1e-12)

    @pytest.mark.parametrize("strain", [[[0.0]], [0.0, np.nan]])
    def test_refuses(self, strain):
        with pytest.raises(ValueError, match="strain must be a list of finite numbers"):
            PRAGER.uniaxial_stress(strain)
        with pytest.raises(ValueError, match="requires a deformable material"):
            sc.Material.rigid().uniaxial_stress([0.0])


class TestMaterial:
    def test_is_a_value(self):
        assert PERFECT.with_kinematic_hardening([30e9]) == PRAGER
        assert hash(PRAGER) == hash(PERFECT.with_kinematic_hardening([30e9], [0.0]))
        assert PRAGER != PERFECT
        assert PRAGER.kinematic == ((30e9, 0.0),)
        assert PRAGER.yield_stress(0.1) == YIELD

    @pytest.mark.parametrize(
        ("arguments", "error", "text"),
        [
            ((0.0,), ValueError, "modulus must be a finite number > 0 [Pa], got 0"),
            ((-1e9,), ValueError, "modulus must be a finite number > 0 [Pa], got -1e+09"),
            ((np.inf,), ValueError, "modulus must be a finite number > 0 [Pa], got inf"),
            ((1e9, -1.0), ValueError, "recovery must be a finite number >= 0, got -1"),
            ((1e9, np.nan), ValueError, "recovery must be a finite number >= 0, got nan"),
            (([1e9, 2e9], [1.0]), ValueError, "must have equal lengths >= 1, got 2 and 1"),
            (([],), ValueError, "must have equal lengths >= 1, got 0 and 0"),
            (([1e9] * 5,), ValueError, "number of backstresses must be from 1 to 4, got 5"),
            (("1e9",), TypeError, "modulus must be a number"),
            ((1e9, None), TypeError, "recovery must be a number, got None"),
        ],
    )
    def test_refused(self, arguments, error, text):
        with pytest.raises(error, match=re.escape(text)):
            PERFECT.with_kinematic_hardening(*arguments)

    def test_needs_a_body_that_yields(self):
        with pytest.raises(ValueError, match="requires an elastic-plastic material"):
            sc.Material.elastic(E, NU).with_kinematic_hardening(1e9)


@pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
class TestOneLoadedCell:
    """A half-space under alternating shear on one cell."""

    D = 10e-6

    def cell(self, material):
        grid = sc.Grid(3, 3, self.D, self.D, 4, self.D)
        return sc.Simulation(
            grid, sc.Material.rigid(), material, np.zeros((3, 3)), tol=1e-11, on_border="warn"
        )

    @staticmethod
    def of(state):
        return np.stack([state.stress() / YIELD, state.plastic_strain() * E / YIELD])

    CYCLE = (4.2e9, 1.8e9, -1.8e9, -4.2e9, -1.8e9, 1.8e9)

    def drive(self, simulation, shears):
        cell = np.zeros((3, 3))
        cell[1, 1] = 1.0
        return [simulation.step(pressure=0 * cell, shear=shear * cell) for shear in shears]

    def test_the_loop_closes(self):
        simulation = self.cell(PRAGER)
        self.drive(simulation, self.CYCLE)
        second, third = (
            np.array([self.of(s) for s in self.drive(simulation, self.CYCLE)]) for _ in range(2)
        )
        # the plastic shear goes to and fro
        assert np.ptp(second[:, 1, 4], axis=0).max() > 0.5
        np.testing.assert_allclose(third, second, rtol=0, atol=1e-10 * np.abs(second).max())

    def test_isotropic_hardening_shakes_down(self):
        simulation = self.cell(sc.Material.linear_hardening(E, NU, YIELD, 0.3 * E))
        for _ in range(40):
            states = self.drive(simulation, self.CYCLE)
        g = states[0].equivalent_plastic_strain()
        assert g.any()
        for state in states + self.drive(simulation, self.CYCLE):
            np.testing.assert_array_equal(state.equivalent_plastic_strain(), g)


def ball(material, n=17, layers=12, body1=None, **settings):
    d, R = 60e-6, 7.5e-3
    grid = sc.Grid(n, n, d, d, layers, d)
    upper = sc.Material.elastic(E, NU) if body1 is None else body1
    return sc.Simulation(grid, upper, material, sc.surfaces.paraboloid(grid, R), **settings)


class TestContact:
    @materials
    @pytest.mark.parametrize("method", ["exact", "fast"])
    def test_yield_surface_is_kept(self, name, method):
        simulation = ball(MATERIALS[name], residual_stress=method)
        for load in (400.0, 600.0, 0.0):
            state = simulation.step(load=load)
            g = state.equivalent_plastic_strain()
            centred = deviator(state.stress()) - state.backstress().sum(axis=0)
            radius = MATERIALS[name].yield_stress(g)
            assert (von_mises(centred) <= radius * (1 + 2e-6)).all()
        assert g.max() > 2e-4

    def test_prager_follows_the_plastic_strain(self):
        state = ball(PRAGER).run([{"load": 400.0}, {"load": 600.0}], progress=False)[-1]
        expected = 2 / 3 * 30e9 * state.plastic_strain()
        assert state.backstress().shape == (1, *expected.shape)
        np.testing.assert_allclose(state.backstress()[0], expected, atol=1e-9 * expected.max())

    def test_without_it_there_is_no_backstress(self):
        state = ball(PERFECT).step(load=400.0)
        assert state.backstress().shape == (0, 6, 17, 17, 12)

    def test_a_very_small_modulus_changes_nothing(self):
        plain = ball(PERFECT).step(load=400.0)
        tiny = ball(PERFECT.with_kinematic_hardening(1.0, 1e-3)).step(load=400.0)
        np.testing.assert_allclose(tiny.pressure, plain.pressure, atol=1e-7 * plain.pressure.max())

    def test_reversed_yield_occurs_earlier_in_unloading(self):
        # pressed far, the residual stress reaches yield sooner when the surface has moved
        further = {}
        for kind, material in (
            ("kinematic", PERFECT.with_kinematic_hardening(300e9)),
            ("isotropic", sc.Material.linear_hardening(E, NU, YIELD, E * 300e9 / (E + 300e9))),
        ):
            simulation = ball(material, n=25, layers=16)
            loaded, unloaded = simulation.run([{"load": 1500.0}, {"load": 0.0}], progress=False)
            g = [s.equivalent_plastic_strain() for s in (loaded, unloaded)]
            further[kind] = (g[1] - g[0]).max()
        assert further["isotropic"] == 0.0
        assert further["kinematic"] > 1e-4

    @materials
    def test_mirrors_box_and_automatic_increments(self, name):
        # without mirrors: the same through a gap shifted out of symmetry by nothing that counts
        states = []
        for tilt in (0.0, 1e-9):
            simulation = ball(MATERIALS[name], residual_stress="fast", increment_tol=1e-3)
            grid = simulation.grid
            gap = sc.surfaces.paraboloid(grid, 7.5e-3)
            gap = gap + tilt * gap.max() * (grid.x[:, None] + 2 * grid.y) / grid.x.max()
            simulation = sc.Simulation(
                grid,
                simulation.body1,
                simulation.body2,
                gap,
                residual_stress="fast",
                increment_tol=1e-3,
            )
            states.append(simulation.run([{"load": 600.0}, {"load": 0.0}], progress=False)[-1])
        assert [s._core.history2["mirrored"] for s in states] == [2, 0]
        x = [s.backstress() for s in states]
        np.testing.assert_allclose(x[1], x[0], atol=5e-4 * np.abs(x[0]).max())

    def test_continuation_from_a_checkpoint_is_bit_identical(self, tmp_path):
        simulation = ball(RECOVERING)
        simulation.step(load=400.0)
        simulation.save(tmp_path / "saved.h5")
        resumed = sc.Simulation.load(tmp_path / "saved.h5")
        assert resumed.body2 == RECOVERING
        for load in (600.0, 0.0):
            a, b = simulation.step(load=load), resumed.step(load=load)
        for field in ("backstress", "plastic_strain", "stress"):
            assert np.array_equal(getattr(a, field)(), getattr(b, field)())

    def test_a_state_can_be_passed_to_another_simulation(self):
        first = ball(RECOVERING, residual_stress="exact")
        state = first.step(load=600.0)
        second = ball(RECOVERING, residual_stress="exact")
        second.set_plastic_strain(
            2, state.plastic_strain(), state.equivalent_plastic_strain(), state.backstress()
        )
        a, b = first.step(load=0.0), second.step(load=0.0)
        np.testing.assert_allclose(a.backstress(), b.backstress(), atol=1e-6 * YIELD)
        np.testing.assert_allclose(
            a.residual_displacement(), b.residual_displacement(), rtol=0, atol=1e-12
        )

    @pytest.mark.parametrize(
        ("component", "value", "text"),
        [
            (0, 1e8, "backstress must be a deviator, with trace 0 Pa"),
            (4, 5e8, "backstress must be at most modulus/recovery = 5e+08 Pa"),
            (4, np.nan, "backstress must be finite everywhere"),
        ],
    )
    def test_bad_backstress(self, component, value, text):
        simulation = ball(RECOVERING)
        shape = simulation.grid.volume_shape
        backstress = np.zeros((2, 6, *shape))
        backstress[0, component, 3, 3, 3] = value
        with pytest.raises(ValueError, match=re.escape(text)):
            simulation.set_plastic_strain(2, np.zeros((6, *shape)), backstress=backstress)
        with pytest.raises(ValueError, match="backstress must have shape"):
            simulation.set_plastic_strain(
                2, np.zeros((6, *shape)), backstress=np.zeros((6, *shape))
            )


def test_in_a_case_file():
    body = {"law": "perfect_plastic", "E": E, "nu": NU, "yield_stress": YIELD}
    kinematic = {"modulus": [200e9, 20e9], "recovery": [400.0, 20.0]}
    section = TypeAdapter(BodySection)
    assert section.validate_python(body | {"kinematic": kinematic}).build() == RECOVERING
    for wrong, text in (
        ({"modulus": [1e9] * 5}, "modulus must have 1 to 4 values, got 5"),
        ({"modulus": [1e9, 2e9], "recovery": [1.0]}, r"as many values as modulus \(2\), got 1"),
        ({"modulus": 0.0}, "greater than 0"),
    ):
        with pytest.raises(ValidationError, match=text):
            section.validate_python(body | {"kinematic": wrong})
    with pytest.raises(ValidationError, match="kinematic"):
        section.validate_python({"law": "elastic", "E": E, "nu": NU, "kinematic": kinematic})
