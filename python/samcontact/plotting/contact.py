# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of a contact that stays in place."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator
from numpy.typing import ArrayLike

from .._checks import choice, finite, finite_array
from ..hertz import EllipticContact, PointContact
from .parts import (
    COMPONENTS,
    QUANTITIES,
    axes_or_new,
    edges,
    finish,
    nearest,
    show_section,
    surface_line,
)

if TYPE_CHECKING:
    from ..grid import Grid
    from ..state import State

HertzContact = PointContact | EllipticContact


def pressure_profile(
    state: State | ArrayLike,
    grid: Grid,
    ax: Axes | None = None,
    *,
    hertz: HertzContact | None = None,
    axis: str = "x",
    position: float = 0.0,
    label: str = "computed",
) -> Axes:
    """Pressure along an axis, with that of Hertz.

    Parameters
    ----------
    state : State or array_like, shape (nx, ny)
        A state, or a pressure field [Pa].
    grid : Grid
        Its grid.
    ax : matplotlib.axes.Axes, optional
        Where to draw.
    hertz : PointContact or EllipticContact, optional
        Drawn as a dashed line, along the same row of cells.
    axis : {"x", "y"}
        Direction of the profile.
    position : float
        Where it runs [m]: y of a profile along x, and the other way round. Nearest cells.
    label : str
        Of the computed curve.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        Wrong shape of the field or unknown axis.
    """
    field: Any = state
    s, pressure = surface_line(getattr(field, "pressure", field), "pressure", grid, axis, position)
    ax = axes_or_new(ax)
    ax.plot(s * 1e6, pressure * 1e-9, "o-", markersize=3, linewidth=1.2, label=label)
    if hertz is not None:
        fine = np.linspace(s[0], s[-1], 801)
        if axis == "x":
            curve = hertz.pressure(fine, grid.y[nearest(grid.y, position)])
        else:
            curve = hertz.pressure(grid.x[nearest(grid.x, position)], fine)
        ax.plot(fine * 1e6, curve * 1e-9, "k--", linewidth=1.0, label="Hertz")
    ax.set_xlabel(f"{axis} [µm]")
    ax.set_ylabel("pressure [GPa]")
    ax.legend(frameon=False)
    return finish(ax)


def section(
    field: ArrayLike,
    grid: Grid,
    ax: Axes | None = None,
    *,
    quantity: str = "von_mises",
    plane: str = "y",
    position: float = 0.0,
    label: str | None = None,
) -> Axes:
    """Cross-section of a volume field with a colour bar, depth downward.

    Parameters
    ----------
    field : array_like, shape (nx, ny, nz)
        Values in SI units.
    grid : Grid
        Its grid, with a volume.
    ax : matplotlib.axes.Axes, optional
        Where to draw.
    quantity : {"von_mises", "hydrostatic", "equivalent_plastic_strain", \
"residual_von_mises", "residual_hydrostatic", "stress", "temperature"}
        Decides label, unit and colours.
    plane : {"y", "x"}
        Coordinate that is constant on the section.
    position : float
        Its value [m]; the nearest row of cells is shown.
    label : str, optional
        Instead of the name of the quantity.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        No volume, wrong shape, or an unknown quantity or plane.
    """
    choice("plane", plane, ("y", "x"))
    choice("quantity", quantity, tuple(QUANTITIES))
    if grid.nz == 0 or grid.dz is None:
        raise ValueError("grid must have a volume (nz >= 1), got nz = 0")
    values = finite_array("field", field, (grid.nx, grid.ny, grid.nz))
    finite("position", position)
    if plane == "y":
        values = values[:, nearest(grid.y, position), :]
        across, name = edges(grid.x, grid.dx), "x"
    else:
        values = values[nearest(grid.x, position), :, :]
        across, name = edges(grid.y, grid.dy), "y"
    return show_section(ax, across, edges(grid.z, grid.dz), values, quantity, name, label)


def load_approach(
    states: Sequence[State], ax: Axes | None = None, *, hertz: HertzContact | None = None
) -> Axes:
    """Load against approach, with that of Hertz (load ~ approach^1.5).

    The increments are points; the dotted line between them tells their order only.

    Parameters
    ----------
    states : sequence of State
        In the order of the path.
    ax : matplotlib.axes.Axes, optional
        Where to draw.
    hertz : PointContact or EllipticContact, optional
        Any load of the same bodies.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        No states.
    """
    if len(states) == 0:
        raise ValueError("states must hold at least one state, got none")
    ax = axes_or_new(ax)
    approach = np.array([state.approach for state in states])
    load = np.array([state.load for state in states])
    # between the increments nothing is known: the line tells their order only
    ax.plot(approach * 1e6, load, ":", color="C0", linewidth=0.8, label="_order")
    ax.plot(approach * 1e6, load, "o", color="C0", markersize=3, label="increments")
    if hertz is not None:
        # prescribed tractions have no approach (NaN)
        largest = np.max(approach, initial=0.0, where=np.isfinite(approach))
        fine = np.linspace(0.0, float(largest), 201)
        curve = hertz.load * (fine / hertz.approach) ** 1.5
        ax.plot(fine * 1e6, curve, "k--", linewidth=1.0, label="Hertz")
    ax.legend(frameon=False)
    ax.set_xlabel("approach [µm]")
    ax.set_ylabel("load [N]")
    return finish(ax)


