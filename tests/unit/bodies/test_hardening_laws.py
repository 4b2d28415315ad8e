# SPDX-License-Identifier: GPL-3.0-or-later
"""Voce's law and tabulated curves against closed forms, other laws and solvers of SciPy."""

import itertools
import pickle
import re

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy import integrate, optimize

import samcontact as sc

E, NU = 210e9, 0.3
G = E / (2 * (1 + NU))
STIFFNESS = 3 * G
ULP = np.finfo(float).eps
S0, S_INF, RATE = 900e6, 1500e6, 60.0
VOCE = sc.Material.voce(E, NU, S0, S_INF, RATE)
STRAIN, STRESS = (0.0, 1e-3, 2e-3, 8e-3, 0.02), (900e6, 950e6, 1300e6, 1310e6, 1600e6)
TABLE = sc.Material.tabulated(E, NU, STRAIN, STRESS)
ONE = sc.Material.tabulated(E, NU, [0.0], [1e9])
LAWS = {"voce": VOCE, "tabulated": TABLE}
laws = pytest.mark.parametrize("law", LAWS)
many = settings(derandomize=True, max_examples=150, deadline=None, database=None)


def curve(g, strain, stress):
    """Return the table by interpolation, constant beyond its end."""
    return np.interp(g, strain, stress)


class TestCurve:
    g = np.concatenate([[0.0], np.geomspace(1e-9, 10.0, 60)])

    def test_voce(self):
        expected = S_INF - (S_INF - S0) * np.exp(-RATE * self.g)
        np.testing.assert_allclose(VOCE.yield_stress(self.g), expected, rtol=4 * ULP)
        assert VOCE.yield_stress(0.0) == S0
        assert VOCE.yield_stress(1e3) == S_INF

    def test_voce_without_range_is_perfect_plasticity(self):
        flat = sc.Material.voce(E, NU, S0, S0, RATE)
        perfect = sc.Material.perfect_plastic(E, NU, S0)
        np.testing.assert_array_equal(flat.yield_stress(self.g), perfect.yield_stress(self.g))
        np.testing.assert_array_equal(flat.plastic_work(self.g), perfect.plastic_work(self.g))

    def test_table(self):
        expected = curve(self.g, STRAIN, STRESS)
        np.testing.assert_allclose(TABLE.yield_stress(self.g), expected, rtol=4 * ULP)
        np.testing.assert_array_equal(TABLE.yield_stress(STRAIN), STRESS)
        np.testing.assert_array_equal(ONE.yield_stress(self.g), np.full(61, 1e9))

    @laws
    @pytest.mark.parametrize("g", [1e-12, 1e-6, 1e-3, 1.7e-3, 0.02, 0.5])
    def test_work_by_quadrature(self, law, g):
        material, kinks = LAWS[law], [k for k in STRAIN if 0 < k < g]
        ends = [0.0, *kinks, g]
        pieces = [
            integrate.quad(material.yield_stress, low, high, epsabs=0.0, epsrel=1e-13)[0]
            for low, high in itertools.pairwise(ends)
        ]
        assert material.plastic_work(g) == pytest.approx(sum(pieces), rel=1e-13)

    @pytest.mark.parametrize("x", [1e-9, 1e-3, 0.9, 1.0, 1.1, 30.0])
    def test_work_of_voce_keeps_its_digits(self, x):
        """If hardening dominates the stress, a series replaces the closed form (cancellation)."""
        steep = sc.Material.voce(E, NU, 1.0, 1e9, RATE)
        g = x / RATE
        range_ = integrate.quad(lambda t: -np.expm1(-RATE * t), 0.0, g, epsabs=0.0, epsrel=1e-13)[0]
        assert steep.plastic_work(g) == pytest.approx(g + (1e9 - 1.0) * range_, rel=1e-12)


