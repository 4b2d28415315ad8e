# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface from above: what a profile misses where a contact is rough."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from .._checks import choice, finite_array, gap_array
from .._quantities import CONTACT
from ..results.reading import cell_size
from .fields import Plane, inside_of_contact, name_sides, outline, show_surface
from .parts import SURFACES, edges

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
    across: str = "x",
    cells: bool = False,
) -> Axes:
    """Pressure, gap or print from above, with a colour bar and a line around the contact.

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
    contact : array_like, shape (nx, ny), optional
        Above zero where the bodies touch; the pressure tells where between two cells the contact
        ends. Default where there is pressure, or the gap is less than 1e-6 of its maximum; a print
        has a line around the contact if it is given here.
    across : {"x", "y"}, optional
        Coordinate from left to right. "y" turns the map by a quarter, with x downward: for contacts
        that are long along y.
    cells : bool, optional
        Show each cell in its colour, instead of what is smooth through their centres.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        Wrong shape of the field, or an unknown quantity or coordinate.
    """
    choice("quantity", quantity, tuple(SURFACES))
    choice("across", across, ("x", "y"))
    if quantity == "gap":  # white where there is no body
        values = gap_array(quantity, field, (grid.nx, grid.ny))
        values = np.where(np.isfinite(values), values, np.nan)
    else:
        values = finite_array(quantity, field, (grid.nx, grid.ny))
    if contact is not None:
        pressed = finite_array("contact", np.asarray(contact, dtype=float), values.shape)
    elif quantity == "print":
        pressed = np.zeros_like(values)
    else:  # a gap is closed but for the tolerance of the contact
        closed = values <= _CLOSED * np.nanmax(values)
        pressed = values if quantity == "pressure" else closed.astype(np.float64)
    plane = Plane(edges(grid.x, grid.dx), edges(grid.y, grid.dy))
    if across == "y":
        plane, values, pressed = Plane(*plane[::-1]), values.T, pressed.T
    inside, note = None, ""
    edge = inside_of_contact(np.maximum(pressed, 0.0))
    ends = bool(np.any(pressed > 0) and not np.all(pressed > 0))
    if quantity in _BLANK and ends:
        inside, note = edge if quantity == "pressure" else -edge, _BLANK[quantity]
    if np.isnan(values).any():
        note = f"{note} or no body" if note else ", white: no body"
    shown = CONTACT[SURFACES[quantity]]
    ax = show_surface(ax, plane, values, shown, across, note, inside=inside, cells=cells)
    if ends and not cells:
        outline(ax, plane, edge, linestyles="dashed" if quantity == "print" else "solid")
    return name_sides(ax, across)


def track_map(track: xr.Dataset, ax: Axes | None = None, *, cells: bool = False) -> Axes:
    """The permanent print of a moving contact from above.

    Parameters
    ----------
    track : xarray.Dataset
        From `Track.to_dataset`.
    ax : matplotlib.axes.Axes, optional
        Where to draw.
    cells : bool, optional
        Show each cell in its colour, instead of what is smooth through their centres.

    Returns
    -------
    matplotlib.axes.Axes
    """
    plane = Plane(*(edges(track[axis], cell_size(track, axis)) for axis in "xy"))
    depth, name = track["residual_displacement"].values, f"x on body {track.attrs['body']}"
    return show_surface(ax, plane, depth, CONTACT["residual_displacement"], name, cells=cells)
