# SPDX-License-Identifier: GPL-3.0-or-later
"""Hertz formulas against quadrature of the potential and against independent integrals."""

import dataclasses
import itertools
import math
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import dblquad, quad
from scipy.special import ellipe, ellipkm1

import samcontact as sc
from samcontact import hertz

E_STAR = 115384615384.6154
STEEL = SimpleNamespace(E=210e9, nu=0.3)


def test_steel_balls_known_values():
    contact = hertz.point(R=7.5e-3, E_star=E_STAR, load=1500.0)
    assert contact.p0 == pytest.approx(4095642673.4, rel=1e-10)
    assert contact.a == pytest.approx(418.2e-6, rel=2e-4)
    assert hertz.point(R=7.5e-3, E_star=E_STAR, p0=8.0e9).load == pytest.approx(11178.8, rel=1e-5)


@given(
    R=st.floats(1e-9, 1e3),
    E_star=st.floats(1e3, 1e13),
    load=st.floats(1e-12, 1e9),
)
def test_point_from_load_approach_and_pressure_agree(R, E_star, load):
    first = hertz.point(R, E_star, load=load)
    for other in (
        hertz.point(R, E_star, approach=first.approach),
        hertz.point(R, E_star, p0=first.p0),
    ):
        for field in dataclasses.fields(first):
            assert getattr(other, field.name) == pytest.approx(
                getattr(first, field.name), rel=1e-13, abs=0
            )


@pytest.mark.parametrize(
    ("R", "E_star", "given", "value"),
    [
        (1e299, 1e11, "p0", 1e300),
        (1e-300, 1e11, "p0", 1e-300),
        (1e200, 1e-200, "load", 1e200),
        (1.0, 1e11, "load", 1e-320),
        (1e150, 1e11, "approach", 1e150),  # a is a number, and its cube is none
    ],
)
def test_contacts_with_overflow(R, E_star, given, value):
    message = "must give finite contact dimensions > 0"
    with pytest.raises(ValueError, match=f"{given} {message}"):
        hertz.point(R, E_star, **{given: value})
    with pytest.raises(ValueError, match=f"{given} {message}"):
        hertz.elliptic(R, 2.0 * R, E_star, **{given: value})
    if given != "approach":
        given = "load_per_length" if given == "load" else given
        with pytest.raises(ValueError, match=f"{given} {message}"):
            hertz.line(R, E_star, **{given: value})


def test_point_pressure_integrates_to_the_load_and_is_zero_outside():
    contact = hertz.point(R=2.0, E_star=3.0, load=0.7)
    total, _ = quad(lambda r: 2 * math.pi * r * contact.pressure(r), 0, contact.a, epsabs=1e-12)
    assert total == pytest.approx(0.7, rel=1e-9)
    field = contact.pressure(np.array([0.0, 2 * contact.a])[:, None], np.zeros((1, 3)))
    assert field.shape == (2, 3)
    assert np.all(field[0] == contact.p0)
    assert np.all(field[1] == 0.0)


def _surface_displacement(pressure, a, b, x, E_star):
    """Return u_z at (x, 0) by polar quadrature of the Boussinesq potential around this point."""

    def along(theta):
        # chord of the ellipse from (x, 0) in direction theta
        c, s = math.cos(theta), math.sin(theta)
        A = (c / a) ** 2 + (s / b) ** 2
        B = x * c / a**2
        D = B * B - A * ((x / a) ** 2 - 1.0)
        if D <= 0.0:
            return 0.0
        low, high = (-B - math.sqrt(D)) / A, (-B + math.sqrt(D)) / A
        if high <= 0.0:
            return 0.0
        # p is a semicircle along the chord: sin substitution makes the integrand smooth
        mid, half = 0.5 * (low + high), 0.5 * (high - low)
        start = math.asin(max(-1.0, (max(low, 0.0) - mid) / half))

        def integrand(phi):
            r = mid + half * math.sin(phi)
            return pressure(x + r * c, r * s) * half * math.cos(phi)

        return quad(integrand, start, math.pi / 2, epsrel=1e-11)[0]

    total = 0.0
    edge = math.asin(min(1.0, a / abs(x))) if abs(x) > a else math.pi / 2
    breaks = [-math.pi, -math.pi / 2, 0.0, math.pi / 2, math.pi]
    if abs(x) > a:
        breaks = sorted({*breaks, math.pi - edge, edge - math.pi})
    for start, end in itertools.pairwise(breaks):
        total += quad(along, start, end, epsrel=1e-10, epsabs=0, limit=200)[0]
    return total / (math.pi * E_star)


