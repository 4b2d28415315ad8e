# SPDX-License-Identifier: GPL-3.0-or-later
"""Slip, layers, zones, periods, cycles, fatigue and wear have the same digits in any units."""

import numpy as np
import pytest
from scaled_scenes import POWERS_OF_TWO, SCENES, UNITS, Units

pytestmark = pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
QUICK = "contact radius, load, time and temperature of the scene"
SLOW = [pytest.param(name, marks=pytest.mark.slow) for name in UNITS if name != QUICK]


@pytest.fixture(scope="module", params=SCENES)
def scene(request):
    return SCENES[request.param]


@pytest.fixture(scope="module")
def in_si(scene):
    return scene(Units())


@pytest.mark.parametrize("units", [QUICK, *SLOW])
def test_same_digits_in_other_units(scene, in_si, units):
    for name, values in scene(Units(*UNITS[units])).items():
        expected = in_si[name]
        assert np.abs(values - expected).max() <= 1e-12 * np.abs(expected).max(), name


def test_same_bits_in_powers_of_two(scene, in_si):
    """But for numbers that vanish beside the largest, where logarithms of lengths are added."""
    for name, values in scene(Units(*POWERS_OF_TWO)).items():
        expected = in_si[name]
        assert np.abs(values - expected).max() <= 1e-17 * np.abs(expected).max(), name
