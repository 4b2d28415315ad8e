# SPDX-License-Identifier: GPL-3.0-or-later
"""Properties for any geometry and load: reciprocity, translation, exchange of axes, sums."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import samcontact as sc
from oracles.quadrature import gauss
from samcontact import kernels, operators

E = 210e9
SWAP = [1, 0, 2, 4, 3, 5]
# eps : sigma counts each shear component twice.
CONTRACTION = np.array([1.0, 1.0, 1.0, 2.0, 2.0, 2.0])

few = settings(derandomize=True, max_examples=12, deadline=None, database=None)
poisson = st.floats(0.0, 0.49)
aspect = st.floats(0.125, 8.0)
count = st.integers(1, 9)
seeds = st.integers(0, 2**32 - 1)


def random(seed, *shape):
    return np.random.default_rng(seed).standard_normal(shape)


def assert_close(actual, expected, tolerance):
    assert np.abs(actual - expected).max() <= tolerance * np.abs(expected).max()


@few
@given(nx=count, ny=count, ratio=aspect, nu=poisson, seed=seeds)
def test_pressures_are_reciprocal(nx, ny, ratio, nu, seed):
    """Betti: the work of p1 through u(p2) is that of p2 through u(p1)."""
    grid = sc.Grid(nx, ny, 1e-5, ratio * 1e-5)
    p1, p2 = random(seed, 2, nx, ny)
    u1, u2 = (operators.surface_displacement(grid, p, E, nu) for p in (p1, p2))
    # The works can cancel; their terms cannot.
    assert abs((p1 * u2).sum() - (p2 * u1).sum()) < 1e-12 * np.abs(p1 * u2).sum()


@few
@given(
    cuboid=st.tuples(*[st.floats(0.5, 2.0)] * 3),
    cover=st.floats(1.0, 4.0),
    rect=st.tuples(*[st.floats(0.5, 2.0)] * 2),
    X=st.floats(-5.0, 5.0),
    Y=st.floats(-5.0, 5.0),
    nu=poisson,
    axis=st.sampled_from("xyz"),
)
def test_tractions_and_plastic_strain_are_reciprocal(cuboid, cover, rect, X, Y, nu, axis):
    """The work of a traction through u_r(eps) equals that of eps : sigma over the cuboid.

    The equality is exact. Singularities stay one unit off 24-point Gauss rules on sides of at
    most four: Bernstein ellipse 0.5 + sqrt(1.25), error about 1.618**-48 = 1e-10.
    """
    a, b, c = cuboid
    zc = c + cover
    x, wx = gauss(-rect[0], rect[0], 24)
    y, wy = gauss(-rect[1], rect[1], 24)
    u = kernels.eigenstrain_displacement(X + x[:, None], Y + y, zc, a, b, c, nu, axis=axis)
    of_traction = np.einsum("eij,i,j->e", u, wx, wy)

    x, wx = gauss(-a, a, 24)
    y, wy = gauss(-b, b, 24)
    z, wz = gauss(zc - c, zc + c, 24)
    places = x[:, None, None] - X, y[:, None] - Y, z
    if axis == "z":
        stress = kernels.pressure_stress(*places, *rect, nu)
    else:
        stress = kernels.shear_stress(*places, *rect, nu, along=axis)
    of_strain = CONTRACTION * np.einsum("eijk,i,j,k->e", stress, wx, wy, wz)
    assert_close(of_traction, of_strain, 1e-8)


def test_grid_operators_are_reciprocal_to_second_order():
    """Sampled at cell centres instead of averaged, the two works differ by O(h**2)."""
    nu, width = 0.3, 1.0
    errors = []
    for n in (8, 16, 32):
        grid = sc.Grid(2 * n, 2 * n, width / n, width / n, n, width / n)
        x, y, z = grid.x[:, None, None], grid.y[:, None], grid.z
        pressure = np.exp(-8.0 * ((x - 0.1) ** 2 + (y + 0.2) ** 2))[..., 0]
        bump = np.exp(-16.0 * ((x + 0.1) ** 2 + y**2 + (z - 0.5) ** 2))
        strain = np.multiply.outer([0.6, 0.3, -0.9, 0.5, -0.4, 0.2], bump)
        u = operators.residual_displacement(grid, strain, nu)
        stress = operators.surface_stress(grid, pressure, grid.z, nu)
        work = (pressure * u).sum() * grid.dx * grid.dy
        volume = grid.dx * grid.dy * grid.dz
        other = np.einsum("e,eijk,eijk->", CONTRACTION, strain, stress) * volume
        errors.append(abs(work / other - 1.0))
    assert errors[-1] < 5e-3
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.3)
    assert errors[1] / errors[2] == pytest.approx(4.0, rel=0.3)


@few
@given(
    shape=st.tuples(count, count, st.integers(1, 4)),
    shift=st.tuples(st.integers(0, 3), st.integers(0, 3)),
    nu=poisson,
    seed=seeds,
)
def test_translation_in_the_plane(shape, shift, nu, seed):
    """Sources moved by whole cells move every field with them."""
    nx, ny, nz = shape
    i, j = shift
    large = sc.Grid(nx + 3, ny + 3, 1e-5, 2e-5, nz, 1.5e-5)
    small_p, small_strain = random(seed, nx, ny), random(seed + 1, 6, nx, ny, nz)
    fields = []
    for di, dj in ((0, 0), (i, j)):
        p = np.zeros((nx + 3, ny + 3))
        strain = np.zeros((6, nx + 3, ny + 3, nz))
        p[di : di + nx, dj : dj + ny] = small_p
        strain[:, di : di + nx, dj : dj + ny] = small_strain
        fields.append(
            (
                operators.surface_displacement(large, p, E, nu, shear=0.2 * p)[None, ..., None],
                operators.surface_stress(large, p, large.z, nu, shear=0.2 * p),
                operators.residual_stress(large, strain, E, nu),
                operators.residual_displacement(large, strain, nu)[None, ..., None],
            )
        )
    for still, moved in zip(*fields, strict=True):
        assert_close(moved[:, i:, j:], still[:, : nx + 3 - i, : ny + 3 - j], 1e-12)


@few
@given(shape=st.tuples(count, count, st.integers(1, 4)), ratio=aspect, nu=poisson, seed=seeds)
def test_exchange_of_x_and_y(shape, ratio, nu, seed):
    nx, ny, nz = shape
    grid = sc.Grid(nx, ny, 1e-5, ratio * 1e-5, nz, 1.5e-5)
    turned = sc.Grid(ny, nx, ratio * 1e-5, 1e-5, nz, 1.5e-5)
    p, sx, sy = random(seed, 3, nx, ny)
    strain = random(seed + 1, 6, nx, ny, nz)
    shear, turned_shear = np.array([sx, sy]), np.array([sy.T, sx.T])
    turned_strain = strain[SWAP].transpose(0, 2, 1, 3)

    for axis, other in ("xy", "yx", "zz"):
        u = operators.surface_displacement(grid, p, E, nu, shear=shear, axis=axis)
        v = operators.surface_displacement(turned, p.T, E, nu, shear=turned_shear, axis=other)
        assert_close(v.T, u, 1e-12)
    depths = [0.0, 1e-5, 5e-5]
    s = operators.surface_stress(grid, p, depths, nu, shear=shear)
    t = operators.surface_stress(turned, p.T, depths, nu, shear=turned_shear)
    assert_close(t[SWAP].transpose(0, 2, 1, 3), s, 1e-12)
    s = operators.residual_stress(grid, strain, E, nu)
    t = operators.residual_stress(turned, turned_strain, E, nu)
    assert_close(t[SWAP].transpose(0, 2, 1, 3), s, 1e-11)
    for axis, other in ("xy", "yx", "zz"):
        u = operators.residual_displacement(grid, strain, nu, axis=axis)
        v = operators.residual_displacement(turned, turned_strain, nu, axis=other)
        assert_close(v.T, u, 1e-11)


@few
@given(shape=st.tuples(count, count, st.integers(1, 4)), factor=st.floats(-1e6, 1e6), seed=seeds)
def test_superposition(shape, factor, seed):
    grid = sc.Grid(*shape[:2], 1e-5, 2e-5, shape[2], 1.5e-5)
    e, f = random(seed, 2, 6, *shape)
    p, q = random(seed + 1, 2, *shape[:2])

    def fields(pressure, strain):
        return (
            operators.surface_displacement(grid, pressure, E, 0.3),
            operators.surface_stress(grid, pressure, grid.z, 0.3),
            operators.residual_stress(grid, strain, E, 0.3),
            operators.residual_displacement(grid, strain, 0.3),
        )

    combined = fields(p + factor * q, e + factor * f)
    for total, one, other in zip(combined, fields(p, e), fields(q, f), strict=True):
        terms = np.abs(one).max() + abs(factor) * np.abs(other).max()
        assert np.abs(total - one - factor * other).max() <= 1e-12 * terms


@few
@given(
    shape=st.tuples(count, count, st.integers(1, 4)),
    factor=st.floats(-1e6, 1e6),
    nu=poisson,
    seed=seeds,
)
def test_superposition_of_shear_and_of_sweeps(shape, factor, nu, seed):
    """Superposition holds for both shear tractions and for residual stress by layer sweeps."""
    grid = sc.Grid(*shape[:2], 1e-5, 2e-5, shape[2], 1.5e-5)
    s, t = random(seed, 2, 2, *shape[:2])
    e, f = random(seed + 1, 2, 6, *shape)
    none = np.zeros(shape[:2])

    def fields(shear, strain):
        return (
            operators.surface_displacement(grid, none, E, nu, shear),
            operators.surface_stress(grid, none, grid.z, nu, shear),
            operators.residual_stress(grid, strain, E, nu, method="fast"),
        )

    combined = fields(s + factor * t, e + factor * f)
    for total, one, other in zip(combined, fields(s, e), fields(t, f), strict=True):
        terms = np.abs(one).max() + abs(factor) * np.abs(other).max()
        assert np.abs(total - one - factor * other).max() <= 1e-12 * terms


@few
@given(
    shape=st.tuples(count, count, st.integers(1, 4)),
    length=st.floats(1e-6, 1e6),
    modulus=st.floats(1e-6, 1e6),
    nu=poisson,
    seed=seeds,
)
def test_scaling_laws(shape, length, modulus, nu, seed):
    """u scales with length over modulus; stress of an eigenstrain scales with the modulus."""
    p, shear = random(seed, *shape[:2]), random(seed + 1, 2, *shape[:2])
    strain = random(seed, 6, *shape)
    fields = []
    for size, stiffness in ((1.0, 1.0), (length, modulus)):
        grid = sc.Grid(*shape[:2], size * 1e-5, size * 2e-5, shape[2], size * 1.5e-5)
        Y = stiffness * E
        fields.append(
            (
                operators.surface_displacement(grid, p, Y, nu, shear) * stiffness / size,
                operators.surface_stress(grid, p, grid.z, nu, shear),
                operators.residual_stress(grid, strain, Y, nu) / stiffness,
                operators.residual_displacement(grid, strain, nu) / size,
                operators.residual_stress(grid, strain, Y, nu, method="fast") / stiffness,
            )
        )
    *exact, sweeps = zip(*fields, strict=True)
    for one, other in exact:
        assert_close(other, one, 1e-11)
    # rounding may decide how many of its images are taken
    assert_close(sweeps[1], sweeps[0], IMAGE_TOL)


MIRROR_X = np.array([1.0, 1.0, 1.0, 1.0, -1.0, -1.0])
IMAGE_TOL = 1e-3
"""Default of the sweeps: their images are neither mirrored nor symmetric."""


@few
@given(shape=st.tuples(count, count, st.integers(1, 4)), ratio=aspect, nu=poisson, seed=seeds)
def test_reversal_of_x(shape, ratio, nu, seed):
    """Shears along x change sign, and with them xz and xy."""
    nx, ny, nz = shape
    grid = sc.Grid(nx, ny, 1e-5, ratio * 1e-5, nz, 1.5e-5)
    p, sx, sy = random(seed, 3, nx, ny)
    strain = random(seed + 1, 6, *shape)
    reversed_strain = (MIRROR_X[:, None, None, None] * strain)[:, ::-1]
    shear, turned = np.array([sx, sy]), np.array([-sx, sy])[:, ::-1]
    for axis, sign in (("x", -1), ("y", 1), ("z", 1)):
        u = operators.surface_displacement(grid, p, E, nu, shear, axis=axis)
        v = operators.surface_displacement(grid, p[::-1], E, nu, turned, axis=axis)
        assert_close(sign * v[::-1], u, 1e-12)
    s = operators.surface_stress(grid, p, grid.z, nu, shear)
    t = operators.surface_stress(grid, p[::-1], grid.z, nu, turned)
    assert_close(MIRROR_X[:, None, None, None] * t[:, ::-1], s, 1e-12)
    for method, tolerance in (("exact", 1e-11), ("fast", IMAGE_TOL)):
        s = operators.residual_stress(grid, strain, E, nu, method=method)
        t = operators.residual_stress(grid, reversed_strain, E, nu, method=method)
        assert_close(MIRROR_X[:, None, None, None] * t[:, ::-1], s, tolerance)
    for axis, sign in (("x", -1), ("y", 1), ("z", 1)):
        u = operators.residual_displacement(grid, strain, nu, axis=axis)
        v = operators.residual_displacement(grid, reversed_strain, nu, axis=axis)
        assert_close(sign * v[::-1], u, 1e-11)


@few
@given(shape=st.tuples(count, count, st.integers(1, 4)), ratio=aspect, nu=poisson, seed=seeds)
def test_plastic_strains_are_reciprocal(shape, ratio, nu, seed):
    """Betti: e1 : sigma(e2) and e2 : sigma(e1) have the same integral.

    The sweeps take means over the layers of band-limited fields: it holds to their images.
    """
    grid = sc.Grid(*shape[:2], 1e-5, ratio * 1e-5, shape[2], 1.5e-5)
    e, f = random(seed, 2, 6, *shape)
    of_e, of_f = (operators.residual_stress(grid, x, E, nu, method="fast") for x in (e, f))
    one = np.einsum("c,cijk,cijk->", CONTRACTION, e, of_f)
    other = np.einsum("c,cijk,cijk->", CONTRACTION, f, of_e)
    terms = np.einsum("c,cijk->", CONTRACTION, np.abs(e * of_f))
    assert abs(one - other) <= IMAGE_TOL * terms


@few
@given(shape=st.tuples(count, count, st.integers(1, 4)), ratio=aspect, nu=poisson, seed=seeds)
def test_residual_stress_stores_energy(shape, ratio, nu, seed):
    """Whatever the eigenstrain, -1/2 of the integral of sigma : e is not negative."""
    grid = sc.Grid(*shape[:2], 1e-5, ratio * 1e-5, shape[2], 1.5e-5)
    strain = random(seed, 6, *shape)
    stress = operators.residual_stress(grid, strain, E, nu, method="fast")
    assert -np.einsum("c,cijk,cijk->", CONTRACTION, strain, stress) > 0


HOT = sc.Material.elastic(E, 0.3).with_thermal(50.0, 12e-6, 1.4e-5)


@few
@given(
    shape=st.tuples(count, count),
    velocity=st.tuples(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0)),
    factor=st.floats(-100.0, 100.0),
    seed=seeds,
)
def test_heat_is_reciprocal_and_linear(shape, velocity, factor, seed):
    """Reciprocity: q2 times the temperature of q1 equals q1 times that of q2 in reversed motion."""
    grid = sc.Grid(*shape, 1e-5, 2e-5)
    q1, q2 = random(seed, 2, *shape)

    def rise(q, direction=1.0):
        v = (direction * velocity[0], direction * velocity[1])
        solver = sc.ContactSolver(grid, HOT, HOT, heat=sc.Heat(0.1, v, reference=1.0))
        return solver.temperature(q)[..., 0]

    t1, t2 = rise(q1), rise(q2)
    together = rise(q1 + factor * q2)
    terms = np.abs(t1).max() + abs(factor) * np.abs(t2).max()
    assert np.abs(together - t1 - factor * t2).max() <= 1e-12 * terms
    against = rise(q2, -1.0)
    # tables of moving sources have a tolerance of 1e-6 of their largest value
    assert abs((q2 * t1).sum() - (q1 * against).sum()) <= 1e-5 * np.abs(q2).sum() * np.abs(t1).max()