class TestAgainstOtherLaws:
    Et = 0.05 * E
    modulus = E * Et / (E - Et)
    linear = sc.Material.linear_hardening(E, NU, 1e9, Et)
    line = sc.Material.tabulated(E, NU, [0.0, 0.5], [1e9, 1e9 + 0.5 * modulus])
    cycle = np.concatenate([np.linspace(0, 0.02, 9), np.linspace(0.02, -0.03, 15), [0.0, 0.04]])

    def test_two_points_are_linear_hardening(self):
        g = np.linspace(0, 0.4, 9)
        np.testing.assert_allclose(self.line.yield_stress(g), self.linear.yield_stress(g), 1e-14)
        np.testing.assert_allclose(self.line.plastic_work(g), self.linear.plastic_work(g), 1e-14)
        for kinematic in (False, True):
            stress = [
                (one.with_kinematic_hardening([9e9, 80e9], [0.0, 50.0]) if kinematic else one)
                .uniaxial_stress(self.cycle)
                for one in (self.line, self.linear)
            ]  # fmt: skip
            np.testing.assert_allclose(*stress, rtol=1e-12, atol=1e-12 * 1e9)

    def test_samples_of_swift_converge_at_second_order(self):
        swift = sc.Material.swift(E, NU, 150e6, 3000.0, 0.25)
        errors = []
        for pieces in (8, 16, 32):
            g = np.linspace(0.0, 0.03, pieces + 1)
            table = sc.Material.tabulated(E, NU, g, swift.yield_stress(g))
            history = np.linspace(0.0, 0.03, 31)
            difference = table.uniaxial_stress(history) - swift.uniaxial_stress(history)
            errors.append(np.abs(difference).mean())
        assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.15)
        assert errors[1] / errors[2] == pytest.approx(4.0, rel=0.1)

    def test_samples_of_voce_converge_to_voce_in_cycles(self):
        moving = VOCE.with_kinematic_hardening(80e9, 50.0)
        expected, errors = moving.uniaxial_stress(self.cycle), []
        for pieces in (20, 40, 80):
            g = np.linspace(0.0, 0.2, pieces + 1)
            table = sc.Material.tabulated(E, NU, g, VOCE.yield_stress(g))
            table = table.with_kinematic_hardening(80e9, 50.0)
            errors.append(np.abs(table.uniaxial_stress(self.cycle) - expected).mean())
        assert errors[1] / errors[2] == pytest.approx(4.0, rel=0.3)
        assert errors[2] < 1e-3 * S0


class TestBar:
    @laws
    def test_first_loading(self, law):
        material, strain = LAWS[law], np.linspace(0, 0.05, 23)
        expected = [
            E * e
            if E * e <= S0
            else E
            * (e - optimize.brentq(lambda g, e=e: E * (e - g) - material.yield_stress(g), 0, e))
            for e in strain
        ]
        np.testing.assert_allclose(material.uniaxial_stress(strain), expected, rtol=1e-9)

    @laws
    def test_cycles_with_kinematic_hardening(self, law):
        """Backward Euler of one backstress, each increment by a bracketing solver."""
        C, r = 60e9, 40.0
        history = np.concatenate([np.linspace(0, 0.02, 6), np.linspace(0.015, -0.02, 8), [0.03]])
        plastic = x = g = 0.0
        expected = []
        for total in history:
            trial = E * (total - plastic)

            def beyond(d, trial=trial, x=x, g=g):
                left = abs(trial - x / (1 + r * d))
                return left - (E + C / (1 + r * d)) * d - LAWS[law].yield_stress(g + d)

            if beyond(0.0) > 0:
                d = optimize.brentq(beyond, 0.0, 0.1, xtol=1e-17, rtol=4 * ULP)
                flow = np.copysign(d, trial - x / (1 + r * d))
                x = (x + C * flow) / (1 + r * d)
                plastic, g = plastic + flow, g + d
            expected.append(E * (total - plastic))
        found = LAWS[law].with_kinematic_hardening(C, r).uniaxial_stress(history)
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-9 * S0)
        assert g > 0.03


