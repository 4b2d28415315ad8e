# SPDX-License-Identifier: GPL-3.0-or-later
"""Fast residual stress against the exact one, a wider box, and algebraic identities."""

import functools
import itertools

import numpy as np
import pytest
from scipy.interpolate import RectBivariateSpline

import samcontact as sc
from samcontact import operators

E, NU = 210e9, 0.3
SHEAR = np.array([1, 1, 1, 2, 2, 2])[:, None, None, None]
FREE = {"method": "fast", "image_tol": 1e-6}


def fast(grid, strain, **options):
    return operators.residual_stress(grid, strain, E, NU, **{"method": "fast", **options})


def exact(grid, strain):
    return operators.residual_stress(grid, strain, E, NU, method="exact")


def rms(values):
    return np.sqrt(np.mean(values**2))


def coordinates(grid):
    return np.meshgrid(grid.x, grid.y, grid.z, indexing="ij")


def blob(cells, power=2, widths=(1.0, 1.0), depth=1.1):
    """Return a smooth strain within a unit ellipsoid, with `cells` cells per semi-axis."""
    h = 1.0 / cells
    nx, ny = (2 * int(np.ceil(w * cells)) for w in widths)
    grid = sc.Grid(nx, ny, h, h, int(np.ceil((depth + 1) * cells)), h)
    X, Y, Z = coordinates(grid)
    inside = np.maximum(0, 1 - (X / widths[0]) ** 2 - (Y / widths[1]) ** 2 - (Z - depth) ** 2)
    pattern = np.array([1.0, -0.4, 0.7, 0.5, -0.8, 0.3])
    return grid, 1e-3 * pattern[:, None, None, None] * inside**power


def padded(grid, strain, factor):
    """Return the strain in a box wider by a factor, and its position in this box."""
    nx, ny = (factor * n + n % 2 * (factor % 2 == 0) for n in (grid.nx, grid.ny))
    wide = sc.Grid(nx, ny, grid.dx, grid.dy, grid.nz, grid.dz)
    i, j = (nx - grid.nx) // 2, (ny - grid.ny) // 2
    inside = np.s_[:, i : i + grid.nx, j : j + grid.ny]
    embedded = np.zeros((6, *wide.volume_shape))
    embedded[inside] = strain
    return wide, embedded, inside


def test_fast_stress_converges_to_exact_stress_with_second_order():
    differences = []
    for cells in (5, 10):
        grid, strain = blob(cells)
        reference = exact(grid, strain)
        differences.append(rms(fast(grid, strain, **FREE) - reference) / rms(reference))
    assert differences[0] < 0.04
    assert differences[1] < 0.3 * differences[0]


@pytest.mark.parametrize("component", range(6))
def test_every_component(component):
    grid, strain = blob(8)
    strain[:component] = strain[component + 1 :] = 0
    reference = exact(grid, strain)
    assert rms(fast(grid, strain, **FREE) - reference) < 0.02 * rms(reference)


@pytest.mark.parametrize("nu", [0.0, 0.45])
@pytest.mark.parametrize("sizes", [(2.0e-5, 3.1e-5, 1.3e-5), (1.0, 0.5, 2.0)])
def test_other_materials_and_cells(nu, sizes):
    dx, dy, dz = sizes
    grid = sc.Grid(21, 24, dx, dy, 16, dz)
    X, Y, Z = coordinates(grid)
    inside = np.maximum(0, 1 - (X / 9 / dx) ** 2 - (Y / 10 / dy) ** 2 - (Z / 7 / dz - 1.1) ** 2)
    strain = 1e-3 * np.array([0.6, -1.0, 0.4, 0.5, 0.3, 0.7])[:, None, None, None] * inside**2
    reference = operators.residual_stress(grid, strain, E, nu)
    found = operators.residual_stress(grid, strain, E, nu, method="fast", image_tol=1e-5)
    assert rms(found - reference) < 0.04 * rms(reference)


@pytest.mark.parametrize(
    "shape", [{}, {"widths": (1.0, 0.5)}, {"depth": 2.2}, {"widths": (2.0, 0.4), "depth": 1.1}]
)
def test_images_are_below_their_tolerance(shape):
    """A box and a much wider one differ only by the periodic images."""
    grid, strain = blob(10 if "widths" in shape else 12, power=4, **shape)
    wide, embedded, inside = padded(grid, strain, 6)
    reference = fast(wide, embedded, **FREE)[inside]
    for tol in (1e-2, 1e-3, 1e-4):
        error = np.abs(fast(grid, strain, image_tol=tol) - reference).max()
        assert error < tol * np.abs(reference).max(), tol


@pytest.mark.parametrize(("cells", "limit"), [((16, 14), 3e-4), ((33, 31), 1e-5)])
def test_strain_of_single_cells_is_independent_of_the_box(cells, limit):
    """Stress does not oscillate between cells; with a cut at the highest wavenumber a box of
    33 cells would differ by 2 %. The difference falls with the fifth power of the cells."""
    draws = np.random.default_rng(3)
    grid = sc.Grid(*cells, 1.0, 1.2, 6, 0.8)
    spots = draws.random(grid.volume_shape) < 0.02
    strain = 1e-3 * draws.standard_normal((6, *grid.volume_shape)) * spots
    wide, embedded, inside = padded(grid, strain, 3)
    reference = fast(wide, embedded, **FREE)[inside]
    error = np.abs(fast(grid, strain, image_tol=1e-5) - reference).max()
    assert error < limit * np.abs(reference).max()


