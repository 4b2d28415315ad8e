# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress of a sliding Hertz contact against quadrature and closed forms; its onset of yield."""

import math
import pickle

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from oracles import hertz_stress
from samcontact import critical, hertz

UNIT = hertz.point(R=1.0, E_star=0.5 * math.pi, p0=1.0)  # a = 1, p0 = 1


def stress(x, y, z, nu=0.3, friction=0.0):
    return UNIT.stress(x, y, z, nu, friction)


def test_the_six_components_at_a_point():
    expected = [-0.135567, -0.121154, -0.617411, -0.124951, -0.133259, -0.027136]
    np.testing.assert_allclose(stress(0.3, 0.4, 0.6, friction=0.25), expected, atol=5e-7)


@settings(max_examples=60, deadline=None)
@given(
    x=st.floats(-2.0, 2.0),
    y=st.floats(-2.0, 2.0),
    z=st.floats(0.1, 3.0),
    nu=st.floats(0.0, 0.5),
    friction=st.sampled_from([0.0, 0.3, 1.0]),
)
def test_against_quadrature_of_point_loads(x, y, z, nu, friction):
    expected = hertz_stress.stress(x, y, z, friction, nu)
    np.testing.assert_allclose(stress(x, y, z, nu, friction), expected, atol=2e-14)


# the stress is linear in nu
@pytest.mark.parametrize("nu", [0.0, pytest.param(0.3, marks=pytest.mark.slow), 0.5])
def test_close_to_the_surface(nu):
    for x, y in ((0.4, -0.3), (-0.999, 0.0), (0.8, 0.6), (1.3, 0.2)):
        expected = hertz_stress.stress(x, y, 0.05, 0.4, nu)
        np.testing.assert_allclose(stress(x, y, 0.05, nu, 0.4), expected, atol=1e-12)


def test_the_axis_is_that_of_johnson():
    z = np.linspace(0.0, 5.0, 41)
    radial, axial = UNIT.axis_stress(z, 0.3)
    found = stress(0.0, 0.0, z)
    np.testing.assert_allclose(found[0], radial, atol=2e-15)
    np.testing.assert_allclose(found[1], radial, atol=2e-15)
    np.testing.assert_allclose(found[2], axial, atol=2e-15)
    assert not found[3:].any()


def test_surface_tractions_and_units():
    contact = hertz.point(R=10e-3, E_star=115e9, load=800.0)
    x, y = np.meshgrid(np.linspace(-1.5, 1.5, 31), np.linspace(-1.5, 1.5, 31))
    x, y = contact.a * x, contact.a * y
    pressure = contact.pressure(x, y)
    found = contact.stress(x, y, 0.0, 0.3, 0.25)
    assert found.shape == (6, *x.shape)
    for component, expected in ((2, -pressure), (3, 0.0 * pressure), (4, -0.25 * pressure)):
        np.testing.assert_allclose(found[component], expected, atol=2e-15 * contact.p0)


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.5])
def test_the_trailing_edge(nu):
    for friction in (0.0, 0.25, 1.0):
        expected = (1.0 - 2.0 * nu) / 3.0 + math.pi * friction * (4.0 + nu) / 8.0
        assert stress(-1.0, 0.0, 0.0, nu, friction)[0] == pytest.approx(expected, abs=2e-15)
        assert stress(-1.0, 0.0, 1e-12, nu, friction)[0] == pytest.approx(expected, abs=1e-5)


def test_far_away_it_is_that_of_a_point_load():
    # the deviation falls like 1/r^2, and rounding grows like r
    from oracles import half_space

    x, y, z = 60.0, -30.0, 50.0
    force = 2.0 * math.pi / 3.0
    expected = half_space.point_normal_stress(x, y, z, 0.3)
    expected = force * (expected + 0.4 * half_space.point_tangential_stress(x, y, z, 0.3))
    np.testing.assert_allclose(stress(x, y, z, 0.3, 0.4), expected, atol=1e-3 * expected.max())


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((0.0, 0.0, -1.0, 0.3), "z must be finite and >= 0"),
        ((math.nan, 0.0, 1.0, 0.3), "x must be finite everywhere"),
        ((0.0, 0.0, 1.0, 0.6), r"nu must be in \[0, 0\.5\], got 0\.6"),
        ((0.0, 0.0, 1.0, 0.3, -0.1), "friction must be a finite number >= 0, got -0.1"),
    ],
)
def test_bad_points_are_named(arguments, message):
    with pytest.raises(ValueError, match=message):
        UNIT.stress(*arguments)