@pytest.mark.parametrize("s", [0.0, 0.3, 0.9])
def test_point_displacement_closes_the_gap_inside(s):
    contact = hertz.point(R=2.0, E_star=3.0, load=0.7)
    a = contact.a
    u = _surface_displacement(contact.pressure, a, a, s * a, 3.0)
    assert u + (s * a) ** 2 / 4.0 == pytest.approx(contact.approach, rel=1e-8)
    assert contact.gap(s * a) == 0.0


@pytest.mark.parametrize("s", [1.05, 1.6])
def test_point_gap_outside_by_quadrature(s):
    contact = hertz.point(R=2.0, E_star=3.0, load=0.7)
    a = contact.a
    u = _surface_displacement(contact.pressure, a, a, s * a, 3.0)
    expected = (s * a) ** 2 / 4.0 + u - contact.approach
    assert float(contact.gap(s * a)) == pytest.approx(expected, rel=1e-6)


def test_point_axis_stress_against_boussinesq_quadrature():
    # sum of Boussinesq point loads over the disc, sigma_zz and sigma_rr on the axis
    contact, nu = hertz.point(R=2.0, E_star=3.0, p0=1.0), 0.3
    a = contact.a
    for s in (0.1, 0.48, 2.0):
        z = s * a

        def zz(r, z=z):
            return -3.0 * z**3 / (r * r + z * z) ** 2.5 * contact.pressure(r) * r

        def rr(r, z=z):
            # mean of the radial and hoop stress of a point load (Johnson 3.20)
            rho = math.hypot(r, z)
            radial = (1 - 2 * nu) / (rho * (rho + z)) - 3 * z * r * r / rho**5
            hoop = -(1 - 2 * nu) * (1 / (rho * (rho + z)) - z / rho**3)
            return 0.5 * (radial + hoop) * contact.pressure(r) * r

        sigma_rr, sigma_zz = contact.axis_stress(z, nu)
        assert float(sigma_zz) == pytest.approx(quad(zz, 0, a, epsabs=1e-12)[0], rel=1e-8)
        assert float(sigma_rr) == pytest.approx(quad(rr, 0, a, epsabs=1e-12)[0], rel=1e-7)


@pytest.mark.parametrize(
    ("nu", "C", "depth"), [(0.25, 1.55435, None), (0.3, 1.61280, 0.4809), (0.5, 1.87724, None)]
)
def test_point_max_von_mises(nu, C, depth):
    contact = hertz.point(R=1.0, E_star=1.0, p0=2.0)
    stress, z = contact.max_von_mises(nu)
    assert 2.0 / stress == pytest.approx(C, rel=5e-6)
    if depth is not None:
        assert z / contact.a == pytest.approx(depth, abs=1e-4)


def test_axis_stress_at_large_depth_keeps_its_digits():
    # against the series in 1/s^2, where the plain formula has lost most of its digits
    contact = hertz.point(R=1.0, E_star=1.0, p0=1.0)
    for s in (50.0, 999.0, 1001.0, 1e5):
        series = sum(
            (-1) ** (k + 1) * s ** (-2 * k) * (0.5 - 1.3 / (2 * k + 1)) for k in range(1, 9)
        )
        computed = float(contact.axis_stress(s * contact.a, 0.3)[0])
        # the plain form, used up to s = 1e3, keeps eps s^2
        assert computed == pytest.approx(series, rel=1e-9, abs=0)


