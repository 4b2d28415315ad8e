# SPDX-License-Identifier: GPL-3.0-or-later
"""Variables of the results dataset on convergence and resolution of each increment."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from ..diagnostics import sharp_edges
from ..diagnostics.resolution import (
    area_uncertainty,
    cells_across,
    layers_across_plastic_zone,
    spots,
)
from ..solutions.strained_cells import strained_extent
from .motion import add

if TYPE_CHECKING:
    from ..solutions.state import State


def add_convergence(dataset: xr.Dataset, states: Sequence[State], inelastic: Sequence[int]) -> None:
    """Add residuals, maximum plastic strains, and the resolution of contact and plastic zone.

    The distances of the contact and of the plastic zone from the edge of the grid are added too.

    Parameters
    ----------
    dataset : xarray.Dataset
        Dataset with the dimension increment; changed in place.
    states : sequence of State
        One state per increment.
    inelastic : sequence of int
        Numbers of the elastic-plastic bodies.
    """

    margins = [
        free_cells(
            extent_of(state.repulsion != 0),
            state.grid.surface_shape,
            not state.grid.along_x,
            not state.grid.along_y,
        )
        for state in states
    ]
    add(dataset, "contact_edge_distance", "increment", margins)
    solved = [np.isfinite(state.approach) for state in states]  # NaN: prescribed tractions
    across = [
        cells_across(state.repulsion, state.grid.periodic) if found else np.nan
        for state, found in zip(states, solved, strict=True)
    ]
    add(dataset, "cells_across_contact", "increment", across)
    _add_area_uncertainty(dataset, states, solved)
    sharp = [sharp_edges.edge_of_state(state) for state in states]
    if any(sharp):
        cells = [0 if edge is None else np.count_nonzero(edge.cells) for edge in sharp]
        add(dataset, "sharp_edge_cells", "increment", cells)
    if not inelastic:
        return
    for name in ("plastic_strain_residual", "yield_violation"):
        add(dataset, name, "increment", [float(getattr(state, name)) for state in states])
    for body in inelastic:
        strains = [float(state.max_plastic_strain_magnitude(body=body)) for state in states]
        add(dataset, "max_plastic_strain_magnitude", "increment", strains, body)
        margins, layers = _plastic_zones(states, body)
        add(dataset, "plastic_edge_distance", "increment", margins, body)
        add(dataset, "layers_across_plastic_zone", "increment", layers, body)


def _add_area_uncertainty(
    dataset: xr.Dataset, states: Sequence[State], solved: Sequence[np.bool_]
) -> None:
    """Add the uncertainty of the contact area in increments with several contact spots."""
    found = [
        area_uncertainty(state.repulsion, state.grid.periodic)
        if there and spots(state.repulsion, state.grid.periodic) > 1
        else np.nan
        for state, there in zip(states, solved, strict=True)
    ]
    if np.isfinite(found).any():
        add(dataset, "area_uncertainty", "increment", found)


def _plastic_zones(states: Sequence[State], body: int) -> tuple[list[float], list[float]]:
    """Return the distance of the plastic zone from the grid edge [cells], and its depth [layers].

    Both lists have one value per increment. The distance is the smallest of the distances to the
    sides of the grid. After a body has moved, its plastic strain leaves the grid along the motion,
    so the two sides perpendicular to the motion are ignored.
    """
    margins: list[float] = []
    layers: list[float] = []
    moved = [False, False]
    for state in states:
        for axis, travels in enumerate((state.travel, state.lateral_travel)):
            moved[axis] = moved[axis] or any(travels)
        extent, grid = strained_extent(state, body), state.grid
        shape = (*grid.surface_shape, len(state.depths))
        has_edges = not (moved[0] or grid.along_x), not (moved[1] or grid.along_y)
        margins.append(free_cells(extent, shape, *has_edges))
        layers.append(layers_across_plastic_zone(extent))
    return margins, layers


def extent_of(inside: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return the first and last marked cell along each axis; an empty list if no cell is marked."""
    return [(int(at.min()), int(at.max())) for at in np.nonzero(inside) if at.size]


def free_cells(
    extent: Sequence[tuple[int, int]],
    shape: Sequence[int],
    along_x: bool = True,
    along_y: bool = True,
) -> float:
    """Return the minimum number of cells between a region of cells and the edge of the grid.

    The edge consists of the four sides and, for a volume, the bottom of the grid.

    Parameters
    ----------
    extent : sequence of (int, int)
        First and last cell of the region along x, y and, in a volume, z.
    shape : sequence of int
        Shape of the grid.
    along_x, along_y : bool, optional
        Whether the edge includes the two sides perpendicular to x, and the two sides perpendicular
        to y.

    Returns
    -------
    float
        Whole number, 0 at the edge; NaN if the region is empty or the edge has no sides.
    """
    free = []
    counted = along_x, along_y, True
    for axis, (first, last) in enumerate(extent):
        if counted[axis]:
            # the top of a volume is the surface
            free += [shape[axis] - 1 - last, *([first] if axis < 2 else [])]
    return float(min(free, default=np.nan))
