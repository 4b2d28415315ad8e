# SPDX-License-Identifier: GPL-3.0-or-later
"""Film thickness to a prescribed accuracy, by refinement and enlargement of the grid."""

from __future__ import annotations

import logging
import math
import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from .._core import ConvergenceError
from .._util.checks import FloatArray, positive
from .._util.display import counts, percent
from .._util.errors import AccuracyWarning
from .._util.short_text import in_short
from ..problem.grid import Grid
from .film_solution import FilmErrors, FilmNotResolvedError, FilmSolution
from .nested import FilmTask

_logger = logging.getLogger("samcontact")

RATIO = 2.0**0.5
"""Ratio of the cell sizes of successive grids."""
ORDER = 1.5
"""Assumed order of convergence: the lowest of the orders measured for central films, 1.5 to 3."""
SAFETY = 1.5
"""Safety factor on the error that is extrapolated from the differences between grids."""
ENLARGEMENT = 1.5
"""Ratio of the side lengths of successive grids when the grid is enlarged."""
WINDOW_SHARE = 0.5
"""Share of the prescribed accuracy that errors due to the edges of the grid may use."""
WINDOW_ORDER = 3.0
"""Exponent n of the error due to the edges, ~1/(inlet length)^n; measured at Moes' M = 20."""
MIN_GRIDS, MAX_GRIDS, MAX_ENLARGEMENTS = 3, 20, 4
MAX_CELLS, MAX_CELLS_OF_LINE = 420**2, 2**14
"""Largest number of cells of a grid, in general and for line contacts."""
MIN_ACCURACY, MAX_ACCURACY = 1e-4, 0.2

Solve = Callable[[FilmTask, Grid], FilmSolution]


def checked_accuracy(accuracy: Any, task: FilmTask) -> FloatArray:
    """Return the prescribed relative accuracies of central and minimum film [-].

    The accuracy of a film for which none is prescribed is returned as infinity.
    """
    if not callable(task.gap):
        raise TypeError(
            "with accuracy, which needs solutions on several grids, gap must be a function of a "
            f"grid, got {in_short(task.gap)}: use e.g. "
            "lambda grid: sc.surfaces.paraboloid(grid, R)"
        )
    names = "central_film", "minimum_film"
    given = accuracy if isinstance(accuracy, Mapping) else dict.fromkeys(names, accuracy)
    if not given or not set(given) <= set(names):
        raise ValueError(
            f"accuracy must be a number, or a mapping with at least one of the keys "
            f"{' and '.join(names)} and no others, got {in_short(accuracy)}"
        )
    checked = {name: positive("accuracy", value) for name, value in given.items()}
    for value in checked.values():
        if not MIN_ACCURACY <= value <= MAX_ACCURACY:
            raise ValueError(
                f"accuracy must be in [{MIN_ACCURACY:g}, {MAX_ACCURACY:g}], got {value!r}: 0.01 "
                "means 1 %"
            )
    return np.array([checked.get(name, math.inf) for name in names])


@dataclass(frozen=True)
class _Window:
    """Grid that is large enough, the solution on it, and the relative errors due to its edges."""

    grid: Grid
    solution: FilmSolution
    errors: FloatArray


def to_accuracy(task: FilmTask, grid: Grid, accuracy: FloatArray, solve: Solve) -> FilmSolution:
    """Return a solution whose estimated film errors are below the prescribed accuracies.

    If this would need too many cells, the solution on the last grid is returned, and an
    `AccuracyWarning` states its estimated errors.
    """
    window = _large_enough(task, _resolved(task, grid, solve), accuracy, solve)
    found, values = window.solution, [_values(window.solution)]
    errors, reached = np.full(2, np.inf), False
    for level in range(1, MAX_GRIDS):
        cells = _finer(window.grid, RATIO**level)
        if _too_many(cells):
            break
        found = solve(task, cells)
        values.append(_values(found))
        errors = grid_errors(np.array(values)) + window.errors
        _logger.info("film on %s cells: errors %s", counts(*found.film.shape), errors)
        if reached := len(values) >= MIN_GRIDS and bool(np.all(errors <= accuracy)):
            break
    if not reached:
        texts = " and ".join(map(percent, errors))
        warnings.warn(
            f"accuracy is not reached: on the last of {len(values)} grids, which has "
            f"{counts(*found.film.shape)} cells, central and minimum film have estimated errors of "
            f"{texts}, and the next grid would have too many cells; relax the accuracy, or start "
            "from a grid with larger cells",
            AccuracyWarning,
            stacklevel=4,
        )
    return replace(found, errors=FilmErrors(*map(float, errors * _values(found))))