# A staircase, on which Newton's method could alternate between two steps.
STAIRS = ([0.0, 1e-3, 1.001e-3, 3e-3, 3.001e-3], [1e9, 1.0001e9, 2e9, 2.0001e9, 4e9])
tables = st.lists(
    st.tuples(
        st.floats(-7, -2).map(lambda x: 10**x),
        st.just(0.0) | st.floats(3, 9.5).map(lambda x: 10**x),
    ),
    max_size=12,
).map(lambda steps: tuple(np.cumsum([(0.0, 5e8), *steps], axis=0).T.tolist()))


class TestReturn:
    @many
    @given(table=tables, g=st.floats(0.0, 0.05), excess=st.floats(-9, 2).map(lambda x: 10**x))
    @example(table=STAIRS, g=0.0, excess=1.5)
    @example(table=STAIRS, g=1e-3, excess=3.0)
    @example(table=STAIRS, g=0.999e-3, excess=1e-3)
    def test_equation_across_kinks(self, table, g, excess):
        material = sc.Material.tabulated(E, NU, *table)
        before = material.yield_stress(g)
        trial = before * (1 + excess)
        d = material._core.equivalent_increment(trial, g)
        assert 0 < d <= (trial - before) / STIFFNESS * (1 + 8 * ULP) + 4 * ULP * trial / STIFFNESS
        # the law loses (g + d) ulp where it is steep, on both sides of a kink
        near = material.yield_stress((g + d) * (1 + np.array([-8, 8]) * ULP))
        residual = trial - STIFFNESS * d - material.yield_stress(g + d)
        assert abs(residual) <= 8 * ULP * trial + np.ptp(near)

    @pytest.mark.parametrize("index", range(1, 5))
    def test_ends_on_a_kink(self, index):
        strain, stress = np.array(STAIRS[0]), np.array(STAIRS[1])
        material = sc.Material.tabulated(E, NU, *STAIRS)
        trial = stress[index] + STIFFNESS * strain[index]
        d = material._core.equivalent_increment(trial, 0.0)
        assert d == pytest.approx(strain[index], rel=1e-13)

    @many
    @given(
        table=tables,
        steps=st.lists(
            st.tuples(*[st.floats(-0.02, 0.02)] * 3).map(
                lambda e: np.array([e[0], e[1], -e[0] - e[1], e[2], 0.5 * e[0], -e[1]])
            ),
            min_size=1,
            max_size=4,
        ),
        terms=st.sampled_from([[(30e9, 0.0)], [(200e9, 400.0), (20e9, 20.0)]]),
    )
    @example(table=STAIRS, steps=[np.array([0.02, -0.02, 0, 0, 0, 0])], terms=[(30e9, 0.0)])
    def test_ends_on_or_inside_a_moving_yield_surface(self, table, steps, terms):
        material = sc.Material.tabulated(E, NU, *table)
        material = material.with_kinematic_hardening(*zip(*terms, strict=True))
        plastic, g, back = np.zeros(6), 0.0, np.zeros((len(terms), 6))
        for total in steps:
            trial = 2 * G * (total - plastic)
            flow, d, after = material._core.radial_return(list(trial), g, back.tolist())
            plastic, g, back = plastic + flow, g + d, np.array(after)
            s = 2 * G * (total - plastic) - back.sum(axis=0)
            norm = np.sqrt(1.5 * (s[:3] @ s[:3]) + 3 * (s[3:] @ s[3:]))
            radius = material.yield_stress(g)
            near = np.ptp(material.yield_stress(g * (1 + np.array([-8, 8]) * ULP)))
            room = 1e-12 * (radius + np.abs(trial).max()) + near
            assert norm <= radius + room
            if d > 0:
                assert norm >= radius - room

    @many
    @given(
        constants=st.tuples(st.floats(5, 10), st.floats(0, 10), st.floats(-2, 8)),
        g=st.floats(0.0, 0.1),
        excess=st.floats(-9, 3).map(lambda x: 10**x),
    )
    def test_equation_of_voce(self, constants, g, excess):
        first, more, rate = 10 ** np.array(constants)
        material = sc.Material.voce(E, NU, first, first + more, rate)
        trial = material.yield_stress(g) * (1 + excess)
        d = material._core.equivalent_increment(trial, g)
        residual = trial - STIFFNESS * d - material.yield_stress(g + d)
        slope = more * rate * np.exp(-rate * (g + d))
        assert d > 0
        assert abs(residual) <= 8 * ULP * (trial + slope * (g + d))