@pytest.mark.parametrize("friction", [0.0, 0.35])
@pytest.mark.parametrize(("x", "z"), [(0.0, 0.5), (-0.87, 0.5), (1.0, 0.05), (0.3, 0.02), (40, 3)])
def test_line_stress_against_line_forces(x, z, friction):
    contact, nu = hertz.line(R=2.0, E_star=3.0, p0=5.0), 0.3
    b = contact.b

    def sheared(t, component):
        """Flamant's radial stress of the forces at s = b sin t, Johnson (2.18) and (2.22)."""
        distance, depth = x * b - b * math.sin(t), z * b
        force = 5.0 * math.cos(t) * b * math.cos(t)
        radial = (
            -2.0 * force * (depth + friction * distance) / math.pi / math.hypot(distance, depth)
        )
        direction = np.array([distance, depth]) / math.hypot(distance, depth)
        one, other = {"xx": (0, 0), "zz": (1, 1), "xz": (0, 1)}[component]
        return radial * direction[one] * direction[other] / math.hypot(distance, depth)

    near = [math.asin(min(max(x, -1.0), 1.0))]
    stress = contact.stress(x * b, z * b, nu, friction)
    for component, index in (("xx", 0), ("zz", 2), ("xz", 4)):
        expected = quad(
            sheared, -0.5 * math.pi, 0.5 * math.pi, component, epsabs=1e-13, points=near, limit=200
        )[0]
        assert stress[index] == pytest.approx(expected, rel=1e-9, abs=1e-12), component
    assert stress[1] == pytest.approx(nu * (stress[0] + stress[2]), rel=1e-14)
    assert not stress[[3, 5]].any()


def test_line_stress_at_the_surface_and_below_the_middle():
    contact = hertz.line(R=2.0, E_star=3.0, p0=5.0)
    b = contact.b
    x = np.array([-3.0, -1.0, -0.4, 0.0, 0.9, 1.0, 1.5]) * b
    stress = contact.stress(x, 0.0, 0.3, 0.2)
    np.testing.assert_allclose(stress[2], -contact.pressure(x), atol=1e-15)
    np.testing.assert_allclose(stress[4], -0.2 * contact.pressure(x), atol=1e-15)
    z = np.array([0.0, 1e-3, 0.5, 2.0, 1e4]) * b
    for computed, expected in zip(
        contact.stress(0.0, z, 0.3)[:3], contact.axis_stress(z, 0.3), strict=True
    ):
        np.testing.assert_allclose(computed, expected, rtol=1e-12, atol=1e-16)


@pytest.mark.parametrize(("ratio", "k"), [(2, 1.585802), (5, 2.890181), (10, 4.499447)])
def test_elliptic_axis_ratio(ratio, k):
    assert hertz.elliptic(1.0, ratio, 1.0, load=1.0).k == pytest.approx(k, abs=6e-7)
    assert hertz.elliptic(ratio, 1.0, 1.0, load=1.0).k == pytest.approx(1 / k, rel=1e-6)


@given(ratio=st.floats(1.0 + 1e-3, 1e6))
def test_elliptic_axis_ratio_solves_the_classical_equation(ratio):
    k = hertz.elliptic(1.0, ratio, 1.0, load=1.0).k
    m = 1.0 - k**-2
    K, E = ellipkm1(k**-2), ellipe(m)
    # K - E loses digits like eps / m near the circle
    assert (E * k**2 - K) / (K - E) == pytest.approx(ratio, rel=1e-12 / m)


