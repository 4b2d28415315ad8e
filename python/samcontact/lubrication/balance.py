# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of lubricated contacts: mass balance, pressure at the grid edges, and resolution."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from .. import _core
from .._util.checks import FloatArray
from ..problem.grid import Grid
from .film_solution import FilmSolution
from .nested import face_velocities, table_of

WEIGHTS = 1.5, 2.0, 0.5
"""Weights (a, b, c) of the time derivative (a now - b one step ago + c two steps ago)/step."""


def outflow(film: FilmSolution, order: int = 3, supply: float | None = None) -> FloatArray:
    """Return the net volume flow of lubricant out of each cell [m^3/s], shape (nx, ny).

    All volumes of lubricant are converted to zero pressure. order, supply: as given to `steady`. In
    a steady film the net outflow of every cell is zero.
    """
    along_x, along_y = face_velocities(film.grid, film.velocities, film.spin)
    fields = (film.fluid_pressure, film.film, 1.0 - film.filling)
    found: FloatArray = _core.film_outflow(
        film.grid._core, table_of(film.lubricant, float(film.pressure.max())), along_x, along_y,
        order, math.inf if supply is None else supply,
        0.0 if film.boundary is None else film.boundary.thickness,
        [np.ascontiguousarray(field) for field in fields],
    )  # fmt: skip
    return found


def flow_imbalance(film: FilmSolution, order: int = 3, supply: float | None = None) -> float:
    """Return the magnitude of the net outflow from the grid, divided by the flow by `swept` [-].

    order, supply: as given to `steady`. The result is 0 if as much lubricant enters the grid as
    leaves it.
    """
    return abs(float(outflow(film, order, supply).sum())) / swept(film)


def swept(film: FilmSolution) -> float:
    """Return the reference volume flow into the grid [m^3/s].

    It is the flow that would enter if the film had its central thickness everywhere.
    """
    grid, mean = film.grid, np.abs(film.velocities.mean(axis=0))
    length, width = grid.nx * grid.dx, grid.ny * grid.dy
    speeds = float(mean[0]) * width + float(mean[1]) * length + abs(film.spin) * length * width
    return speeds * film.central_film


def storage_imbalance(films: Sequence[FilmSolution]) -> FloatArray:
    """Return the relative imbalance of the oil on the grid at each time [-].

    The imbalance is the net outflow from the grid plus the rate of change of the oil volume on the
    grid. It is divided by the largest value that the reference flow `swept` or the rate of change
    has at any time. films: films at the start and after each step of a history, equally spaced in
    time. The film is assumed to be steady before the start.
    """
    stored = np.array([float(film.content.sum()) for film in films]) * films[0].grid.cell_area
    before = np.concatenate([stored[:1], stored[:-1]])
    earlier = np.concatenate([stored[:1], before[:-1]])
    steps = np.diff([film.time for film in films], prepend=-np.inf)
    now, one, two = WEIGHTS
    rates = (now * stored - one * before + two * earlier) / steps
    out = np.array([float(outflow(film, film.order, film.supply).sum()) for film in films])
    size = max(*map(swept, films), float(np.abs(rates).max()))
    found: FloatArray = np.abs(out + rates) / size
    return found


def inlet_pressure(film: FilmSolution) -> float:
    """Return the relative pressure next to the edges through which lubricant enters [-].

    This is the largest pressure there, divided by the maximum pressure of the contact.
    """
    return _edge_pressure(film, 1.0)


def outlet_pressure(film: FilmSolution) -> float:
    """Return the relative pressure next to the edges through which lubricant leaves [-].

    This is the largest pressure there, divided by the maximum pressure of the contact.
    """
    return _edge_pressure(film, -1.0)


def _edge_pressure(film: FilmSolution, sign: float) -> float:
    """Return the relative pressure next to the edges through which lubricant enters or leaves [-].

    This is the largest pressure there, divided by the maximum pressure of the contact. sign: 1 for
    the edges through which lubricant enters, -1 for those through which it leaves.
    """
    along_x, along_y = face_velocities(film.grid, film.velocities, film.spin)
    p = film.fluid_pressure
    edges = [(p[0], along_x[0]), (p[-1], -along_x[-1])]
    if not film.grid.periodic:
        edges += [(p[:, 0], along_y[:, 0]), (p[:, -1], -along_y[:, -1])]
    found = [float(edge[sign * v > 0].max()) for edge, v in edges if np.any(sign * v > 0)]
    return max(found, default=0.0) / float(film.pressure.max())


def cells_per_radius(pressure: FloatArray, grid: Grid) -> float:
    """Return the number of cells per semi-axis of a contact, along the axis with fewer cells [-].

    The semi-axes are those of the Hertz contact whose pressure has the same second moments.
    The result counts cells of `grid`. pressure: field over the area of `grid`, whose cells may have
    another size.
    """
    total = float(pressure.sum())
    is_line = grid.ny == 1 or "y" in grid.periodic
    found = []
    for axis, (n, share) in enumerate(((grid.nx, 4.0 if is_line else 5.0), (grid.ny, 5.0))):
        if axis == 1 and is_line:
            continue
        sums = pressure.sum(axis=1 - axis)
        place = (np.arange(sums.size) + 0.5) * n / sums.size
        mean = float(place @ sums) / total
        found.append(math.sqrt(share * float((place - mean) ** 2 @ sums) / total))
    return min(found)
