# SPDX-License-Identifier: GPL-3.0-or-later
"""Grid operators against the plain sum over rectangles and cuboids of the same influence
coefficients.

Both sides use the same coefficients, so only the rounding of the transforms remains: 1e-10 of the
largest value.
"""

import numpy as np
import pytest

import samcontact as sc
from samcontact import kernels, operators

E, NU = 210e9, 0.3
TOLERANCE = 1e-10
# Square, prime, long, one row, one cell.
PLANES = ((8, 8), (7, 11), (13, 5), (16, 3), (1, 9), (1, 1))


def make_grid(nx, ny, nz=0):
    return sc.Grid(nx, ny, 2.0e-5, 3.1e-5, nz, 1.3e-5 if nz else None)


def random(*shape, seed=0):
    return np.random.default_rng(seed).standard_normal(shape)


def offsets(grid):
    """Every difference of cell centres, X (2 nx - 1, 1) and Y (1, 2 ny - 1)."""
    x = np.arange(1 - grid.nx, grid.nx) * grid.dx
    y = np.arange(1 - grid.ny, grid.ny) * grid.dy
    return x[:, None], y[None, :]


def plane_sum(kernel, source):
    """Return sum_j kernel[..., i - j] source[j] by a loop over the sources."""
    nx, ny = source.shape
    total = np.zeros((*kernel.shape[:-2], nx, ny))
    for i in range(nx):
        for j in range(ny):
            seen = kernel[..., nx - 1 - i : 2 * nx - 1 - i, ny - 1 - j : 2 * ny - 1 - j]
            total += source[i, j] * seen
    return total


def direct_displacement(grid, pressure, shear_x, shear_y, axis="z"):
    place = (*offsets(grid), grid.dx / 2, grid.dy / 2, E, NU)
    return (
        plane_sum(kernels.pressure_displacement(*place, axis=axis), pressure)
        + plane_sum(kernels.shear_displacement(*place, along="x", axis=axis), shear_x)
        + plane_sum(kernels.shear_displacement(*place, along="y", axis=axis), shear_y)
    )


def direct_stress(grid, pressure, shear_x, shear_y, depths):
    X, Y = offsets(grid)
    a, b = grid.dx / 2, grid.dy / 2
    layers = [
        plane_sum(kernels.pressure_stress(X, Y, z, a, b, NU), pressure)
        + plane_sum(kernels.shear_stress(X, Y, z, a, b, NU), shear_x)
        + plane_sum(kernels.shear_stress(X, Y, z, a, b, NU, along="y"), shear_y)
        for z in depths
    ]
    return np.stack(layers, axis=-1)


def direct_residual_stress(grid, strain, nu=NU):
    X, Y = offsets(grid)
    half = (grid.dx / 2, grid.dy / 2, grid.dz / 2)
    total = np.zeros_like(strain)
    for k, z in enumerate(grid.z):
        for source, zc in enumerate(grid.z):
            kernel = kernels.eigenstrain_stress(X, Y, z, zc, *half, E, nu)
            for component in range(6):
                total[..., k] += plane_sum(kernel[:, component], strain[component, :, :, source])
    return total


def direct_residual_displacement(grid, strain, nu=NU, axis="z"):
    X, Y = offsets(grid)
    half = (grid.dx / 2, grid.dy / 2, grid.dz / 2)
    total = np.zeros((grid.nx, grid.ny))
    for source, zc in enumerate(grid.z):
        kernel = kernels.eigenstrain_displacement(X, Y, zc, *half, nu, axis=axis)
        for component in range(6):
            total += plane_sum(kernel[component], strain[component, :, :, source])
    return total


def assert_close(actual, expected, tolerance=TOLERANCE):
    assert actual.shape == expected.shape
    assert np.abs(actual - expected).max() <= tolerance * np.abs(expected).max()


@pytest.mark.parametrize("plane", PLANES)
def test_surface_displacement_is_the_direct_sum(plane):
    grid = make_grid(*plane)
    p, sx, sy = random(3, *plane)
    zero = np.zeros(plane)
    actual = operators.surface_displacement(grid, p, E, NU)
    assert_close(actual, direct_displacement(grid, p, zero, zero))
    actual = operators.surface_displacement(grid, p, E, NU, shear=sx)
    assert_close(actual, direct_displacement(grid, p, sx, zero))
    for axis in "xyz":
        actual = operators.surface_displacement(grid, p, E, NU, shear=[sx, sy], axis=axis)
        assert_close(actual, direct_displacement(grid, p, sx, sy, axis))


