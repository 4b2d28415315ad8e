# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress on the axis of elliptic contacts against quadrature, its limits, and Johnson's table."""

import math

import numpy as np
import pytest

import samcontact as sc
from samcontact import hertz
from samcontact.hertz.axis import elliptic_axis
from samcontact.results.against_hertz import hertz_rows


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.5])
@pytest.mark.parametrize(("Rx", "Ry"), [(1.0, 5.0), (5.0, 1.0), (1.0, 1.3), (1.0, 1000.0)])
def test_elliptic_axis_stress_against_boussinesq_quadrature(Rx, Ry, nu):
    """Sum of point loads p dA in polar coordinates."""
    contact = hertz.elliptic(Rx, Ry, 3.0, p0=1.0)
    z = np.array([0.05, 0.48, 2.0, 30.0]) * min(contact.a_x, contact.a_y)
    t, weight = np.polynomial.legendre.leggauss(200)
    theta = 0.25 * math.pi * (t + 1)  # a quarter of the ellipse
    c, s = np.cos(theta)[:, None], np.sin(theta)[:, None]
    edge = 1.0 / np.hypot(c / contact.a_x, s / contact.a_y)
    stresses = []
    for depth in z:
        reach = np.arcsinh(edge / depth)  # more points near the axis
        u = 0.5 * (t + 1) * reach
        r = depth * np.sinh(u)
        measure = r * depth * np.cosh(u) * 0.5 * reach * weight * weight[:, None]
        measure = measure * 0.25 * math.pi * 4 * np.sqrt(np.maximum(1 - (r / edge) ** 2, 0))
        rho = np.hypot(r, depth)
        # Johnson (3.19): a point load P = 1, without what is odd in x and y
        own = (1 - 2 * nu) / r**2 * (1 - depth / rho)
        odd = own * (2 * c**2 - 1) + (1 - 2 * nu) * depth * s**2 / rho**3
        even = own * (2 * s**2 - 1) + (1 - 2 * nu) * depth * c**2 / rho**3
        parts = (
            odd - 3 * depth * (r * c) ** 2 / rho**5,
            even - 3 * depth * (r * s) ** 2 / rho**5,
            -3 * depth**3 / rho**5,
        )
        stresses.append([np.sum(part * measure) / (2 * math.pi) for part in parts])
    found = np.array(contact.axis_stress(z, nu)).T
    np.testing.assert_allclose(found, stresses, rtol=1e-5, atol=1e-7)


def test_elliptic_axis_stress_between_circle_and_line():
    depths = np.array([0.0, 1e-9, 1e-3, 0.3, 1.0, 5.0])
    circle, ellipse = (f(p0=2.0) for f in (
        lambda p0: hertz.point(1.0, 3.0, p0=p0), lambda p0: hertz.elliptic(1.0, 1.0, 3.0, p0=p0)
    ))  # fmt: skip
    radial, axial = circle.axis_stress(depths * circle.a, 0.3)
    found = ellipse.axis_stress(depths * circle.a, 0.3)
    np.testing.assert_allclose(found, [radial, radial, axial], rtol=1e-13)
    assert ellipse.max_von_mises(0.3)[0] == pytest.approx(circle.max_von_mises(0.3)[0], rel=1e-13)
    line = hertz.line(1.0, 3.0, p0=2.0)
    expected = line.axis_stress(depths * line.b, 0.3)
    for ellipse in (hertz.elliptic(1.0, 1e40, 3.0, p0=2.0), hertz.elliptic(1e40, 1.0, 3.0, p0=2.0)):
        xx, yy, zz = ellipse.axis_stress(depths * line.b, 0.3)
        across, along = (xx, yy) if ellipse.k > 1.0 else (yy, xx)
        np.testing.assert_allclose((across, along, zz), expected, rtol=1e-12)
        stress, depth = ellipse.max_von_mises(0.3)
        assert stress == pytest.approx(line.max_von_mises(0.3)[0], rel=1e-12)
        assert depth == pytest.approx(line.max_von_mises(0.3)[1], rel=1e-6)


@pytest.mark.parametrize(
    ("ratio", "shear"), [(0.2, 0.322), (0.4, 0.325), (0.6, 0.323), (0.8, 0.317), (1.0, 0.310)]
)
def test_elliptic_largest_shear_stress(ratio, shear):
    """Johnson (1985), table 4.1, nu = 0.3, to its digits."""
    normal = np.array(elliptic_axis(np.linspace(0.4, 0.9, 2001), 1.0 / ratio, 0.3))
    assert 0.5 * np.ptp(normal, axis=0).max() == pytest.approx(shear, abs=1e-3)


def test_an_elliptic_contact_is_compared_with_its_von_mises_stress():
    """Maximum over cells of a twelfth of the shorter semi-axis, which miss the true one."""
    ball = sc.Material.elastic(210e9, 0.3)
    contact = hertz.elliptic(5e-3, 15e-3, hertz.effective_modulus(ball, ball), load=20.0)
    step = min(contact.a_x, contact.a_y) / 12
    grid = sc.Grid(41, 81, step, step, nz=20, dz=step)
    gap = sc.surfaces.paraboloid(grid, 5e-3, 15e-3)
    simulation = sc.Simulation(grid, ball, ball, gap)
    dataset = sc.results.to_dataset(simulation, simulation.run([{"load": 20.0}], progress=False))
    rows = {quantity.heading: (exact, here) for quantity, exact, here in hertz_rows(
        dataset, 0, contact, 2)}  # fmt: skip
    exact, here = rows["maximum von Mises stress"]
    assert exact == pytest.approx(contact.max_von_mises(0.3)[0])
    assert here == pytest.approx(exact, rel=0.01)
