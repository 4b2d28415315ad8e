# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact domain: a grid with the undeformed surfaces of both bodies."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, gap_array
from .._util.frozen import read_only
from .grid import Grid
from .moving_topography import Relief, heights_over, relief_rows

_SAME_HEIGHT_TOLERANCE = 1e-9  # relative to the heights
_SAME_PLACE_TOLERANCE = 1e-6  # relative to the cells


@dataclass(frozen=True, eq=False)
class Domain:
    """Grid with the initial gap, and the moving topography (relief) of each body."""

    grid: Grid
    initial_gap: FloatArray
    relief1: Relief | None
    relief2: Relief | None

    @property
    def reliefs(self) -> tuple[Relief | None, Relief | None]:
        return self.relief1, self.relief2

    @property
    def cells(self) -> int:
        return self.grid.nx * self.grid.ny


@dataclass(frozen=True, eq=False)
class SurfaceGeometry:
    """Gap and reliefs of two bodies, as arrays on one grid or as functions of the grid."""

    gap: ArrayLike | Callable[[Grid], ArrayLike]
    relief1: Relief | Callable[[Grid], Relief] | None = None
    relief2: Relief | Callable[[Grid], Relief] | None = None

    @property
    def are_known(self) -> bool:
        """Whether gap and reliefs are functions, and can thus be computed on any grid."""
        reliefs = (self.relief1, self.relief2)
        return callable(self.gap) and all(r is None or callable(r) for r in reliefs)

    def over(self, grid: Grid, strip: tuple[float, float] = (-math.inf, math.inf)) -> Domain:
        """Check the surfaces on a grid, and return the domain.

        strip: range of y in which both bodies exist [m]; the gap is infinite beyond it.
        """
        gap = self.gap(grid) if callable(self.gap) else self.gap
        reliefs = [r(grid) if callable(r) else r for r in (self.relief1, self.relief2)]
        relief_rows("relief1", reliefs[0], grid)
        relief_rows("relief2", reliefs[1], grid)
        checked = np.array(gap_array("gap", gap, grid.surface_shape), order="C")
        low, high = strip
        for face in strip:
            if math.isfinite(face):
                _require_possible(grid, face)
                checked[:, (grid.y < low) | (grid.y > high)] = np.inf
        return Domain(grid, read_only(checked), *reliefs)


def _require_possible(grid: Grid, face: float) -> None:
    """Raise ValueError if the grid is periodic, or if a free face at y = `face` cuts cells."""
    if grid.periodic:
        raise ValueError(
            f"free_faces cannot be combined with grid.periodic = {grid.periodic!r}, got a face at "
            f"y = {face!r} m: the displacement of periodic surfaces near a free face is not known"
        )
    row = face / grid.dy + 0.5 * grid.ny
    if abs(row - round(row)) > _SAME_PLACE_TOLERANCE:
        nearest = (round(row) - 0.5 * grid.ny) * grid.dy
        raise ValueError(
            f"free_faces must lie on edges of cells, got a face at y = {face!r} m with grid.dy = "
            f"{grid.dy!r} m and grid.ny = {grid.ny}: the nearest edge is at {nearest:.9g} m"
        )


def require_consistent_overlap(larger: Domain, window: Domain) -> None:
    """Raise ValueError unless the surfaces of two domains agree in the cells of the smaller one."""
    i = (larger.grid.nx - window.grid.nx) // 2
    j = (larger.grid.ny - window.grid.ny) // 2
    columns = slice(j, j + window.grid.ny)
    shown = [("gap", larger.initial_gap[i : i + window.grid.nx, columns], window.initial_gap)]
    for number, (now, before) in enumerate(zip(larger.reliefs, window.reliefs, strict=True), 1):
        if now is not None and before is not None:
            first, rows = before.first, len(before.heights)
            heights = heights_over(now, first + i, rows, larger.grid)[:, columns]
            shown.append((f"relief{number}", heights, before.heights))
    for name, field, known in shown:
        body = np.isfinite(known)
        if not np.array_equal(np.isfinite(field), body):
            raise ValueError(
                f"{name} must give the same result on every grid, but on a larger grid, it is "
                "infinite (no body) in other cells: let it depend on the coordinates only"
            )
        off = np.abs(field[body] - known[body])
        if not np.all(off <= _SAME_HEIGHT_TOLERANCE * float(np.ptp(known[body]))):
            raise ValueError(
                f"{name} must give the same result on every grid, but on a larger grid, heights "
                f"in the common cells differ by up to {off.max():.3g} m: let it depend on the "
                "coordinates only"
            )
