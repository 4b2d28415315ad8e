# SPDX-License-Identifier: GPL-3.0-or-later
"""Section [film.transient] of a case file: moving reliefs, and load and speeds over time."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from pydantic import Field, model_validator

from .._util.lazy_scipy import scipy
from .base import Count, Finite, NonNegative, Positive, Section
from .converted import Unit

if TYPE_CHECKING:
    from .._util.checks import FloatArray
    from ..problem.grid import Grid
    from ..problem.moving_topography import Relief

Vectors = tuple[tuple[float, float], tuple[float, float]]
"""Velocities of bodies 1 and 2 along x and y."""
Heights = Callable[["FloatArray", "FloatArray"], "FloatArray"]
_ROWS_BEYOND = 4  # flat rows around a relief, for the splines


class TransientSection(Section):
    """[film.transient]: duration and steps, load and speeds over time, see `transient`."""

    duration: Annotated[Positive, Unit("s")]
    steps: Count | None = None
    times: Annotated[list[NonNegative], Field(min_length=2), Unit("s")] | None = None
    load_factors: Annotated[list[Positive], Field(min_length=2)] | None = None
    speed_factors: Annotated[list[Finite], Field(min_length=2)] | None = None

    @model_validator(mode="after")
    def _go_together(self) -> TransientSection:
        given = [n for n in ("load_factors", "speed_factors") if getattr(self, n) is not None]
        if (self.times is None) != (not given):
            raise ValueError(
                "`times` requires load_factors or speed_factors, and these require `times`: "
                + ("add times" if given else "add factors, or omit times")
            )
        times = self.times or []
        if any(after <= before for before, after in pairwise(times)):
            raise ValueError(f"times must increase, got {times}")
        for name in given:
            if len(getattr(self, name)) != len(times):
                raise ValueError(
                    f"{name} must have as many values as times ({len(times)}), got "
                    f"{len(getattr(self, name))}"
                )
        return self

    def load_factor(self, time: float) -> float:
        """Return the factor on the load at a time [s] by linear interpolation."""
        return self._factor(self.load_factors, time)

    def speed_factor(self, time: float) -> float:
        """Return the factor on the speeds at a time [s] by linear interpolation."""
        return self._factor(self.speed_factors, time)

    def _factor(self, factors: list[float] | None, time: float) -> float:
        return 1.0 if factors is None else float(np.interp(time, self.times or [], factors))

    def count(self, grid: Grid, velocities: Vectors) -> int:
        """Return the number of steps: `steps`, or one per cell of travel of the faster surface.

        velocities: of bodies 1 and 2 along x and y, before multiplication by speed factors [m/s].
        """
        if self.steps is not None:
            return self.steps
        largest = max(map(abs, self.speed_factors or [1.0]))
        cells = np.abs(velocities) / [grid.dx, grid.dy if grid.ny > 1 else math.inf]
        return max(math.ceil(self.duration * largest * float(cells.max()) - 1e-9), 1)


def moving_heights(section: Any, grid: Grid, cells: tuple[int, int], folder: Path) -> Heights:
    """Return the heights of a relief at time 0 [m] as a function of positions x and y on the grid.

    section: [relief1] or [relief2], in which x = y = 0 is the contact. cells: distance
    of the contact from the centre of the grid, in cells.
    """
    more = abs(cells[1])
    relief = section.build(replace(grid, ny=grid.ny + 2 * more), folder)
    return _function(relief, grid, cells[0], more - cells[1])


def _function(relief: Relief, grid: Grid, shift: int, column: int) -> Heights:
    """Return a function that interpolates the heights of a relief by cubic splines along x."""
    heights = relief.heights[:, column : column + grid.ny]
    first = relief.first + shift
    if relief.periodic:
        rows, ends = np.concatenate([heights, heights[:1]]), "periodic"
    else:  # beyond the rows, the surface is flat
        rows, ends = np.pad(heights, ((_ROWS_BEYOND, _ROWS_BEYOND), (0, 0))), "natural"
        first -= _ROWS_BEYOND
    spline = scipy.interpolate.CubicSpline(np.arange(len(rows)), rows, bc_type=ends)

    def function(x: FloatArray, y: FloatArray) -> FloatArray:
        row = x[:, 0] / grid.dx + 0.5 * (grid.nx - 1) - first
        if not relief.periodic:
            row = np.clip(row, 0.0, len(rows) - 1.0)
        found: FloatArray = spline(row)
        return found

    return function
