# SPDX-License-Identifier: GPL-3.0-or-later
"""Part of the results dataset that tells how well each increment is solved, and its limits."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from ..diagnostics import sharp_edges
from ..diagnostics.resolution import area_uncertainty, cells_across, plastic_layers, spots
from ..solutions.strained_cells import strained_extent
from .motion import add

if TYPE_CHECKING:
    from ..solutions.state import State


def add_convergence(dataset: xr.Dataset, states: Sequence[State], inelastic: Sequence[int]) -> None:
    """Add residuals, largest plastic strains, and how far the border of the grid is.

    Parameters
    ----------
    dataset : xarray.Dataset
        With the dimension increment; changed in place.
    states : sequence of State
    inelastic : sequence of int
        Bodies that can yield.
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
    add(dataset, "contact_margin", "increment", margins)
    solved = [np.isfinite(state.approach) for state in states]  # else the tractions were given
    across = [
        cells_across(state.repulsion, state.grid.periodic) if found else np.nan
        for state, found in zip(states, solved, strict=True)
    ]
    add(dataset, "contact_cells", "increment", across)
    _add_area_uncertainty(dataset, states, solved)
    sharp = [sharp_edges.edge_of_state(state) for state in states]
    if any(sharp):
        cells = [0 if edge is None else np.count_nonzero(edge.cells) for edge in sharp]
        add(dataset, "sharp_cells", "increment", cells)
    if not inelastic:
        return
    for name in ("plastic_residual", "yield_excess"):
        add(dataset, name, "increment", [float(getattr(state, name)) for state in states])
    for body in inelastic:
        strains = [float(state.max_plastic_strain_magnitude(body=body)) for state in states]
        add(dataset, "max_plastic_strain_magnitude", "increment", strains, body)
        margins, layers = _plastic_zones(states, body)
        add(dataset, "plastic_margin", "increment", margins, body)
        add(dataset, "plastic_layers", "increment", layers, body)


def _add_area_uncertainty(
    dataset: xr.Dataset, states: Sequence[State], solved: Sequence[np.bool_]
) -> None:
    """Of contacts of several spots, where there are some."""
    found = [
        area_uncertainty(state.repulsion, state.grid.periodic)
        if there and spots(state.repulsion, state.grid.periodic) > 1
        else np.nan
        for state, there in zip(states, solved, strict=True)
    ]
    if np.isfinite(found).any():
        add(dataset, "area_uncertainty", "increment", found)


def _plastic_zones(states: Sequence[State], body: int) -> tuple[list[float], list[float]]:
    """How far the border is, and how many layers have yielded.

    Where a body has moved, its plastic strain leaves the grid along x: that border is none.
    """
    margins, layers, moved = [], [], False
    for state in states:
        moved = moved or any(state.travel)
        extent, grid = strained_extent(state, body), state.grid
        shape = (*grid.surface_shape, len(state.depths))
        beside = not (moved or grid.along_x), not grid.along_y
        margins.append(free_cells(extent, shape, *beside))
        layers.append(plastic_layers(extent))
    return margins, layers


def extent_of(inside: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First and last cell inside along each axis; empty where none is."""
    return [(int(at.min()), int(at.max())) for at in np.nonzero(inside) if at.size]


def free_cells(
    extent: Sequence[tuple[int, int]],
    shape: Sequence[int],
    along_x: bool = True,
    along_y: bool = True,
) -> float:
    """Least number of cells between those inside and the border: sides and, in a volume, bottom.

    Parameters
    ----------
    extent : sequence of (int, int)
        First and last cell inside, along x, y and in a volume z.
    shape : sequence of int
        Of the grid.
    along_x, along_y : bool, optional
        Whether the sides across x, and across y, count.

    Returns
    -------
    float
        A whole number, 0 at the border; NaN where nothing is inside, or no side counts.
    """
    free = []
    counted = along_x, along_y, True
    for axis, (first, last) in enumerate(extent):
        if counted[axis]:
            # the top of a volume is the surface
            free += [shape[axis] - 1 - last, *([first] if axis < 2 else [])]
    return float(min(free, default=np.nan))
