# SPDX-License-Identifier: GPL-3.0-or-later
"""Critical values against published numbers and against Hertz contact at the onset of yield."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

from samcontact import critical, hertz

E_STAR = 111.40819964e9
TUGGING = {"R": 0.5, "E_star": E_STAR, "nu": 0.32, "yield_stress": 0.9115e9}


def test_green_published_values():
    values = critical.green(**TUGGING)
    assert values.interference == pytest.approx(2.2143e-4, rel=2e-5)
    assert values.load == pytest.approx(346092.8, rel=1e-6)
    assert values.energy == pytest.approx(30.654, rel=2e-5)
    assert pytest.approx(1.30075 + 0.87825 * 0.32 + 0.54373 * 0.32**2, rel=1e-15) == values.C


@pytest.mark.parametrize(
    "model", [critical.green, critical.onset, critical.kogut_etsion, critical.jackson_green]
)
def test_sphere_is_a_hertz_contact_with_its_energy(model):
    values = model(**TUGGING)
    contact = hertz.point(0.5, E_STAR, p0=values.p0)
    assert values.p0 == pytest.approx(values.C * 0.9115e9, rel=1e-14)
    assert values.interference == pytest.approx(contact.approach, rel=1e-13)
    assert values.load == pytest.approx(contact.load, rel=1e-13)
    assert values.a == pytest.approx(contact.a, rel=1e-13)
    energy, _ = quad(
        lambda w: hertz.point(0.5, E_STAR, approach=w).load, 0.0, values.interference, epsrel=1e-10
    )
    assert values.energy == pytest.approx(energy, rel=1e-8)


@pytest.mark.parametrize(
    ("nu", "C"), [(0.25, 1.55435), (0.3, 1.61280), (0.32, 1.63697), (0.5, 1.87724)]
)
def test_onset_exact_C(nu, C):
    assert pytest.approx(C, rel=5e-6) == critical.onset(1.0, 1.0, nu, 1.0).C


@given(nu=st.floats(0.0, 0.5))
def test_fits_stay_within_their_stated_error(nu):
    arguments = {"R": 1.0, "E_star": 1.0, "nu": nu, "yield_stress": 1.0}
    exact = critical.onset(**arguments).C
    for fit in (critical.green, critical.jackson_green):
        assert pytest.approx(exact, rel=4e-3) == fit(**arguments).C
    exact = critical.onset_cylinder(**arguments).C
    assert pytest.approx(exact, rel=1.3e-3) == critical.green_cylinder(**arguments).C


def test_cylinder_is_a_line_contact():
    values = critical.onset_cylinder(1.0, E_STAR, 0.3, 1e9)
    assert pytest.approx(1.79367, rel=5e-6) == values.C
    contact = hertz.line(1.0, E_STAR, p0=values.p0)
    assert values.load_per_length == pytest.approx(contact.load_per_length, rel=1e-13)
    assert values.b == pytest.approx(contact.b, rel=1e-13)
    # below nu = 0.1938 the surface yields first, in plane strain at p0 (1 - 2 nu)
    assert pytest.approx(1.25, rel=1e-12) == critical.onset_cylinder(1.0, 1.0, 0.1, 1.0).C


def test_kogut_etsion_interference():
    K, H = 0.454 + 0.41 * 0.32, 2.8 * 0.9115e9
    expected = (3.141592653589793 * K * H / (2 * E_STAR)) ** 2 * 0.5
    assert critical.kogut_etsion(**TUGGING).interference == pytest.approx(expected, rel=1e-13)
    harder = critical.kogut_etsion(**TUGGING, hardness=2 * H)
    assert harder.interference == pytest.approx(4 * expected, rel=1e-13)


@pytest.mark.parametrize(
    "model",
    [
        critical.green,
        critical.onset,
        critical.jackson_green,
        critical.green_cylinder,
        critical.onset_cylinder,
    ],
)
@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"nu": 0.51}, r"nu must be in \[0, 0\.5\], got 0\.51"),
        ({"yield_stress": 0.0}, "yield_stress must be a finite number > 0, got 0.0"),
        ({"R": -1.0}, "R must be a finite number > 0, got -1.0"),
        ({"E_star": float("nan")}, "E_star must be a finite number > 0, got nan"),
    ],
)
def test_bad_input_is_named(model, changed, message):
    with pytest.raises(ValueError, match=message):
        model(**{**TUGGING, **changed})
