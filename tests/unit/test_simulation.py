# SPDX-License-Identifier: GPL-3.0-or-later
"""Increments of elastic-plastic contact: work done, symmetries, failures, initial states, input."""

import math
import re
import warnings

import numpy as np
import pytest

import samcontact as sc
from samcontact import hertz, operators, surfaces

E, NU = 210e9, 0.3
STEEL = sc.Material.elastic(E, NU)
SOFT = sc.Material.linear_hardening(E, NU, 1e9, 0.1 * E)
OTHER = sc.Material.linear_hardening(1.5 * E, 0.25, 1.2e9, 0.1 * E)
RIGID = sc.Material.rigid()
RADIUS = 7.5e-3
EXACT = hertz.point(R=RADIUS, E_star=hertz.effective_modulus(STEEL, STEEL), p0=2.4e9)
LOAD = EXACT.load
SIZE = EXACT.a / 6
GRID = sc.Grid(19, 21, SIZE, 0.9 * SIZE, 10, SIZE)
BALL = surfaces.paraboloid(GRID, RADIUS)
FIRST_YIELD = 1e9 / 0.62 / 2.4e9  # as a part of p0, before the cells round anything
# Sign of each component under x -> -x.
MIRROR_X = np.array([1, 1, 1, 1, -1, -1])[:, None, None, None]
SURFACE = ("pressure", "shear", "gap")
SCALARS = ("load", "approach", "iterations", "contact_iterations", "substeps", "converged")
VOLUME = ("plastic_strain", "equivalent_plastic_strain", "stress", "residual_displacement")


def simulation(body1=STEEL, body2=SOFT, gap=BALL, grid=GRID, **settings):
    return sc.Simulation(grid, body1, body2, gap, **settings)


def snapshot(state):
    """Everything a state tells, as arrays."""
    fields = {name: np.array(getattr(state, name)) for name in SURFACE + SCALARS}
    for body in (1, 2):
        fields |= {f"{name} {body}": np.array(getattr(state, name)(body)) for name in VOLUME}
    return fields


def assert_same(actual, expected):
    for name, values in snapshot(expected).items():
        np.testing.assert_array_equal(snapshot(actual)[name], values, err_msg=name)


def assert_close(actual, expected, tolerance):
    difference = np.abs(actual - expected).max()
    assert difference <= tolerance * np.abs(expected).max()


class TestWorkDone:
    def test_nothing_for_the_volume_without_an_inelastic_body(self):
        sim = simulation(STEEL, STEEL)
        state = sim.step(load=LOAD)
        assert state.iterations == 0
        counters = sim.counters
        assert counters["volume_bytes"] == 0
        assert counters["yield_checks"] == 0
        assert counters["plastic_solves"] == 0
        assert counters["contact_solves"] == 1
        assert counters["contact_iterations"] == state.contact_iterations > 0

    def test_the_least_tol(self):
        """The contact within is solved more tightly, but not beyond its own least tol."""
        by_default, least = (
            simulation(STEEL, STEEL, tol=tol).step(load=LOAD) for tol in (1e-6, 1e-11)
        )
        assert_close(least.pressure, by_default.pressure, 1e-6)

    def test_no_plastic_solve_below_yield(self):
        """What acts on plastic strain is only built at first yield."""
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
        assert below["volume_bytes"] < 0.2 * above["volume_bytes"]

    def test_yields_where_the_elastic_stress_does(self):
        """The check is exact: 1e-6 below the load of first yield nothing flows, above it does."""
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

    def test_is_elastic(self, path):
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

    def test_earlier_states_stay(self, path):
        """What a state tells does not depend on the steps that followed it."""
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
            assert state.yield_excess <= 1e-6
            assert state.plastic_residual <= 1e-6
            assert state.converged


