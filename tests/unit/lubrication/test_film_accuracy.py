# SPDX-License-Identifier: GPL-3.0-or-later
"""Films to a prescribed accuracy: true errors against published films, and messages."""

import warnings

import numpy as np
import pytest

import samcontact as sc
from samcontact.lubrication.film_accuracy import grid_errors

E_STAR, R, ETA, ALPHA = 113.74e9, 0.01, 0.04, 22e-9
STEEL = sc.Material.elastic(2 * E_STAR * 0.91, 0.3)
OIL = sc.Lubricant.roelands(ETA, ALPHA)


def line_film(accuracy, cells=48, M=10.0, L=10.0, **more):
    """Return the film of a line contact, and Moes' scale of films."""
    group = (L / (ALPHA * 2 * E_STAR)) ** 4
    u, load = group * E_STAR * R / ETA, M * 2 * E_STAR * R * np.sqrt(group)
    b = np.sqrt(4 * load * R / (np.pi * E_STAR))
    grid = sc.Grid(cells, 1, 6 * b / cells, 1e-3, periodic="y")
    film = sc.lubrication.steady(
        grid, STEEL, STEEL, lambda on: sc.surfaces.paraboloid(on, R, np.inf), load=1e-3 * load,
        speed=(u, u), lubricant=OIL, accuracy=accuracy, **more,
    )  # fmt: skip
    return film, R * np.sqrt(group)


@pytest.mark.parametrize(
    ("M", "central", "minimum"), [(10.0, 4.796, 4.0925), (100.0, 3.4095, 3.09)]
)
@pytest.mark.parametrize("accuracy", [0.03, 0.008])
def test_true_errors_of_line_contacts_are_below_the_stated_ones(M, central, minimum, accuracy):
    """Films of other finite volumes with 1024 cells, themselves accurate to 0.3 %."""
    film, scale = line_film(accuracy, M=M)
    for value, error, reference in zip(
        (film.central_film, film.minimum_film), film.errors, (central, minimum), strict=True
    ):
        assert error <= accuracy * value
        assert abs(value / scale - reference) <= error / scale + 3e-3 * reference
    assert "±" in str(film)


def test_a_short_inlet_is_enlarged():
    film, _ = line_film({"central_film": 0.003})
    short, _ = line_film({"central_film": 0.1})
    given = short.grid.nx * short.grid.dx
    assert film.grid.nx * film.grid.dx > 1.4 * given
    change = abs(film.central_film - short.central_film)
    assert change <= film.errors.central_film + short.errors.central_film


def test_errors_of_values_that_converge_with_order_1_5_are_covered():
    sizes = 2.0 ** (-0.5 * np.arange(5))
    values = 3.0 + 0.2 * sizes[:, None] ** 1.5 * np.array([1.0, -1.0])
    true = np.abs(values[-1] - 3.0) / values[-1]
    found = grid_errors(values)
    assert np.all(found >= true)
    assert np.all(found <= 2 * true)


def test_an_accuracy_out_of_reach_is_reported(monkeypatch):
    monkeypatch.setattr(sc.lubrication.film_accuracy, "MAX_CELLS_OF_LINE", 200)
    with pytest.warns(sc.AccuracyWarning, match="relax the accuracy"):
        film, _ = line_film(1e-4)
    assert film.errors.central_film > 1e-4 * film.central_film


@pytest.mark.slow
@pytest.mark.parametrize(("M", "width"), [(200.0, 4.0), (20.0, 8.0)])
def test_true_errors_of_balls_are_below_the_stated_ones(M, width):
    """Central films: 3.638 and 4.184 on the finest grids of other finite volumes."""
    group = (10 / (ALPHA * 2 * E_STAR)) ** 4
    u, load = 0.5 * group * 2 * E_STAR * R / ETA, M * 2 * E_STAR * R**2 * group**0.75
    a = (0.75 * load * R / E_STAR) ** (1 / 3)
    grid = sc.Grid(48, 48, width * a / 48, width * a / 48)
    film = sc.lubrication.steady(
        grid, STEEL, STEEL, lambda on: sc.surfaces.paraboloid(on, R), load=load, speed=(u, u),
        lubricant=OIL, accuracy={"central_film": 0.02},
    )  # fmt: skip
    reference = {200.0: 3.638, 20.0: 4.184}[M] * R * np.sqrt(group)
    assert abs(film.central_film - reference) <= film.errors.central_film + 5e-3 * reference


@pytest.mark.parametrize(
    ("accuracy", "error", "words"),
    [
        ({"peak": 0.1}, ValueError, "central_film and minimum_film"),
        (1.0, ValueError, "0.01 means 1 %"),
        (-0.1, ValueError, "accuracy must be"),
    ],
)
def test_wrong_accuracies_are_refused(accuracy, error, words):
    with pytest.raises(error, match=words):
        line_film(accuracy)


def test_a_measured_gap_has_no_finer_grid():
    grid = sc.Grid(48, 1, 1e-5, 1e-3, periodic="y")
    with warnings.catch_warnings(), pytest.raises(TypeError, match="gap must be a function"):
        sc.lubrication.steady(
            grid, STEEL, STEEL, sc.surfaces.paraboloid(grid, R, np.inf), load=1.0,
            speed=(1.0, 1.0), lubricant=OIL, accuracy=0.01,
        )  # fmt: skip
