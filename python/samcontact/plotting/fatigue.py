# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of fatigue criteria: versus depth, in a section, and as a map.

The functions are also available from `samcontact.plotting`. Each draws on the axes `ax` and returns
them.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes

from .._util.checks import FloatArray, choice, finite, positive
from .._util.quantities import Quantity
from .._util.short_text import in_short
from .fields import Plane, show_surface
from .parts import axes_or_new, edges, finish, nearest, place

if TYPE_CHECKING:
    from ..fatigue import Exposure, FatigueField

_UNITS = {"Pa": "MPa", "-": "%"}


def fatigue_depth(
    fields: FatigueField | Sequence[FatigueField],
    ax: Axes | None = None,
    *,
    limit: float | None = None,
) -> Axes:
    """Draw the maximum of a criterion in each layer of cells versus depth; one line per criterion.

    Parameters
    ----------
    fields : FatigueField, or several
        Fields computed from states, all with the same unit. The maximum of each field is marked.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    limit : float, optional
        Fatigue limit of the material, > 0, in the unit of the values.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        No fields are given, a field has no depths, or the units differ.
    """
    several = list(fields) if isinstance(fields, Sequence) else [fields]
    if not several:
        raise ValueError("fields must contain at least one field, got none")
    for field in several:
        _require_axes(field, "z")
    if len({field.unit for field in several}) > 1:
        raise ValueError(
            "fields must have the same unit: draw criteria of stress and of strain in separate "
            "figures"
        )
    factor, unit = _quantity(several[0]).factor, _UNITS[several[0].unit]
    ax = axes_or_new(ax)
    for field in several:
        depth, values = field.coordinates["z"] * 1e6, field.over_depth() * factor
        (line,) = ax.plot(values, depth, linewidth=1.4, label=_name(field))
        peak = int(values.argmax())
        ax.plot(values[peak], depth[peak], "o", color=line.get_color(), markersize=4)
    if limit is not None:
        bound = positive("limit", limit) * factor
        ax.axvline(bound, color="0.35", linewidth=1.0, linestyle=(0, (5, 3)), label="limit")
    ax.set_ylim(float(several[0].coordinates["z"][-1]) * 1e6, 0.0)
    if len(several) == 1 and limit is None:
        ax.set_xlabel(f"{_name(several[0])} [{unit}]")
    else:
        ax.set_xlabel(f"maximum criterion value at this depth [{unit}]")
        ax.legend(frameon=False, loc="upper left", bbox_to_anchor=(1.0, 1.0))
    ax.set_ylabel("depth z [µm]")
    return finish(ax)


