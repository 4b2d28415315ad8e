# SPDX-License-Identifier: GPL-3.0-or-later
"""Yield stress from hardness: consistency, units, and a warning outside the data."""

import numpy as np
import pytest

import samcontact as sc
from samcontact import hardness

DATA = np.linspace(129.0, 632.0, 40)


def test_yield_is_below_the_flow_stress_at_eight_percent_and_nears_it_with_hardness():
    # the remaining hardening decreases with hardness (Pavlina, Van Tyne 2008, figures 1 and 4)
    ratio = hardness.yield_from_vickers(DATA) / hardness.flow_stress_from_vickers(DATA)
    assert np.all(np.diff(ratio) > 0)
    assert ratio[0] > 0.6
    assert ratio[-1] < 0.9


def test_a_third_of_the_mean_pressure_of_the_indent_is_the_flow_stress():
    # 1 kgf on a pyramid of diagonal 0.1 mm: HV = 1.8544 F/d^2, by contact area, not projected area
    force, diagonal = 9.80665, 0.1e-3
    vickers = 2 * np.sin(np.radians(68.0)) * (force / 9.80665) / (diagonal * 1e3) ** 2
    shadow = force / (diagonal**2 / 2)
    found = hardness.flow_stress_from_vickers(vickers)
    assert found == pytest.approx(shadow * np.sin(np.radians(68.0)) / 3, rel=1e-12)


def test_a_hardened_case_becomes_a_profile_with_a_warning_beyond_the_data():
    depth, indents = [0.1e-3, 0.5e-3, 1e-3, 2e-3], [720, 640, 550, 380]
    with pytest.warns(hardness.HardnessRangeWarning, match="HV = 720 is outside"):
        strength = hardness.yield_from_vickers(indents)
    core = sc.Material.linear_hardening(210e9, 0.3, strength[-1], 20e9)
    case = core.with_yield_profile(depth, strength / strength[-1])
    assert "profile" in repr(case)
    assert strength[0] / strength[-1] == pytest.approx(1.98, abs=0.01)


@pytest.mark.parametrize("wrong", [0.0, -300.0, np.nan, 7e9, [300.0, 6900.0]])
@pytest.mark.parametrize("name", ["yield_from_vickers", "flow_stress_from_vickers"])
def test_invalid_vickers_numbers_are_refused(name, wrong):
    with pytest.raises(ValueError, match=r"HV must be Vickers numbers .* got"):
        getattr(hardness, name)(wrong)
