# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed forms of adhesive contacts against independent evaluations and limiting cases.

The numbers in `reference` were computed from the formulas of the papers by another program.
"""

import json
import math
from pathlib import Path

import numpy as np
import pytest

import samcontact as sc

REFERENCE = Path(__file__).parent / "reference"
R, W, E_STAR = 1e-6, 0.05, 1e9


def reference(name):
    return json.loads((REFERENCE / f"{name}.json").read_text(encoding="utf-8"))


def test_jkr_equals_the_reference_and_its_own_inverse():
    given = reference("jkr_sphere")
    sphere = sc.adhesion.jkr(given["R"], given["work_of_adhesion"], given["E_star"])
    radii = np.array(given["contact_radius"])
    np.testing.assert_allclose(sphere.load(radii), given["load"], rtol=1e-12)
    np.testing.assert_allclose(sphere.approach(radii), given["approach"], rtol=1e-12, atol=1e-15)
    stable = radii[radii > sphere.radius_at_pull_off * (1 + 1e-9)]
    np.testing.assert_allclose(sphere.radius(sphere.load(stable)), stable, rtol=1e-9)
    assert sphere.load(sphere.radius_at_pull_off) == pytest.approx(-sphere.pull_off, rel=1e-12)
    with pytest.raises(ValueError, match="load must be at least"):
        sphere.radius(-1.01 * sphere.pull_off)


def test_maugis_equals_the_reference_and_lies_between_jkr_and_dmt():
    given = reference("maugis_sphere")
    for case in given["cases"]:
        sphere = sc.adhesion.maugis(
            given["R"], given["work_of_adhesion"], given["E_star"], case["cohesive_stress"]
        )
        assert sphere.transition_parameter == pytest.approx(case["lam"], rel=1e-12)
        radius, load, approach, outer = np.transpose(case["rows"])
        np.testing.assert_allclose(sphere.load(radius), load, rtol=1e-9, atol=1e-9 * load.max())
        np.testing.assert_allclose(sphere.approach(radius), approach, rtol=1e-9, atol=1e-12)
        np.testing.assert_allclose(sphere.outer_radius(radius), outer, rtol=1e-9)
        assert sphere.pull_off == pytest.approx(case["pull_off"], rel=1e-6)
    stiff, soft = (sc.adhesion.maugis(R, W, E_STAR, s).pull_off for s in (1e5, 1e10))
    assert stiff == pytest.approx(sc.adhesion.dmt(R, W), rel=2e-3)
    assert soft == pytest.approx(sc.adhesion.jkr(R, W, E_STAR).pull_off, rel=2e-3)


def test_a_parabolic_profile_is_jkr_and_a_cone_follows_from_its_integrals():
    radii = np.linspace(2e-8, 3e-7, 7)
    sphere = sc.adhesion.jkr(R, W, E_STAR)
    profile = sc.adhesion.jkr_profile(lambda r: r / R, radii, W, E_STAR)
    np.testing.assert_allclose(profile.load, sphere.load(radii), rtol=1e-9, atol=1e-20)
    np.testing.assert_allclose(profile.approach, sphere.approach(radii), rtol=1e-9, atol=1e-20)
    slope = 0.1
    cone = sc.adhesion.jkr_profile(lambda r: np.full_like(r, slope), radii, W, E_STAR)
    pulled = np.sqrt(2 * math.pi * radii * W / E_STAR)
    np.testing.assert_allclose(cone.approach, math.pi / 2 * slope * radii - pulled, rtol=1e-9)
    expected = E_STAR * radii * (math.pi / 2 * slope * radii - 2 * pulled)
    np.testing.assert_allclose(cone.load, expected, rtol=1e-9, atol=1e-18)
    assert cone.pull_off == pytest.approx(-cone.load.min())


def test_a_wave_equals_the_reference():
    given = reference("adhesive_wave")
    for case in given["cases"]:
        wave = sc.adhesion.wave(
            given["wavelength"], given["amplitude"], case["work_of_adhesion"], given["E_star"]
        )
        assert wave.alpha == pytest.approx(case["alpha"], rel=1e-12)
        mean = wave.mean_pressure(case["half_width"]) / wave.flattening_pressure
        np.testing.assert_allclose(mean, case["mean_pressure_over_pstar"], atol=1e-12)
        assert wave.pull_off / wave.flattening_pressure == pytest.approx(
            -case["pull_off"], rel=1e-6
        )


def test_the_tabor_number_of_a_law_is_that_of_its_range():
    grid, tip, soft = sc.Grid(9, 7, 2e-9, 3e-9), sc.Material.rigid(), sc.Material.elastic(1e9, 0.3)
    E_star = sc.hertz.effective_modulus(tip, soft)
    law = sc.Adhesion.exponential(W, 2e-9)
    found = law.on(grid, tip, soft)
    assert found.modulus == pytest.approx(E_star, rel=1e-12)
    assert found.tabor(R) == pytest.approx(sc.adhesion.tabor(R, W, E_star, 2e-9), rel=1e-12)
    refined = sc.Adhesion.jkr(W).on(grid, tip, soft)
    assert refined.is_refined
    assert refined.kappa == pytest.approx(0.5, rel=1e-12)
    assert not found.is_refined
    periodic = sc.Grid(16, 16, 2e-9, 2e-9, periodic="xy")
    assert law.on(periodic, tip, soft).modulus == pytest.approx(E_star, rel=1e-12)
