# SPDX-License-Identifier: GPL-3.0-or-later
"""A cycle in which a contact passes over a surface that has no ends."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import integer, require_type, tractions
from ..scene.grid import Grid


def passes(grid: Grid, pressure: ArrayLike, cells: int = 1) -> list[dict[str, Any]]:
    """Steps in which a pressure passes once over a surface that is periodic along x.

    Towards +x, from where it is given, once through the period: every point of the surface sees
    the same, as below a train of equal rollers, one in each period. No contact is solved. With
    friction as a number the shear along +x passes with it.

    Parameters
    ----------
    grid : Grid
        With periodic = "x" or "xy".
    pressure : array_like, shape (nx, ny)
        [Pa], e.g. that of `hertz.line` in the middle of a period of 6 half-widths or more.
    cells : int, optional
        Cells between two steps; divides nx.

    Returns
    -------
    list of dict
        For `run` or `Simulation.run`.

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
            f"grid must be periodic along x, got periodic = {grid.periodic!r}: on a track with "
            "ends use paths.rolling, and bring the bodies back"
        )
    step = integer("cells", cells, 1)
    if grid.nx % step:
        raise ValueError(f"cells must divide nx = {grid.nx}, got {cells!r}")
    start = tractions("pressure", pressure, grid.surface_shape)
    return [{"pressure": np.roll(start, n, axis=0)} for n in range(0, grid.nx, step)]
