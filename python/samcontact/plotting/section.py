# SPDX-License-Identifier: GPL-3.0-or-later
"""Cross-sections of volume fields."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from .._util.checks import choice, finite, finite_array
from ..problem.contact_law import in_contact
from .fields import Plane, show_section, touching_along
from .parts import INTERFACE_STYLE, SECTIONS, depths_of, edges, nearest
from .shown import quantity_of

if TYPE_CHECKING:
    from ..problem.grid import Grid


def section(
    field: ArrayLike,
    grid: Grid,
    ax: Axes | None = None,
    *,
    quantity: str | None = None,
    plane: str = "y",
    position: float = 0.0,
    label: str | None = None,
    interfaces: ArrayLike = (),
    contact: ArrayLike | None = None,
    cells: bool = False,
) -> Axes:
    """Draw a cross-section of a volume field with contour lines and a colour bar, depth downward.

    Parameters
    ----------
    field : array_like, shape (nx, ny, nz)
        Values in SI units.
    grid : Grid
        Grid of the field, with layers (dz).
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    quantity : {"von_mises", "hydrostatic", "equivalent_plastic_strain", \
"residual_von_mises", "residual_hydrostatic", "stress", "residual_stress", "plastic_strain", \
"temperature"}, optional
        Quantity shown, which determines name, unit and colours. If omitted, values are shown
        without conversion, with a diverging colour map if any value is negative.
    plane : {"y", "x"}
        Coordinate that is constant on the section.
    position : float
        Value of the constant coordinate [m]; the nearest row of cells is shown.
    label : str, optional
        Text to be shown instead of the name of the quantity.
    interfaces : array_like, shape (n,), optional
        Depths of the interfaces between layers [m], e.g. `Layered.interfaces`; drawn as lines.
    contact : array_like, shape (nx, ny), optional
        Field that is positive in contact cells, e.g. the repulsion; the contact is shown as a bar
        along the surface.
    cells : bool, optional
        Show each cell in one colour, instead of smooth colours between the cell centres.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The grid has no layers, the field has the wrong shape, `quantity` or `plane` is unknown, or
        values are impossible: a negative von Mises stress, equivalent plastic strain or temperature
        rise, a strain above 100, or a temperature rise above 1e6 K.
    """
    choice("plane", plane, ("y", "x"))
    if quantity is not None:
        choice("quantity", quantity, SECTIONS)
    depths = depths_of(grid, field)
    values = finite_array("field", field, (grid.nx, grid.ny, len(depths)))
    assert grid.dz is not None
    shown = quantity_of(quantity, values, grid, label=label)
    finite("position", position)
    row: Any
    if plane == "y":
        row = np.s_[:, nearest(grid.y, position)]
        across, name = edges(grid.x, grid.dx), "x"
    else:
        row = np.s_[nearest(grid.x, position), :]
        across, name = edges(grid.y, grid.dy), "y"
    between = finite_array("interfaces", interfaces, np.shape(interfaces))
    touching = None if contact is None else finite_array("contact", contact, values.shape[:2])
    sides = Plane(across, edges(depths, grid.dz))
    ax = show_section(ax, sides, values[row], shown, name, cells=cells)
    for depth in between[between < sides.down[-1]]:
        ax.axhline(depth * 1e6, **INTERFACE_STYLE)
    if touching is not None:
        touching_along(ax, across, in_contact(touching[row]))
    return ax
