# SPDX-License-Identifier: GPL-3.0-or-later
"""Influence coefficients against quadrature of point-load solutions, and against mechanics.

Tolerances are relative to the largest component at the same field point. The oracles are good to
1e-11; the closed forms lose about (distance / size)**3 in the corner sums, which leaves 1e-10 at
30 sizes.
"""

import itertools
from functools import partial

import numpy as np
import pytest

from oracles import eigenstrain, half_space
from samcontact import kernels

# Lengths below are in units of LENGTH, so metres enter the package and numbers of order one the
# oracle.
LENGTH = 2.5e-5
E = 210e9
TOLERANCE = 1e-9
POISSON = (0.0, 0.3, 0.49)
TENSOR = np.array([[0, 5, 4], [5, 1, 3], [4, 3, 2]])
# Sign of each component under x -> -x and y -> -y.
MIRROR_X = np.array([1, 1, 1, 1, -1, -1])
MIRROR_Y = np.array([1, 1, 1, -1, 1, -1])
SWAP = [1, 0, 2, 4, 3, 5]

RECTANGLES = ((1.0, 1.0), (1.0, 8.0), (8.0, 1.0), (0.5, 0.7))
# In half sides: centre, inside, almost on an edge, just outside, above an edge line, far.
PLANE_POINTS = (
    (0.0, 0.0),
    (0.3, -0.6),
    (0.999, 0.2),
    (-1.001, 0.5),
    (0.0, 1.7),
    (2.0, -2.0),
    (25.0, 14.0),
)
DEPTHS = (0.0, 0.01, 0.4, 3.0, 20.0)

CUBOIDS = ((1.0, 1.0, 1.0), (0.5, 1.2, 0.7), (8.0, 1.0, 1.0), (1.0, 8.0, 1.0), (1.0, 1.0, 8.0))
# Each with steel; one without equal sides, in which every term has its part, with the others too.
CUBOIDS_AND_POISSON = (*((half, 0.3) for half in CUBOIDS), (CUBOIDS[1], 0.0), (CUBOIDS[1], 0.49))


def assert_close(actual, expected, tolerance=TOLERANCE):
    error = np.abs(actual - expected).max() / np.abs(expected).max()
    assert error < tolerance


def cuboid_points(half, zc):
    """Field points (X, Y, z): inside, near faces, edges and corner, on the surface, far."""
    a, b, c = half
    points = [
        (0.0, 0.0, zc),
        (0.4 * a, -0.3 * b, zc + 0.5 * c),
        (0.99 * a, 0.98 * b, zc - 0.97 * c),
        (1.02 * a, 0.1 * b, zc),
        (1.1 * a, -1.1 * b, zc + 1.1 * c),
        (0.0, 2.0 * b, zc),
        (2.0 * a, 0.0, zc + 2.0 * c),
        (0.2 * a, 0.3 * b, 0.0),
        (-3.0 * a, 1.3 * b, 0.0),
        (20.0, -12.0, 30.0),
    ]
    return points


@pytest.mark.parametrize("nu", POISSON)
@pytest.mark.parametrize("rect", RECTANGLES)
class TestRectangleAgainstQuadrature:
    # Displacements are finite on edges and corners too.
    points = (*PLANE_POINTS, (1.0, 0.3), (0.2, -1.0), (1.0, 1.0))

    def test_displacement(self, rect, nu):
        a, b = rect
        for p, q in self.points:
            X, Y = p * a, q * b
            place = (X * LENGTH, Y * LENGTH, a * LENGTH, b * LENGTH, E, nu)
            for expected, actual in (
                (half_space.displacement_pressure, kernels.pressure_displacement),
                (half_space.displacement_shear_x, kernels.shear_displacement),
                (half_space.displacement_shear_y, partial(kernels.shear_displacement, along="y")),
            ):
                found = [actual(*place, axis=axis) * E / LENGTH for axis in "xyz"]
                assert_close(np.array(found), expected(X, Y, rect, nu, 1.0))
            # By default the displacement along z.
            assert kernels.pressure_displacement(*place) == kernels.pressure_displacement(
                *place, axis="z"
            )
            assert kernels.shear_displacement(*place) == kernels.shear_displacement(
                *place, along="x", axis="z"
            )

    def test_stress(self, rect, nu):
        a, b = rect
        for (p, q), z in itertools.product(PLANE_POINTS, DEPTHS):
            X, Y = p * a, q * b
            place = (X * LENGTH, Y * LENGTH, z * LENGTH, a * LENGTH, b * LENGTH)
            expected = half_space.stress_pressure(X, Y, z, rect, nu)
            assert_close(kernels.pressure_stress(*place, nu), expected)
            expected = half_space.stress_shear_x(X, Y, z, rect, nu)
            assert_close(kernels.shear_stress(*place, nu), expected)
            expected = half_space.stress_shear_y(X, Y, z, rect, nu)
            assert_close(kernels.shear_stress(*place, nu, along="y"), expected)


