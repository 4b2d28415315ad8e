# SPDX-License-Identifier: GPL-3.0-or-later
"""Increments of elastic-plastic contact: work done, symmetries, unloading, initial states."""

import math
import re

import numpy as np
import pytest
from simulation_setups import (
    BALL,
    EXACT,
    GRID,
    LOAD,
    NU,
    OTHER,
    PRESSURE,
    RIGID,
    SIZE,
    SOFT,
    STEEL,
    VOLUME,
    assert_close,
    assert_same,
    simulation,
)

import samcontact as sc
from samcontact import operators, surfaces

FIRST_YIELD = 1e9 / 0.62 / 2.4e9  # as a part of p0, before the cells round anything
# Sign of each component under x -> -x.
MIRROR_X = np.array([1, 1, 1, 1, -1, -1])[:, None, None, None]


class TestWorkDone:
    def test_elastic_bodies_build_no_volume_operators(self):
        sim = simulation(STEEL, STEEL)
        state = sim.step(load=LOAD)
        assert state.iterations == 0
        counters = sim.counters
        assert counters["volume_bytes"] == 0
        assert counters["yield_checks"] == 0
        assert counters["plastic_solves"] == 0
        assert counters["contact_solves"] == 1
        assert counters["contact_iterations"] == state.contact_iterations > 0

    def test_the_smallest_tol(self):
        """The inner contact solve uses a tighter tolerance, but not below its minimum."""
        by_default, smallest = (
            simulation(STEEL, STEEL, tol=tol).step(load=LOAD) for tol in (1e-6, 1e-11)
        )
        assert_close(smallest.pressure, by_default.pressure, 1e-6)

    def test_no_plastic_solve_below_yield(self):
        """Operators for plastic strain are built only at first yield."""
        sim = simulation()
        for part in (0.2, 0.5):
            state = sim.step(load=part * FIRST_YIELD**3 * LOAD)
        below = sim.counters
        assert (below["yield_checks"], below["plastic_solves"]) == (2, 0)
        assert below["plastic_iterations"] == state.iterations == 0
        assert not state.equivalent_plastic_strain().any()
        state = sim.step(load=LOAD)
        above = sim.counters
        assert above["plastic_solves"] == 1
        assert above["plastic_iterations"] >= state.iterations > 0
        assert state.equivalent_plastic_strain().max() > 1e-3
        assert below["volume_bytes"] < 0.25 * above["volume_bytes"]

    def test_yields_where_the_elastic_stress_does(self):
        """The yield check is exact to 1e-6 of the load at first yield."""
        onset = LOAD
        for _ in range(60):  # the discrete contact is not exactly self-similar
            onset *= (1e9 / simulation(STEEL, STEEL).step(load=onset).von_mises().max()) ** 2
        assert onset == pytest.approx(FIRST_YIELD**3 * LOAD, rel=0.15)
        for factor, flows in ((1 - 1e-6, False), (1 + 1e-6, True)):
            state = simulation().step(load=factor * onset)
            assert bool(state.equivalent_plastic_strain().any()) == flows

    def test_is_elastic_contact_below_yield(self):
        load = 0.5 * FIRST_YIELD**3 * LOAD
        state = simulation().step(load=load)
        solution = sc.ContactSolver(GRID, STEEL, SOFT).solve(BALL, load=load)
        assert_close(state.pressure, solution.pressure, 1e-6)
        assert state.approach == pytest.approx(solution.approach, rel=1e-7)


