# SPDX-License-Identifier: GPL-3.0-or-later
"""Surface displacements in all directions against closed forms and Betti's theorem."""

import numpy as np
import pytest

import samcontact as sc

E, NU = 210e9, 0.3
G = E / (2 * (1 + NU))
STEEL, CERAMIC = sc.Material.elastic(E, NU), sc.Material.elastic(310e9, 0.2)
A, P0 = 1e-3, 1e9


def hertzian(cells):
    """Return a grid with `cells` per radius, its x and y, and the traction P0 sqrt(1 - r^2/A^2)."""
    n = 3 * cells + 1
    grid = sc.Grid(n, n, A / cells, A / cells)
    x, y = np.meshgrid(grid.x, grid.y, indexing="ij")
    return grid, x, y, P0 * np.sqrt(np.maximum(1 - (x**2 + y**2) / A**2, 0))


def along_shear(x, y):
    """Return u_x, u_y inside the circle under shear s_x: Johnson (1985), eq. (3.91)."""
    unit = np.pi * P0 / (32 * G * A)
    u_x = unit * (4 * (2 - NU) * A**2 - (4 - 3 * NU) * x**2 - (4 - NU) * y**2)
    return u_x, 2 * unit * NU * x * y


def under_pressure(x, y):
    """Return u_x, u_y, u_z inside the circle under pressure: Johnson (1985), eq. (3.41)."""
    r2 = np.maximum(x**2 + y**2, 1e-30)
    inwards = (1 - 2 * NU) * (1 + NU) * A**2 * P0 / (3 * E * r2)
    inwards = inwards * (1 - np.maximum(1 - r2 / A**2, 0) ** 1.5)
    u_z = (1 - NU**2) * np.pi * P0 * (2 * A**2 - r2) / (4 * E * A)
    return -inwards * x, -inwards * y, u_z


def errors(cells):
    """Return maximum errors inside the circle over maximum displacements, by case and component."""
    grid, x, y, traction = hertzian(cells)
    solver = sc.ContactSolver(grid, sc.Material.rigid(), STEEL)
    inside = x**2 + y**2 <= A**2
    none = np.zeros(grid.surface_shape)
    found = {
        "pressure": (solver.displacement(traction), under_pressure(x, y)),
        "shear_x": (solver.displacement(none, traction)[:2], along_shear(x, y)),
        "shear_y": (
            solver.displacement(none, [none, traction])[:2],
            along_shear(y, x)[::-1],
        ),
    }
    return {
        name: [
            np.abs(u - v)[inside].max() / np.abs(v)[inside].max()
            for u, v in zip(actual, exact, strict=True)
        ]
        for name, (actual, exact) in found.items()
    }


def test_hertzian_tractions_move_the_surface_as_their_closed_forms_do():
    # uniform cells miss the square root at the edge, an error of order (cell)^1.5
    coarse, fine = errors(10), errors(40)
    for name, of_components in fine.items():
        assert max(of_components) < 0.003, name
        assert max(of_components) < 0.25 * max(coarse[name]), name


def test_work_of_one_traction_on_the_displacement_of_another_is_mutual():
    grid = sc.Grid(14, 11, 2e-5, 3e-5)
    solver = sc.ContactSolver(grid, CERAMIC, STEEL)
    random = np.random.default_rng(3)
    first, second = random.normal(size=(2, 3, *grid.surface_shape)) * 1e8
    for body in (1, 2):
        sign = np.reshape([-1, -1, 1] if body == 1 else [1, 1, 1], (3, 1, 1))

        def move(tractions, body=body):
            return solver.displacement(tractions[2], tractions[:2], body)

        one, other = np.sum(sign * first * move(second)), np.sum(sign * second * move(first))
        assert one == pytest.approx(other, rel=1e-11)
        assert np.sum(sign * first * move(first)) > 0


def test_shear_on_body_1_has_the_opposite_sign():
    grid = sc.Grid(9, 8, 1e-5, 1e-5)
    solver = sc.ContactSolver(grid, STEEL, STEEL)
    shear = np.zeros((2, *grid.surface_shape))
    shear[0, 3, 4], shear[1, 5, 2] = 1e8, 2e8
    none = np.zeros(grid.surface_shape)
    upper, lower = (solver.displacement(none, shear, body) for body in (1, 2))
    np.testing.assert_array_equal(upper, -lower)
    assert lower[0, 3, 4] > 0
    assert lower[1, 5, 2] > 0


def test_default_shear_is_that_of_friction():
    grid = sc.Grid(9, 8, 1e-5, 1e-5)
    pressure = np.zeros(grid.surface_shape)
    pressure[4, 4] = 1e8
    solver = sc.ContactSolver(grid, STEEL, CERAMIC, friction=0.3)
    for body in (1, 2):
        given = solver.displacement(pressure, 0.3 * pressure, body)
        np.testing.assert_array_equal(solver.displacement(pressure, body=body), given)
        of_pressure = solver.displacement(pressure, np.zeros(grid.surface_shape), body)
        assert np.abs(given - of_pressure).max() > 0
    smooth = sc.ContactSolver(grid, STEEL, CERAMIC)
    np.testing.assert_array_equal(smooth.displacement(pressure), of_pressure)


def test_a_rigid_body_has_zero_displacement_and_other_bodies_are_refused():
    grid = sc.Grid(9, 8, 1e-5, 1e-5)
    solver = sc.ContactSolver(grid, sc.Material.rigid(), STEEL)
    assert not solver.displacement(np.ones(grid.surface_shape), body=1).any()
    with pytest.raises(ValueError, match="body"):
        solver.displacement(np.ones(grid.surface_shape), body=3)
    with pytest.raises(ValueError, match="shear"):
        solver.displacement(np.ones(grid.surface_shape), np.ones((3, *grid.surface_shape)))
