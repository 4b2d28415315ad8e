# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed forms of spheres, and the stress of the matrix at interfaces."""

import numpy as np
import pytest

import samcontact as sc
from samcontact.inclusions.tensors import as_matrix, fibonacci_directions

STEEL = sc.Material.elastic(210e9, 0.3)
ALUMINA = sc.Material.elastic(390e9, 0.25)
SULPHIDE = sc.Material.elastic(60e9, 0.35)
STRESS = np.array([1.0, -2.0, 3.0, 0.4, -0.7, 0.2]) * 1e8
NORMAL = fibonacci_directions(60)
MATERIALS = [ALUMINA, SULPHIDE, None]


def sphere(material, misfit=0.0, stress=STRESS):
    return sc.inclusions.eshelby_sphere(STEEL, material, stress, misfit, radius=2e-5)


def divergence(stress, points, step):
    """Divergence of a stress by central differences of fourth order."""
    total = 0.0
    for axis in range(3):
        at = [points.copy() for _ in range(4)]
        for place, factor in zip(at, (1, -1, 2, -2), strict=True):
            place[axis] += factor * step
        near, far = (as_matrix(stress(*at[n]) - stress(*at[n + 1])) for n in (0, 2))
        total = total + (8 * near - far)[:, axis] / (12 * step)
    return total


@pytest.mark.parametrize(("ratio", "nu"), [(2.0, 0.3), (0.3, 0.3), (1.86, 0.25), (10.0, 0.3)])
def test_uniaxial_tension_agrees_with_eshelby(ratio, nu):
    """Interior stress of a sphere under uniaxial tension from Eshelby's coefficients alpha, beta.

    The total strain is e + S x; the sphere has the stress C1 (e + S x).
    """
    matrix, inner = sc.Material.elastic(1.0, 0.3), sc.Material.elastic(ratio, nu)
    found = sc.inclusions.eshelby_sphere(matrix, inner, [0, 0, 1.0, 0, 0, 0])
    alpha, beta = (1 + 0.3) / (3 * 0.7), 2 * (4 - 5 * 0.3) / (15 * 0.7)
    bulk, shear = ratio * 0.4 / (1 - 2 * nu), ratio * 1.3 / (1 + nu)
    mean = bulk / (1 + alpha * (bulk - 1)) / 3
    axial = shear / (1 + beta * (shear - 1)) * 2 / 3
    assert found.interior_stress[2] == pytest.approx(mean + axial, rel=1e-12)
    assert found.interior_stress[0] == pytest.approx(mean - axial / 2, rel=1e-12)


@pytest.mark.parametrize("nu", [0.0, 0.25, 0.3, 0.45])
def test_a_void_has_the_concentration_of_goodier(nu):
    matrix = sc.Material.elastic(1.0, nu)
    void = sc.inclusions.eshelby_sphere(matrix, None, [0, 0, 1.0, 0, 0, 0])
    assert np.abs(void.interior_stress).max() < 1e-14
    at = void.stress(1.0, 0.0, 0.0)[2]
    assert at == pytest.approx((27 - 15 * nu) / (2 * (7 - 5 * nu)), rel=1e-12)


@pytest.mark.parametrize("material", MATERIALS)
@pytest.mark.parametrize("misfit", [0.0, [1e-3, 0, -2e-3, 3e-4, 0, 0]])
def test_tractions_are_continuous_and_stresses_in_equilibrium(material, misfit):
    if material is None and misfit:
        misfit = 0.0
    found = sphere(material, misfit)
    jump = found.stress(*(2e-5 * NORMAL)) - found.interior_stress[:, None]
    traction = np.einsum("ij...,j...->i...", as_matrix(jump), NORMAL)
    assert np.abs(traction).max() < 1e-12 * np.abs(jump).max()
    rest = divergence(found.stress, 3.1e-5 * NORMAL, 2e-7)
    assert np.abs(rest).max() * 2e-5 < 2e-7 * np.abs(STRESS).max()
    far = found.stress(*(NORMAL * 1.0))
    np.testing.assert_allclose(far, np.broadcast_to(STRESS[:, None], far.shape), rtol=1e-9, atol=1)


