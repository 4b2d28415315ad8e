# SPDX-License-Identifier: GPL-3.0-or-later
"""Load cycle of a prescribed pressure that passes over a periodic surface."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import integer, require_type, tractions
from ..problem.grid import Grid


def passes(grid: Grid, pressure: ArrayLike, cells: int = 1) -> list[dict[str, Any]]:
    """Return steps that move a prescribed pressure once over a surface that is periodic along x.

    The pressure moves towards +x through one period, starting at its given position. All points
    with equal y and equal depth have the same stress history, as under a train of equal rollers,
    one per period. The contact is not solved. With friction given as a number, the shear traction
    along +x moves with the pressure.

    Parameters
    ----------
    grid : Grid
        Grid with periodic = "x" or "xy".
    pressure : array_like, shape (nx, ny)
        Contact pressure [Pa], e.g. from `hertz.line`, centred in a period of at least 6
        half-widths.
    cells : int, optional
        Number of cells by which the pressure moves in each step; must divide nx.

    Returns
    -------
    list of dict
        Steps for `run` or `Simulation.run`.

    Raises
    ------
    ValueError
        The grid is not periodic along x, or an argument is outside its range.

    Examples
    --------
    >>> import samcontact as sc
    >>> grid = sc.Grid(4, 1, 1e-6, 1e-5, dz=1e-6, periodic="xy")
    >>> for step in passes(grid, [[0.0], [1e9], [2e9], [1e9]], cells=2):
    ...     print(step["pressure"].ravel())
    [0.e+00 1.e+09 2.e+09 1.e+09]
    [2.e+09 1.e+09 0.e+00 1.e+09]
    """
    require_type("grid", grid, Grid)
    if not grid.along_x:
        raise ValueError(
            f"grid must be periodic along x, got periodic = {grid.periodic!r}: for a track with "
            "ends, use paths.rolling and move the bodies back after each pass"
        )
    step = integer("cells", cells, 1)
    if grid.nx % step:
        raise ValueError(f"cells must be a divisor of nx ({grid.nx}), got {cells!r}")
    start = tractions("pressure", pressure, grid.surface_shape)
    return [{"pressure": np.roll(start, n, axis=0)} for n in range(0, grid.nx, step)]
