# SPDX-License-Identifier: GPL-3.0-or-later
"""Influence of a heat source against point sources, frequency responses, and thermoelasticity.

Lengths, ages and speeds are those of `heat_scales`. Tolerances of tables are the requested ones,
relative to the largest value; the oracles are more accurate.
"""

import itertools

import numpy as np
import pytest
from heat_scales import (
    AT_REST,
    HALF,
    INF,
    NU,
    REGIMES,
    X,
    Y,
    displacement,
    error,
    over,
    steady_displacement,
    steady_stress,
    steady_temperature,
    stress,
    temperature,
)
from scipy.special import erfc

from oracles import heat, quadrature

RECTANGLES = ((0.5, 0.5), (0.5, 4.0), (4.0, 0.5), (0.5, 0.35))
# In half-sides: centre, inside, on an edge, on a corner, just off, above an edge line, far on both
# sides of the change to Gauss points at 30 sizes, 1000 cells away.
PLACES = (
    (0.0, 0.0),
    (0.3, -0.6),
    (1.0, 0.3),
    (-1.0, 1.0),
    (1.001, 0.5),
    (1.0, 1.7),
    (-20.0, 21.0),
    (22.0, 21.0),
    (2000.0, -300.0),
)


@pytest.mark.parametrize("half", RECTANGLES)
class TestSteadyAtRest:
    def test_temperature(self, half):
        for (p, q), z in itertools.product(PLACES, (0.0, 0.01, 0.7, 30.0)):
            x, y = p * half[0], q * half[1]
            expected = heat.temperature(x, y, z, *half, INF, AT_REST)
            np.testing.assert_allclose(steady_temperature(x, y, z, half), expected, rtol=1e-11)

    def test_stress(self, half):
        """The point source's Airy function, integrated; in the surface it is sigma = E alpha/(2 pi
        k) times -x^2/r^3, -y^2/r^3, -x y/r^3."""
        for (p, q), z in itertools.product(PLACES, (0.0, 0.01, 0.7, 30.0)):
            x, y = p * half[0], q * half[1]
            height = max(z, quadrature.LIMIT_HEIGHT * min(half))
            u, v, weight = quadrature.points(
                -half[0] - x, half[0] - x, -half[1] - y, half[1] - y, height
            )
            R = np.sqrt(u * u + v * v + height**2)
            cube = 1 / (R * (R + height) ** 2)
            plane = np.array([u * u * cube, v * v * cube, u * v * cube])
            plane[:2] += height / (R * (R + height))
            expected = -plane @ weight * (1 - NU) / (2 * np.pi)
            actual = steady_stress(x, y, z, half)
            # xy vanishes on the axes
            np.testing.assert_allclose(
                actual[[0, 1, 5]], expected, rtol=1e-10, atol=1e-11 * np.abs(expected).max()
            )
            assert not actual[2:5].any()

    def test_displacement(self, half):
        for (p, q), r0 in itertools.product(PLACES, (0.3, 100.0)):
            x, y = p * half[0], q * half[1]
            u, v, weight = quadrature.points(
                -half[0] - x, half[0] - x, -half[1] - y, half[1] - y, 1e-14 * min(half)
            )
            expected = np.log(np.hypot(u, v) / r0) @ weight / (2 * np.pi)
            np.testing.assert_allclose(
                steady_displacement(x, y, half, r0), expected, rtol=1e-10, atol=1e-13
            )

    def test_trace(self, half):
        x, y = np.linspace(-50, 50, 37)[:, None], np.linspace(-50, 50, 41)
        for z in (0.0, 0.3, 8.0):
            trace = steady_stress(x, y, z, half)[:2].sum(axis=0)
            np.testing.assert_allclose(
                trace, -(1 - NU) * steady_temperature(x, y, z, half), rtol=1e-10
            )


def test_steady_stress_against_its_frequency_response():
    points = [(0.0, 0.0), (0.7, 0.3), (-1.2, 0.9)]
    expected = heat.stress(points, 0.8, *HALF, NU, INF, AT_REST)
    x, y = np.transpose(points)
    assert error(steady_stress(x, y, 0.8, HALF), expected) < 1e-9


def test_round_sources():
    """Centre of a uniform disc, q a/k; centre of a semi-ellipsoid of flux, pi q0 a/4 k."""
    n, radius = 240, 20.0
    cell = 2 * radius / n
    at = (np.arange(n) - (n - 1) / 2) * cell
    r2 = at[:, None] ** 2 + at**2
    rise = steady_temperature(at[:, None], at, 0.0, (cell / 2, cell / 2))
    disc = (rise * (r2 < radius**2)).sum()
    # the jump on the rim is resolved to about a cell, in both directions
    assert disc == pytest.approx(radius, rel=1e-3)
    ellipsoid = (rise * np.sqrt(np.maximum(1 - r2 / radius**2, 0.0))).sum()
    assert ellipsoid == pytest.approx(np.pi * radius / 4, rel=2e-4)


