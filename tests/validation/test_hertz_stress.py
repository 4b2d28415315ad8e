# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic stress under a Hertz pressure sampled at cell centres, 32 cells per contact radius.

Sampling causes errors at the rim, where the pressure rises like a square root: (dx/a)**1.5 in the
cells there, and much less below; the tolerances are about twice the measured errors. The
reference values come from quadrature of the point-load solutions (tests/oracles/hertz_stress.py).
"""

import numpy as np
import pytest

import samcontact as sc
from oracles import hertz_stress
from samcontact import operators

A, P0, NU = 1e-3, 2e9, 0.3
CELLS = 32
TABLE = "Stress under a Hertz pressure"


def sampled(cells):
    """Return a grid with a row at y = 0, and the Hertz pressure at its cell centres."""
    n = 2 * cells + 3
    grid = sc.Grid(n, n, A / cells, A / cells)
    r2 = (grid.x[:, None] ** 2 + grid.y[None, :] ** 2) / A**2
    return grid, P0 * np.sqrt(np.maximum(1.0 - r2, 0.0))


def parabolic(values, positions, index):
    """Return maximum and position of the parabola through three equidistant points."""
    left, middle, right = values[index - 1 : index + 2]
    step = positions[index + 1] - positions[index]
    curvature = left - 2.0 * middle + right
    offset = 0.5 * (left - right) / curvature
    return middle - 0.125 * (left - right) ** 2 / curvature, positions[index] + offset * step


@pytest.mark.parametrize(
    ("friction", "expected", "x_expected", "z_expected"),
    [(0.0, 0.62004, 0.0, 0.4809), (0.2, 0.63766, 0.2192, 0.4571), (0.3, 0.65976, 0.3188, 0.4282)],
)
def test_largest_von_mises_stress(friction, expected, x_expected, z_expected, measured):
    grid, pressure = sampled(CELLS)
    depths = np.linspace(0.36, 0.54, 10) * A
    stress = operators.surface_stress(grid, pressure, depths, NU, shear=friction * pressure)
    middle = hertz_stress.von_mises(stress)[:, grid.ny // 2] / P0
    i, k = np.unravel_index(np.argmax(middle), middle.shape)
    value_z, z = parabolic(middle[i], depths / A, k)
    value_x, x = parabolic(middle[:, k], grid.x / A, i)
    value = value_z + value_x - middle[i, k]
    name, mesh = f"maximum von Mises stress, μ = {friction:g}", f"a/{CELLS}"
    measured.close(TABLE, name, value, expected, unit="p0", rel=2e-4, mesh=mesh)
    # The maximum is flat: 1e-3 of its value is 0.02 a of its place.
    for axis, found, at in (("x", x, x_expected), ("z", z, z_expected)):
        measured.close(TABLE, f"position {axis} of this maximum, μ = {friction:g}", found, at,
                       unit="a", abs=5e-3, mesh=mesh)  # fmt: skip


@pytest.mark.parametrize("friction", [(0.0, 0.0), (0.25, 0.0), (0.0, 0.25)], ids=["0", "x", "y"])
def test_all_components_at_points(friction, measured):
    grid, pressure = sampled(CELLS)
    depths = np.array([0.2, 0.6, 1.5])
    shear = np.multiply.outer(friction, pressure)
    stress = operators.surface_stress(grid, pressure, depths * A, NU, shear=shear) / P0
    largest = 0.0
    for i, j, k in ((33, 33, 0), (43, 46, 1), (20, 60, 1), (65, 33, 1), (50, 10, 2)):
        x, y = grid.x[i] / A, grid.y[j] / A
        expected = hertz_stress.stress(x, y, depths[k], friction[0], NU)
        if friction[1]:
            turned = hertz_stress.stress(y, x, depths[k], friction[1], NU)
            expected = turned[[1, 0, 2, 4, 3, 5]]
        largest = max(largest, np.abs(stress[:, i, j, k] - expected).max())
    direction = {(0.0, 0.0): "no friction", (0.25, 0.0): "μ = 0.25 along x"}
    name = f"all components, largest error, {direction.get(friction, 'μ = 0.25 along y')}"
    measured.close(TABLE, name, largest, 0, unit="p0", abs=6e-4, mesh=f"a/{CELLS}")


def test_error_falls_with_the_grid():
    """Better than order 1.5 from 8 to 32 cells per radius, at fixed points of the material."""
    errors = []
    for cells in (8, 32):
        grid, pressure = sampled(cells)
        stress = operators.surface_stress(grid, pressure, [0.48 * A], NU)[..., 0] / P0
        centre = grid.nx // 2
        error = 0.0
        for eighths in range(-6, 7, 2):
            i = centre + eighths * cells // 8
            expected = hertz_stress.stress(eighths / 8, 0.0, 0.48, 0.0, NU)
            error = max(error, np.abs(stress[:, i, centre] - expected).max())
        errors.append(error)
    assert errors[1] < errors[0] / 8.0