class TestUnloading:
    @pytest.fixture(scope="class")
    @staticmethod
    def path():
        sim = simulation()
        return sim, [sim.step(load=part * LOAD) for part in (0.6, 1.0, 0.5, 0.0, 0.6, 1.0, 1.1)]

    def test_unloading_is_elastic(self, path):
        _, states = path
        for state in states[2:5]:
            assert state.iterations == 0
            strain = states[1].plastic_strain()
            np.testing.assert_array_equal(state.plastic_strain(), strain)

    def test_reloading_to_the_same_load_flows_no_more(self, path):
        _, states = path
        loaded, reloaded = states[1], states[5]
        more = reloaded.equivalent_plastic_strain() - loaded.equivalent_plastic_strain()
        assert more.min() >= 0
        assert more.max() < 1e-5 * loaded.equivalent_plastic_strain().max()
        assert_close(reloaded.pressure, loaded.pressure, 1e-5)
        assert reloaded.approach == pytest.approx(loaded.approach, rel=1e-6)
        further = states[6].equivalent_plastic_strain().max()
        assert further > 1.05 * loaded.equivalent_plastic_strain().max()

    def test_unloaded(self, path):
        _, states = path
        state = states[3]
        assert not state.pressure.any()
        print_ = state.residual_displacement()
        assert state.approach == pytest.approx((BALL + print_).min(), rel=1e-12)
        assert_close(state.gap, BALL + print_ - state.approach, 1e-12)
        assert_close(state.stress(), state.residual_stress(), 1e-12)
        assert print_.max() == print_[9, 10] > 0.02 * states[1].approach

    def test_earlier_states_do_not_change(self, path):
        """A state does not depend on later steps."""
        sim, states = path
        again = simulation()
        for kept, part in zip(states, (0.6, 1.0, 0.5, 0.0), strict=False):
            assert_same(kept, again.step(load=part * LOAD))
        assert_same(sim.state, states[-1])

    def test_yield_condition_holds_at_every_increment(self, path):
        _, states = path
        for state in states:
            excess = state.von_mises() / SOFT.yield_stress(state.equivalent_plastic_strain()) - 1
            assert excess.max() < 2e-6
            assert state.yield_violation <= 1e-6
            assert state.plastic_strain_residual <= 1e-6
            assert state.converged


class TestBothBodies:
    gap = BALL + surfaces.sinusoidal(GRID, 4e-8, 3.3 * SIZE, 4.7 * SIZE) + GRID.x[:, None] * 1e-4

    @pytest.mark.parametrize("other", [STEEL, RIGID])
    def test_upper_and_lower_body_are_equivalent(self, other):
        lower = simulation(other, SOFT, self.gap).step(load=LOAD / 2)
        upper = simulation(SOFT, other, self.gap).step(load=LOAD / 2)
        assert lower.iterations > 0
        assert_close(upper.pressure, lower.pressure, 1e-10)
        assert upper.approach == pytest.approx(lower.approach, rel=1e-10)
        for name in VOLUME:
            assert_close(getattr(upper, name)(1), getattr(lower, name)(2), 1e-9)
        if not other.is_rigid:
            assert not upper.plastic_strain(2).any()

    def test_identical_bodies_stay_identical(self):
        sim = simulation(SOFT, SOFT, self.gap)
        for load in (0.3 * LOAD, LOAD, 0.0, 1.1 * LOAD):
            state = sim.step(load=load)
            for name in VOLUME:
                upper, lower = (getattr(state, name)(body) for body in (1, 2))
                assert_close(upper, lower, 1e-12)
        assert state.equivalent_plastic_strain(1).max() > 1e-3

    def test_friction_drags_them_in_opposite_directions(self):
        """Equal constants and a symmetric gap make body 1 the x mirror image of body 2."""
        sim = simulation(SOFT, SOFT, friction=0.3)
        for load in (0.5 * LOAD, LOAD):
            state = sim.step(load=load)
        strain1, strain2 = state.plastic_strain(1), state.plastic_strain(2)
        assert_close(strain1, MIRROR_X * strain2[:, ::-1], 1e-5)
        assert np.abs(strain1 - strain2).max() > 0.1 * np.abs(strain2).max()

    def test_each_keeps_its_own_material_and_history(self):
        state = simulation(OTHER, SOFT).step(load=LOAD)
        for body, material in ((1, OTHER), (2, SOFT)):
            flow = state.equivalent_plastic_strain(body)
            assert flow.max() > 0
            flowing = flow > 1e-3 * flow.max()
            mises, limit = state.von_mises(body), material.yield_stress(flow)
            np.testing.assert_allclose(mises[flowing], limit[flowing], rtol=1e-5)
        first, second = (state.equivalent_plastic_strain(body).max() for body in (1, 2))
        assert first < 0.8 * second

    def test_two_yielding_bodies_share_the_flow(self):
        one = simulation(STEEL, SOFT).step(load=LOAD)
        two = simulation(SOFT, SOFT).step(load=LOAD)
        assert two.pressure.max() < one.pressure.max()
        flow = one.equivalent_plastic_strain().max()
        assert two.equivalent_plastic_strain().max() < flow


