# SPDX-License-Identifier: GPL-3.0-or-later
"""The reference solutions checked by equilibrium, boundary values, decay and known values."""

import itertools

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import erfc, j0

from oracles import eigenstrain, half_space, heat, hertz_stress, quadrature

# Eighth-order central first difference.
STENCIL = ((1, 4 / 5), (2, -1 / 5), (3, 4 / 105), (4, -1 / 280))
TENSOR = np.array([[0, 5, 4], [5, 1, 3], [4, 3, 2]])
CUBOID = (0.5, 0.25, 0.7)


def divergence(stress, point, step=0.01):
    """Divergence (3, ...) of a stress field of shape (6, ...) and the largest derivative in it."""
    total, scale = 0.0, 0.0
    for axis in range(3):
        unit = np.eye(3)[axis] * step
        derivative = sum(
            w * (stress(*(point + k * unit)) - stress(*(point - k * unit))) for k, w in STENCIL
        )
        derivative = derivative / step
        total = total + derivative[TENSOR[axis]]
        scale = max(scale, np.abs(derivative).max())
    return total, scale


@pytest.mark.parametrize(
    "load", [half_space.point_normal_stress, half_space.point_tangential_stress]
)
@pytest.mark.parametrize("nu", [0.0, 0.3])
def test_point_load_is_in_equilibrium(load, nu):
    residual, scale = divergence(lambda x, y, z: load(x, y, z, nu), np.array([0.4, -0.7, 0.9]))
    assert np.abs(residual).max() < 1e-10 * scale


@pytest.mark.parametrize(
    ("load", "displacement"),
    [
        (half_space.point_normal_stress, half_space.point_normal_displacement),
        (half_space.point_tangential_stress, half_space.point_tangential_displacement),
    ],
)
def test_point_load_stress_is_hookes_law_of_its_displacement(load, displacement):
    E, nu, step, point = 2.5, 0.3, 0.01, np.array([0.4, -0.7, 0.9])
    gradient = np.empty((3, 3))
    for axis in range(3):
        unit = np.eye(3)[axis] * step
        gradient[:, axis] = (
            sum(
                w
                * (
                    displacement(*(point + k * unit), nu, E)
                    - displacement(*(point - k * unit), nu, E)
                )
                for k, w in STENCIL
            )
            / step
        )
    mu = E / (2 * (1 + nu))
    expected = mu * (gradient + gradient.T) + 2 * mu * nu / (1 - 2 * nu) * np.trace(
        gradient
    ) * np.eye(3)
    actual = load(*point, nu)[TENSOR]
    assert np.abs(actual - expected).max() < 1e-10 * np.abs(expected).max()


def test_mindlin_force_at_the_surface_is_boussinesq_and_cerruti():
    E, nu, point = 2.5, 0.3, (0.4, -0.7, 0.9)
    mu = E / (2 * (1 + nu))
    G = np.array(eigenstrain.mindlin(*point, 0.0, point[2], nu)) / (16 * np.pi * mu * (1 - nu))
    normal = half_space.point_normal_displacement(*point, nu, E)
    tangential = half_space.point_tangential_displacement(*point, nu, E)
    np.testing.assert_allclose(G[:, 2], normal, rtol=1e-14)
    np.testing.assert_allclose(G[:, 0], tangential, rtol=1e-14)


def test_mindlin_reciprocity():
    """G_km(x, x') = G_mk(x', x)."""
    there = np.array(eigenstrain.mindlin(0.4, -0.7, 0.9, 0.35, 0.55, 0.3))
    back = np.array(eigenstrain.mindlin(-0.4, 0.7, 0.35, 0.9, -0.55, 0.3))
    np.testing.assert_allclose(there, back.T, rtol=1e-13)


