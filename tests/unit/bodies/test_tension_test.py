# SPDX-License-Identifier: GPL-3.0-or-later
"""Hardening law from a test: a known law is recovered, and the usual slips are refused."""

import numpy as np
import pytest

import samcontact as sc

E, K, N = 205e9, 1.2e9, 0.12
TRUE_STRESS = np.concatenate([np.linspace(0, 600e6, 60, endpoint=False), np.linspace(6e8, 1e9, 80)])
TRUE_STRAIN = TRUE_STRESS / E + (TRUE_STRESS / K) ** (1 / N)  # Ramberg-Osgood
STRAIN, STRESS = np.expm1(TRUE_STRAIN), TRUE_STRESS / np.exp(TRUE_STRAIN)
NECK = int(STRESS.argmax()) + 1  # Considere: uniform strain up to the maximum force


@pytest.mark.parametrize(
    ("strain", "stress", "extra"),
    [
        (STRAIN[:NECK], STRESS[:NECK], {}),
        (STRAIN[:NECK] + 1e-3, STRESS[:NECK], {}),  # slack of the grips
        (np.r_[0.0, STRAIN[1:NECK] + 3e-4], STRESS[:NECK], {}),
        (STRAIN[:NECK] + STRESS[:NECK] / 1e11, STRESS[:NECK], {"E": E}),  # the machine deforms
        (STRAIN[40:NECK], STRESS[40:NECK], {"E": E}),
        (TRUE_STRAIN, TRUE_STRESS, {"engineering": False, "E": E}),
        (-TRUE_STRAIN, -TRUE_STRESS, {"engineering": False}),
        (np.expm1(-TRUE_STRAIN), -TRUE_STRESS * np.exp(TRUE_STRAIN), {}),  # compression thickens
    ],
)
def test_the_law_of_a_ramberg_osgood_curve_is_recovered(strain, stress, extra):
    made = sc.Material.from_test(strain, stress, **extra)
    assert pytest.approx(E, rel=3e-3) == made.E
    g = np.array([3e-4, 1e-3, 0.01, 0.08])
    assert made.yield_stress(g) == pytest.approx(K * g**N, rel=3e-3)
    assert made.yield_stress(0.0) == pytest.approx(K * 2e-4**N, rel=3e-3)  # at the offset
    proof = sc.Material.from_test(strain, stress, offset=2e-3, **extra)
    assert proof.yield_stress(0.0) == pytest.approx(K * 2e-3**N, rel=3e-3)


@pytest.mark.parametrize(
    ("strain", "stress", "extra", "says"),
    [
        (STRAIN[:NECK] * 100, STRESS[:NECK], {}, "divide strains in percent"),
        (STRAIN[:70] * 100, STRESS[:70], {}, "divide strains in percent"),  # less than 1 %
        (STRAIN[:70] * 100, STRESS[:70], {"E": E}, "divide strains in percent"),
        (STRAIN, STRESS / 1e6, {}, "multiply MPa by 1e6"),
        (STRAIN, STRESS, {}, f"necks.* first {NECK} points"),
        (np.r_[STRAIN[:50], STRAIN[40:70]], STRESS[:80], {}, r"got strain\[50\]"),
        (STRAIN[:NECK], -STRESS[:NECK], {}, "equal signs"),
        (STRAIN[:20], STRESS[:20], {"E": E}, "does not yield"),
        (STRAIN[40:NECK], STRESS[40:NECK], {}, "E is required"),
        (STRAIN[:NECK], np.where(np.arange(NECK) == 90, 9e8, STRESS[:NECK]), {}, "smooth|necks"),
        (STRAIN[:3], STRESS[:3], {}, "at least 4"),
        (STRAIN[:NECK], STRESS[:NECK], {"E": 205.0}, "E must be in Pa, got 205"),
        (STRAIN[:NECK], STRESS[:NECK], {"E": 1.5e11}, "must not be below the slope of the curve"),
        (STRAIN[:NECK], STRESS[:NECK], {"offset": 0.2}, "offset must"),
    ],
)
def test_slips_are_refused(strain, stress, extra, says):
    with pytest.raises(ValueError, match=says):
        sc.Material.from_test(strain, stress, **extra)


def test_long_records_are_thinned():
    fine = np.linspace(0, TRUE_STRAIN[-1], 20001)
    stress = np.interp(fine, TRUE_STRAIN, TRUE_STRESS)
    made = sc.Material.from_test(fine, stress, engineering=False)
    assert len(made.parameters["stress"]) == 4096
    assert made.yield_stress(0.05) == pytest.approx(K * 0.05**N, rel=3e-3)


def noisy(peak=0.0):
    """Return a curve recorded at constant strain rate, with noise of 2 MPa and 3e-6."""
    rng = np.random.default_rng(11)
    strain = np.linspace(0.0, TRUE_STRAIN[-1], 3000)
    stress = np.interp(strain, TRUE_STRAIN, TRUE_STRESS)
    stress = stress + peak * np.exp(-(((strain - 4e-3) / 4e-4) ** 2))
    return strain + 3e-6 * rng.standard_normal(3000), stress + 2e6 * rng.standard_normal(3000)


def test_noise_leaves_the_law():
    """The fit that does not decrease is unbiased; without noise it is the curve itself."""
    made = sc.Material.from_test(*noisy(), engineering=False)
    assert pytest.approx(E, rel=0.02) == made.E
    g = np.array([1e-3, 0.01, 0.08])
    assert made.yield_stress(g) == pytest.approx(K * g**N, rel=1e-2)
    assert (np.diff(made.parameters["stress"]) >= 0).all()


def test_an_upper_yield_point_is_no_noise():
    with pytest.raises(ValueError, match=r"more than the noise .* strain of 0\.00[0-9]+ .* smooth"):
        sc.Material.from_test(*noisy(peak=90e6), engineering=False)