def test_elliptic_contact_tends_to_point_contact():
    sphere = hertz.point(1e-2, E_STAR, load=10.0)
    for ratio in (1.0, 1.0 + 3e-16, 1.0 + 1e-12, 1.0 + 1e-7):
        contact = hertz.elliptic(1e-2, 1e-2 * ratio, E_STAR, load=10.0)
        tolerance = 1e-13 + ratio - 1.0
        assert contact.a_x == pytest.approx(sphere.a, rel=tolerance, abs=0)
        assert contact.a_y == pytest.approx(sphere.a, rel=tolerance, abs=0)
        assert contact.p0 == pytest.approx(sphere.p0, rel=tolerance, abs=0)
        assert contact.approach == pytest.approx(sphere.approach, rel=tolerance, abs=0)
        # near the circle k ~ (Ry/Rx)^(2/3)
        assert contact.k - 1.0 == pytest.approx(2.0 / 3.0 * (ratio - 1.0), rel=1e-3, abs=1e-15)


@pytest.mark.parametrize(("Rx", "Ry"), [(1.0, 5.0), (5.0, 1.0), (1.0, 1.3)])
def test_elliptic_displacement_closes_the_gap(Rx, Ry):
    contact = hertz.elliptic(Rx, Ry, 3.0, load=0.7)
    for s in (0.0, 0.6):
        x = s * contact.a_x
        u = _surface_displacement(contact.pressure, contact.a_x, contact.a_y, x, 3.0)
        assert u + x * x / (2 * Rx) == pytest.approx(contact.approach, rel=1e-7)

        def rotated(y, x, contact=contact):
            return contact.pressure(x, y)

        y = s * contact.a_y
        u = _surface_displacement(rotated, contact.a_y, contact.a_x, y, 3.0)
        assert u + y * y / (2 * Ry) == pytest.approx(contact.approach, rel=1e-7)


def test_elliptic_pressure_integrates_to_the_load():
    contact = hertz.elliptic(1.0, 5.0, 3.0, load=0.7)
    total, _ = dblquad(
        lambda t, r: (
            contact.pressure(contact.a_x * r * math.cos(t), contact.a_y * r * math.sin(t))
            * contact.a_x
            * contact.a_y
            * r
        ),
        0.0,
        1.0,
        0.0,
        2 * math.pi,
    )
    assert total == pytest.approx(0.7, rel=1e-7)


@given(
    Rx=st.floats(1e-6, 1e2),
    ratio=st.floats(1e-4, 1e4),
    load=st.floats(1e-6, 1e6),
)
def test_elliptic_from_load_approach_and_pressure_agree(Rx, ratio, load):
    first = hertz.elliptic(Rx, Rx * ratio, E_STAR, load=load)
    for other in (
        hertz.elliptic(Rx, Rx * ratio, E_STAR, approach=first.approach),
        hertz.elliptic(Rx, Rx * ratio, E_STAR, p0=first.p0),
    ):
        for field in dataclasses.fields(first):
            assert getattr(other, field.name) == pytest.approx(
                getattr(first, field.name), rel=1e-12, abs=0
            )


def test_line_load_and_known_values():
    contact = hertz.line(R=7.5e-3, E_star=E_STAR, load_per_length=1e6)
    total, _ = quad(contact.pressure, -contact.b, contact.b, epsabs=1e-3)
    assert total == pytest.approx(1e6, rel=1e-7)
    again = hertz.line(R=7.5e-3, E_star=E_STAR, p0=contact.p0)
    assert again.load_per_length == pytest.approx(1e6, rel=1e-13)
    assert again.b == pytest.approx(contact.b, rel=1e-13)
    # slope of the displacement of a line pressure closes the parabola: u'(x) = -x/R
    x = 0.4 * contact.b
    slope = (
        -2
        / (math.pi * E_STAR)
        * quad(contact.pressure, -contact.b, contact.b, weight="cauchy", wvar=x)[0]
    )
    assert abs(slope) == pytest.approx(x / 7.5e-3, rel=1e-7)


