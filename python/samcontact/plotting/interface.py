# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of the stresses at the interfaces of a layered body."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, choice, finite, finite_array, integer
from .._util.quantities import CONTACT
from ..problem.contact_law import in_contact
from ..results.contact import repulsion_of
from .fields import touching_along
from .parts import (
    COMPONENT_INDEX,
    axes_or_new,
    edges,
    elsewhere,
    finish,
    nearest,
    new_figure,
    row_of_interest,
)

if TYPE_CHECKING:
    from ..problem.grid import Grid
    from .contact_results import ContactResults

_MAX_PANELS = 3
_TENSION_LABEL = "maximum tension"
_MIN_MARKED_TENSION = 1e-2
"""Smallest maximum tension that is marked, relative to the maximum stress drawn."""
_SIDE_STYLES = (("above", "C0", "-"), ("below", "C1", "--"))
_LEGEND_ABOVE: Any = {"loc": "lower center", "bbox_to_anchor": (0.5, 1.0), "frameon": False}


def interface_profile(
    stress: ArrayLike,
    grid: Grid,
    ax: Axes | None = None,
    *,
    interface: int = 0,
    interfaces: ArrayLike = (),
    axis: str = "x",
    position: float = 0.0,
    contact: ArrayLike | None = None,
) -> Axes:
    """Draw normal, shear and in-plane stress at an interface.

    The in-plane stress is discontinuous; one curve is drawn for the layer above the interface and
    one for the layer below. Normal and shear traction are continuous, except for a small difference
    due to the discretised plastic strain; the mean of both sides is drawn. A side without stress,
    such as a rigid substrate, is omitted. The maximum tension is marked.

    Parameters
    ----------
    stress : array_like, shape (2, 6, nx, ny, m)
        Stress above and below each interface [Pa], see `State.interface_stress`.
    grid : Grid
        Grid of the field.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    interface : int
        Index of the interface, from 0; interface 0 is nearest to the surface.
    interfaces : array_like, shape (m,), optional
        Depths of the interfaces between layers [m], e.g. `Layered.interfaces`; used in the label.
    axis : {"x", "y"}
        Direction of the profile.
    position : float
        Position of the profile [m]: y for a profile along x, x for a profile along y. The nearest
        row of cells is used.
    contact : array_like, shape (nx, ny), optional
        Field that is positive in contact cells, e.g. the repulsion; the contact is shown as a bar
        along the top of the figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The stress has the wrong shape, or the interface or axis does not exist.
    """
    count = max(np.shape(stress)[-1:], default=1)
    shape = (grid.nx, grid.ny)
    sides = finite_array("stress", stress, (2, 6, *shape, count))
    number = integer("interface", interface, 0, count - 1)
    depths = finite_array("interfaces", interfaces, (count,) if np.size(interfaces) else (0,))
    choice("axis", axis, ("x", "y"))
    along_x = axis == "x"
    across = grid.y if along_x else grid.x
    row = [nearest(across, finite("position", position))]
    touching = None if contact is None else in_contact(finite_array("contact", contact, shape))

    s, step = (np.asarray(grid.x), grid.dx) if along_x else (np.asarray(grid.y), grid.dy)
    ax = axes_or_new(ax)
    shown = sides[..., number].take(row, axis=3 if along_x else 2)
    _draw_lines(ax, s, shown.reshape(2, 6, -1), axis)
    if touching is not None:
        bar = touching.take(row, axis=1 if along_x else 0).ravel()
        touching_along(ax, edges(s, step), bar, 1.0, transform=ax.get_xaxis_transform())
    where = f"at {depths[number] * 1e6:.4g} µm depth" if depths.size else "at the interface"
    ax.set(xlabel=f"{axis} [µm]", ylabel=f"stress {where} [{CONTACT['stress'].shown}]")
    ax.legend(ncols=3, **_LEGEND_ABOVE)
    return finish(ax)


def _draw_lines(ax: Axes, s: FloatArray, sides: FloatArray, axis: str) -> None:
    """Draw the stress on both sides of an interface along an axis, and mark the maximum tension.

    s: coordinates along the axis [m], shape (n,). sides: stress above and below the interface [Pa],
    shape (2, 6, n).
    """
    shown = sides * CONTACT["stress"].factor
    known = [n for n in (0, 1) if shown[n].any()] or [0, 1]
    passing = shown[known].mean(axis=0)
    name = axis * 2
    lines = [
        (rf"$\sigma_{{{name}}}$ {side}", shown[n, COMPONENT_INDEX[name]], colour, style)
        for n, (side, colour, style) in enumerate(_SIDE_STYLES)
        if n in known
    ]
    for name, colour, style in (("zz", "C2", "-"), (f"{axis}z", "C3", "-.")):
        lines.append((rf"$\sigma_{{{name}}}$", passing[COMPONENT_INDEX[name]], colour, style))
    for label, values, colour, style in lines:
        ax.plot(s * 1e6, values, style, color=colour, linewidth=1.2, label=label)
    normal = np.stack([values for _, values, _, _ in lines[:-1]])
    max_normal = float(normal.max())
    # a unique maximum for mirror-symmetric stresses
    which, at = np.unravel_index(
        int(np.argmax(normal >= max_normal - 1e-6 * abs(max_normal))), normal.shape
    )
    if max_normal > _MIN_MARKED_TENSION * max(np.abs(values).max() for _, values, _, _ in lines):
        label = f"{_TENSION_LABEL} {max_normal:.4g} {CONTACT['stress'].shown}"
        colour = lines[which][2]
        ax.plot(
            s[at] * 1e6, normal[which, at], "o", color=colour, markersize=4, zorder=3, label=label
        )


def interface_figure(results: ContactResults, number: int) -> Figure:
    """Return a figure of the stress at the interfaces of a body, with one panel per interface.

    All profiles run along x in the same row of cells. This is the row in which the in-plane stress
    varies most along x, or the middle row if the variation there is at least 90 % of this. If there
    are more than three interfaces, the three with the highest tension are shown. number: number of
    the increment.
    """
    stress, grid = results.field("interface_stress", number), results.grid
    tension = stress[:, [0, 2]].max(axis=(0, 1, 2, 3))
    shown = np.sort(np.argsort(-tension, kind="stable")[:_MAX_PANELS])
    change = np.ptp(stress[:, COMPONENT_INDEX["xx"]][..., shown], axis=1).max(axis=(0, 2))
    y = float(grid.y[row_of_interest(change, grid.y)])
    figure = new_figure(5.0, 0.5 + 2.6 * len(shown))
    panels = np.ravel(figure.subplots(len(shown), 1, sharex=True))
    contact = repulsion_of(results.dataset).sel(increment=number).values
    for ax, interface in zip(panels, shown, strict=True):
        interface_profile(
            stress, grid, ax, interface=int(interface), interfaces=results.interfaces,
            position=y, contact=contact,
        )  # fmt: skip
    for ax in panels[1:]:
        ax.get_legend().remove()
        named = zip(*ax.get_legend_handles_labels(), strict=True)
        if marks := [line for line, label in named if label.startswith(_TENSION_LABEL)]:
            ax.legend(handles=marks, **_LEGEND_ABOVE)
    for ax in panels[:-1]:
        ax.set_xlabel("")
    if where := elsewhere("y", y, grid.dy):
        figure.suptitle(where, fontsize="medium")
    return figure