def print_profile(
    state: State | ArrayLike,
    grid: Grid,
    ax: Axes | None = None,
    *,
    body: int = 2,
    axis: str = "x",
    position: float = 0.0,
    label: str | None = None,
) -> Axes:
    """Residual displacement of the surface along an axis: the print, depth downward.

    Parameters
    ----------
    state : State or array_like, shape (nx, ny)
        A state, or a residual displacement [m], positive into the body.
    grid : Grid
        Its grid.
    ax : matplotlib.axes.Axes, optional
        Where to draw.
    body : {1, 2}
        Whose print.
    axis : {"x", "y"}
        Direction of the profile.
    position : float
        Where it runs [m]: y of a profile along x, and the other way round. Nearest cells.
    label : str, optional
        Of the curve.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        Wrong shape of the field or unknown axis.
    """
    field: Any = state
    if hasattr(field, "residual_displacement"):
        field = field.residual_displacement(body=body)
    s, depth = surface_line(field, "residual displacement", grid, axis, position)
    ax = axes_or_new(ax)
    ax.plot(s * 1e6, depth * 1e6, "-", linewidth=1.2, label=label)
    if not ax.yaxis_inverted():
        ax.invert_yaxis()
    ax.set_xlabel(f"{axis} [µm]")
    ax.set_ylabel("residual displacement [µm]")
    if label is not None:
        ax.legend(frameon=False)
    return finish(ax)


def temperature_profile(
    state: State | ArrayLike,
    grid: Grid,
    ax: Axes | None = None,
    *,
    body: int = 2,
    axis: str = "x",
    position: float = 0.0,
    label: str | None = None,
) -> Axes:
    """Rise of temperature of the surface (flash temperature) along an axis.

    Parameters
    ----------
    state : State or array_like, shape (nx, ny)
        A state, or a rise of temperature of the surface [K].
    grid : Grid
        Its grid.
    ax : matplotlib.axes.Axes, optional
        Where to draw.
    body : {1, 2}
        Whose surface.
    axis : {"x", "y"}
        Direction of the profile.
    position : float
        Where it runs [m]: y of a profile along x, and the other way round. Nearest cells.
    label : str, optional
        Of the curve.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        Wrong shape of the field or unknown axis.
    """
    field: Any = state
    if hasattr(field, "surface_temperature"):
        field = field.surface_temperature(body=body)
    s, rise = surface_line(field, "temperature", grid, axis, position)
    ax = axes_or_new(ax)
    ax.plot(s * 1e6, rise, "-", linewidth=1.2, label=label)
    ax.set_xlabel(f"{axis} [µm]")
    ax.set_ylabel("rise of temperature [K]")
    if label is not None:
        ax.legend(frameon=False)
    return finish(ax)


def axis_profile(
    state: State,
    grid: Grid,
    ax: Axes | None = None,
    *,
    body: int = 2,
    components: Sequence[str] = ("von_mises", "hydrostatic", "xx", "zz"),
) -> Axes:
    """Stresses under the centre of the grid against depth.

    Parameters
    ----------
    state : State
        Read through ``stress``, ``von_mises`` and ``hydrostatic``.
    grid : Grid
        Its grid, with a volume.
    ax : matplotlib.axes.Axes, optional
        Where to draw.
    body : {1, 2}
        Whose stresses.
    components : sequence of str
        From "von_mises", "hydrostatic", "xx", "yy", "zz", "yz", "xz", "xy".

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        No volume, or an unknown component.
    """
    if grid.nz == 0:
        raise ValueError("grid must have a volume (nz >= 1), got nz = 0")
    for component in components:
        choice("components", component, ("von_mises", "hydrostatic", *COMPONENTS))
    i, j = nearest(grid.x, 0.0), nearest(grid.y, 0.0)
    tensor = state.stress(body=body) if set(components) & set(COMPONENTS) else None
    ax = axes_or_new(ax)
    for component in components:
        if component in COMPONENTS:
            assert tensor is not None
            values, label = tensor[COMPONENTS[component], i, j, :], rf"$\sigma_{{{component}}}$"
        else:
            values = getattr(state, component)(body=body)[i, j, :]
            label = QUANTITIES[component][0]
        ax.plot(values * 1e-6, np.asarray(grid.z) * 1e6, linewidth=1.2, label=label)
    ax.set_ylim(float(np.max(grid.z)) * 1e6, 0.0)
    ax.xaxis.set_major_locator(
        MaxNLocator(5, steps=[1, 2, 5, 10])
    )  # five digits and a sign are wide
    ax.set_xlabel("stress on the axis [MPa]")
    ax.set_ylabel("depth z [µm]")
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2, frameon=False)
    return finish(ax)