def test_line_axis_stress():
    contact = hertz.line(R=1.0, E_star=1.0, p0=2.0)
    stress, depth = contact.max_von_mises(0.3)
    assert 2.0 / stress == pytest.approx(1.79367, rel=5e-6)
    assert depth / contact.b == pytest.approx(0.7043, abs=1e-4)
    sxx, syy, szz = contact.axis_stress([0.0, contact.b], 0.3)
    s = 1.0  # Johnson (4.46) as printed, at z = b
    printed = -((1 + 2 * s * s) / math.sqrt(1 + s * s) - 2 * s) * 2.0
    assert sxx[1] == pytest.approx(printed, rel=1e-13)
    assert (sxx[0], szz[0]) == (-2.0, -2.0)
    np.testing.assert_allclose(syy, 0.3 * (sxx + szz), rtol=1e-15)


def test_effective_modulus():
    rigid = SimpleNamespace(E=math.inf, nu=0.0)
    assert hertz.effective_modulus(STEEL, STEEL) == pytest.approx(E_STAR, rel=1e-14)
    assert hertz.effective_modulus(rigid, STEEL) == pytest.approx(210e9 / 0.91, rel=1e-14)
    with pytest.raises(ValueError, match="both rigid"):
        hertz.effective_modulus(rigid, rigid)
    with pytest.raises(ValueError, match=r"body2\.E must be a number > 0 .*got -1\.0"):
        hertz.effective_modulus(STEEL, SimpleNamespace(E=-1.0, nu=0.3))
    steel = sc.Material.elastic(210e9, 0.3)
    oxide = sc.Inclusion.sphere((0.0, 0.0, 3e-4), 1e-4, sc.Material.elastic(390e9, 0.25))
    with pytest.raises(TypeError, match=r"body2 must be homogeneous, got .* use its matrix"):
        hertz.effective_modulus(STEEL, sc.Heterogeneous(steel, [oxide]))


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: hertz.point(1.0, 1.0, load=-1.0), "load must be a finite number > 0, got -1.0"),
        (lambda: hertz.point(1.0, 1.0, load=math.nan), "load must be a finite number > 0, got nan"),
        (lambda: hertz.point(0.0, 1.0, load=1.0), "R must be a finite number > 0, got 0.0"),
        (lambda: hertz.point(1.0, math.inf, p0=1.0), "E_star must be a finite number > 0, got inf"),
        (
            lambda: hertz.point(1.0, 1.0),
            "exactly one of load, approach, p0 must be given, got none",
        ),
        (lambda: hertz.point(1.0, 1.0, load=1.0, p0=1.0), "exactly one .* got load, p0"),
        (lambda: hertz.elliptic(1.0, math.inf, 1.0, load=1.0), "Ry must be a finite number > 0"),
        (
            lambda: hertz.line(1.0, 1.0),
            "exactly one of load_per_length, p0 must be given, got none",
        ),
        (
            lambda: hertz.point(1.0, 1.0, p0=1.0).max_von_mises(0.6),
            r"nu must be in \[0, 0\.5\], got 0\.6",
        ),
        (lambda: hertz.point(1.0, 1.0, p0=1.0).axis_stress(-1.0, 0.3), "z must be finite and >= 0"),
        (lambda: hertz.point(1.0, 1.0, p0=1.0).pressure(math.nan), "x must be finite everywhere"),
        (lambda: hertz.point(1.0, 1.0, p0=1.0).gap(0.0, math.inf), "y must be finite everywhere"),
        (lambda: hertz.line(1.0, 1.0, p0=1.0).pressure([math.nan]), "x must be finite everywhere"),
        (
            lambda: hertz.elliptic(1.0, 2.0, 1.0, p0=1.0).pressure(0.0, [0.0, math.nan]),
            r"y must be finite everywhere, got nan at index \(1,\)",
        ),
    ],
)
def test_bad_input_is_named(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_wrong_types_are_named():
    with pytest.raises(TypeError, match="load must be a number, got '3'"):
        hertz.point(1.0, 1.0, load="3")
    with pytest.raises(TypeError, match="R must be a number, got True"):
        hertz.point(True, 1.0, load=1.0)