def test_a_table_is_a_value():
    strain, stress = np.array(STRAIN), list(STRESS)
    material = sc.Material.tabulated(E, NU, strain, stress)
    strain[1], stress[1] = 1e-4, 1e6
    assert material == TABLE
    assert hash(material) == hash(TABLE)
    assert pickle.loads(pickle.dumps(material)) == TABLE
    assert material.parameters["stress"] == STRESS
    assert "stress=(900000000.0, 950000000.0, " in repr(material)
    assert "5 values, 900 MPa to 1.6 GPa" in material._repr_html_()
    assert sc.Material.tabulated(E, NU, STRAIN, (*STRESS[:4], 1.7e9)) != TABLE


@pytest.mark.parametrize(
    ("strain", "stress", "error", "text"),
    [
        ([], [], ValueError, "number of values in plastic_strain must be from 1 to 4096, got 0"),
        (
            [0.0, 0.1],
            [1e9],
            ValueError,
            "number of values in stress must be the number of values in plastic_strain",
        ),
        ([1e-3, 0.1], [1e9, 2e9], ValueError, "plastic_strain[0] must be 0, the strain at first y"),
        (
            [0.0, -0.1],
            [1e9, 2e9],
            ValueError,
            "plastic_strain[1] must be a finite number >= 0, got",
        ),
        ([0.0, np.inf], [1e9, 2e9], ValueError, "plastic_strain[1] must be a finite number >= 0"),
        (
            [0.0, 0.1, 0.1],
            [1e9, 2e9, 3e9],
            ValueError,
            "plastic_strain[2] must be > plastic_strain[1] = 0.1, got 0.1: specify one stress",
        ),
        ([0.0, 0.2, 0.1], [1e9, 2e9, 3e9], ValueError, "plastic_strain[2] must be > plastic_strai"),
        (
            [0.0, 0.1],
            [1e9, 0.9e9],
            ValueError,
            "stress[1] must be >= stress[0] = 1e+09 Pa, got 9e+08: a falling curve",
        ),
        ([0.0, 0.1], [0.0, 0.9e9], ValueError, "stress[0] must be a finite number > 0 [Pa], got 0"),
        (
            [0.0, 0.1],
            [1e9, np.nan],
            ValueError,
            "stress[1] must be a finite number > 0 [Pa], got n",
        ),
        ([0.0, 5e-324], [1e9, 2e9], ValueError, "plastic_strain[1] must be farther from plastic_s"),
        (0.0, 1e9, ValueError, "plastic_strain must be a list of numbers, got shape ()"),
        ([0.0], [["1e9"]], TypeError, "stress must be an array of numbers"),
        (None, [1e9], TypeError, "plastic_strain must be an array of numbers, got None"),
        (np.linspace(0, 1, 4097), np.full(4097, 1e9), ValueError, "from 1 to 4096, got 4097"),
    ],
)
def test_an_invalid_table_is_refused(strain, stress, error, text):
    with pytest.raises(error, match=re.escape(text)):
        sc.Material.tabulated(E, NU, strain, stress)


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ((0.0, 1e9, 1.0), "yield_stress must be a finite number > 0 [Pa], got 0"),
        ((1e9, np.inf, 1.0), "saturation_stress must be a finite number > 0 [Pa], got inf"),
        ((1e9, 0.9e9, 1.0), "saturation_stress must be >= yield_stress = 1e+09 Pa, got 9e+08"),
        ((1e9, 2e9, 0.0), "rate must be a finite number > 0, got 0"),
        ((1e9, 2e9, -3.0), "rate must be a finite number > 0, got -3"),
    ],
)
def test_voce_refuses(arguments, text):
    with pytest.raises(ValueError, match=re.escape(text)):
        sc.Material.voce(E, NU, *arguments)