def test_rectangle_boundary_values():
    rect, nu = (1.0, 0.4), 0.3
    inside = half_space.stress_pressure(0.3, -0.1, 0.0, rect, nu)
    np.testing.assert_allclose(inside[2:5], [-1.0, 0.0, 0.0], atol=1e-11)
    sheared = half_space.stress_shear_x(0.3, -0.1, 0.0, rect, nu)
    np.testing.assert_allclose(sheared[2:5], [0.0, 0.0, -1.0], atol=1e-11)
    outside = half_space.stress_pressure(1.3, 0.1, 0.0, rect, nu)
    np.testing.assert_allclose(outside[2:5], 0.0, atol=1e-14)


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.49])
@pytest.mark.parametrize("zc", [0.7, 1.1])
def test_eigenstrain_leaves_the_surface_free(nu, zc):
    for X, Y in ((0.1, 0.05), (0.62, 0.3), (-2.0, 0.1)):
        stress = eigenstrain.stress(X, Y, 0.0, zc, *CUBOID, 1.0, nu)
        largest = np.abs(eigenstrain.stress(0.0, 0.0, zc, zc, *CUBOID, 1.0, nu)).max()
        assert np.abs(stress[2:5]).max() < 2e-11 * largest


@pytest.mark.parametrize("point", [(0.1, 0.05, 0.9), (0.9, -0.3, 0.4)], ids=["inside", "outside"])
def test_eigenstrain_stress_is_in_equilibrium(point):
    residual, scale = divergence(
        lambda x, y, z: eigenstrain.stress(x, y, z, 1.1, *CUBOID, 1.0, 0.3), np.array(point)
    )
    assert np.abs(residual).max() < 1e-8 * scale


def test_eigenstrain_far_field_is_a_dipole_of_stress_decay_three():
    near, far = (
        eigenstrain.stress(r, 0.6 * r, 0.8 * r, 1.1, *CUBOID, 1.0, 0.3) for r in (40.0, 80.0)
    )
    assert np.log2(np.abs(near).max() / np.abs(far).max()) == pytest.approx(3.0, abs=0.05)


def test_deep_cube_has_the_dilatation_of_eshelby():
    """Centre of a cube in an infinite body: tr(strain) = (1 + nu)/(3 (1 - nu)) tr(eps)."""
    nu, E = 0.3, 1.0
    stress = eigenstrain.stress(0.0, 0.0, 2e3, 2e3, 1.0, 1.0, 1.0, E, nu)
    trace = stress[:3, :3].sum()
    bulk = E / (3 * (1 - 2 * nu))
    expected = 3 * bulk * 3 * ((1 + nu) / (3 * (1 - nu)) - 1.0)
    assert trace == pytest.approx(expected, rel=1e-8)


def test_quadrature_is_converged(monkeypatch):
    """24 instead of 16 nodes per panel change nothing beyond rounding."""
    cases = [
        (0.3, -0.1, 0.9, 1.1),
        (0.55, 0.2, 0.05, 0.7),
        (0.52, 0.0, 1.0, 1.1),
        (0.1, 0.1, 0.0, 0.7),
    ]
    coarse = [eigenstrain.solve(*case, *CUBOID, 1.0, 0.3) for case in cases]
    nodes, weights = np.polynomial.legendre.leggauss(24)
    monkeypatch.setattr(quadrature, "NODES", nodes)
    monkeypatch.setattr(quadrature, "WEIGHTS", weights)
    for case, (u, stress) in zip(cases, coarse, strict=True):
        u_fine, stress_fine = eigenstrain.solve(*case, *CUBOID, 1.0, 0.3)
        assert np.abs(u - u_fine).max() < 1e-12 * np.abs(u_fine).max()
        assert np.abs(stress - stress_fine).max() < 2e-12 * np.abs(stress_fine).max()


@pytest.mark.parametrize(
    ("friction", "value", "x", "z"),
    [
        (0.0, 0.62004, 0.0, 0.4809),
        (0.1, 0.62444, 0.1116, 0.4749),
        (0.25, 0.64759, 0.2703, 0.4440),
        (0.3, 0.65976, 0.3188, 0.4282),
    ],
)
def test_sliding_sphere_table(friction, value, x, z):
    found = hertz_stress.max_von_mises(friction, 0.3)
    np.testing.assert_allclose(found, (value, x, z), atol=6e-5)


def test_hertz_stress_on_the_axis():
    """Johnson (1985), eq. 3.45."""
    nu, z = 0.3, 0.48
    stress = hertz_stress.stress(0.0, 0.0, z, 0.0, nu)
    radial = -(1 + nu) * (1 - z * np.arctan(1 / z)) + 0.5 / (1 + z * z)
    np.testing.assert_allclose(stress, [radial, radial, -1 / (1 + z * z), 0, 0, 0], atol=1e-12)