@pytest.mark.parametrize(("age", "speed"), REGIMES)
@pytest.mark.parametrize("tol", [1e-3, 1e-6, 1e-9])
class TestTablesAgainstPointSources:
    def test_temperature(self, age, speed, tol):
        for z in (0.0, 0.05, 0.8):
            expected = over(X, Y, lambda x, y, z=z: heat.temperature(x, y, z, *HALF, age, speed))
            assert error(temperature(X, Y, z, HALF, age, speed, tol), expected) < tol

    def test_displacement(self, age, speed, tol):
        expected = over(X[2:5], Y[1:3], lambda x, y: heat.displacement(x, y, *HALF, age, speed))
        actual = displacement(X, Y, HALF, age, speed, tol)
        assert error(actual[2:5, 1:3], expected) < tol


@pytest.mark.parametrize(("age", "speed", "z"), [(*r, 0.8) for r in REGIMES[1:]])
def test_stress_against_frequency_response(age, speed, z):
    points = [(X[i], Y[j]) for i, j in ((3, 1), (4, 2), (1, 1), (5, 3))]
    expected = heat.stress(points, z, *HALF, NU, age, speed)
    for tol in (1e-3, 1e-6, 1e-9):
        table = stress(X, Y, z, HALF, age, speed, tol)
        actual = np.transpose([table[:, i, j] for i, j in ((3, 1), (4, 2), (1, 1), (5, 3))])
        assert error(actual, expected) < tol


# Central differences of eighth order: first and second derivative on nine points.
FIRST = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 0, 4 / 5, -1 / 5, 4 / 105, -1 / 280])
SECOND = np.array([-1 / 560, 8 / 315, -1 / 5, 8 / 5, -205 / 72, 8 / 5, -1 / 5, 8 / 315, -1 / 560])
TENSOR = np.array([[0, 5, 4], [5, 1, 3], [4, 3, 2]])


@pytest.mark.parametrize(("age", "speed"), [REGIMES[n] for n in (1, 3, 4, 5, 7)])
def test_thermoelastic_equations(age, speed):
    """Equilibrium, and Beltrami-Michell compatibility with the temperature: lap sigma_ij +
    s_kk,ij/(1 + nu) + E alpha (T,ij/(1 + nu) + delta_ij lap T/(1 - nu)) = 0. The tolerances are the
    errors of the differences in the thermal layer of the fastest source."""
    step, centre = 0.04, (0.4, -0.3, 0.8)
    x, y, z = (c + step * np.arange(-4, 5) for c in centre)
    s = np.stack([stress(x, y, d, HALF, age, speed, 1e-11) for d in z], axis=-1) / (1 - NU)
    T = np.stack([temperature(x, y, d, HALF, age, speed, 1e-11) for d in z], axis=-1)
    first, second = FIRST / step, SECOND / step**2
    here = np.eye(9)[4]

    def derivative(field, *axes):
        stencils = [here, here, here]
        for axis in set(axes):
            stencils[axis] = second if axes.count(axis) == 2 else first
        return np.einsum("...ijk,i,j,k->...", field, *stencils)

    terms = np.array([derivative(s[TENSOR[n]], n) for n in range(3)])
    assert np.abs(terms.sum(axis=0)).max() < 1e-6 * np.abs(terms).max()

    def laplacian(field):
        return sum(derivative(field, n, n) for n in range(3))

    trace, lap_T = s[:3].sum(axis=0), laplacian(T)
    for i, j in itertools.combinations_with_replacement(range(3), 2):
        parts = [
            laplacian(s[TENSOR[i, j]]),
            derivative(trace, i, j) / (1 + NU),
            derivative(T, i, j) / (1 + NU),
            lap_T / (1 - NU) if i == j else 0.0,
        ]
        assert abs(sum(parts)) < 1e-6 * np.abs(derivative(s, 0, 0)).max()


@pytest.mark.parametrize(("age", "speed"), REGIMES)
def test_the_surface_is_free(age, speed):
    surface = stress(X, Y, 0.0, HALF, age, speed)
    assert not surface[2:5].any()
    # the limit from below; stress has infinite slope at the edges
    close = stress(X, Y, 1e-6, HALF, age, speed)
    assert error(close, surface) < 1e-4


@pytest.mark.parametrize("nu", [0.0, 0.49])
def test_heat_over_a_large_area_is_one_dimensional(nu):
    """Far inside the source and early: T = 2 sqrt(X/pi) ierfc(z/2 sqrt X), sigma_xx = -E alpha
    T/(1 - nu), u_z = -2 X."""
    root = 1e-3
    x = y = np.array([0.1])
    h = 0.7
    expected = 2 * root * (np.exp(-h * h) / np.sqrt(np.pi) - h * erfc(h))
    z = 2 * root * h
    assert temperature(x, y, z, HALF, root**2, AT_REST).item() == pytest.approx(expected, rel=1e-6)
    s = stress(x, y, z, HALF, root**2, AT_REST, nu=nu).ravel()
    # the bulge strains what is around it, by about the heated depth over the size
    np.testing.assert_allclose(s[:2], -expected, rtol=20 * root)
    assert np.abs(s[2:]).max() < 20 * root * expected
    u = displacement(x, y, HALF, root**2, AT_REST).item()
    assert u == pytest.approx(-2 * root**2, rel=20 * root)
