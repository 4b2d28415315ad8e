# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws of lubricants against closed forms, quadrature and each other."""

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.interpolate import CubicHermiteSpline

import samcontact as sc

ALPHA, ETA = 22e-9, 0.04
PRESSURES = np.array([0.0, 1e5, 3e7, 4e8, 1.2e9])
TABLE = np.linspace(0, 2e9, 41)
OIL = sc.Lubricant.roelands(ETA, ALPHA)
SQUALANE = {"B": 4.71, "R0": 0.6568, "bulk_modulus": 1.19e9, "modulus_slope": 11.74}
LAWS = {
    "roelands": OIL,
    "roelands z": sc.Lubricant.roelands(ETA, ALPHA, z=0.6),
    "barus": sc.Lubricant.barus(ETA, ALPHA),
    "doolittle": sc.Lubricant.doolittle(0.0157, **SQUALANE),
    "tabulated": sc.Lubricant.tabulated(
        np.linspace(0, 2e9, 41),
        OIL.viscosity(np.linspace(0, 2e9, 41)),
        [900 + k for k in range(41)],
    ),
}


@pytest.mark.parametrize("oil", LAWS.values(), ids=LAWS)
def test_slopes_belong_to_the_values(oil):
    assert oil.viscosity(0.0) == pytest.approx(oil.eta0)
    step = 1e3
    slope = np.log(oil.viscosity(step) / oil.eta0) / step
    assert slope == pytest.approx(oil.pressure_viscosity, rel=1e-3)
    density = (oil.density(PRESSURES + step) - oil.density(PRESSURES)) / step
    # a rounding of the density of 1e-16 is one of 1e-13/Pa of the difference
    assert oil.density_law.slope(PRESSURES) == pytest.approx(density, rel=1e-4, abs=1e-12)


@pytest.mark.parametrize("oil", LAWS.values(), ids=LAWS)
def test_the_reduced_pressure_is_the_integral_of_density_over_viscosity(oil):
    tables = oil.tables(2e9)
    assert tables.pressure[-1] == pytest.approx(2e9)
    curve = CubicHermiteSpline(tables.pressure, tables.reduced, tables.fluidity)
    for p in (2e5, 3e7, 2.3e8):
        exact = quad(lambda q: float(oil.density(q) / oil.viscosity(q)), 0, p, epsrel=1e-12)[0]
        assert curve(p) == pytest.approx(exact, rel=2e-9)


def test_the_reduced_pressure_of_an_exponential_law_saturates():
    oil = sc.Lubricant.barus(ETA, ALPHA, density=None)
    tables = oil.tables(5e9)
    exact = -np.expm1(-ALPHA * tables.pressure) / (ALPHA * ETA)
    assert tables.reduced == pytest.approx(exact, rel=1e-12)


def test_roelands_has_published_values():
    """z = 0.68 of mineral oil belongs to 0.04 Pa s, 22 1/GPa; the pole is at 6.31e-5 Pa s."""
    assert OIL.law.z == pytest.approx(0.675, abs=1e-3)
    at_the_pole = OIL.law.scale + np.log(6.31e-5 / ETA)
    assert at_the_pole == pytest.approx(0.0, abs=1e-3)
    assert LAWS["roelands z"].law.pressure < OIL.law.pressure


def test_a_table_repeats_its_law_and_ends():
    table = LAWS["tabulated"]
    inside = np.linspace(1e8, 1.9e9, 7)
    assert table.viscosity(inside) == pytest.approx(OIL.viscosity(inside), rel=2e-3)
    with pytest.raises(ValueError, match="extend the table"):
        table.viscosity(2.1e9)
    assert table.tables(3e9).reduced[-1] == pytest.approx(table.tables(2e9).reduced[-1], rel=1e-6)


def test_shear_laws_are_newtonian_at_low_rates_and_limited_at_high_rates():
    thin = OIL.with_eyring(5e6)
    slow = 1e-3
    for oil in (thin, OIL.with_carreau(5e6, 0.4), OIL.with_limiting_shear(0.05)):
        assert oil.shear_stress(slow, 1e8) == pytest.approx(OIL.shear_stress(slow, 1e8))
    rate = 1e6
    newton = OIL.viscosity(5e8) * rate
    assert thin.shear_stress(-rate, 5e8) == pytest.approx(-5e6 * np.arcsinh(newton / 5e6))
    carreau = OIL.with_carreau(5e6, 0.4).shear_stress([1e9, 1e10], 5e8)
    assert carreau[1] / carreau[0] == pytest.approx(10**0.4, rel=1e-3)
    limited = thin.with_limiting_shear(0.05).shear_stress([1.0, 1e15], 1e9)
    assert limited[1] == pytest.approx(0.05e9, rel=0.02)
    assert thin.with_limiting_shear(0.05).shear_stress(1e6, 0.0) == 0.0


def test_temperature_lowers_the_viscosity():
    warm = OIL.with_thermal(0.14, 1.7e6, 0.04, temperature=313.15)
    assert warm.viscosity(1e8, 323.15) == pytest.approx(OIL.viscosity(1e8) * np.exp(-0.4))
    with pytest.raises(ValueError, match="with_thermal"):
        OIL.viscosity(1e8, 323.15)
    with pytest.raises(ValueError, match="kelvins"):
        warm.viscosity(1e8, -10.0)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: sc.Lubricant.barus(40.0, ALPHA), "mPa s"),
        (lambda: sc.Lubricant.roelands(ETA, 22.0), "1/GPa"),
        (lambda: OIL.with_limiting_shear(5.0), "not 5 %"),
        (lambda: OIL.with_thermal(0.14, 2000.0, 0.04), "J/"),
    ],
)
def test_likely_unit_errors_are_warned_of(make, words):
    with pytest.warns(sc.UnitWarning, match=words):
        make()


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: sc.Lubricant.roelands(5e-5, ALPHA), "barus"),
        (lambda: sc.Lubricant.roelands(ETA, ALPHA, density="tait"), "Tait"),
        (lambda: sc.Lubricant.tabulated([0, 1e8, 1e8], [1, 2, 3]), "increase from 0"),
        (lambda: sc.Lubricant.tabulated([0, 1e8, 2e8], [1, 2, 1.5]), "not decrease"),
        (lambda: sc.Lubricant.doolittle(ETA, 4.7, 1.2, 1e9, 11.0), "R0 must"),
        (lambda: OIL.viscosity(-1.0), "p must be >= 0"),
        (lambda: OIL.with_carreau(1e6, 2.0), "n must"),
    ],
)
def test_wrong_values_are_refused(make, words):
    with pytest.raises(ValueError, match=words):
        make()
