# SPDX-License-Identifier: GPL-3.0-or-later
"""Minimum on an interval: the digits of SciPy, for smooth, flat and kinked functions."""

import math

import pytest
import scipy.optimize

from samcontact._util.bounded_minimum import bounded_minimum
from samcontact.hertz import axis

FUNCTIONS = {
    "parabola": lambda x: (x - 0.7) ** 2,
    "at the lower end": lambda x: x,
    "at the upper end": lambda x: -x,
    "kink": lambda x: abs(x - 1.3),
    "flat": lambda x: (x - 1.0) ** 6,
    "constant": lambda x: 0.25,
    "two minima": lambda x: math.cos(5.0 * x),
    "line contact": lambda x: -axis._von_mises(*axis.line_axis(x, 0.3)),
    "ellipse": lambda x: -axis._von_mises(*axis.elliptic_axis(x, 3.0, 0.28)),
}


@pytest.mark.parametrize("tolerance", [1e-3, 1e-10, 1e-14])
@pytest.mark.parametrize("name", FUNCTIONS)
def test_digits_of_scipy(name, tolerance):
    function = FUNCTIONS[name]
    for upper in (2.0, 3.7):
        known = scipy.optimize.minimize_scalar(
            function, bounds=(0.0, upper), method="bounded", options={"xatol": tolerance}
        )
        assert bounded_minimum(function, 0.0, upper, tolerance) == (known.x, known.fun)
