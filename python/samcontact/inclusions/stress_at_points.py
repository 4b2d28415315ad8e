# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress of a state, interpolated to the points of a finer grid."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from .._util.checks import FloatArray
from .._util.display import quantity
from .._util.lazy_scipy import scipy
from ..solutions.state import State

_MARGIN = 4  # cells of the state around the points that the splines use
_CUBIC, _LINEAR = 3, 1


class StressAtPoints:
    """Interpolation of the stress of one body of a state."""

    def __init__(self, state: State, which: int) -> None:
        self._state, self._which, self._grid = state, which, state.grid

    def require_matrix(self, ends: Sequence[FloatArray], numbers: Sequence[int]) -> None:
        """Raise ValueError if a box extends beyond the grid or contains inclusions of the body."""
        low, high = ends
        grid = self._grid
        sides = (("x", grid.nx * grid.dx, grid.along_x), ("y", grid.ny * grid.dy, grid.along_y))
        for axis, (name, length, periodic) in enumerate(sides):
            outside = max(-low[axis], high[axis]) > length / 2 * (1 + 1e-9)
            if outside and not periodic:
                raise ValueError(
                    f"the fine box around inclusions {list(numbers)} must lie inside the grid, "
                    f"within {name} = ±{quantity(length / 2, 'm')}, got {name} = {low[axis]:.4g} "
                    f"to {high[axis]:.4g} m: use a smaller value of within, or enlarge the grid"
                )
        x, y, z = (self._cells(axis, low[axis], high[axis], 0) for axis in range(3))
        share = self._at_layers(int(z[-1]) + 1).share(self._which)
        if share[np.ix_(x, y, z)].any():
            raise ValueError(
                f"the fine box around inclusions {list(numbers)} must not contain inclusions of "
                "the body: use a smaller value of within, or omit these inclusions"
            )

    def at(self, x: FloatArray, y: FloatArray, z: FloatArray) -> tuple[FloatArray, float]:
        """Stress at points [Pa], shape (6, nx, ny, nz), and a bound of its relative error."""
        axes = [self._axis(axis, points) for axis, points in enumerate((x, y, z))]
        cells = [cells for cells, _, _ in axes]
        state = self._at_layers(int(cells[2][-1]) + 1)
        stress = np.asarray(state.stress(self._which))
        at_all: tuple[Any, ...] = (slice(None), *np.ix_(*cells))
        block = stress[at_all]
        found, rough = (
            np.einsum("cijk,xi,yj,zk->cxyz", block, *(of[n] for of in axes), optimize=True)
            for n in (1, 2)
        )
        largest = float(np.abs(found).max())
        return found, float(np.abs(found - rough).max()) / largest if largest > 0 else 0.0

    def _at_layers(self, layers: int) -> State:
        return self._state.at_layers(max(layers, self._state.layers))

    def _step(self, axis: int) -> tuple[float, int, bool, float]:
        """Return cell size, number of cells, periodicity and lower edge along an axis."""
        grid = self._grid
        assert grid.dz is not None
        if axis == 2:
            return grid.dz, 0, False, 0.0
        sides = ((grid.dx, grid.nx, grid.along_x), (grid.dy, grid.ny, grid.along_y))
        step, count, periodic = sides[axis]
        return step, count, periodic, -count / 2 * step

    def _cells(self, axis: int, low: float, high: float, margin: int) -> np.ndarray:
        """Indices of the cells between two coordinates, and of `margin` more cells at each end."""
        step, count, periodic, edge = self._step(axis)
        first = math.floor((low - edge) / step + 1e-9) - margin
        last = math.ceil((high - edge) / step - 1e-9) + margin
        cells = np.arange(first, last)
        if periodic:
            return np.unique(cells % count) if count == 1 else cells % count
        cells = cells[cells >= 0]
        return cells if axis == 2 else cells[cells < count]

    def _axis(self, axis: int, points: FloatArray) -> tuple[np.ndarray, FloatArray, FloatArray]:
        """Cells of the state near points, and the weights of cubic and of linear interpolation.

        The weights have the shape (points, cells).
        """
        step, _, periodic, edge = self._step(axis)
        cells = self._cells(axis, float(points[0]), float(points[-1]), _MARGIN)
        if cells.size == 1:
            ones = np.ones((points.size, 1))
            return cells, ones, ones
        first = cells[0]
        if periodic:
            first = math.floor((points[0] - edge) / step + 1e-9) - _MARGIN
        at = edge + (first + np.arange(cells.size) + 0.5) * step
        spline, every = scipy.interpolate.make_interp_spline, np.eye(cells.size)
        weights = [
            np.asarray(spline(at, every, k=min(k, cells.size - 1))(points))
            for k in (_CUBIC, _LINEAR)
        ]
        return cells, weights[0], weights[1]
