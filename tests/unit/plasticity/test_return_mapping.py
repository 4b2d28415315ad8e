# SPDX-License-Identifier: GPL-3.0-or-later
"""The scalar equation of the radial return, trial - 3 G d = sigma_y(g + d), is solved to rounding.

Rounding: the terms trial, 3 G d and sigma_y are each known to one ulp of trial, so the
residual cannot be below a few ulp of the trial stress.
"""

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import samcontact as sc

E, NU = 210e9, 0.3
STIFFNESS = 3 * E / (2 * (1 + NU))
ULP = np.finfo(float).eps
LAWS = {
    "perfect": sc.Material.perfect_plastic(E, NU, 1e9),
    "linear": sc.Material.linear_hardening(E, NU, 1e9, 0.1 * E),
    "linear, steep": sc.Material.linear_hardening(E, NU, 1e9, 0.999 * E),
    "52100": sc.Material.swift(E, NU, 945e6, 20.0, 0.121),
    "M50": sc.Material.swift(E, NU, 1280e6, 4.0, 0.095),
    # the slope falls from 1e6 times 3 G to nearly nothing within the increment
    "Swift, steep": sc.Material.swift(E, NU, 1e9, 1e-6, 0.3),
    "Swift, n = 0": sc.Material.swift(E, NU, 1e9, 4.0, 0.0),
    "Swift, n = 1": sc.Material.swift(E, NU, 1e6, 1000.0, 1.0),
}
laws = pytest.mark.parametrize("law", LAWS)
many = settings(derandomize=True, max_examples=80, deadline=None, database=None)


def increment(law, trial, g):
    return LAWS[law]._core.equivalent_increment(trial, g)


@laws
@many
@given(excess=st.floats(-12.0, 4.0), g=st.just(0.0) | st.floats(-9.0, 0.0).map(lambda x: 10**x))
@example(excess=-12.0, g=0.0)
@example(excess=4.0, g=0.0)
def test_equation(law, excess, g):
    """Trial stresses from 1e-12 of the yield stress above it to 1e4 times."""
    trial = LAWS[law].yield_stress(g) * (1 + 10**excess)
    d = increment(law, trial, g)
    assert d > 0
    residual = trial - STIFFNESS * d - LAWS[law].yield_stress(g + d)
    # the law itself loses (g + d) ulp relative to d where it is steep
    slope = (LAWS[law].yield_stress((g + d) * (1 + 8 * ULP)) - LAWS[law].yield_stress(g + d)) / 8
    assert abs(residual) <= 8 * (ULP * trial + abs(slope))


@laws
def test_no_flow_up_to_the_yield_stress(law):
    for g in (0.0, 1e-3):
        yield_stress = LAWS[law].yield_stress(g)
        for trial in (0.0, 0.5 * yield_stress, yield_stress):
            assert increment(law, trial, g) == 0.0


@pytest.mark.parametrize("law", ["perfect", "linear", "linear, steep"])
def test_closed_form_of_linear_laws(law):
    hardening = (LAWS[law].yield_stress(1.0) - 1e9) / 1.0
    expected = 0.7e9 / (STIFFNESS + hardening)
    assert increment(law, 1.7e9, 0.0) == pytest.approx(expected, rel=1e-13)


@laws
@many
@given(trials=st.tuples(*[st.floats(1.0, 50.0)] * 2), g=st.floats(0.0, 0.1))
def test_monotonic_in_the_trial_stress(law, trials, g):
    low, high = sorted(LAWS[law].yield_stress(g) * factor for factor in trials)
    d_low, d_high = increment(law, low, g), increment(law, high, g)
    assert d_low <= d_high
    # no more than elastic predictor: 3 G d never exceeds what is above the old yield stress
    above = high - LAWS[law].yield_stress(g)
    assert STIFFNESS * d_high <= above * (1 + 4 * ULP) + 4 * ULP * high