class TestBothBodies:
    gap = BALL + surfaces.sinusoidal(GRID, 4e-8, 3.3 * SIZE, 4.7 * SIZE) + GRID.x[:, None] * 1e-4

    @pytest.mark.parametrize("other", [STEEL, RIGID])
    def test_upper_body_does_what_the_lower_one_would(self, other):
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
        """Equal constants, so no coupling; a symmetric gap: body 1 is the x mirror of body 2."""
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
    pressure = EXACT.pressure(GRID.x[:, None] - SIZE, GRID.y[None, :])

    def test_reversed_shear_mirrors_in_x(self):
        p, s = self.pressure, 0.2 * self.pressure
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
        state = simulation(friction=friction).step(pressure=self.pressure)
        given = simulation().step(pressure=self.pressure, shear=friction * self.pressure)
        np.testing.assert_array_equal(state.shear[0], friction * self.pressure)
        np.testing.assert_array_equal(state.plastic_strain(), given.plastic_strain())

    def test_elastic_fields(self):
        sim = simulation(OTHER, STEEL)
        p, s = 0.1 * self.pressure, np.stack([0.02 * self.pressure, -0.03 * self.pressure])
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

    def test_contact_goes_on_from_them(self):
        """Tractions that a contact gave, given back: the same state, and the same way on."""
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

    def test_fields_are_those_of_the_operators(self):
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
    def test_contact_goes_on_from_it(self):
        """Hardened enough not to flow: elastic contact of the surface that the strain bends."""
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
    def test_hardening_counts(self):
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
            ((1, strain), ValueError, "body 1 is not inelastic: it has no plastic strain to set"),
            ((2, strain[:5]), ValueError, "strain must have shape (6, 19, 21, 10), got (5, 19,"),
            ((2, strain[0]), ValueError, "strain must have shape (6, 19, 21, 10), got (19, 21, 10"),
            (
                (2, np.where(strain == strain.max(), np.nan, strain)),
                ValueError,
                "strain must be fin",
            ),
            ((2, "strain"), TypeError, "strain must be an array of numbers, got str"),
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


class TestGridTooSmall:
    shallow = sc.Grid(19, 21, SIZE, 0.9 * SIZE, 6, SIZE)
    narrow = sc.Grid(7, 9, SIZE, SIZE, 12, SIZE)

    def test_bottom(self):
        depth = re.escape(repr(6 * SIZE)[:8])
        text = (
            rf"at load .* N the plastic zone of body 2 reaches the bottom of the volume "
            rf"\({depth}.* m\), where it flows by [\d.]+ % of its largest plastic strain: "
            r"enlarge nz dz, or ask for a warning with on_border=\"warn\".*Hertz: radius"
        )
        sim = simulation(grid=self.shallow)
        with pytest.raises(sc.GridTooSmallError, match=text):
            sim.step(load=LOAD)
        warned = simulation(grid=self.shallow, on_border="warn")
        with pytest.warns(sc.GridTooSmallWarning, match="plastic zone of body 2 .* enlarge nz dz"):
            state = warned.step(load=LOAD)
        assert state.equivalent_plastic_strain()[..., -1].any()
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            warned.step(load=0.9 * LOAD)  # no further flow at the bottom: nothing to say

    def test_sides(self):
        """Pressure on the whole of a narrow grid: it yields under the edge of the pressed area."""
        pressure = np.full(self.narrow.surface_shape, 1.9e9)
        gap = np.zeros(self.narrow.surface_shape)
        text = r"at the prescribed tractions the plastic zone of body 1 reaches the sides of the "
        with pytest.raises(sc.GridTooSmallError, match=text + r".*enlarge nx dx and ny dy, or ask"):
            simulation(SOFT, STEEL, gap, self.narrow).step(pressure=pressure)
        warned = simulation(SOFT, STEEL, gap, self.narrow, on_border="warn")
        with pytest.warns(sc.GridTooSmallWarning, match=text):
            assert warned.step(pressure=pressure).converged

    def test_contact(self):
        gap = surfaces.paraboloid(self.narrow, RADIUS)
        text = r"at load .* N the contact touches the border .* enlarge nx dx .*, or ask for"
        for body in (STEEL, SOFT):
            with pytest.raises(sc.GridTooSmallError, match=text):
                simulation(STEEL, body, gap, self.narrow).step(load=LOAD)
        warned = simulation(STEEL, STEEL, gap, self.narrow, on_border="warn")
        with pytest.warns(sc.GridTooSmallWarning, match="contact touches the border"):
            assert warned.step(load=LOAD).load == LOAD


FAILURES = {
    "bad load": ({"load": -1.0}, ValueError),
    "no target": ({}, ValueError),
    "two targets": ({"load": 1.0, "approach": 1.0}, ValueError),
    "bad pressure": ({"pressure": np.full(GRID.surface_shape, np.nan)}, ValueError),
    "shear with load": ({"load": 1.0, "shear": BALL}, ValueError),
    "contact at the border": ({"load": 40 * LOAD}, sc.GridTooSmallError),
    "flow at the bottom": ({"load": 3.5 * LOAD}, sc.GridTooSmallError),
}


