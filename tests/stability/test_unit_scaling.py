# SPDX-License-Identifier: GPL-3.0-or-later
"""Results have equal digits in other units: no constant contains a hidden length or stress."""

import itertools
from functools import cache

import numpy as np
import pytest

from benchmarks.stability import interface_setups
from benchmarks.stability.scaled_setups import POWERS_OF_TWO, UNITS, Units
from benchmarks.stability.table import relative_difference
from benchmarks.stability.units import CASES, SLIDING

pytestmark = pytest.mark.filterwarnings("ignore::samcontact.GridTooSmallWarning")
QUICK_CASE = "contact radius, load, time and temperature of the case"
assert QUICK_CASE in UNITS


@cache
def in_si(problem):
    return CASES[problem](Units())


@pytest.mark.parametrize(
    ("problem", "units"),
    [
        pair
        if QUICK_CASE in pair or pair[0] in SLIDING
        else pytest.param(*pair, marks=pytest.mark.slow)
        for pair in itertools.product(CASES, UNITS)
    ],
)
def test_same_digits_in_other_units(problem, units):
    for name, values in CASES[problem](Units(*UNITS[units])).items():
        assert relative_difference(values, in_si(problem)[name]) <= 1e-12, name


@pytest.mark.parametrize("problem", CASES)
def test_same_bits_in_powers_of_two(problem):
    """Such units change no mantissa, so results are bit-identical if no code compares or adds
    quantities of different units. Exceptions: numbers negligible against the largest, where
    logarithms of lengths are added, and error-controlled values of runs to an accuracy."""
    minimum = 1e-13 if problem == "to an accuracy" else 1e-17
    for name, values in CASES[problem](Units(*POWERS_OF_TWO)).items():
        if problem in SLIDING:
            np.testing.assert_array_equal(values, in_si(problem)[name], err_msg=name)
        assert relative_difference(values, in_si(problem)[name]) <= minimum, name


@pytest.mark.parametrize(
    "units",
    [
        name if n == 0 else pytest.param(name, marks=pytest.mark.slow)
        for n, name in enumerate(UNITS)
    ],
)
def test_inclusions_in_other_units(units):
    for name, values in interface_setups.included(Units(*UNITS[units])).items():
        assert relative_difference(values, interface_setups.included(Units())[name]) <= 1e-12, name


def test_inclusions_have_the_same_bits_in_powers_of_two():
    found = interface_setups.included(Units(*POWERS_OF_TWO))
    for name, values in interface_setups.included(Units()).items():
        np.testing.assert_array_equal(found[name], values, err_msg=name)
