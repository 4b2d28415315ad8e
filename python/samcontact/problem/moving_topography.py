# SPDX-License-Identifier: GPL-3.0-or-later
"""Surface topography (roughness, dents, furrows) that moves with a body."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from .._util.checks import FloatArray, boolean, finite_array, integer, real_array
from .._util.display import ShortRepr
from .._util.frozen import read_only
from ..surfaces import SurfaceGrid
from .grid import Grid

__all__ = ["Relief"]

MAX_ROWS = 1 << 20
"""Maximum number of rows between the initial contact and the last row of a dent or furrow."""


@dataclass(frozen=True, eq=False, repr=False)
class Relief(ShortRepr):
    """Surface topography (roughness, dents) that moves with a body.

    Parameters
    ----------
    heights : array_like, shape (rows, ny)
        Heights [m], positive out of the body, in cells of the same size as the grid cells. The
        number of rows along x is arbitrary.
    first : int, optional
        Index of the grid row at which the first row of heights lies initially; may be negative. As
        the body moves towards +x, rows with negative indices enter the grid.
    periodic : bool, optional
        Whether the rows repeat along x. By default the surface is flat (height 0) beyond the rows.
        On a grid that is periodic along x, every relief repeats with the period of the grid. Its
        number of rows must then divide grid.nx if `periodic`, and otherwise be at most grid.nx.
    worn : array_like, shape (rows, ny), optional
        Depth of material already removed by wear [m], >= 0. The depths of a yield profile and of
        an initial residual stress are then measured from the unworn surface. This argument does not
        change the heights. Default: 0, which also applies beyond the rows.

    Raises
    ------
    ValueError, TypeError
        Heights are not finite or not two-dimensional, worn depths are negative or have another
        shape, or `first` is not an integer.
    """

    heights: FloatArray
    first: int = 0
    periodic: bool = False
    worn: FloatArray | None = None

    def __post_init__(self) -> None:
        heights = real_array("heights", self.heights)
        if heights.ndim != 2:
            raise ValueError(f"heights must have shape (rows, ny), got {heights.shape}")
        checked = np.array(finite_array("heights", heights, heights.shape), order="C")
        object.__setattr__(self, "heights", read_only(checked))
        object.__setattr__(self, "first", integer("first", self.first))
        object.__setattr__(self, "periodic", boolean("periodic", self.periodic))
        if self.worn is not None:
            worn = np.array(finite_array("worn", self.worn, heights.shape), order="C")
            if (worn < 0).any():
                raise ValueError(f"worn must be >= 0 everywhere, got {float(worn.min())!r}")
            object.__setattr__(self, "worn", read_only(worn))


def relief_rows(name: str, relief: Relief | None, grid: Grid) -> tuple[Any, int, bool, Any] | None:
    """Check a relief against the grid, and return it as arguments of the compiled core, or None."""
    if relief is None:
        return None
    if not isinstance(relief, Relief):
        raise TypeError(f"{name} must be a Relief, got {type(relief).__name__}")
    if relief.heights.shape[1] != grid.ny or relief.heights.shape[0] == 0:
        raise ValueError(
            f"{name} must have heights of shape (rows, {grid.ny}), got {relief.heights.shape}"
        )
    if grid.along_x:
        _require_period(name, relief, grid)
        relief = over_period(relief, grid.nx)
    return relief.heights, int(relief.first), bool(relief.periodic), relief.worn


def _require_period(name: str, relief: Relief, grid: Grid) -> None:
    """Raise ValueError unless a relief fits into the period of a grid along x."""
    rows = len(relief.heights)
    if relief.periodic and grid.nx % rows:
        raise ValueError(
            f"{name} repeats every {rows} rows, which must divide grid.nx = {grid.nx} because the "
            "grid is periodic along x"
        )
    if rows > grid.nx:
        raise ValueError(
            f"{name} must have at most grid.nx = {grid.nx} rows because the grid is periodic along "
            f"x, got {rows}"
        )


def over_period(relief: Relief, rows: int) -> Relief:
    """Return a periodic relief of `rows` rows that contains the heights of the given relief."""
    count = len(relief.heights)
    at = np.arange(rows if relief.periodic else count)

    def over(values: FloatArray) -> FloatArray:
        repeated = np.zeros((rows, values.shape[1]))
        repeated[(relief.first + at) % rows] = values[at % count]
        return repeated

    worn = None if relief.worn is None else over(relief.worn)
    return Relief(over(relief.heights), 0, True, worn)


def heights_over(relief: Relief, first: int, count: int, grid: Grid) -> FloatArray:
    """Return heights of a relief [m] in `count` grid rows from row `first`, shape (count, ny)."""
    if grid.along_x:
        relief = over_period(relief, grid.nx)
    rows = len(relief.heights)
    places = np.arange(first, first + count) - relief.first
    if relief.periodic:
        places %= rows
    inside = (places >= 0) & (places < rows)
    return np.where(inside[:, None], relief.heights[np.clip(places, 0, rows - 1)], 0.0)


def rows_within(grid: SurfaceGrid, x: float, radius: float) -> tuple[FloatArray, int]:
    """Return positions [m] of grid rows within `radius` of x, and the index of the first row."""
    middle = 0.5 * (grid.nx - 1)
    if not (abs(x) + radius) / grid.dx < MAX_ROWS:
        raise ValueError(
            f"all rows around x must be within {MAX_ROWS} cells (of {grid.dx!r} m) of the grid "
            f"centre, got x = {x!r} m and rows up to {radius!r} m from it"
        )
    first = int(np.ceil((x - radius) / grid.dx + middle))
    last = max(first, int(np.floor((x + radius) / grid.dx + middle)))
    return np.asarray((np.arange(first, last + 1) - middle) * grid.dx, dtype=np.float64), first