# Their displacements follow from those of the others by symmetry, or linearity in nu.
IMPLIED = (CUBOIDS[3], 0.3), (CUBOIDS[1], 0.3)


@pytest.mark.parametrize("cover", [0.0, 2.3], ids=["touching", "buried"])
class TestCuboidAgainstQuadrature:
    @pytest.mark.parametrize(("half", "nu"), CUBOIDS_AND_POISSON)
    def test_stress(self, half, cover, nu):
        zc = half[2] + cover
        scaled = [LENGTH * h for h in half]
        for X, Y, z in cuboid_points(half, zc):
            place = (X * LENGTH, Y * LENGTH, z * LENGTH, zc * LENGTH)
            actual = kernels.eigenstrain_stress(*place, *scaled, E, nu)
            assert_close(actual, eigenstrain.stress(X, Y, z, zc, *half, E, nu))

    @pytest.mark.parametrize(
        ("half", "nu"),
        [
            pytest.param(*case, marks=[pytest.mark.slow] * (case in IMPLIED))
            for case in CUBOIDS_AND_POISSON
        ],
    )
    def test_surface_displacement(self, half, cover, nu):
        zc = half[2] + cover
        scaled = [LENGTH * h for h in half]
        for X, Y in {point[:2] for point in cuboid_points(half, zc)}:
            place = (X * LENGTH, Y * LENGTH, zc * LENGTH)
            expected = eigenstrain.surface_displacement(X, Y, zc, *half, nu)
            actual = np.array(
                [kernels.eigenstrain_displacement(*place, *scaled, nu, axis=a) for a in "xyz"]
            )
            assert_close(actual[2] / LENGTH, expected[2])
            assert_close(actual / LENGTH, expected)


X, Y = np.array([0.13, 0.9, -2.2, 4.0]), np.array([-0.4, 1.3, 0.7, 2.5])
HALF = (0.5, 0.8, 0.3)


@pytest.mark.parametrize("nu", POISSON)
class TestSymmetry:
    def test_pressure(self, nu):
        a, b = HALF[:2]
        u = kernels.pressure_displacement(X, Y, a, b, E, nu)
        np.testing.assert_allclose(kernels.pressure_displacement(-X, Y, a, b, E, nu), u, rtol=1e-12)
        np.testing.assert_allclose(kernels.pressure_displacement(Y, X, b, a, E, nu), u, rtol=1e-12)
        s = kernels.pressure_stress(X, Y, 0.6, a, b, nu)
        x_flipped = kernels.pressure_stress(-X, Y, 0.6, a, b, nu)
        y_flipped = kernels.pressure_stress(X, -Y, 0.6, a, b, nu)
        swapped = kernels.pressure_stress(Y, X, 0.6, b, a, nu)
        assert_close(x_flipped, MIRROR_X[:, None] * s, 1e-12)
        assert_close(y_flipped, MIRROR_Y[:, None] * s, 1e-12)
        assert_close(swapped[SWAP], s, 1e-12)

    def test_shear(self, nu):
        a, b = HALF[:2]
        u = kernels.shear_displacement(X, Y, a, b, E, nu)
        np.testing.assert_allclose(kernels.shear_displacement(-X, Y, a, b, E, nu), -u, rtol=1e-11)
        np.testing.assert_allclose(kernels.shear_displacement(X, -Y, a, b, E, nu), u, rtol=1e-11)
        s = kernels.shear_stress(X, Y, 0.6, a, b, nu)
        x_flipped = kernels.shear_stress(-X, Y, 0.6, a, b, nu)
        y_flipped = kernels.shear_stress(X, -Y, 0.6, a, b, nu)
        assert_close(x_flipped, -MIRROR_X[:, None] * s, 1e-12)
        assert_close(y_flipped, MIRROR_Y[:, None] * s, 1e-12)

    def test_eigenstrain(self, nu):
        a, b, c = HALF
        for zc in (c, 1.4):
            for axis, other, sign_x, sign_y in (
                ("x", "y", -1, 1), ("y", "x", 1, -1), ("z", "z", 1, 1),
            ):  # fmt: skip
                moved = partial(kernels.eigenstrain_displacement, axis=axis)
                u = moved(X, Y, zc, *HALF, nu)
                x_flipped, y_flipped = moved(-X, Y, zc, *HALF, nu), moved(X, -Y, zc, *HALF, nu)
                swapped = kernels.eigenstrain_displacement(Y, X, zc, b, a, c, nu, axis=other)
                assert_close(x_flipped, sign_x * MIRROR_X[:, None] * u, 1e-11)
                assert_close(y_flipped, sign_y * MIRROR_Y[:, None] * u, 1e-11)
                assert_close(swapped[SWAP], u, 1e-11)
            s = kernels.eigenstrain_stress(X, Y, 0.6, zc, *HALF, E, nu)
            x_flipped = kernels.eigenstrain_stress(-X, Y, 0.6, zc, *HALF, E, nu)
            y_flipped = kernels.eigenstrain_stress(X, -Y, 0.6, zc, *HALF, E, nu)
            swapped = kernels.eigenstrain_stress(Y, X, 0.6, zc, b, a, c, E, nu)
            assert_close(x_flipped, np.multiply.outer(MIRROR_X, MIRROR_X)[:, :, None] * s, 1e-11)
            assert_close(y_flipped, np.multiply.outer(MIRROR_Y, MIRROR_Y)[:, :, None] * s, 1e-11)
            assert_close(swapped[SWAP][:, SWAP], s, 1e-11)