@pytest.mark.slow
def test_images_at_the_tightest_tolerance():
    grid, strain = blob(24, power=5)
    wide, embedded, inside = padded(grid, strain, 8)
    reference = fast(wide, embedded, **FREE)[inside]
    error = np.abs(fast(grid, strain, image_tol=1e-5) - reference).max()
    assert error < 1e-5 * np.abs(reference).max()


def dot(strain, stress):
    return (SHEAR * strain * stress).sum()


def test_is_symmetric():
    grid = sc.Grid(12, 9, 1.0, 1.3, 10, 0.8)
    first, second = 1e-3 * np.random.default_rng(1).standard_normal((2, 6, *grid.volume_shape))
    there, back = dot(first, fast(grid, second, **FREE)), dot(second, fast(grid, first, **FREE))
    scale = np.sqrt(dot(first, first) * dot(second, second)) * E
    assert abs(there - back) < 1e-6 * scale


def test_elastic_energy_of_a_strain_is_not_negative():
    """-strain : stress is the elastic energy and never negative; exact point values violate
    this (tests/unit/operators/test_operators.py)."""
    shape = (8, 8, 8)
    grid = sc.Grid(8, 8, 1.0, 1.0, 8, 1.0)
    i, j, k = np.ogrid[:8, :8, :8]
    patterns = [1e-3 * np.random.default_rng(2).standard_normal((6, *shape))]
    for directions in itertools.product((0, 1), repeat=3):
        sign = (-1.0) ** (directions[0] * i + directions[1] * j + directions[2] * k)
        for first, second in ((0, 1), (0, 2), (1, 2)):
            strain = np.zeros((6, *shape))
            strain[first], strain[second] = 1e-3 * sign, -1e-3 * sign
            patterns.append(strain)
        for component in (3, 4, 5):
            strain = np.zeros((6, *shape))
            strain[component] = 1e-3 * sign
            patterns.append(strain)
    for strain in patterns:
        assert -dot(strain, fast(grid, strain, image_tol=1e-2)) > 0


LAWS = {
    "52100": sc.Material.swift(E, NU, 945e6, 20.0, 0.121),
    "perfect": sc.Material.perfect_plastic(E, NU, 1.4e9),
}


@functools.cache
def plastic_zone(law):
    """Return radius and depth of the plastic zone of two balls at 1500 N, and its strain (y = 0)
    as functions of (x, z)."""
    exact_contact = sc.hertz.point(R=7.5e-3, E_star=E / (1 - NU**2) / 2, load=1500.0)
    h = exact_contact.a / 24
    grid = sc.Grid(57, 57, h, h, 38, h)
    gap = sc.surfaces.paraboloid(grid, Rx=7.5e-3)
    state = sc.Simulation(grid, sc.Material.elastic(E, NU), LAWS[law], gap).step(load=1500.0)
    flowed = np.argwhere(state.equivalent_plastic_strain() > 1e-7).max(axis=0)
    middle = state.plastic_strain()[:, :, grid.ny // 2]
    fields = [RectBivariateSpline(grid.x, grid.z, middle[c], kx=1, ky=1) for c in (0, 1, 2, 4)]
    return grid.x[flowed[0]], grid.z[flowed[2]], fields


def zone_strain(grid, fields):
    """The axisymmetric strain on a grid."""
    X, Y, Z = coordinates(grid)
    R = np.hypot(X, Y)
    c, s = X / np.maximum(R, 1e-300), Y / np.maximum(R, 1e-300)
    c[R == 0] = 1.0
    rr, tt, zz, rz = (field.ev(R, Z) for field in fields)
    return np.stack(
        [rr * c**2 + tt * s**2, rr * s**2 + tt * c**2, zz, rz * s, rz * c, (rr - tt) * c * s]
    )


def zone_errors(law, cells, refinement):
    """Return rms errors of the exact and the fast method, relative to a finer grid."""
    radius, depth, fields = plastic_zone(law)
    h = radius / cells
    n, nz = 2 * int(np.ceil(cells + 1)) + 1, int(np.ceil(depth / h + 1))
    grid = sc.Grid(n, n, h, h, nz, h)
    fine = sc.Grid(n * refinement, n * refinement, h / refinement, h / refinement, nz * refinement,
                   h / refinement)  # fmt: skip
    centres = np.s_[(slice(None), *[slice(refinement // 2, None, refinement)] * 3)]
    reference = fast(fine, zone_strain(fine, fields), image_tol=1e-4)[centres]
    strain = zone_strain(grid, fields)
    return [
        rms(stress - reference) / rms(reference)
        for stress in (exact(grid, strain), fast(grid, strain))
    ]


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize(
    ("cells", "refinement"),
    [
        (8, 5),
        pytest.param(16, 5, marks=pytest.mark.slow),
        pytest.param(32, 3, marks=pytest.mark.slow),
    ],
)
def test_the_fast_method_is_as_accurate_as_the_exact_one(law, cells, refinement):
    of_exact, of_fast = zone_errors(law, cells, refinement)
    assert of_fast <= of_exact < 2.0 / cells**1.5


def test_bad_arguments():
    grid = sc.Grid(4, 4, 1.0, 1.0, 4, 1.0)
    strain = np.zeros((6, 4, 4, 4))
    with pytest.raises(ValueError, match="method must be one of"):
        operators.residual_stress(grid, strain, E, NU, method="best")
    with pytest.raises(ValueError, match=r"image_tol must be in \[1e-6, 0.1\], got 0.5"):
        operators.residual_stress(grid, strain, E, NU, method="fast", image_tol=0.5)
