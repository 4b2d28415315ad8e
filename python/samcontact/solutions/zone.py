# SPDX-License-Identifier: GPL-3.0-or-later
"""Plastic subdomain of a body, i.e. a box of cells that contains plastic strain."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._util import memory
from .._util.checks import FloatArray
from .._util.frozen import FixedAttributes, read_only

if TYPE_CHECKING:
    from ..problem.grid import Grid

__all__ = ["Zone"]

Box = tuple[int, int, int, int, int]
"""Index of the first cell along x and y, and numbers of cells along x, y and z."""


class ZoneStress:
    """Stress in the plastic subdomains of a body, computed for all of them at the first request."""

    def __init__(self, core: Any, body: int) -> None:
        self.core, self._body = core, body
        self.boxes: list[Box] = core.zones(body - 1)
        cells = np.array([box[2:] for box in self.boxes], dtype=np.int64).reshape(-1, 3)
        self._ends = np.cumsum(6 * cells.prod(axis=1))
        self._fields: dict[bool, FloatArray] = {}

    def stress(self, zone: int, *, loaded: bool) -> FloatArray:
        if loaded not in self._fields:
            needed = memory.ZONE_FIELD_BYTES * self._ends[-1] / 6
            memory.require("the stress in all plastic subdomains", needed)
            self._fields[loaded] = read_only(self.core.stress_in_zones(self._body - 1, loaded))
        *_, nx, ny, nz = self.boxes[zone]
        mine = self._fields[loaded][: self._ends[zone]][-6 * nx * ny * nz :]
        field: FloatArray = mine.reshape(6, nz, nx, ny).transpose(0, 2, 3, 1)
        return field


class Zone(FixedAttributes):
    """Plastic subdomain: a box of cells of one body, from the surface down.

    Created by `State.zones`. A subdomain may extend beyond the volume fields of the state: outside
    the grid and below its layers. Fields are read-only.
    """

    def __init__(self, grid: Grid, body: int, number: int, zones: ZoneStress) -> None:
        self._box = i0, j0, nx, ny, nz = zones.boxes[number]
        self.body = body
        self.first = i0, j0
        """Position in the grid of the first cell of the subdomain; negative outside the grid."""
        self.shape = nx, ny, nz
        """Numbers of cells along x and y, and of layers."""
        self.x: FloatArray = _centres(i0, nx, grid.nx, grid.dx)
        """Cell centres along x [m]."""
        self.y: FloatArray = _centres(j0, ny, grid.ny, grid.dy)
        """Cell centres along y [m]."""
        self.z: FloatArray = read_only(grid.depths(nz))
        """Mid-layer depths [m]."""
        self._number, self._zones = number, zones
        self._core = zones.core

    def plastic_strain(self) -> FloatArray:
        """Plastic strain [-], tensor components, shape (6, nx, ny, nz)."""
        return read_only(self._core.plastic_strain_in(self.body - 1, self._box))

    def equivalent_plastic_strain(self) -> FloatArray:
        """Accumulated equivalent plastic strain [-], shape (nx, ny, nz)."""
        return read_only(self._core.equivalent_plastic_strain_in(self.body - 1, self._box))

    def residual_stress(self) -> FloatArray:
        """Residual stress [Pa], shape (6, nx, ny, nz).

        It is the stress due to all plastic strain of the body plus the initial stress. With several
        subdomains, it is computed by the same operators as in the solver, see the page on
        plasticity.
        """
        return self._zones.stress(self._number, loaded=False)

    def stress(self) -> FloatArray:
        """Total stress [Pa], shape (6, nx, ny, nz)."""
        return self._zones.stress(self._number, loaded=True)

    def __repr__(self) -> str:
        return f"Zone(body={self.body}, first={self.first}, shape={self.shape})"


def _centres(first: int, count: int, cells: int, size: float) -> FloatArray:
    """Return the centres of `count` cells [m]; `first` is the grid index of the first centre."""
    return read_only(np.asarray((first - 0.5 * (cells - 1) + np.arange(count)) * size, np.float64))
