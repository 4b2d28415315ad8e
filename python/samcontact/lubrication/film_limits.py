# SPDX-License-Identifier: GPL-3.0-or-later
"""Limits of theory and grid for a lubricated contact, based on the film that a formula predicts."""

from __future__ import annotations

import math

import numpy as np

from .._util.checks import FloatArray
from .._util.display import quantity
from ..problem.grid import Grid
from .nested import DryContact, FilmTask

MAX_FILM_OF_RADIUS = 0.1
"""Largest film thickness for Reynolds' equation, divided by the radius of curvature of the gap."""
FEW_ITERATIONS = 15
"""Number of iterations below which `remedy` advises to increase `max_iterations`."""
USUAL_REMEDY = "use smaller cells, a longer inlet, or order = 1"
MIN_FILM_OF_RISE = 0.2
"""Smallest ratio of the film to the increase of the dry gap over one cell at the contact edge.

Below this ratio, `remedy` advises smaller cells."""


def require_thin_film(task: FilmTask, dry: DryContact) -> None:
    """Raise ValueError, before the solution begins, if the predicted film is not thin.

    Raises
    ------
    ValueError
        The film that a formula predicts is thicker than a tenth of the radius of curvature of the
        gap.
    """
    if not task.is_load or min(dry.film, task.supply) <= MAX_FILM_OF_RADIUS * dry.gap_radius:
        return
    raise ValueError(
        f"load must be large enough for a thin film, got {task.target:.4g} N: at this speed and "
        f"viscosity a formula predicts a film of {quantity(dry.film, 'm')}, more than "
        f"{MAX_FILM_OF_RADIUS:g} times the radius of curvature of the gap, "
        f"{quantity(dry.gap_radius, 'm')}; check the units of load, speed and viscosity"
    )


def require_thin_layer(task: FilmTask, dry: DryContact) -> None:
    """Raise ValueError if the boundary layer is thicker than a tenth of the radius of the gap."""
    layer = task.boundary
    if layer is not None and layer.thickness > MAX_FILM_OF_RADIUS * dry.gap_radius:
        raise ValueError(
            f"boundary.thickness must be at most {MAX_FILM_OF_RADIUS:g} times the radius of "
            f"curvature of the gap, {quantity(dry.gap_radius, 'm')}, got "
            f"{quantity(layer.thickness, 'm')}: check the unit of the thickness"
        )


def remedy(task: FilmTask, dry: DryContact, grid: Grid) -> str:
    """Return advice for the error message of a solution that did not converge."""
    if task.max_iterations < FEW_ITERATIONS:
        return f"increase max_iterations, which is {task.max_iterations}"
    film = min(dry.film, task.supply)
    reach = math.sqrt(2.0 * film * dry.gap_radius) + dry.radius
    inlet = _inlet_length(task, dry.pressure, grid)
    is_starved = task.supply < dry.film
    expected = "the supply limits the film to" if is_starved else "a formula predicts a film of"
    expected = f"{expected} {quantity(film, 'm')}"
    if reach > inlet:
        return (
            f"{expected}, whose pressure extends to about {quantity(reach, 'm')} from the contact "
            f"centre, but the grid ends {quantity(inlet, 'm')} from it: enlarge the grid towards "
            "the inlet"
        )
    size = grid.dx if grid.ny == 1 else max(grid.dx, grid.dy)
    slope = 2.0 * dry.radius / (math.pi * dry.gap_radius)
    thinnest = max(film, 0.0 if task.boundary is None else task.boundary.thickness)
    if thinnest < MIN_FILM_OF_RISE * slope * size:
        layer = "" if task.boundary else ", or add a boundary layer"
        cells = quantity(thinnest / (MIN_FILM_OF_RISE * slope), "m")
        return f"{expected}, too thin for the cells: use cells of about {cells}{layer}"
    return USUAL_REMEDY


def _inlet_length(task: FilmTask, pressure: FloatArray, grid: Grid) -> float:
    """Return the smallest distance of the contact centre from a main inlet edge [m].

    The centre is the place of maximum pressure. An edge is a main inlet if its mean inward velocity
    exceeds half of the largest mean inward velocity of all edges.
    """
    i, j = np.unravel_index(int(np.argmax(pressure)), pressure.shape)
    along_x, along_y = task.face_velocities(grid)
    nx, ny = pressure.shape
    length, width = grid.nx * grid.dx, grid.ny * grid.dy
    x, y = (i + 0.5) * length / nx, (j + 0.5) * width / ny
    edges = [(x, along_x[0]), (length - x, -along_x[-1])]
    if grid.ny > 1 and not grid.periodic:
        edges += [(y, along_y[:, 0]), (width - y, -along_y[:, -1])]
    # A spin draws some lubricant in through each edge: the main inlet counts.
    fastest = max(float(inward.mean()) for _, inward in edges)
    return min(
        (way for way, inward in edges if float(inward.mean()) > 0.5 * fastest), default=math.inf
    )
