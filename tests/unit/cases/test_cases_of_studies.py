# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files that come with the package: hot fretting, a coating that wears, laps."""

from pathlib import Path

import numpy as np

from samcontact.cases import load_case

CASES = Path(__file__).parents[3] / "cases"


def test_hot_fretting_heats_both_bodies_equally():
    """Half of the heat enters each of two equal bodies."""
    simulation, path = load_case(CASES / "s4_hot_fretting.toml").build()
    states = simulation.run(path, progress=False)
    rise = [states[-1].surface_temperature(body) for body in (1, 2)]
    assert rise[0].max() > 0.1
    np.testing.assert_allclose(rise[0], rise[1], atol=1e-9 * rise[0].max())
    assert states[-1].friction_work > states[0].friction_work


def test_a_coating_wears_by_its_share():
    case = load_case(CASES / "w3_coated_wear.toml")
    result = case.wear.solve(*case.build(), None, False)
    thickness = case.body2.layers[0].thickness
    worn = -result.profile(body=2).min()
    shares = [cycle.coating_worn_share[0] for cycle in result.cycles]
    assert 0 < shares[0] < shares[-1] < 0.2
    np.testing.assert_allclose(shares[-1], worn / thickness)
    work = sum(cycle.friction_work for cycle in result.cycles)
    volumes = sum(cycle.volume[0] for cycle in result.cycles)
    np.testing.assert_allclose(volumes, case.wear.energy * work, rtol=1e-6)


def test_laps_shake_down():
    case = load_case(CASES / "r5_rolling_lap.toml")
    found = case.shakedown.solve(*case.build(), False)
    assert found.response == "elastic shakedown"
    assert found.cycles[0].flow > found.yield_strain
    np.testing.assert_allclose(found.state.travel, -2 * 320e-6)  # two laps
