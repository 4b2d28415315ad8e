# SPDX-License-Identifier: GPL-3.0-or-later
"""A part of a body that holds plastic strain."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .._util import memory
from .._util.checks import FloatArray
from .._util.frozen import Fixed, read_only

if TYPE_CHECKING:
    from ..scene.grid import Grid
    from .state import State

__all__ = ["Zone"]

Box = tuple[int, int, int, int, int]
"""First cell along x and y, cells along x, y and z."""


class ZoneStress:
    """Stress in all zones of a body, computed at once when the first asks."""

    def __init__(self, core: Any, body: int) -> None:
        self.core, self._body = core, body
        self.boxes: list[Box] = core.zones(body - 1)
        cells = np.array([box[2:] for box in self.boxes], dtype=np.int64).reshape(-1, 3)
        self._ends = np.cumsum(6 * cells.prod(axis=1))
        self._fields: dict[bool, FloatArray] = {}

    def stress(self, zone: int, *, loaded: bool) -> FloatArray:
        if loaded not in self._fields:
            needed = memory.ZONE_FIELD * self._ends[-1] / 6
            memory.require("the stress in all zones", needed)
            self._fields[loaded] = read_only(self.core.stress_in_zones(self._body - 1, loaded))
        *_, nx, ny, nz = self.boxes[zone]
        mine = self._fields[loaded][: self._ends[zone]][-6 * nx * ny * nz :]
        field: FloatArray = mine.reshape(6, nz, nx, ny).transpose(0, 2, 3, 1)
        return field


class Zone(Fixed):
    """A box of cells of one body with plastic strain in some, from the surface down.

    Made by `State.zones`. It may reach beyond the cells that fields of the state show, beside the
    grid and below its layers. Fields are read-only.
    """

    def __init__(self, grid: Grid, body: int, number: int, zones: ZoneStress) -> None:
        self._box = i0, j0, nx, ny, nz = zones.boxes[number]
        self.body = body
        self.first = i0, j0
        """The grid's cell over which its first one lies; negative beside the grid."""
        self.shape = nx, ny, nz
        """Cells along x and y, and layers."""
        self.x: FloatArray = _centres(i0, nx, grid.nx, grid.dx)
        """Cell centres along x [m]."""
        self.y: FloatArray = _centres(j0, ny, grid.ny, grid.dy)
        """Cell centres along y [m]."""
        self.z: FloatArray = read_only(grid.depths(nz))
        """Mid-depths of the layers [m]."""
        self._number, self._zones = number, zones
        self._core = zones.core

    def plastic_strain(self) -> FloatArray:
        """Plastic strain [-], tensor components, shape (6, nx, ny, nz)."""
        return read_only(self._core.plastic_strain_in(self.body - 1, self._box))

    def equivalent_plastic_strain(self) -> FloatArray:
        """Accumulated equivalent plastic strain [-], shape (nx, ny, nz)."""
        return read_only(self._core.equivalent_plastic_strain_in(self.body - 1, self._box))

    def residual_stress(self) -> FloatArray:
        """Stress of all plastic strain of the body, and from the start [Pa], shape (6, nx, ny, nz).

        Of several zones, by the operators that their strain was solved with: see the theory.
        """
        return self._zones.stress(self._number, loaded=False)

    def stress(self) -> FloatArray:
        """Total stress [Pa], shape (6, nx, ny, nz)."""
        return self._zones.stress(self._number, loaded=True)

    def __repr__(self) -> str:
        return f"Zone(body={self.body}, first={self.first}, shape={self.shape})"


def _centres(first: int, count: int, cells: int, size: float) -> FloatArray:
    """Of cells of a lattice, counted from the first of the grid's cells."""
    return read_only(np.asarray((first - 0.5 * (cells - 1) + np.arange(count)) * size, np.float64))


def strained_cells(
    zone: Zone, shape: Sequence[int]
) -> tuple[tuple[NDArray[np.intp], ...], tuple[NDArray[np.intp], ...]]:
    """Cells i, j, k with plastic strain, of those in a grid of this shape: in the zone, there."""
    inside = np.nonzero(zone.equivalent_plastic_strain())
    there = [at + first for at, first in zip(inside, (*zone.first, 0), strict=True)]
    shown = np.logical_and.reduce(
        [(at >= 0) & (at < n) for at, n in zip(there, shape, strict=True)]
    )
    return tuple(at[shown] for at in inside), tuple(at[shown] for at in there)


def strained_extent(state: State, body: int) -> list[tuple[int, int]]:
    """First and last cell along x, y and z with plastic strain, of those that fields show.

    Empty without plastic strain.
    """
    shape = (*state.grid.surface_shape, len(state.depths))
    found = [strained_cells(zone, shape)[1] for zone in state.zones(body)]
    ends = [[(int(at.min()), int(at.max())) for at in cells] for cells in found if cells[0].size]
    return [(min(axis)[0], max(last for _, last in axis)) for axis in zip(*ends, strict=True)]