def exposure_depth(found: Exposure, ax: Axes | None = None) -> Axes:
    """Draw the exposure of a case-hardened body versus depth, and mark the maxima.

    The exposure is the equivalent stress of a criterion divided by the local strength. A dot marks
    the maximum of each criterion, and a circle marks the governing criterion. The dashed line shows
    where the exposure is 1, i.e. where stress equals strength.

    Parameters
    ----------
    found : Exposure
        Result of `fatigue.exposure`.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.

    Returns
    -------
    matplotlib.axes.Axes
    """
    from ..fatigue.exposure import NAMES

    ax = axes_or_new(ax)
    for name, values in found.values.items():
        (line,) = ax.plot(values, found.z * 1e6, linewidth=1.4, label=NAMES[name])
        peak = (found.max_value(name), found.depth(name) * 1e6)
        ax.plot(*peak, "o", color=line.get_color(), markersize=4)
        if name == found.criterion:
            ax.plot(*peak, "o", color="0.2", markersize=9, fillstyle="none", label="governs")
            ax.set_title(f"maximum {peak[0]:.3g} at {peak[1]:.3g} µm", fontsize="medium")
    ax.axvline(1.0, color="0.35", linewidth=1.0, linestyle=(0, (5, 3)), label="limit")
    ax.set_xlim(left=0.0)
    ax.set_ylim(float(found.z[-1]) * 1e6, 0.0)
    ax.set_xlabel("exposure: stress / local strength [-]")
    ax.set_ylabel("depth z [µm]")
    ax.legend(frameon=False, loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return finish(ax)


def fatigue_section(
    field: FatigueField,
    ax: Axes | None = None,
    *,
    plane: str | None = None,
    position: float | None = None,
) -> Axes:
    """Draw a section of a fatigue field, with a cross at the maximum of the section.

    Parameters
    ----------
    field : FatigueField
        Field computed from states.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    plane : {"y", "x"}, optional
        Coordinate that is constant on the section. Default: "y". A field from a `steady_cycle` has
        only one section, perpendicular to the direction of motion.
    position : float, optional
        Value of the constant coordinate [m]; default: its value at the maximum of the field.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The field has no coordinates because it was computed from arrays, or the plane is unknown.
    """
    _require_axes(field, "z")
    values, note = field.values, ""
    across = next(axis for axis in field.coordinates if axis != "z")
    if "x" in field.coordinates and "y" in field.coordinates:
        chosen = choice("plane", "y" if plane is None else plane, ("y", "x"))
        across = "x" if chosen == "y" else "y"
        there = field.coordinates[chosen]
        at = field.position[chosen] if position is None else finite("position", position)
        index = nearest(there, at)
        values = values[:, index] if chosen == "y" else values[index]
        note = f", {place(chosen, float(there[index]))}"
    elif plane not in (None, "xy".replace(across, "")):
        only = "xy".replace(across, "")
        raise ValueError(f"plane must be {only!r} or None for this field, got {in_short(plane)}")
    ax = _coloured(field, ax, f"{across}z", values, note)
    ax.set_ylabel("depth z [µm]")
    ax.invert_yaxis()
    return ax


def fatigue_map(field: FatigueField, ax: Axes | None = None) -> Axes:
    """Draw a map of a criterion on the surface: at each point, the maximum over the depth below.

    Parameters
    ----------
    field : FatigueField
        Field computed from the states of a pass or loop.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The field has no coordinates along x and y.
    """
    _require_axes(field, "x", "y", "z")
    ax = _coloured(field, ax, "xy", field.values.max(axis=2), ", maximum over depth")
    ax.set_xlabel("x on the body [µm]")
    return ax


def _require_axes(field: FatigueField, *axes: str) -> None:
    missing = [axis for axis in axes if axis not in field.coordinates]
    if missing:
        raise ValueError(
            f"field must have the coordinates {', '.join(axes)}, got "
            f"{', '.join(field.coordinates) or 'none: compute it from states, not from arrays'}"
        )


def _name(field: FatigueField) -> str:
    numbers = [f"{k} = {v:g}" for k, v in field.parameters.items() if k in ("slope", "k")]
    return " ".join([field.name, *(f"({number})" for number in numbers)])


def _quantity(field: FatigueField) -> Quantity:
    return Quantity(field.unit, "", _UNITS[field.unit], _name(field), kind="criterion")


def _coloured(
    field: FatigueField, ax: Axes | None, axes: str, values: FloatArray, note: str
) -> Axes:
    """Draw values in colour over two coordinates, with a cross at the maximum.

    axes: names of the horizontal and the vertical coordinate, e.g. "xz". note: text after the name
    of the criterion in the title.
    """
    sides = [field.coordinates[axis] for axis in axes]
    plane = Plane(*(edges(side, _step(side)) for side in sides))
    ax = show_surface(ax, plane, values, _quantity(field), axes[0], note)
    i, j = np.unravel_index(int(values.argmax()), values.shape)
    peak = sides[0][i] * 1e6, sides[1][j] * 1e6
    ax.plot(*peak, "x", color="white", markersize=7, markeredgewidth=1.6)
    return ax


def _step(centres: FloatArray) -> float:
    return float(centres[1] - centres[0]) if len(centres) > 1 else 1e-6
