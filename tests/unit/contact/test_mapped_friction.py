# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction that depends on the place: bounds of the cells, motion with a body, rolling."""

import math

import numpy as np
import pytest

import samcontact as sc

STEEL = sc.Material.elastic(210e9, 0.3)
BRASS = sc.Material.elastic(100e9, 0.2)
GRID = sc.Grid(28, 28, 36e-6, 36e-6)
GAP = sc.surfaces.paraboloid(GRID, 7.5e-3)
LOAD = 300.0
X, Y = GRID.x[:, None], GRID.y[None, :]
ACROSS = sc.MappedCoulomb([0.2, 0.4], y=[-1e-4, 2e-4])
BOTH = sc.MappedCoulomb([[0.1, 0.3], [0.5, 0.2]], x=[-2e-4, 2e-4], y=[-1e-4, 3e-4])


def coefficient(law, moved=0.0):
    """Coefficients on the cells by NumPy, along y and then along x."""
    table = np.reshape(law.coefficient, (max(len(law.x), 1), max(len(law.y), 1)))
    rows = [np.interp(GRID.y, law.y, row) if law.y else np.full(GRID.ny, row[0]) for row in table]
    if not law.x:
        return np.tile(rows[0], (GRID.nx, 1))
    columns = [np.interp(GRID.x + moved, law.x, column) for column in np.transpose(rows)]
    return np.transpose(columns)


@pytest.mark.parametrize("body1", [STEEL, BRASS], ids=["identical", "dissimilar"])
@pytest.mark.parametrize("law", [ACROSS, BOTH], ids=["across", "both"])
def test_cells_slip_at_the_coefficient_of_their_place(body1, law):
    solver = sc.ContactSolver(GRID, body1, STEEL, law, tol=1e-10)
    shift = np.array([1.0e-6, 0.5e-6])
    found = solver.solve(GAP, load=LOAD, shift=shift)
    slip = (
        shift[:, None, None]
        - (
            solver.displacement(found.pressure, found.shear, 2)
            - solver.displacement(found.pressure, found.shear, 1)
        )[:2]
    )
    pressed, size = found.pressure > 0, np.hypot(*found.shear)
    bound = coefficient(law) * found.pressure
    slips = pressed & ~found.sticking
    assert 0.1 < slips.sum() / pressed.sum() < 0.9
    np.testing.assert_allclose(size[slips], bound[slips], rtol=1e-9)
    assert (size[pressed] <= bound[pressed] * (1 + 1e-9)).all()
    length = np.hypot(*slip)
    assert length[found.sticking].max() < 1e-5 * length[pressed].max()
    along = (slip * found.shear).sum(axis=0)[slips]
    np.testing.assert_allclose(along, (length * size)[slips], atol=1e-5 * (length * size).max())


def test_a_uniform_map_is_coulomb_friction():
    one, other = (
        sc.ContactSolver(GRID, BRASS, STEEL, law).solve(GAP, load=LOAD, shift=(1e-6, 0.0))
        for law in (sc.Coulomb(0.3), sc.MappedCoulomb([0.3]))
    )
    for name in ("pressure", "shear", "slip", "sticking"):
        assert np.array_equal(getattr(one, name), getattr(other, name))


def test_cells_without_friction_carry_no_shear():
    law = sc.MappedCoulomb([0.0, 0.0, 0.3, 0.3], y=[-1.0, -1e-9, 0.0, 1.0])
    found = sc.ContactSolver(GRID, STEEL, STEEL, law).solve(GAP, load=LOAD, shift=(1e-6, 0.0))
    assert np.hypot(*found.shear)[:, GRID.y < 0].max() < 1e-8 * found.pressure.max()
    assert found.tangential_load[0] > 0


@pytest.mark.parametrize("body", [1, 2])
def test_the_coefficients_move_with_their_body(body):
    law = sc.MappedCoulomb([0.1, 0.4], x=[-3e-4, 3e-4], body=body)
    run = sc.Simulation(GRID, STEEL, STEEL, GAP, law)
    run.step(load=LOAD)
    step = 3 * GRID.dx
    travels = [0.0, 0.0]
    for advance in ((-step, -step), (-step, -step), (GRID.dx, 0.0)):
        state = run.step(load=LOAD, advance=advance, shift=(1e-3, 0.0))
        travels = [travels[n] + advance[n] for n in range(2)]
        pressed = state.pressure > 0
        # material that has moved by s towards +x was at x - s
        expected = coefficient(law, -travels[body - 1])[pressed]
        np.testing.assert_allclose(
            np.hypot(*state.shear)[pressed] / state.pressure[pressed], expected, rtol=1e-6
        )


def test_steady_rolling_with_friction_that_varies_across():
    drive = {"load": LOAD, "creepage": (1e-3, 0.0)}
    found = sc.rolling.steady(GRID, BRASS, STEEL, GAP, friction=ACROSS, **drive)
    bound = coefficient(ACROSS) * found.pressure
    size, slips = np.hypot(*found.shear), (found.pressure > 0) & ~found.sticking
    np.testing.assert_allclose(size[slips], bound[slips], rtol=1e-9)
    assert (size <= bound * (1 + 1e-9)).all()
    assert found.sticking.any()
    solver = sc.ContactSolver(GRID, BRASS, STEEL, ACROSS)
    rolled = solver.solve(GAP, load=LOAD, previous=found, advance=(-GRID.dx, -GRID.dx),
                          shift=(1e-3 * GRID.dx, 0.0))  # fmt: skip
    np.testing.assert_allclose(rolled.shear, found.shear, atol=1e-4 * size.max())
    with pytest.raises(ValueError, match=r"^friction must not vary along x in steady rolling"):
        sc.rolling.steady(GRID, STEEL, STEEL, GAP, friction=BOTH, **drive)


def test_a_contact_solver_refuses_to_move_a_map_along_x():
    solver = sc.ContactSolver(GRID, STEEL, STEEL, BOTH)
    first = solver.solve(GAP, load=LOAD)
    with pytest.raises(ValueError, match=r"^advance must be \(0, 0\) with friction that varies"):
        solver.solve(GAP, load=LOAD, previous=first, advance=(-GRID.dx, -GRID.dx))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"coefficient": [0.3, 0.2]}, "x, y must define as many points"),
        ({"coefficient": []}, "x, y must define as many points"),
        (
            {"coefficient": [0.3, -0.2], "x": [0, 1]},
            r"coefficient\[1\] must be a finite number >= 0",
        ),
        ({"coefficient": [0.3, 0.2], "x": [0, 0]}, r"x\[1\] must be larger than x\[0\]"),
        ({"coefficient": [0.3, 0.2], "y": [0, math.inf]}, r"y\[1\] must be a finite number"),
        ({"coefficient": [0.3], "body": 3}, r"body must be in \[1, 2\]"),
        ({"coefficient": [0.3], "body": 1.5}, "body must be 1 or 2"),
    ],
)
def test_refused_maps(arguments, message):
    with pytest.raises(ValueError, match=f"^{message}"):
        sc.MappedCoulomb(**arguments)
