# SPDX-License-Identifier: GPL-3.0-or-later
"""Minimum on an interval: equal to SciPy's to the last digit, without loading it."""

import math
import random

import pytest
import scipy.optimize

from samcontact._util.bounded import bounded_minimum

FUNCTIONS = {
    "parabola": lambda x: (x - 0.3) ** 2,
    "quartic": lambda x: (x - 1.7) ** 4 + 0.1 * x,
    "kink": lambda x: abs(x - 0.9),
    "waves": lambda x: math.sin(5 * x) + 0.2 * x,
    "step": lambda x: float(x > 0.5),
    "falling": lambda x: -x,
    "constant": lambda x: 1.0,
    "stress": lambda x: -abs(1.5 / (1 + x * x) - 1.3 * (1 - x * math.atan2(1.0, x))),
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_the_steps_are_those_of_scipy(name):
    function, chance = FUNCTIONS[name], random.Random(1)
    for _ in range(50):
        low = chance.uniform(-1, 1)
        high, xatol = low + chance.choice((1e-3, 0.5, 2.0)), 10 ** chance.uniform(-13, -3)
        known = scipy.optimize.minimize_scalar(
            function, bounds=(low, high), method="bounded", options={"xatol": xatol}
        )
        assert bounded_minimum(function, low, high, xatol) == (known.x, known.fun)
