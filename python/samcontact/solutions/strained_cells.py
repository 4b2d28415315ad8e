# SPDX-License-Identifier: GPL-3.0-or-later
"""Cells of a state with plastic strain."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from .zone import Zone

if TYPE_CHECKING:
    from .state import State


def strained_cells(
    zone: Zone, shape: Sequence[int]
) -> tuple[tuple[NDArray[np.intp], ...], tuple[NDArray[np.intp], ...]]:
    """Return the indices of cells with plastic strain that lie both in a zone and in a grid.

    zone: plastic subdomain of a body; shape: numbers of cells of the grid along x, y and z. The
    first tuple contains the indices in the zone, the second tuple the indices in the grid.
    """
    inside = np.nonzero(zone.equivalent_plastic_strain())
    there = [at + first for at, first in zip(inside, (*zone.first, 0), strict=True)]
    shown = np.logical_and.reduce(
        [(at >= 0) & (at < n) for at, n in zip(there, shape, strict=True)]
    )
    return tuple(at[shown] for at in inside), tuple(at[shown] for at in there)


def strained_extent(state: State, body: int) -> list[tuple[int, int]]:
    """Return the first and the last cell with plastic strain, along each of x, y and z.

    Only cells inside the volume fields count. The list is empty if none has plastic strain.
    """
    shape = (*state.grid.surface_shape, len(state.depths))
    found = [strained_cells(zone, shape)[1] for zone in state.zones(body)]
    ends = [[(int(at.min()), int(at.max())) for at in cells] for cells in found if cells[0].size]
    return [(min(axis)[0], max(last for _, last in axis)) for axis in zip(*ends, strict=True)]
