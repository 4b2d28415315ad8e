# SPDX-License-Identifier: GPL-3.0-or-later
"""Results have equal digits in other units: no constant contains a hidden length or stress."""

import itertools
from functools import cache

import numpy as np
import pytest

from benchmarks.stability.scaled_setups import POWERS_OF_TWO, UNITS, Units
from benchmarks.stability.table import apart
from benchmarks.stability.units import SCENES, SLIDING

pytestmark = pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
QUICK_CASE = "contact radius, load, time and temperature of the scene"


@cache
def in_si(scene):
    return SCENES[scene](Units())


@pytest.mark.parametrize(
    ("scene", "units"),
    [
        pair
        if QUICK_CASE in pair or pair[0] in SLIDING
        else pytest.param(*pair, marks=pytest.mark.slow)
        for pair in itertools.product(SCENES, UNITS)
    ],
)
def test_same_digits_in_other_units(scene, units):
    for name, values in SCENES[scene](Units(*UNITS[units])).items():
        assert apart(values, in_si(scene)[name]) <= 1e-12, name


@pytest.mark.parametrize("scene", SCENES)
def test_same_bits_in_powers_of_two(scene):
    """Such units change no mantissa, so results are bit-identical if no code compares or adds
    quantities of different units. Exceptions: numbers negligible against the largest, where
    logarithms of lengths are added, and error-controlled values of runs to an accuracy."""
    least = 1e-13 if scene == "to an accuracy" else 1e-17
    for name, values in SCENES[scene](Units(*POWERS_OF_TWO)).items():
        if scene in SLIDING:
            np.testing.assert_array_equal(values, in_si(scene)[name], err_msg=name)
        assert apart(values, in_si(scene)[name]) <= least, name