class TestFailedStep:
    """After any failure the state is that before it, bit by bit, and so is all that follows."""

    @pytest.fixture(scope="class")
    @staticmethod
    def untroubled():
        sim = simulation()
        return [sim.step(load=part * LOAD) for part in (0.7, 1.0, 0.0)]

    @pytest.mark.parametrize("case", FAILURES)
    def test_leaves_the_state_intact(self, case, untroubled):
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
        with pytest.raises(sc.ConvergenceError, match="the plastic increment to load") as caught:
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
    def test_is_smaller_increments(self):
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
        goal = {"approach": EXACT.approach, "pressure": TestPrescribedTractions.pressure}[driver]
        whole = simulation().step(**{driver: goal})
        sim = simulation(max_iterations=whole.iterations - 1)
        state = sim.step(**{driver: goal})
        assert state.substeps > 1
        change = np.abs(state.plastic_strain() - whole.plastic_strain()).max()
        assert 0 < change < 0.1 * np.abs(whole.plastic_strain()).max()
        np.testing.assert_allclose(getattr(state, driver), goal, rtol=1e-12)


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

    def test_is_the_steps_one_after_the_other(self, capsys):
        sim, by_hand = simulation(), simulation()
        states = sim.run(iter(self.path), progress=False)
        assert capsys.readouterr().err == ""
        assert len(states) == 3
        for state, arguments in zip(states, self.path, strict=True):
            assert_same(state, by_hand.step(**arguments))

    def test_progress_bar(self, capsys):
        simulation().run([{"load": 1.0}])
        assert capsys.readouterr().err == "increment 1 of 1\n"

    def test_failure_keeps_what_was_reached(self):
        sim = simulation()
        path = [*self.path[:2], {"pressure": np.zeros((2, 2))}, {"load": 0.0}]
        with pytest.raises(ValueError, match="pressure must have shape") as caught:
            sim.run(path, progress=False)
        assert len(caught.value.states) == 2
        assert_same(sim.state, caught.value.states[-1])

    def test_empty_path(self):
        assert simulation().run([], progress=False) == []


class TestState:
    @pytest.fixture(scope="class")
    @staticmethod
    def state():
        return simulation(OTHER, SOFT).step(load=LOAD)

    def test_before_the_first_step(self):
        state = simulation(gap=BALL + 3e-6).state
        assert (state.load, state.iterations) == (0.0, 0)
        assert state.approach == (BALL + 3e-6).min()
        assert not state.pressure.any()
        assert not state.stress().any()
        assert not state.residual_displacement().any()

    def test_shapes_and_components(self, state):
        tensors = ("stress", "residual_stress", "plastic_strain")
        scalars = ("von_mises", "hydrostatic", "equivalent_plastic_strain")
        for body in (1, 2):
            for name in tensors:
                assert getattr(state, name)(body).shape == (6, *GRID.volume_shape)
            for name in scalars:
                assert getattr(state, name)(body).shape == GRID.volume_shape
            for name in ("residual_displacement", "surface_displacement"):
                assert getattr(state, name)(body).shape == GRID.surface_shape
            xx, yy, zz, yz, xz, xy = state.stress(body)
            mises = np.sqrt(
                0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2)
                + 3 * (yz**2 + xz**2 + xy**2)
            )
            assert_close(state.von_mises(body), mises, 1e-13)
            assert_close(state.hydrostatic(body), (xx + yy + zz) / 3, 1e-13)
        assert state.pressure.shape == state.gap.shape == GRID.surface_shape
        assert state.shear.shape == (2, *GRID.surface_shape)
        # the x component changes along x: under the flank of the ball sigma_xz is odd in x
        xz = state.stress()[4]
        assert_close(xz[::-1], -xz, 1e-5)
        assert np.abs(xz[:, ::-1] - xz).max() < 1e-5 * np.abs(xz).max()

    def test_plastic_strain_is_isochoric_and_accumulates(self, state):
        strain = state.plastic_strain()
        assert_close(strain[:3].sum(axis=0) + 1.0, np.ones(GRID.volume_shape), 1e-15)
        rate = np.sqrt(2 / 3 * ((strain[:3] ** 2).sum(0) + 2 * (strain[3:] ** 2).sum(0)))
        # one increment from the virgin state: proportional, so both measures agree
        assert_close(state.equivalent_plastic_strain(), rate, 1e-12)

    @pytest.mark.parametrize("name", ["pressure", "gap"])
    def test_surface_fields_are_read_only_views(self, state, name):
        field = getattr(state, name)
        with pytest.raises(ValueError, match="read-only"):
            field[0, 0] = 1.0
        assert np.shares_memory(field, getattr(state, name))

    def test_fields_outlive_their_state(self):
        sim = simulation()
        pressure = sim.step(load=LOAD).pressure
        kept = pressure.copy()
        sim.step(load=0.5 * LOAD)
        del sim
        np.testing.assert_array_equal(pressure, kept)

    def test_scribbling_on_a_volume_field_changes_nothing(self, state):
        expected = state.plastic_strain().copy()
        with pytest.raises(ValueError, match="read-only"):
            state.plastic_strain()[...] = 7.0
        np.testing.assert_array_equal(state.plastic_strain(), expected)

    def test_balance(self, state):
        assert state.pressure.sum() * GRID.cell_area == pytest.approx(LOAD, rel=1e-12)
        total = BALL - state.approach
        for body in (1, 2):
            total = total + state.surface_displacement(body)
        inside = state.pressure > 0
        assert np.abs(state.gap - total).max() < 1e-6 * EXACT.approach
        assert np.abs(state.gap[inside]).max() < 1e-6 * EXACT.approach
        assert state.gap.min() > -1e-6 * EXACT.approach

    def test_repr(self, state):
        assert re.fullmatch(r"State\(load=.* N, approach=.* m, .*iterations=\d+\)", repr(state))

    def test_fields_that_do_not_exist(self, state):
        with pytest.raises(ValueError, match="body must be one of 1, 2, got 0"):
            state.stress(0)
        rigid = simulation(RIGID, SOFT).step(load=0.1 * LOAD)
        surface = sc.Grid(19, 21, SIZE, 0.9 * SIZE)
        flat = simulation(STEEL, STEEL, grid=surface).step(load=0.1 * LOAD)
        for name in ("stress", "von_mises", "equivalent_plastic_strain", "residual_stress"):
            with pytest.raises(ValueError, match="body 1 is rigid: it has no stress or strain"):
                getattr(rigid, name)(1)
            with pytest.raises(ValueError, match="nz is 0: fields below the surface need a grid"):
                getattr(flat, name)(2)


