# SPDX-License-Identifier: GPL-3.0-or-later
"""Viscosity of mineral oils over the temperature, and their pressure-viscosity coefficient."""

import math

import numpy as np
import pytest

import samcontact as sc

TABLE = """
    12.1 18.4  5.3 13.4  153 23.7  34 20.5  9.1 15.8  250 25  50.5 21.3  12.6 17.6  810 34
    135 28  26.8 22  18.6 20  6.3 16  2.4 13  45 28  12 20  3.9 16  107 29.6  23.3 22.8  6.4 17.8
    122 27  26.3 21.6  7.3 17.5  171 28  31 23  7.5 18  30.7 25.7  8.6 20.3  3.1 15.4  165 33
    30 23.8  6.8 16  310 34.6  44.2 26.3  9.4 19.5  2000 41.5  180 29.4  24 25
"""
"""Viscosity [mPa s] and pressure-viscosity coefficient [1/GPa] of thirteen mineral oils, table 2.3
of Stachowiak & Batchelor, Engineering Tribology."""


def test_the_viscosity_over_temperature_has_a_published_value():
    """32 mm^2/s at 40 °C and 5.4 at 100 °C are 8.5 at 80 °C by ASTM D341."""
    oil = sc.lubricants.oil(32e-6, 5.4e-6)
    found = oil.kinematic_viscosity(np.array([313.15, 353.15, 373.15]))
    assert found == pytest.approx([32e-6, 8.5e-6, 5.4e-6], rel=4e-3)
    assert found[[0, 2]] == pytest.approx([32e-6, 5.4e-6], rel=1e-12)


def test_beta_is_the_slope_of_the_viscosity():
    oil = sc.lubricants.iso_vg("ISO VG 68")
    cold, hot = oil.viscosity([349.9, 350.1])
    assert oil.beta(350.0) == pytest.approx(math.log(cold / hot) / 0.2, rel=1e-6)


def test_the_pressure_viscosity_coefficient_is_near_measured_values():
    values = np.array(TABLE.split(), dtype=float).reshape(-1, 2)
    oil = sc.lubricants.iso_vg(68)
    temperatures = np.linspace(293.15, 403.15, 400)
    viscosities = 1e3 * oil.viscosity(temperatures)
    inside = values[(values[:, 0] > viscosities.min()) & (values[:, 0] < viscosities.max())]
    deviations = [
        oil.pressure_viscosity(np.interp(-eta, -viscosities, temperatures)) * 1e9 / alpha - 1.0
        for eta, alpha in inside
    ]
    assert len(deviations) > 20
    assert min(deviations) > -0.31
    assert max(deviations) < 0.18
    assert np.mean(deviations) == pytest.approx(-0.12, abs=0.03)


def test_a_grade_makes_a_lubricant():
    oil = sc.lubricants.iso_vg(68)
    assert oil.nu40 == pytest.approx(68e-6)
    hot = oil.lubricant(T=343.15)
    assert hot.eta0 == pytest.approx(870 * float(oil.kinematic_viscosity(343.15)))
    assert 15e-9 < hot.pressure_viscosity < oil.lubricant().pressure_viscosity < 30e-9
    assert "ISO 3448" in oil._repr_html_()


@pytest.mark.parametrize("grade", [67, "ISO VG 67", "SAE 30"])
def test_unknown_grades_are_refused(grade):
    with pytest.raises(ValueError, match="ISO VG 10, 15"):
        sc.lubricants.iso_vg(grade)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: sc.lubricants.oil(68.0, 8.5), "68 mm"),
        (lambda: sc.lubricants.oil(8.5e-6, 68e-6), "nu40 must be > nu100"),
        (lambda: sc.lubricants.oil(68e-6, 8.5e-6, 0.87), "870"),
        (lambda: sc.lubricants.iso_vg(68).lubricant(40.0), "kelvins"),
    ],
)
def test_wrong_values_are_refused(make, words):
    with pytest.raises(ValueError, match=words):
        make()