@pytest.mark.parametrize("nu", POISSON)
def test_surface_tractions(nu):
    a, b = HALF[:2]
    x = np.linspace(-1.5, 1.5, 14)[:, None]
    y = np.linspace(-1.7, 1.7, 12)[None, :]
    loaded = ((np.abs(x) < a) & (np.abs(y) < b)).astype(float)
    zero = np.zeros_like(loaded)
    pressure = kernels.pressure_stress(x, y, 0.0, a, b, nu)
    np.testing.assert_allclose(pressure[2:5], [-loaded, zero, zero], atol=1e-12)
    shear = kernels.shear_stress(x, y, 0.0, a, b, nu)
    np.testing.assert_allclose(shear[2:5], [zero, zero, -loaded], atol=1e-12)


@pytest.mark.parametrize("nu", POISSON)
@pytest.mark.parametrize("half", CUBOIDS)
@pytest.mark.parametrize("cover", [0.0, 0.4, 50.0])
def test_eigenstrain_leaves_the_surface_free(half, cover, nu):
    a, b, c = half
    x = 3.0 * a * np.linspace(-1.0, 1.0, 14)[:, None]
    y = 3.0 * b * np.linspace(-1.0, 1.0, 12)[None, :]
    zc = c + cover
    largest = np.abs(kernels.eigenstrain_stress(0.0, 0.0, zc, zc, a, b, c, E, nu)).max()
    stress = kernels.eigenstrain_stress(x, y, 0.0, zc, a, b, c, E, nu)
    traction = float(np.abs(stress[2:5]).max() / largest)
    assert traction < 1e-12


@pytest.mark.parametrize(
    "kernel",
    [
        lambda x, y, z: kernels.pressure_stress(x, y, z, *HALF[:2], 0.3),
        lambda x, y, z: kernels.shear_stress(x, y, z, *HALF[:2], 0.3),
        lambda x, y, z: kernels.eigenstrain_stress(x, y, z, 0.6, *HALF, 1.0, 0.3),
        lambda x, y, z: kernels.eigenstrain_stress(x, y, z, 0.3, *HALF, 1.0, 0.49),
    ],
    ids=["pressure", "shear", "buried eigenstrain", "touching eigenstrain"],
)
@pytest.mark.parametrize("point", [(0.1, 0.2, 0.45), (0.9, -0.6, 0.5), (0.2, -0.1, 1.3)])
def test_equilibrium(kernel, point):
    """Divergence by eighth-order differences, at points away from faces and edges."""
    step, total, scale = 0.01, 0.0, 0.0
    for axis in range(3):
        derivative = 0.0
        for k, weight in ((1, 4 / 5), (2, -1 / 5), (3, 4 / 105), (4, -1 / 280)):
            shift = np.eye(3)[axis] * step * k
            derivative = derivative + weight / step * (
                kernel(*(point + shift)) - kernel(*(point - shift))
            )
        total = total + derivative[TENSOR[axis]]
        scale = max(scale, np.abs(derivative).max())
    assert np.abs(total).max() < 1e-7 * scale


