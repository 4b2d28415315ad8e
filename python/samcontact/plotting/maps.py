# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface from above: what a profile misses where a contact is rough."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from .._checks import choice, finite_array
from ..results.reading import cell_size
from .parts import SURFACES, edges, show_surface

if TYPE_CHECKING:
    import xarray as xr

    from ..grid import Grid

_BLANK = {"pressure": ", white: no contact", "gap": ", white: contact"}
_CLOSED = 1e-6  # of the largest gap


def surface_map(
    field: ArrayLike,
    grid: Grid,
    ax: Axes | None = None,
    *,
    quantity: str = "pressure",
    contact: ArrayLike | None = None,
) -> Axes:
    """Pressure, gap or print from above, with a colour bar.

    Parameters
    ----------
    field : array_like, shape (nx, ny)
        Pressure [Pa], gap or residual displacement [m].
    grid : Grid
        Its grid.
    ax : matplotlib.axes.Axes, optional
        Where to draw.
    quantity : {"pressure", "gap", "print"}
        What is shown. Where there is no pressure, or no gap, the map is white.
    contact : array_like of bool, shape (nx, ny), optional
        Where the bodies touch; default where there is pressure, or the gap is less than 1e-6 of its
        maximum.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        Wrong shape of the field, or an unknown quantity.
    """
    choice("quantity", quantity, tuple(SURFACES))
    values = finite_array(quantity, field, (grid.nx, grid.ny))
    if contact is not None:
        touching = finite_array("contact", np.asarray(contact, dtype=float), values.shape) > 0
    else:  # a gap is closed but for the tolerance of the contact
        touching = values > 0 if quantity == "pressure" else values <= _CLOSED * values.max()
    note = ""
    if quantity in _BLANK and np.any(touching) and not np.all(touching):
        values = np.where(touching == (quantity == "pressure"), values, np.nan)
        note = _BLANK[quantity]
    x, y = edges(grid.x, grid.dx), edges(grid.y, grid.dy)
    return show_surface(ax, x, y, values, quantity, "x", note)


def track_map(track: xr.Dataset, ax: Axes | None = None) -> Axes:
    """The permanent print of a moving contact from above.

    Parameters
    ----------
    track : xarray.Dataset
        From `Track.to_dataset`.
    ax : matplotlib.axes.Axes, optional
        Where to draw.

    Returns
    -------
    matplotlib.axes.Axes
    """
    x, y = (edges(track[axis], cell_size(track, axis)) for axis in "xy")
    name = f"x on body {track.attrs['body']}"
    return show_surface(ax, x, y, track["residual_displacement"].values, "print", name)