class TestBadInput:
    @pytest.mark.parametrize(
        ("arguments", "error", "text"),
        [
            ({"grid": (19, 21)}, TypeError, "grid must be a samcontact.Grid, got (19, 21)"),
            ({"body1": 210e9}, TypeError, "body1 must be a samcontact.Material, got 2"),
            ({"body2": None}, TypeError, "body2 must be a samcontact.Material, got None"),
            ({"body1": RIGID, "body2": RIGID}, ValueError, "body1 and body2 are both rigid"),
            ({"gap": BALL[1:]}, ValueError, "gap must have shape (19, 21), got (18, 21)"),
            ({"gap": BALL * np.nan}, ValueError, "gap must be finite everywhere, got nan at index"),
            ({"gap": "ball"}, TypeError, "gap must be an array of numbers, got str"),
            ({"friction": -0.1}, ValueError, "friction must be a finite number >= 0, got -0.1"),
            ({"friction": math.nan}, ValueError, "friction must be a finite number >= 0, got nan"),
            ({"friction": "much"}, TypeError, "friction must be a number, got 'much'"),
            ({"tol": 0.0}, ValueError, "tol must be in [1e-11, 1), got 0"),
            ({"tol": 2.0}, ValueError, "tol must be in [1e-11, 1), got 2"),
            ({"tol": math.nan}, ValueError, "tol must be in [1e-11, 1), got nan"),
            ({"increment_tol": 5e-6}, ValueError, "increment_tol must be in [10 tol, 1) with tol"),
            ({"increment_tol": 1.0}, ValueError, "increment_tol must be in [10 tol, 1) with tol"),
            ({"increment_tol": "1 %"}, TypeError, "increment_tol must be a number, got '1 %'"),
            ({"on_border": "stop"}, ValueError, "on_border must be one of 'error', 'warn', got 's"),
            ({"max_iterations": 0}, ValueError, "max_iterations must be an integer >= 1, got 0"),
            (
                {"grid": sc.Grid(19, 21, SIZE, SIZE)},
                ValueError,
                "nz must be > 0 for an inelastic body: give the grid layers with nz and dz",
            ),
        ],
    )
    def test_of_the_scene(self, arguments, error, text):
        good = {"grid": GRID, "body1": STEEL, "body2": SOFT, "gap": BALL}
        with pytest.raises(error, match=re.escape(text)):
            sc.Simulation(**(good | arguments))

    @pytest.mark.parametrize(
        ("arguments", "error", "text"),
        [
            ({}, ValueError, "give exactly one of load, approach, pressure; got none"),
            ({"load": 1.0, "approach": 0.0}, ValueError, "pressure; got load, approach"),
            ({"load": 1.0, "pressure": BALL}, ValueError, "pressure; got load, pressure"),
            ({"load": -1.0}, ValueError, "load must be a finite number >= 0 [N], got -1"),
            ({"load": math.nan}, ValueError, "load must be a finite number >= 0 [N], got nan"),
            ({"load": math.inf}, ValueError, "load must be a finite number >= 0 [N], got inf"),
            ({"load": "1 kN"}, TypeError, "load must be a number, got '1 kN'"),
            ({"approach": math.inf}, ValueError, "approach must be a finite number [m], got inf"),
            ({"approach": None, "load": None}, ValueError, "pressure; got none"),
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
            ({"load": 1.0, "shear": BALL}, ValueError, "shear goes with pressure, not with load"),
            ({"shear": BALL}, ValueError, "give exactly one of load, approach, pressure; got none"),
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


class TestSmallStrain:
    """Beyond a plastic strain of 5 %."""

    STRONG = sc.Material.perfect_plastic(E, NU, 1e12)

    def strained(self, sim, body, shear):
        strain = np.zeros((6, *GRID.volume_shape))
        strain[5, 9, 9, 4] = shear  # sqrt(2/3 e:e) = 2/sqrt(3) shear
        sim.set_plastic_strain(body, strain)

    @staticmethod
    def warnings_of(sim, load):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            sim.step(load=load)
        return [str(w.message) for w in caught if w.category is sc.PlasticStrainWarning]

    @pytest.mark.parametrize("body", [1, 2])
    def test_warns_once_when_it_passes_five_per_cent(self, body):
        sim = simulation(*((self.STRONG, STEEL) if body == 1 else (STEEL, self.STRONG)))
        self.strained(sim, body, 0.0499 * math.sqrt(3) / 2)
        assert self.warnings_of(sim, LOAD) == []
        assert sim.state.max_plastic_strain(body) == pytest.approx(0.0499, rel=1e-14)
        self.strained(sim, body, -0.0501 * math.sqrt(3) / 2)
        (message,) = self.warnings_of(sim, LOAD)
        start = f"the equivalent plastic strain of body {body} reaches 0.0501, more than 0.05"
        assert message.startswith(start)
        assert "small" in message
        self.strained(sim, body, 0.06)
        assert self.warnings_of(sim, LOAD) == []

    def test_may_be_an_error(self):
        """The step is done all the same, as with a grid that is too small."""
        sim = simulation(STEEL, self.STRONG)
        self.strained(sim, 2, 0.05)
        with pytest.raises(sc.PlasticStrainWarning, match="body 2"):
            sim.step(load=LOAD)
        assert sim.state.load == pytest.approx(LOAD)

    @pytest.mark.parametrize("symmetric", [True, False])
    def test_is_that_of_the_tensor(self, symmetric):
        gap = BALL if symmetric else BALL + GRID.x[:, None] * 1e-4
        state = simulation(gap=gap).step(load=LOAD)
        e = state.plastic_strain()
        expected = np.sqrt(2 / 3 * ((e[:3] ** 2).sum(0) + 2 * (e[3:] ** 2).sum(0)).max())
        assert state.max_plastic_strain() == pytest.approx(expected, rel=1e-12)
        assert 0 < expected <= state.max_equivalent_plastic_strain() * (1 + 1e-12)
        assert state.max_plastic_strain(1) == 0.0


class TestNumbersOfAState:
    def test_area_mean_pressure_and_largest_strain(self):
        sim = simulation()
        state = sim.step(load=LOAD)
        assert state.contact_area == np.count_nonzero(state.pressure) * GRID.cell_area
        assert state.contact_area == pytest.approx(math.pi * EXACT.a**2, rel=0.15)
        assert state.mean_pressure == pytest.approx(state.pressure[state.pressure > 0].mean())
        largest = state.equivalent_plastic_strain().max()
        assert state.max_equivalent_plastic_strain() == largest > 0
        assert state.max_equivalent_plastic_strain(body=1) == 0.0

    def test_without_contact(self):
        state = simulation(RIGID, SOFT).state
        assert (state.contact_area, state.mean_pressure) == (0.0, 0.0)
        assert state.max_equivalent_plastic_strain(1) == 0.0
        assert state.max_equivalent_plastic_strain(2) == 0.0
        with pytest.raises(ValueError, match="body must be one of 1, 2, got 0"):
            state.max_equivalent_plastic_strain(0)
