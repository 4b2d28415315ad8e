# SPDX-License-Identifier: GPL-3.0-or-later
"""Enlargement of a grid whose edge the contact reaches."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager

from .._core import GridTooSmallError
from ..diagnostics import hertz_estimate
from ..problem.grid import Grid

MAX_ENLARGEMENT, MAX_CELLS_UNFITTED = 64, 1 << 22
"""Maximum number of cells, divided by the number of cells of the initial grid. The second value is
a number of cells that is always allowed while the grid is smaller than the Hertz contact."""
HERTZ_MARGIN = 1.25
"""Minimum side of an enlarged grid / width of the Hertz contact. Plastic flow widens contacts."""
_SIDE_GROWTH, _MIN_SIDE_GROWTH = (
    1.5,
    1.25,
)  # factor on a side that the contact reaches; minimum factor


def counts_for(
    error: GridTooSmallError,
    first: Grid,
    setup: hertz_estimate.ContactSetup,
    load: float | None = None,
    approach: float | None = None,
) -> list[int]:
    """Return the numbers of cells of the enlarged grid; raise ValueError if they are too many."""
    shape, sizes = setup.grid.surface_shape, (setup.grid.dx, setup.grid.dy)
    halves = zip(hertz_estimate.extent(setup, load, approach), sizes, strict=True)
    needed = [math.ceil(2 * HERTZ_MARGIN * half / d) for half, d in halves]
    fits = all(n >= cells for n, cells in zip(shape, needed, strict=True))
    counts = [
        enlarged_evenly(
            n, max(cells, _SIDE_GROWTH * n if fits and axis in (error.axes or "xy") else n)
        )
        for axis, n, cells in zip("xy", shape, needed, strict=True)
    ]
    max_cells = MAX_ENLARGEMENT * first.nx * first.ny
    max_cells = max(
        max_cells, MAX_ENLARGEMENT * needed[0] * needed[1] if fits else MAX_CELLS_UNFITTED
    )
    if counts[0] * counts[1] > max_cells:
        raise ValueError(f"{counts[0]} x {counts[1]} cells exceed the limit of {max_cells}")
    return counts


@contextmanager
def explain_failed_enlargement(error: GridTooSmallError, grid: Grid) -> Iterator[None]:
    """Context manager for enlarging a grid; on failure, raise `error` with the reason added."""
    try:
        yield
    except (ValueError, MemoryError) as reason:
        cells = f"{grid.nx} x {grid.ny} cells"
        error.args = (f"{error}; the grid of {cells} cannot be enlarged: {reason}",)
        raise error from reason


def enlarged_evenly(n: int, min_cells: float) -> int:
    """Return n if n >= `min_cells`; else n plus an even number, at least `min_cells` and 1.25 n."""
    if min_cells <= n:
        return n
    return n + 2 * math.ceil((max(min_cells, _MIN_SIDE_GROWTH * n) - n) / 2)