def onset(friction, nu=0.3):
    return critical.onset_sliding(1.0, 1.0, nu, 1.0, friction)


@pytest.mark.parametrize(
    ("friction", "largest", "x", "z"),
    [
        (0.0, 0.62004, 0.0, 0.4809),
        (0.1, 0.62444, 0.1116, 0.4749),
        (0.2, 0.63766, 0.2192, 0.4571),
        (0.25, 0.64759, 0.2703, 0.4440),
        (0.3, 0.65976, 0.3188, 0.4282),
    ],
)
def test_onset_below_the_surface(friction, largest, x, z):
    found = onset(friction)
    assert pytest.approx(largest, abs=5.1e-6) == 1.0 / found.C
    assert (found.x / found.a, found.z / found.a) == pytest.approx((x, z), abs=5.1e-5)


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.5])
def test_without_friction_it_is_the_onset_of_a_sphere(nu):
    at_rest, sliding = critical.onset(1.0, 1.0, nu, 1.0), onset(0.0, nu)
    for name in ("interference", "load", "energy", "C", "p0", "a"):
        assert getattr(sliding, name) == getattr(at_rest, name)
    assert sliding.x == 0.0
    nearly = onset(1e-6, nu)
    assert pytest.approx(at_rest.C, rel=1e-11) == nearly.C
    assert nearly.z / nearly.a == pytest.approx(hertz.point(1, 1, p0=1).max_von_mises(nu)[1]
                                                / hertz.point(1, 1, p0=1).a, rel=1e-5)  # fmt: skip


def test_the_surface_yields_first_from_a_friction_of_0_304():
    assert onset(0.304).z > 0.4 * onset(0.304).a
    for friction in (0.305, 0.4, 0.5):
        found = onset(friction)
        assert (found.x, found.z) == (-found.a, 0.0)
        edge = stress(-1.0, 0.0, 0.0, 0.3, friction)
        assert pytest.approx(hertz_stress.von_mises(edge), rel=1e-15) == 1.0 / found.C
    # far beyond, the first yield moves from the edge towards the centre
    assert onset(1.0).x / onset(1.0).a == pytest.approx(-0.3097, abs=1e-4)
    # incompressible: only the shear is left at the surface
    assert pytest.approx(1.0 / (math.sqrt(3.0) * 0.5), rel=1e-12) == onset(0.5, 0.5).C


@pytest.mark.parametrize("nu", [0.0, 0.15, 0.3, 0.45, 0.5])
def test_nothing_in_the_half_space_exceeds_the_onset(nu):
    x = np.append(-np.cos(np.linspace(0.0, np.pi, 41)), (-1.1, 1.1))[:, None, None]
    y = np.linspace(0.0, 1.2, 25)[:, None]
    z = np.append(0.0, np.geomspace(1e-3, 1.5, 40))
    previous = math.inf
    for friction in (0.05, 0.2, 0.28, 0.33, 0.45, 0.7, 2.0):
        C = onset(friction, nu).C
        largest = float(hertz_stress.von_mises(stress(x, y, z, nu, friction)).max())
        assert 0.97 < largest * C < 1.0 + 1e-12
        assert previous > C
        previous = C


def test_onset_is_a_hertz_contact():
    found = critical.onset_sliding(10e-3, 115e9, 0.3, 1731e6, 0.4)
    contact = hertz.point(10e-3, 115e9, p0=found.p0)
    assert found.load == pytest.approx(contact.load, rel=1e-13)
    assert found.a == pytest.approx(contact.a, rel=1e-13)
    assert found.interference == pytest.approx(contact.approach, rel=1e-13)
    reached = hertz_stress.von_mises(contact.stress(found.x, 0.0, found.z, 0.3, 0.4))
    assert reached == pytest.approx(1731e6, rel=1e-12)
    assert pickle.loads(pickle.dumps(found)) == found
    with pytest.raises(ValueError, match="friction must be a finite number >= 0"):
        critical.onset_sliding(1.0, 1.0, 0.3, 1.0, -0.1)