@pytest.mark.parametrize("plane", PLANES)
def test_surface_stress_is_the_direct_sum(plane):
    grid = make_grid(*plane)
    p, sx, sy = random(3, *plane)
    zero = np.zeros(plane)
    depths = [0.0, 3e-6, 2e-5, 4e-4]
    actual = operators.surface_stress(grid, p, depths, NU)
    assert_close(actual, direct_stress(grid, p, zero, zero, depths))
    actual = operators.surface_stress(grid, p, depths, NU, shear=sx)
    assert_close(actual, direct_stress(grid, p, sx, zero, depths))
    actual = operators.surface_stress(grid, p, depths, NU, shear=np.array([sx, sy]))
    assert_close(actual, direct_stress(grid, p, sx, sy, depths))


def test_each_depth_is_as_accurate_as_the_largest():
    """The stress at a depth of 100 cells is small, and still accurate to 1e-9 of its value."""
    grid = make_grid(9, 7)
    p = np.abs(random(9, 7))
    zero = np.zeros((9, 7))
    for depth in (0.0, 2e-4, 2e-3):
        actual = operators.surface_stress(grid, p, [depth], NU)
        assert_close(actual, direct_stress(grid, p, zero, zero, [depth]), 1e-9)


def test_surface_stress_at_the_surface_returns_the_tractions():
    grid = make_grid(11, 6)
    p, sx, sy = random(3, 11, 6)
    stress = operators.surface_stress(grid, p, [0.0], NU, shear=np.array([sx, sy]))[..., 0]
    np.testing.assert_allclose(stress[2], -p, atol=1e-12)
    np.testing.assert_allclose(stress[3], -sy, atol=1e-12)
    np.testing.assert_allclose(stress[4], -sx, atol=1e-12)


@pytest.mark.parametrize(
    "shape", [(6, 6, 4), (5, 7, 3), (11, 3, 2), (1, 4, 5), (4, 4, 1), (1, 1, 1)]
)
@pytest.mark.parametrize("nu", [0.0, 0.3, 0.49])
def test_residual_operators_are_the_direct_sum(shape, nu):
    grid = make_grid(*shape)
    strain = random(6, *shape)
    actual = operators.residual_stress(grid, strain, E, nu)
    assert_close(actual, direct_residual_stress(grid, strain, nu))
    for axis in "xyz":
        actual = operators.residual_displacement(grid, strain, nu, axis=axis)
        assert_close(actual, direct_residual_displacement(grid, strain, nu, axis))


@pytest.mark.parametrize("component", range(6))
def test_one_cell_of_one_component_gives_the_influence_coefficient(component):
    """A unit source off the middle reveals every error of sign, order and index."""
    grid = make_grid(6, 5, 4)
    i, j, k = 1, 3, 2
    strain = np.zeros((6, 6, 5, 4))
    strain[component, i, j, k] = 1.0
    half = (grid.dx / 2, grid.dy / 2, grid.dz / 2)
    X = (grid.x - grid.x[i])[:, None, None]
    Y = (grid.y - grid.y[j])[None, :, None]
    stress = kernels.eigenstrain_stress(X, Y, grid.z[None, None, :], grid.z[k], *half, E, NU)
    assert_close(operators.residual_stress(grid, strain, E, NU), stress[:, component])
    for axis in "xyz":
        u = kernels.eigenstrain_displacement(X[..., 0], Y[..., 0], grid.z[k], *half, NU, axis=axis)
        found = operators.residual_displacement(grid, strain, NU, axis=axis)
        assert_close(found, u[component])


def test_wide_layer_is_in_biaxial_stress():
    """Uniform eigenstrain of a wide layer: -E eps/(1 - nu) far from its rim, no stress across it.

    The forces at the rim, and therefore the error inside, are proportional to the thickness:
    measured 1.1 % at 1/100 of the half width.
    """
    deviations = []
    for dz in (1e-6, 0.5e-6):
        grid = sc.Grid(41, 41, 1e-5, 1e-5, 2, dz)
        strain = np.zeros((6, 41, 41, 2))
        strain[0] = strain[1] = 1e-3
        stress = operators.residual_stress(grid, strain, E, NU)[:, 20, 20]
        stress = stress / (-E / (1.0 - NU) * 1e-3)
        assert np.abs(stress[2:]).max() < 1e-5
        np.testing.assert_allclose(stress[0], stress[1], rtol=1e-10)
        deviations.append(1.0 - stress[0, 0])
    assert 0.0 < deviations[0] < 1.5e-2
    assert deviations[0] / deviations[1] == pytest.approx(2.0, rel=1e-2)


