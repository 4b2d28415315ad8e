# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress history of a body under films: a steady pass, and places between cells."""

import warnings

import numpy as np
import pytest

import samcontact as sc
from samcontact.lubrication.pass_stress import moved

STEEL = sc.Material.elastic(207e9, 0.3)
OIL = sc.Lubricant.roelands(viscosity=0.04, pressure_viscosity=20e-9).with_eyring(5e6)
R, LOAD = 0.01, 30.0
A = sc.hertz.point(R, 113.7e9, load=LOAD).a
GRID = sc.Grid(40, 24, A / 8, A / 8)
Z = np.array([0.3, 0.5, 0.8]) * A


@pytest.fixture(scope="module")
def films():
    """Return films whose surfaces move by a cell in each step, body 2 slower by 5 %."""
    x, y = GRID.x[:, None], GRID.y[None, :]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        start = sc.lubrication.steady(
            GRID, STEEL, STEEL, 0.5 * (x**2 + y**2) / R, load=LOAD, speed=(1.1, 1.0),
            lubricant=OIL, order=1,
        )  # fmt: skip
    run = sc.lubrication.transient(start, duration=39 * GRID.dx, steps=39, order=1)
    return run.solutions


def test_points_that_pass_through_a_steady_film_have_its_cycle(films):
    """Dang Van's criterion of the history is that of the material that moves through one film."""
    history = sc.lubrication.pass_stress(films, z=Z)
    friction = sc.lubrication.friction(films[0])
    solver = sc.ContactSolver(GRID, STEEL, STEEL)
    steady = solver.stress(films[0].pressure, Z, shear=friction.fluid_shear)
    # the points of the first row pass through all others
    expected = sc.fatigue.dang_van(sc.fatigue.steady_cycle(steady[:, 1:]), slope=0.3)
    found = sc.fatigue.dang_van(history, slope=0.3)
    np.testing.assert_allclose(found.values[0], expected.values, rtol=1e-3)
    assert found.values[0].max() > 0.1 * films[0].pressure.max()


def test_the_shear_on_body_1_is_reversed(films):
    """Half the difference of both stresses is that of the shear, which drives body 2."""
    film = films[0]
    pair = [sc.lubrication.pass_stress(films[:2], z=Z, body=n)[0] for n in (1, 2)]
    pair = [moved(one, -film.past.ways[n, 0], GRID) for n, one in enumerate(pair)]
    solver = sc.ContactSolver(GRID, STEEL, STEEL)
    shear = sc.lubrication.friction(film).fluid_shear
    alone = solver.stress(np.zeros(film.film.shape), Z, shear=shear)
    inside = np.s_[:, 5:35]
    difference, alone = 0.5 * (pair[1] - pair[0])[inside], alone[inside]
    # that of body 1 was interpolated between cells
    assert np.vdot(difference, alone) / np.vdot(alone, alone) == pytest.approx(1.0, rel=0.05)


def test_places_between_cells_are_linear():
    field = np.zeros((1, 40, 1, 1))
    field[0, :, 0, 0] = np.arange(40.0)
    for way in (0.0, 1.0, 2.25, -3.5):
        shifted = moved(field, way * GRID.dx, GRID)[0, :, 0, 0]
        inside = slice(5, 35)
        np.testing.assert_allclose(shifted[inside], np.arange(40.0)[inside] + way, atol=1e-12)
    assert not moved(field, 60 * GRID.dx, GRID).any()


def test_wrong_arguments_are_refused(films):
    with pytest.raises(ValueError, match="at least two films"):
        sc.lubrication.pass_stress(films[:1], z=Z)
    with pytest.raises(ValueError, match="films of one history"):
        sc.lubrication.pass_stress([films[0], sc.lubrication.steady(
            GRID, STEEL, STEEL, films[0].gap, load=LOAD, speed=(1.0, 1.0), lubricant=OIL, order=1,
        )], z=Z)  # fmt: skip