def _resolved(task: FilmTask, grid: Grid, solve: Solve) -> Grid:
    """Return the given grid if it resolves the film, or else a grid with smaller cells."""
    while True:
        try:
            solve(task, grid)
        except (FilmNotResolvedError, ConvergenceError):
            finer = _finer(grid, RATIO)
            if _too_many(finer):
                raise
            grid = finer
        else:
            return grid


def _too_many(grid: Grid) -> bool:
    return grid.nx * grid.ny > (MAX_CELLS_OF_LINE if grid.ny == 1 else MAX_CELLS)


def grid_errors(values: FloatArray) -> FloatArray:
    """Return the estimated relative errors of the values on the finest of several grids [-].

    values: results on grids refined by `RATIO` each time, the finest last. The last three
    differences between successive grids are converted to the cell size of the finest grid, with the
    order of convergence `ORDER`. The largest of the three is taken as the difference between the
    two finest grids. The differences between all still finer grids are assumed to decrease with the
    same order; the error is `SAFETY` times their sum.
    """
    steps = np.abs(np.diff(values, axis=0))[::-1][:3]
    ages = np.arange(len(steps))[:, None]
    left = 1.0 / (RATIO**ORDER - 1.0)
    widest = np.max(steps * RATIO ** (-ORDER * ages), axis=0)
    found: FloatArray = SAFETY * left * widest / np.abs(values[-1])
    return found


def _large_enough(task: FilmTask, grid: Grid, accuracy: FloatArray, solve: Solve) -> _Window:
    """Return the given grid, or a larger grid whose edges affect the films little enough.

    The relative errors due to the edges must not exceed `WINDOW_SHARE` times the accuracy. After
    `MAX_ENLARGEMENTS`, the last grid is returned.
    """
    here, less = solve(task, grid), ENLARGEMENT**-WINDOW_ORDER
    for _ in range(MAX_ENLARGEMENTS):
        larger = _larger(grid)
        beyond = solve(task, larger)
        change = np.abs(_values(beyond) - _values(here)) / _values(beyond)
        errors = change / (1.0 - less)  # due to all further enlargements together
        if np.all(errors <= WINDOW_SHARE * accuracy):
            return _Window(grid, here, errors)
        grid, here, errors = larger, beyond, less * errors
        if np.all(errors <= WINDOW_SHARE * accuracy):
            break
    return _Window(grid, here, errors)


def _values(film: FilmSolution) -> FloatArray:
    return np.array([film.central_film, film.minimum_film])


def _finer(grid: Grid, factor: float) -> Grid:
    """Return a grid of the same area with smaller cells."""
    nx = 2 * round(0.5 * grid.nx * factor)
    ny = grid.ny if grid.ny == 1 else 2 * round(0.5 * grid.ny * factor)
    return replace(grid, nx=nx, ny=ny, dx=grid.nx * grid.dx / nx, dy=grid.ny * grid.dy / ny)


def _larger(grid: Grid) -> Grid:
    """Return a grid with cells of the same size that is longer along its non-periodic axes."""
    nx = 2 * round(0.5 * ENLARGEMENT * grid.nx)
    ny = grid.ny if grid.along_y else 2 * round(0.5 * ENLARGEMENT * grid.ny)
    return replace(grid, nx=nx, ny=ny)
