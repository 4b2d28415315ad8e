# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface from above: what a profile misses where a contact is rough."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, choice, finite_array, gap_array
from .._util.quantities import CONTACT, Quantity
from ..results.reading import cell_size
from ..scene.contact_law import in_contact
from .fields import Plane, inside_of_contact, name_sides, outline, show_surface
from .parts import SURFACES, edges
from .shown import of_either_sign, quantity_of

if TYPE_CHECKING:
    import xarray as xr

    from ..scene.grid import Grid
    from .scene import Scene

_BLANK = {"pressure": ", white: no contact", "gap": ", white: contact"}
_PRINT = SURFACES["print"]
_CLOSED = 1e-6  # of the largest gap


def surface_map(
    field: ArrayLike,
    grid: Grid,
    ax: Axes | None = None,
    *,
    quantity: str | None = None,
    label: str | None = None,
    contact: ArrayLike | None = None,
    across: str = "x",
    cells: bool = False,
) -> Axes:
    """Pressure, gap or print from above, with a colour bar and a line around the contact.

    Parameters
    ----------
    field : array_like, shape (nx, ny)
        Values in SI units, e.g. pressure [Pa], gap or residual displacement [m].
    grid : Grid
        Its grid.
    ax : matplotlib.axes.Axes, optional
        Where to draw.
    quantity : {"pressure", "gap", "print", "shear_x", "shear_y", "temperature"}, optional
        What is shown; decides name, unit and colours. Where there is no pressure, or no gap, the
        map is white. Without it values are shown as they are given, in colours of both signs where
        both occur.
    label : str, optional
        Instead of the name of the quantity, before its unit.
    contact : array_like, shape (nx, ny), optional
        Above zero where the bodies touch; the pressure tells where between two cells the contact
        ends. Default where there is pressure, or the gap is less than 1e-6 of its maximum; other
        quantities have a line around the contact if it is given here.
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
        Wrong shape of the field, an unknown quantity or coordinate, or values that the quantity
        cannot have: pressure, gap or temperature below zero, a length a thousand times the grid.
    """
    name = None if quantity is None else SURFACES[choice("quantity", quantity, tuple(SURFACES))]
    if quantity == "gap":  # white where there is no body
        values = gap_array(quantity, field, (grid.nx, grid.ny))
        values = np.where(np.isfinite(values), values, np.nan)
    else:
        values = finite_array(quantity or "field", field, (grid.nx, grid.ny))
    shown = quantity_of(name, values, grid, argument=quantity or "field", label=label)
    return _draw(
        values, grid, ax, name, shown, contact, choice("across", across, ("x", "y")), cells
    )


def peak_map(scene: Scene, name: str, ax: Axes) -> Axes:
    """`surface_map` of the pressure or the gap of a run at its peak, also of given tractions."""
    values, repulsion = scene.surface(name, scene.peak), scene.surface("repulsion", scene.peak)
    shown = of_either_sign(name, values, scene.grid)
    solved = np.isfinite(scene.dataset["approach"].values[scene.peak])
    known = name if solved or name == "pressure" else None  # no gap is closed by given tractions
    return _draw(values, scene.grid, ax, known, shown, repulsion, scene.map_look[0], cells=False)


def _draw(
    values: FloatArray,
    grid: Grid,
    ax: Axes | None,
    name: str | None,
    shown: Quantity,
    contact: ArrayLike | None,
    across: str,
    cells: bool,
) -> Axes:
    if contact is not None:
        pressed = finite_array("contact", np.asarray(contact, dtype=float), values.shape)
    elif name == "pressure":
        pressed = values
    elif name == "gap":  # closed but for the tolerance of the contact
        pressed = (values <= _CLOSED * np.nanmax(values)).astype(np.float64)
    else:
        pressed = np.zeros_like(values)
    plane = Plane(edges(grid.x, grid.dx), edges(grid.y, grid.dy))
    if across == "y":
        plane, values, pressed = Plane(*plane[::-1]), values.T, pressed.T
    inside, note = None, ""
    edge = inside_of_contact(np.maximum(pressed, 0.0))
    touching = in_contact(pressed)
    ends = bool(np.any(touching) and not np.all(touching))
    if name in _BLANK and ends and not shown.signed:
        inside, note = edge if name == "pressure" else -edge, _BLANK[name]
    if np.isnan(values).any():
        note = f"{note} or no body" if note else ", white: no body"
    ax = show_surface(ax, plane, values, shown, across, note, inside=inside, cells=cells)
    if ends and not cells:
        outline(ax, plane, edge, linestyles="dashed" if name == _PRINT else "solid")
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
