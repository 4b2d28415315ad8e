# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps of surface fields."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, choice, finite_array, gap_array
from .._util.quantities import CONTACT, Quantity
from ..problem.contact_law import in_contact
from ..results.reading import cell_size
from .fields import Plane, inside_of_contact, name_sides, outline, show_surface
from .parts import SURFACES, edges
from .shown import quantity_for_values, quantity_of

if TYPE_CHECKING:
    import xarray as xr

    from ..problem.grid import Grid
    from .contact_results import ContactResults

_BLANK_NOTES = {"pressure": ", white: no contact", "gap": ", white: contact"}
_IMPRINT = SURFACES["imprint"]
_MIN_OPEN_GAP = 1e-6  # gap, relative to its maximum, below which it counts as closed


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
    """Draw a map of a surface field, e.g. the pressure, with a colour bar and the contact edge.

    Parameters
    ----------
    field : array_like, shape (nx, ny)
        Values in SI units, e.g. pressure [Pa], gap or residual displacement [m].
    grid : Grid
        Grid of the field.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    quantity : {"pressure", "gap", "imprint", "shear_x", "shear_y", "temperature"}, optional
        Quantity shown, which determines name, unit and colours. A map of pressure or gap is white
        where its values are zero. If `quantity` is omitted, values are shown without conversion,
        with a diverging colour map if any value is negative.
    label : str, optional
        Text to be shown instead of the name of the quantity.
    contact : array_like, shape (nx, ny), optional
        Field that is positive in contact cells, from which the contact edge is drawn. Give the
        pressure to have the edge interpolated between cell centres. Default for a map of pressure:
        the pressure. Default for a map of the gap: 1 in cells with a gap below 1e-6 of the maximum
        gap. For other quantities, the edge is drawn only if this argument is given.
    across : {"x", "y"}, optional
        Coordinate that runs from left to right. "y" rotates the map by 90°, with x downward, for
        contacts that are long along y.
    cells : bool, optional
        Show each cell in one colour, instead of smooth colours between the cell centres.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The field has the wrong shape, `quantity` or `across` is unknown, or values are impossible:
        a negative pressure, gap or temperature rise, a temperature rise above 1e6 K, or a length
        above 1000 times the longer side of the grid.
    """
    name = None if quantity is None else SURFACES[choice("quantity", quantity, tuple(SURFACES))]
    if quantity == "gap":  # white outside the body
        values = gap_array(quantity, field, (grid.nx, grid.ny))
        values = np.where(np.isfinite(values), values, np.nan)
    else:
        values = finite_array(quantity or "field", field, (grid.nx, grid.ny))
    shown = quantity_of(name, values, grid, argument=quantity or "field", label=label)
    return _draw(
        values, grid, ax, name, shown, contact, choice("across", across, ("x", "y")), cells
    )


def peak_map(results: ContactResults, name: str, ax: Axes) -> Axes:
    """Draw a `surface_map` of pressure or gap at the increment `peak` of the results."""
    values = results.surface(name, results.peak)
    values = np.where(np.isfinite(values), values, np.nan)  # white outside the body
    repulsion = results.surface("repulsion", results.peak)
    shown = quantity_for_values(name, values, results.grid)
    solved = np.isfinite(results.dataset["approach"].values[results.peak])
    # prescribed tractions do not close the gap
    known = name if solved or name == "pressure" else None
    return _draw(
        values, results.grid, ax, known, shown, repulsion, results.map_look[0], cells=False
    )


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
    elif name == "gap":  # closed within the tolerance of the contact
        pressed = (values <= _MIN_OPEN_GAP * np.nanmax(values)).astype(np.float64)
    else:
        pressed = np.zeros_like(values)
    plane = Plane(edges(grid.x, grid.dx), edges(grid.y, grid.dy))
    if across == "y":
        plane, values, pressed = Plane(*plane[::-1]), values.T, pressed.T
    inside, note = None, ""
    edge = inside_of_contact(np.maximum(pressed, 0.0))
    touching = in_contact(pressed)
    ends = bool(np.any(touching) and not np.all(touching))
    if name in _BLANK_NOTES and ends and not shown.signed:
        inside, note = edge if name == "pressure" else -edge, _BLANK_NOTES[name]
    if np.isnan(values).any():
        note = f"{note} or no body" if note else ", white: no body"
    ax = show_surface(ax, plane, values, shown, across, note, inside=inside, cells=cells)
    if ends and not cells:
        outline(ax, plane, edge, linestyles="dashed" if name == _IMPRINT else "solid")
    return name_sides(ax, across)


def track_map(track: xr.Dataset, ax: Axes | None = None, *, cells: bool = False) -> Axes:
    """Draw a map of the residual imprint of a moving contact.

    Parameters
    ----------
    track : xarray.Dataset
        Result of `Track.to_dataset`.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    cells : bool, optional
        Show each cell in one colour, instead of smooth colours between the cell centres.

    Returns
    -------
    matplotlib.axes.Axes
    """
    plane = Plane(*(edges(track[axis], cell_size(track, axis)) for axis in "xy"))
    depth, name = track["residual_displacement"].values, f"x on body {track.attrs['body']}"
    return show_surface(ax, plane, depth, CONTACT["residual_displacement"], name, cells=cells)