@pytest.mark.parametrize("material", MATERIALS)
def test_the_interface_operator_gives_the_stress_of_the_matrix(material):
    found = sphere(material)
    outside = sc.inclusions.interface_stress(
        found.interior_stress, found.eigenstrain, NORMAL, STEEL
    )
    expected = found.stress(*(2e-5 * NORMAL))
    np.testing.assert_allclose(outside, expected, atol=1e-11 * np.abs(expected).max())
    assert found.concentration > 1.0


def test_equal_constants_disturb_nothing_and_a_misfit_is_that_of_a_hot_sphere():
    same = sphere(STEEL)
    np.testing.assert_array_equal(same.eigenstrain, 0.0)
    hot = sphere(STEEL, misfit=1e-3, stress=np.zeros(6))
    pressure = 2 * 210e9 * 1e-3 / (3 * 0.7)  # Timoshenko and Goodier, section 138
    np.testing.assert_allclose(hot.interior_stress[:3], -pressure)
    assert hot.concentration == np.inf


def test_a_misfit_sphere_leaves_the_surface_free_and_tends_to_the_infinite_body():
    sphere = sc.inclusions.MisfitSphere(1.0, 0.3, 1e-3, 1.0, 1.7)
    x = np.linspace(-4, 4, 21)
    assert np.abs(sphere.stress(x, 0.3, 0.0)[2:5]).max() < 1e-15
    points = np.array([0.0, 0.0, 1.7])[:, None] + 1.2 * NORMAL
    outside = points[:, points[2] > 0.1]
    assert np.abs(divergence(sphere.stress, outside, 2e-3)).max() < 1e-9
    ends = [np.array([0.0, 0.0, 1.7])[:, None] + (1 + side * 1e-9) * NORMAL for side in (-1, 1)]
    jump = as_matrix(sphere.stress(*ends[1]) - sphere.stress(*ends[0]))
    assert np.abs(np.einsum("ij...,j...->i...", jump, NORMAL)).max() < 1e-10
    deep = sc.inclusions.MisfitSphere(1.0, 0.3, 1e-3, 1.0, 1e5)
    alone = sc.inclusions.eshelby_sphere(
        sc.Material.elastic(1.0, 0.3), sc.Material.elastic(1.0, 0.3), np.zeros(6), 1e-3
    )
    at = 1.5 * NORMAL
    np.testing.assert_allclose(
        deep.stress(at[0], at[1], at[2] + 1e5), alone.stress(*at), atol=1e-12
    )


def test_the_surface_above_a_misfit_sphere_rises_by_the_displaced_volume():
    """The volume is 2 (1 + nu) times the misfit times the volume of the sphere."""
    sphere = sc.inclusions.MisfitSphere(210e9, 0.3, 1e-3, 1e-5, 3e-5)
    r = np.geomspace(1e-8, 3.0, 200_001)
    u = sphere.surface_displacement(r)
    ring = u * 2 * np.pi * r
    volume = (np.diff(r) * (ring[1:] + ring[:-1]) / 2).sum()
    assert volume == pytest.approx(-2 * 1.3 * 1e-3 * 4 / 3 * np.pi * 1e-15, rel=1e-4)


def test_a_thermal_misfit_is_the_difference_of_the_expansions():
    oxide = ALUMINA.with_thermal(30.0, 8e-6, 1e-5)
    steel = STEEL.with_thermal(40.0, 12e-6, 1e-5)
    assert sc.inclusions.thermal_misfit(oxide, steel, -100.0) == pytest.approx(4e-4)
    with pytest.raises(ValueError, match="inclusion must have thermal constants"):
        sc.inclusions.thermal_misfit(ALUMINA, steel, 1.0)


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: sphere(None, 1e-3), "misfit must be 0 in a void"),
        (
            lambda: sc.inclusions.eshelby_sphere(sc.Material.rigid(), STEEL, STRESS),
            "matrix must not be rigid",
        ),
        (lambda: sphere(STEEL, stress=[1.0]), r"stress must have shape \(6,\)"),
        (
            lambda: sc.inclusions.MisfitSphere(1.0, 0.3, 1e-3, 2.0, 1.0),
            "depth must be at least the radius",
        ),
        (
            lambda: sc.inclusions.interface_stress(STRESS, STRESS, np.ones((3, 2)), STEEL),
            "normal must contain n unit vectors",
        ),
    ],
)
def test_invalid_arguments_are_refused(make, text):
    with pytest.raises(ValueError, match=text):
        make()