class TestPrescribedTractions:
    def test_reversed_shear_mirrors_in_x(self):
        p, s = PRESSURE, 0.2 * PRESSURE
        one = simulation(image_tol=1e-5).step(pressure=p, shear=s)
        other = simulation(image_tol=1e-5).step(pressure=p[::-1], shear=-s[::-1])
        assert one.iterations > 0
        assert_close(other.plastic_strain(), MIRROR_X * one.plastic_strain()[:, ::-1], 1e-5)
        assert_close(other.stress(), MIRROR_X * one.stress()[:, ::-1], 1e-6)
        np.testing.assert_array_equal(other.shear[0], -s[::-1])
        assert not other.shear[1].any()

    def test_shear_along_y(self):
        grid = sc.Grid(19, 19, SIZE, SIZE, 10, SIZE)
        p = EXACT.pressure(grid.x[:, None], grid.y[None, :] - SIZE)
        s = np.stack([0.1 * p, 0.3 * p])
        one = simulation(grid=grid, gap=p).step(pressure=p, shear=s)
        shear = np.stack([s[1].T, s[0].T])
        other = simulation(grid=grid, gap=p).step(pressure=p.T, shear=shear)
        swapped = one.plastic_strain().swapaxes(1, 2)[[1, 0, 2, 4, 3, 5]]
        assert_close(other.plastic_strain(), swapped, 1e-5)

    @pytest.mark.parametrize("friction", [0.0, 0.2])
    def test_default_shear_is_friction_times_pressure(self, friction):
        state = simulation(friction=friction).step(pressure=PRESSURE)
        given = simulation().step(pressure=PRESSURE, shear=friction * PRESSURE)
        np.testing.assert_array_equal(state.shear[0], friction * PRESSURE)
        np.testing.assert_array_equal(state.plastic_strain(), given.plastic_strain())

    def test_elastic_fields(self):
        sim = simulation(OTHER, STEEL)
        p, s = 0.1 * PRESSURE, np.stack([0.02 * PRESSURE, -0.03 * PRESSURE])
        state = sim.step(pressure=p, shear=s)
        assert math.isnan(state.approach)
        assert state.load == pytest.approx(p.sum() * GRID.cell_area, rel=1e-13)
        np.testing.assert_array_equal(state.pressure, p)
        total = BALL
        for body, material, sign in ((1, OTHER, -1), (2, STEEL, 1)):
            u = operators.surface_displacement(GRID, p, material.E, material.nu, sign * s)
            stress = operators.surface_stress(GRID, p, GRID.z, material.nu, sign * s)
            assert_close(state.surface_displacement(body), u, 1e-12)
            assert_close(state.stress(body), stress, 1e-12)
            assert_close(state.hydrostatic(body), stress[:3].mean(axis=0), 1e-12)
            total = total + u
        assert_close(state.gap, total, 1e-12)
        assert sim.counters["contact_solves"] == 0

    def test_contact_continues_from_prescribed_tractions(self):
        """Prescribed tractions of a contact give an equal state and an equal continuation."""
        contact = simulation(image_tol=1e-6)
        prescribed = simulation(image_tol=1e-6)
        for part in (0.5, 1.0):
            there = contact.step(load=part * LOAD)
            here = prescribed.step(pressure=there.pressure)
        assert_close(here.plastic_strain(), there.plastic_strain(), 1e-5)
        assert_close(here.gap - here.gap[9, 10], there.gap - there.gap[9, 10], 1e-5)
        there, here = contact.step(load=0.0), prescribed.step(load=0.0)
        assert_close(here.residual_displacement(), there.residual_displacement(), 1e-5)