def test_unit_of_length_does_not_matter():
    """In metres and millimetres stress is equal, and displacement scales as a length."""
    a, b, c = HALF
    for k in (1e-3, 1e-6, 1e3):
        x, y, half = k * X, k * Y, (k * a, k * b, k * c)
        u = kernels.pressure_displacement(X, Y, a, b, E, 0.3)
        assert_close(kernels.pressure_displacement(x, y, *half[:2], E, 0.3) / k, u, 1e-12)
        u = kernels.shear_displacement(X, Y, a, b, E, 0.3)
        assert_close(kernels.shear_displacement(x, y, *half[:2], E, 0.3) / k, u, 1e-12)
        u = kernels.eigenstrain_displacement(X, Y, 0.6, *HALF, 0.3)
        assert_close(kernels.eigenstrain_displacement(x, y, k * 0.6, *half, 0.3) / k, u, 1e-11)
        s = kernels.pressure_stress(X, Y, 0.6, a, b, 0.3)
        assert_close(kernels.pressure_stress(x, y, k * 0.6, *half[:2], 0.3), s, 1e-12)
        s = kernels.shear_stress(X, Y, 0.6, a, b, 0.3)
        assert_close(kernels.shear_stress(x, y, k * 0.6, *half[:2], 0.3), s, 1e-12)
        s = kernels.eigenstrain_stress(X, Y, 0.5, 0.6, *HALF, E, 0.3)
        assert_close(kernels.eigenstrain_stress(x, y, k * 0.5, k * 0.6, *half, E, 0.3), s, 1e-11)


def test_young_modulus_only_scales():
    a, b, _ = HALF
    ratio = kernels.pressure_displacement(X, Y, a, b, 1.0, 0.3) / E
    np.testing.assert_allclose(kernels.pressure_displacement(X, Y, a, b, E, 0.3), ratio, rtol=1e-14)
    ratio = kernels.shear_displacement(X, Y, a, b, 1.0, 0.3) / E
    np.testing.assert_allclose(kernels.shear_displacement(X, Y, a, b, E, 0.3), ratio, rtol=1e-14)
    stress = kernels.eigenstrain_stress(X, Y, 0.5, 0.6, *HALF, 1.0, 0.3)
    assert_close(kernels.eigenstrain_stress(X, Y, 0.5, 0.6, *HALF, E, 0.3), E * stress, 1e-14)


def test_parts_sum_to_the_whole():
    """The eight octants of a cuboid and the four quarters of a rectangle sum to the whole."""
    a, b, c = HALF
    signs = np.array([-0.5, 0.5])
    whole = kernels.eigenstrain_stress(X, Y, 0.6, 0.5, a, b, c, E, 0.3)
    parts = sum(
        kernels.eigenstrain_stress(
            X - i * a, Y - j * b, 0.6, 0.5 + k * c, a / 2, b / 2, c / 2, E, 0.3
        )
        for i, j, k in itertools.product(signs, signs, signs)
    )
    assert_close(parts, whole, 1e-12)
    whole = kernels.pressure_stress(X, Y, 0.6, a, b, 0.3)
    parts = sum(
        kernels.pressure_stress(X - i * a, Y - j * b, 0.6, a / 2, b / 2, 0.3)
        for i, j in itertools.product(signs, signs)
    )
    assert_close(parts, whole, 1e-13)


@pytest.mark.parametrize("depth", [1e2, 1e3, 1e4])
def test_image_stress_decays_with_the_cube_of_the_depth(depth):
    """The field of deep cuboids tends to that in an infinite body, without unstable image terms."""
    a, b, c = HALF

    def at(level):
        return kernels.eigenstrain_stress(X, Y, level + 0.25, level, a, b, c, 1.0, 0.3)

    difference = np.abs(at(depth) - at(1e7)).max() / np.abs(at(1e7)).max()
    assert difference < 10.0 * depth**-3 + 1e-12


def test_broadcasting():
    x, y = np.linspace(-1.0, 1.0, 4)[:, None], np.linspace(-2.0, 2.0, 3)
    a, b, c = HALF
    calls = {
        (): lambda x, y: kernels.pressure_displacement(x, y, a, b, E, 0.3),
        (1,): lambda x, y: kernels.shear_displacement(x, y, a, b, E, 0.3)[None],
        (6,): lambda x, y: kernels.pressure_stress(x, y, 0.4, a, b, 0.3),
        (6, 1): lambda x, y: kernels.shear_stress(x, y, 0.4, a, b, 0.3)[:, None],
        (1, 6): lambda x, y: kernels.eigenstrain_displacement(x, y, 0.4, a, b, c, 0.3)[None],
        (6, 6): lambda x, y: kernels.eigenstrain_stress(x, y, 0.4, 0.4, a, b, c, E, 0.3),
    }
    for lead, call in calls.items():
        together = call(x, y)
        assert together.shape == (*lead, 4, 3)
        one = np.asarray(call(x[2, 0], y[1]))
        assert one.shape == lead
        np.testing.assert_array_equal(together[..., 2, 1], one)
    depths = np.array([0.0, 0.4, 2.0])
    several = kernels.pressure_stress(0.1, 0.2, depths, a, b, 0.3)
    np.testing.assert_array_equal(several[:, 1], kernels.pressure_stress(0.1, 0.2, 0.4, a, b, 0.3))
