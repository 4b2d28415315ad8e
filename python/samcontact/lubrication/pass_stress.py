# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress history of the points of a body that passes through a film."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, choice, require_type
from .._util.short_text import in_short
from ..contact.solver import ContactSolver
from ..problem.grid import Grid
from .film_solution import FilmSolution
from .friction import friction


def pass_stress(films: Sequence[FilmSolution], *, z: ArrayLike, body: int = 2) -> FloatArray:
    """Stress history of the points of an elastic body that moves through a film [Pa].

    Pressure and shear of the film cause the stress. The result is a stress history for the criteria
    of `samcontact.fatigue`, e.g. ``sc.fatigue.dang_van(pass_stress(films, z=z), slope=0.3)``.

    Parameters
    ----------
    films : sequence of FilmSolution
        Films in the order of time, from `transient`; the body moves along x.
    z : array_like, shape (m,)
        Depths [m], > 0.
    body : {1, 2}, optional
        Body whose stress is returned. Default: 2.

    Returns
    -------
    ndarray, shape (n, 6, nx, ny, m)
        Stress components xx, yy, zz, yz, xz, xy under each film, tension positive. The points are
        fixed to the body; at time 0 they are at the cell centres of the grid. When they are between
        cell centres, their stress is interpolated linearly; beyond the grid it is 0.

    Raises
    ------
    ValueError, TypeError
        There are fewer than two films, the films do not belong to one history, the body moves along
        y or is rigid, or the friction is higher than an oil can transmit (see `friction`).
    """
    number = choice("body", body, (1, 2))
    if not isinstance(films, Sequence):
        raise TypeError(f"films must be a sequence of films, got {in_short(films)}")
    if len(films) < 2:
        raise ValueError(f"films must contain at least two films, got {len(films)}")
    for film in films:
        require_type("films", film, FilmSolution)
    first = films[0]
    if any(film.past is None or film.grid != first.grid for film in films):
        raise ValueError("films must be films of one history, all from `transient` on one grid")
    body1, body2 = first.bodies
    solver = ContactSolver(first.grid, body1, body2)
    return np.stack([_stress(film, solver, z, number) for film in films])


def _stress(film: FilmSolution, solver: ContactSolver, z: ArrayLike, body: int) -> FloatArray:
    """Return the stress under one film at the points of the body [Pa]."""
    assert film.past is not None
    along, across = film.past.ways[body - 1].tolist()
    if across != 0.0:
        raise ValueError(
            f"body{body} must move along x only, got a displacement of {across:.3g} m along y"
        )
    found = friction(film)
    shear = found.fluid_shear + found.boundary_shear
    return moved(solver.stress(film.pressure, z, body, shear=shear), along, film.grid)


def moved(stress: FloatArray, way: float, grid: Grid) -> FloatArray:
    """Return a field at points displaced by a distance `way` along x [m]; 0 outside the grid.

    stress: field with the axes component, x, y and z; the result has the same shape.
    """
    cells = way / grid.dx
    whole = int(np.floor(cells))
    share = cells - whole
    if share < 1e-9 or share > 1.0 - 1e-9:
        return _shifted(stress, round(cells))
    return (1.0 - share) * _shifted(stress, whole) + share * _shifted(stress, whole + 1)


def _shifted(field: FloatArray, cells: int) -> FloatArray:
    """Return a field shifted along x by a number of cells.

    The value at index i is the given value at i + cells, or 0 if this index is outside the field.
    """
    found, count = np.zeros_like(field), field.shape[1]
    first, last = max(0, -cells), min(count, count - cells)
    if first < last:
        found[:, first:last] = field[:, first + cells : last + cells]
    return found


__all__ = ["pass_stress"]