@pytest.mark.parametrize("speed", [(0.0, 0.0), (1.5, -2.0)])
@pytest.mark.parametrize("heated", [0.3, 40.0, np.inf])
@pytest.mark.parametrize("point", [(0.4, -0.3, 0.5), (3.0, -4.0, 0.1), (-2.0, 1.0, 0.0)])
def test_point_heat_source_is_the_sum_of_instants(speed, heated, point):
    """Carslaw & Jaeger's instantaneous source, doubled by the surface, integrated over its age."""
    r = np.array(point)

    def instant(log_age):
        age = np.exp(log_age)
        d2 = ((r - age * np.array([*speed, 0.0])) ** 2).sum()
        return age * 2 * np.exp(-d2 / (4 * age)) / (4 * np.pi * age) ** 1.5

    cut = np.linspace(-12, np.log(min(heated, 1e24)), 40)
    expected = sum(quad(instant, u, v, epsabs=1e-15)[0] for u, v in itertools.pairwise(cut))
    actual = heat.point_temperature(*(np.array(c) for c in point), heated, speed)
    assert actual == pytest.approx(expected, rel=1e-10)


@pytest.mark.parametrize("distance", [0.0, 0.7, 3.0])
def test_instantaneous_displacement_has_the_response_of_erfc(distance):
    """-2 erfc(w sqrt x), from P(0) of an instant, inverted by Hankel's integral."""
    age = 0.6
    top = 7 / np.sqrt(age)
    cut = np.linspace(0, top, 20)
    inverse = sum(
        quad(lambda w: -erfc(w * np.sqrt(age)) * j0(w * distance) * w / np.pi, u, v)[0]
        for u, v in itertools.pairwise(cut)
    )
    assert heat.instantaneous_displacement(distance**2, age) == pytest.approx(inverse, rel=1e-11)


def test_displacement_of_heat_is_the_integral_of_instants():
    """The line integral along the edges against quadrature of the area."""
    half, speed, heated = (0.5, 0.35), (1.0, -0.5), 2.0
    x, y = 0.9, 0.1
    # younger heat adds age^(3/2) at this distance from the edge
    logs, weight = quadrature.gauss(np.log(1e-6), np.log(heated), 100)
    u, wu = quadrature.gauss(-half[0], half[0], 40)
    v, wv = quadrature.gauss(-half[1], half[1], 40)
    total = 0.0
    for age, w in zip(np.exp(logs), weight * np.exp(logs), strict=True):
        r2 = (x - speed[0] * age - u[:, None]) ** 2 + (y - speed[1] * age - v) ** 2
        total += w * (wu @ heat.instantaneous_displacement(r2, age) @ wv)
    assert heat.displacement(x, y, *half, heated, speed) == pytest.approx(total, rel=1e-6)


@pytest.mark.parametrize("heated", [0.3, np.inf])
def test_heat_frequency_response_solves_its_equations(heated):
    """P'' - w^2 P = -T, P'(0) = 0, unit flux, and the heat equation dT/dX = T'' - (w^2 - a) T."""
    w1, w2, speed, step = 1.3, -0.8, (2.0, 0.7), 0.02
    w, a = np.hypot(w1, w2), -1j * (w1 * speed[0] + w2 * speed[1])

    def response(z, heated=heated):
        return np.array(heat.frequency_response(w1, w2, z, heated, speed))

    z = 0.5
    first = sum(c * (response(z + k * step) - response(z - k * step)) for k, c in STENCIL) / step
    T, P, P_z, P0 = response(z)
    T_zz = (response(z + 1e-3)[0] - 2 * T + response(z - 1e-3)[0]) / 1e-6
    assert first[1] == pytest.approx(P_z, rel=1e-9)
    assert first[2] == pytest.approx(w * w * P - T, rel=1e-9)
    assert response(0.0)[1] == pytest.approx(P0, rel=1e-12)
    assert abs(response(0.0)[2]) < 1e-13
    assert (response(1e-6)[0] - response(0.0)[0]) / 1e-6 == pytest.approx(-1, abs=1e-5)
    growth = 0.0
    if np.isfinite(heated):
        growth = (response(z, heated + 1e-4)[0] - response(z, heated - 1e-4)[0]) / 2e-4
    assert T_zz - (w * w - a) * T == pytest.approx(growth, rel=1e-5, abs=1e-5)
