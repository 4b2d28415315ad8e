# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface from above: what a profile misses where a contact is rough."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from .._checks import choice, finite_array
from .parts import SURFACES, edges, show_surface

if TYPE_CHECKING:
    from ..grid import Grid
    from ..state import State
    from ..track import Track

_BLANK = {"pressure": ", white: no contact", "gap": ", white: contact"}
_CLOSED = 1e-6  # of the largest gap


def surface_map(
    state: State | ArrayLike,
    grid: Grid,
    ax: Axes | None = None,
    *,
    quantity: str = "pressure",
    body: int = 2,
) -> Axes:
    """Pressure, gap or print from above, with a colour bar.

    Parameters
    ----------
    state : State or array_like, shape (nx, ny)
        A state, or the field: pressure [Pa], gap or residual displacement [m]. A state tells where
        the contact is; of a mere gap it is where the gap is less than 1e-6 of its maximum.
    grid : Grid
        Its grid.
    ax : matplotlib.axes.Axes, optional
        Where to draw.
    quantity : {"pressure", "gap", "print"}
        What is shown. Where there is no pressure, or no gap, the map is white.
    body : {1, 2}
        Whose print.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        Wrong shape of the field, or an unknown quantity or body.
    """
    choice("quantity", quantity, tuple(SURFACES))
    choice("body", body, (1, 2))
    field: Any = state
    touching = None
    if hasattr(field, "pressure"):
        touching = np.asarray(field.pressure) > 0
        field = _of(field, quantity, body)
    values = finite_array(quantity, field, (grid.nx, grid.ny))
    if touching is None:  # a gap is closed but for the tolerance of the contact
        touching = values > 0 if quantity == "pressure" else values <= _CLOSED * values.max()
    note = ""
    if quantity in _BLANK and np.any(touching) and not np.all(touching):
        values = np.where(touching == (quantity == "pressure"), values, np.nan)
        note = _BLANK[quantity]
    x, y = edges(grid.x, grid.dx), edges(grid.y, grid.dy)
    return show_surface(ax, x, y, values, quantity, "x", note)


def _of(state: Any, quantity: str, body: int) -> Any:
    return (
        state.residual_displacement(body=body) if quantity == "print" else getattr(state, quantity)
    )


def track_map(track: Track, ax: Axes | None = None) -> Axes:
    """The permanent print of a moving contact from above.

    Parameters
    ----------
    track : Track
        From `State.track`.
    ax : matplotlib.axes.Axes, optional
        Where to draw.

    Returns
    -------
    matplotlib.axes.Axes
    """
    x, y = edges(track.x, track.grid.dx), edges(track.y, track.grid.dy)
    name = f"x on body {track.body}"
    return show_surface(ax, x, y, track.residual_displacement(), "print", name)