class TestInitialStrain:
    strain = 1e-3 * np.random.default_rng(7).standard_normal((6, *GRID.volume_shape))

    def test_fields_of_an_initial_strain_are_those_of_the_operators(self):
        """Any symmetric strain, here random with a dilatation, in either body."""
        sim = simulation(OTHER, SOFT, residual_stress="exact")
        for body, material in ((1, OTHER), (2, SOFT)):
            sim.set_plastic_strain(body, self.strain)
            state = sim.state
            stress = operators.residual_stress(GRID, self.strain, material.E, material.nu)
            displacement = operators.residual_displacement(GRID, self.strain, material.nu)
            assert_close(state.residual_stress(body), stress, 1e-13)
            assert_close(state.stress(body), stress, 1e-13)
            assert_close(state.residual_displacement(body), displacement, 1e-13)
            assert_close(state.surface_displacement(body), displacement, 1e-13)
            np.testing.assert_array_equal(state.plastic_strain(body), self.strain)
            assert not state.equivalent_plastic_strain(body).any()

    @pytest.mark.filterwarnings("ignore::samcontact.PlasticStrainWarning")
    def test_contact_continues_from_an_initial_strain(self):
        """The body is hard enough to stay elastic; its surface is displaced by the strain."""
        sim = simulation(STEEL, SOFT)
        hardened = np.full(GRID.volume_shape, 0.5)
        strain = self.strain
        sim.set_plastic_strain(2, strain, hardened)
        state = sim.step(load=LOAD / 10)
        assert state.iterations == 0
        np.testing.assert_array_equal(state.plastic_strain(), strain)
        np.testing.assert_array_equal(state.equivalent_plastic_strain(), hardened)
        bent = BALL + operators.residual_displacement(GRID, strain, NU)
        expected = sc.ContactSolver(GRID, STEEL, SOFT).solve(bent, load=LOAD / 10)
        assert_close(state.pressure, expected.pressure, 1e-6)
        assert state.approach == pytest.approx(expected.approach, rel=1e-6)

    @pytest.mark.filterwarnings("ignore::samcontact.PlasticStrainWarning")
    def test_hardening_of_an_initial_strain_is_kept(self):
        """The yield stress of the next increment is that of the given equivalent strain."""
        flows = []
        for g in (0.0, 0.02, 0.1):
            sim = simulation()
            zero = np.zeros((6, *GRID.volume_shape))
            sim.set_plastic_strain(2, zero, np.full(GRID.volume_shape, g))
            flows.append((sim.step(load=LOAD).equivalent_plastic_strain() - g).max())
        assert flows[0] > flows[1] > flows[2] == pytest.approx(0, abs=1e-15)
        assert flows[0] == simulation().step(load=LOAD).equivalent_plastic_strain().max()

    @pytest.mark.parametrize(
        ("arguments", "error", "text"),
        [
            ((3, strain), ValueError, "body must be one of 1, 2, got 3"),
            (
                (1, strain),
                ValueError,
                "body 1 is not elastic-plastic: its plastic strain cannot be set",
            ),
            ((2, strain[:5]), ValueError, "strain must have shape (6, 19, 21, 10), got (5, 19,"),
            ((2, strain[0]), ValueError, "strain must have shape (6, 19, 21, 10), got (19, 21, 10"),
            (
                (2, np.where(strain == strain.max(), np.nan, strain)),
                ValueError,
                "strain must be fin",
            ),
            ((2, "strain"), TypeError, "strain must be an array of numbers, got texts"),
            (
                (2, strain, strain[0, 1:]),
                ValueError,
                "equivalent must have shape (19, 21, 10), got",
            ),
            ((2, strain, strain[0]), ValueError, "equivalent must be >= 0 everywhere, got -"),
            ((2, strain, strain[0] + np.inf), ValueError, "equivalent must be finite everywhere"),
        ],
    )
    def test_refused(self, arguments, error, text):
        sim = simulation()
        before = sim.step(load=LOAD)
        with pytest.raises(error, match=re.escape(text)):
            sim.set_plastic_strain(*arguments)
        assert_same(sim.state, before)