def test_linearity():
    grid = make_grid(7, 6, 3)
    p, q = random(2, 7, 6)
    e, f = random(2, 6, 7, 6, 3)

    def all_of(pressure, strain):
        return (
            operators.surface_displacement(grid, pressure, E, NU, shear=0.3 * pressure),
            operators.surface_stress(grid, pressure, grid.z, NU, shear=0.3 * pressure),
            operators.residual_stress(grid, strain, E, NU),
            operators.residual_displacement(grid, strain, NU),
        )

    combined = all_of(2.0 * p - 3.0 * q, 2.0 * e - 3.0 * f)
    for total, one, other in zip(combined, all_of(p, e), all_of(q, f), strict=True):
        assert_close(total, 2.0 * one - 3.0 * other, 1e-13)


def test_memory_order_of_the_input_does_not_matter():
    grid = make_grid(7, 6, 3)
    p, strain = random(7, 6), random(6, 7, 6, 3)
    padded = np.zeros((14, 6))
    padded[::2] = p
    u = operators.surface_displacement(grid, p, E, NU)
    for same in (np.asfortranarray(p), padded[::2]):
        np.testing.assert_array_equal(operators.surface_displacement(grid, same, E, NU), u)
    stress = operators.residual_stress(grid, strain, E, NU)
    depth_first = np.ascontiguousarray(strain.transpose(0, 3, 1, 2)).transpose(0, 2, 3, 1)
    for same in (np.asfortranarray(strain), depth_first):
        np.testing.assert_array_equal(operators.residual_stress(grid, same, E, NU), stress)


def test_inputs_are_not_changed():
    grid = make_grid(7, 6, 3)
    p, strain = random(7, 6), random(6, 7, 6, 3)
    p_before, strain_before = p.copy(), strain.copy()
    operators.surface_displacement(grid, p, E, NU, shear=p)
    operators.surface_stress(grid, p, [0.0, 1e-5], NU, shear=p)
    operators.residual_stress(grid, strain, E, NU)
    operators.residual_displacement(grid, strain, NU)
    np.testing.assert_array_equal(p, p_before)
    np.testing.assert_array_equal(strain, strain_before)


def test_wrong_shapes_are_rejected():
    grid = make_grid(7, 6, 3)
    with pytest.raises(ValueError, match=r"7.*6"):
        operators.surface_displacement(grid, np.zeros((6, 7)), E, NU)
    with pytest.raises(ValueError, match=r"7.*6"):
        operators.surface_stress(grid, np.zeros((7, 6)), [0.0], NU, shear=np.zeros((3, 7, 6)))
    with pytest.raises(ValueError, match=r"6.*7.*6.*3"):
        operators.residual_stress(grid, np.zeros((6, 7, 6, 2)), E, NU)
    with pytest.raises(ValueError, match=r"6.*7.*6.*3"):
        operators.residual_displacement(grid, np.zeros((5, 7, 6, 3)), NU)
    for call in (
        lambda: operators.residual_displacement(grid, np.zeros((6, 7, 6, 3)), NU, axis="w"),
        lambda: operators.surface_displacement(grid, np.zeros((7, 6)), E, NU, axis=0),
        lambda: kernels.pressure_displacement(0.0, 0.0, 1.0, 1.0, E, NU, axis="xy"),
    ):
        with pytest.raises(ValueError, match="axis must be one of 'x', 'y', 'z', got"):
            call()
    with pytest.raises(ValueError, match="along must be one of 'x', 'y', got 'z'"):
        kernels.shear_displacement(0.0, 0.0, 1.0, 1.0, E, NU, along="z")


@pytest.mark.parametrize(("axes", "components"), [((0, 1), (0, 1)), ((0, 2), (0, 2))])
def test_stress_at_the_centres_of_an_alternating_strain(axes, components):
    """Point values have a stress of the wrong sign, as docs/theory/accuracy.md states."""
    grid = sc.Grid(16, 16, 1e-5, 1e-5, 16, 1e-5)
    index = np.indices(grid.volume_shape)
    pattern = (-1.0) ** (index[axes[0]] + index[axes[1]])
    strain = np.zeros((6, *grid.volume_shape))
    strain[components[0]], strain[components[1]] = pattern, -pattern
    stress = operators.residual_stress(grid, strain, E, NU)
    work = (stress[components[0]] - stress[components[1]]) / 2 * pattern
    assert work[8, 8, 8] / (E / (1 + NU)) == pytest.approx(0.28, abs=0.005)
