# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed forms of adhesive contact: stored values, limits, and a profile of any shape."""

import json
from pathlib import Path

import numpy as np
import pytest

from samcontact import adhesion, hertz

STORED = json.loads((Path(__file__).parents[2] / "oracles" / "adhesion.json").read_text())
R, W, E_STAR = 2e-6, 0.05, 3e8


def test_jkr():
    stored = STORED["jkr"]
    found = adhesion.jkr(1.0, stored["w"], 1.0)
    np.testing.assert_allclose(found.load(stored["radius"]), stored["load"], rtol=1e-8)
    np.testing.assert_allclose(found.approach(stored["radius"]), stored["approach"], rtol=1e-8)
    np.testing.assert_allclose(found.pull_off, stored["pull_off"], rtol=1e-12)
    np.testing.assert_allclose(found.radius_at_pull_off, stored["radius_at_pull_off"])
    stable = [a for a in stored["radius"] if a > 1.01 * stored["radius_at_pull_off"]]
    np.testing.assert_allclose(found.radius(found.load(stable)), stable, rtol=1e-7)


@pytest.mark.parametrize("stored", STORED["maugis"])
def test_maugis(stored):
    found = adhesion.maugis(1.0, stored["w"], 1.0, stored["stress"])
    radius, load, approach, outer = np.transpose(stored["rows"])
    np.testing.assert_allclose(found.transition_parameter, stored["transition_parameter"])
    scale = np.pi * stored["w"]
    np.testing.assert_allclose(found.load(radius), load, rtol=1e-8, atol=1e-9 * scale)
    np.testing.assert_allclose(found.approach(radius), approach, rtol=1e-8, atol=1e-11)
    np.testing.assert_allclose(found.outer_radius(radius), outer, rtol=1e-8)
    np.testing.assert_allclose(found.pull_off, stored["pull_off"], rtol=1e-6)


def test_maugis_lies_between_jkr_and_dmt():
    """The pull-off falls with the stress, from DMT to JKR."""
    limits = adhesion.dmt(R, W), adhesion.jkr(R, W, E_STAR).pull_off
    found = [adhesion.maugis(R, W, E_STAR, s).pull_off for s in (1e5, 1e6, 1e7, 1e8, 1e9)]
    assert limits[0] > found[0]
    assert found[-1] > limits[1] * (1 - 1e-6)
    assert np.all(np.diff(found) < 0)
    np.testing.assert_allclose([found[0], found[-1]], limits, rtol=2e-2)


def test_a_profile_without_adhesion_is_hertz_and_with_adhesion_jkr():
    radius = np.array([1e-8, 5e-8, 2e-7])
    sphere = adhesion.jkr_profile(lambda r: r / R, radius, W, E_STAR)
    jkr = adhesion.jkr(R, W, E_STAR)
    np.testing.assert_allclose(sphere.load, jkr.load(radius), rtol=1e-9)
    np.testing.assert_allclose(sphere.approach, jkr.approach(radius), rtol=1e-9)
    bare = adhesion.jkr_profile(lambda r: r / R, radius, 1e-30, E_STAR)
    radii = [hertz.point(R, E_STAR, load=load).a for load in bare.load]
    np.testing.assert_allclose(radii, radius, rtol=1e-9)


def test_a_cone_with_adhesion():
    """Sneddon (1965) with the tension of a flat punch."""
    slope, radius = 0.2, np.array([1e-7, 1e-6])
    found = adhesion.jkr_profile(lambda r: np.full_like(r, slope), radius, W, E_STAR)
    tension = np.sqrt(8 * np.pi * W * E_STAR * radius**3)
    np.testing.assert_allclose(
        found.load, 0.5 * np.pi * E_STAR * slope * radius**2 - tension, rtol=1e-9
    )


@pytest.mark.parametrize("stored", STORED["wave"])
def test_wave(stored):
    found = adhesion.wave(1.0, stored["amplitude"], stored["w"], 1.0)
    np.testing.assert_allclose(found.alpha, stored["alpha"], rtol=1e-10)
    mean = found.mean_pressure(stored["half_width"]) / found.flattening_pressure
    np.testing.assert_allclose(mean, stored["mean_pressure"], rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(
        found.pull_off / found.flattening_pressure, -stored["pull_off"], rtol=1e-6
    )


def test_tabor_and_maugis_parameters():
    """At equal work and peak 1.03 w/z, lambda is 1.16 mu (Maugis 1992)."""
    z = 1e-9
    found = adhesion.maugis(R, W, E_STAR, 1.03 * W / z).transition_parameter
    np.testing.assert_allclose(found, 1.16 * adhesion.tabor(R, W, E_STAR, z), rtol=3e-3)


@pytest.mark.parametrize(("number", "difference"), [(5.0, 0.004), (0.1, 0.03)])
def test_the_theories_of_short_and_long_range_at_their_stated_limits(number, difference):
    z = (R * W**2 / E_STAR**2) ** (1.0 / 3.0) / number
    found = adhesion.maugis(R, W, E_STAR, W / z).pull_off
    limit = adhesion.jkr(R, W, E_STAR).pull_off if number > 1 else adhesion.dmt(R, W)
    np.testing.assert_allclose(adhesion.tabor(R, W, E_STAR, z), number, rtol=1e-12)
    np.testing.assert_allclose(found, limit, rtol=difference)
