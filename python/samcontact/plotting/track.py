# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of a moving contact, in the frame of a body: x = 0 is the initial contact position.

The functions are also available from `samcontact.plotting`. Each draws on the axes `ax` and returns
them.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from .._util.checks import FloatArray, choice, finite
from .._util.quantities import CONTACT, Quantity
from ..results.reading import grid_of
from .fields import Plane, show_section
from .parts import (
    COMPONENT_INDEX,
    add_to_title,
    axes_or_new,
    depths_of,
    edges,
    elsewhere,
    finish,
    nearest,
    new_figure,
    place,
    require_volume,
    row_of_interest,
    section_height,
)
from .shown import shown_on

if TYPE_CHECKING:
    import xarray as xr

    from ..problem.grid import Grid
    from ..solutions.state import State

_RESIDUAL_FIELDS = ("residual_von_mises", "residual_hydrostatic", "equivalent_plastic_strain")
_LOADED_FIELDS = ("von_mises", "hydrostatic", "equivalent_plastic_strain", "temperature")


def positions_on_body(state: State, body: int) -> FloatArray:
    """Return x of the cells of a volume field in the frame of its body [m], shape (nx,)."""
    shift = state.offset(body=body) - state.origin - state.travel[body - 1]
    return np.asarray(np.asarray(state.grid.x) + shift, dtype=np.float64)


def track_imprint(
    track: xr.Dataset,
    ax: Axes | None = None,
    *,
    axis: str = "x",
    positions: Sequence[float] = (0.0,),
) -> Axes:
    """Draw profiles of the residual imprint along the track or across it; depth points downward.

    Parameters
    ----------
    track : xarray.Dataset
        Result of `Track.to_dataset`.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    axis : {"x", "y"}
        Direction of the profiles: along the track, or across it.
    positions : sequence of float
        Positions of the profiles [m]: y for profiles along x, x for profiles along y. The nearest
        rows of cells are used.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The axis is unknown, or there are no positions.
    """
    choice("axis", axis, ("x", "y"))
    if len(positions) == 0:
        raise ValueError("positions must contain at least one value, got none")
    field, other = track["residual_displacement"].values, "y" if axis == "x" else "x"
    along, others = track[axis].values, track[other].values
    ax = axes_or_new(ax)
    shown = shown_on(ax, "residual_displacement", field)
    for position in positions:
        index = nearest(others, finite("positions", position))
        profile = field[:, index] if axis == "x" else field[index, :]
        label = place(other, float(others[index]))
        ax.plot(along * 1e6, profile * shown.factor, "-", linewidth=1.2, label=label)
    if not ax.yaxis_inverted():
        ax.invert_yaxis()
    ax.set_xlabel(f"{axis} on body {track.attrs['body']} [µm]")
    ax.set_ylabel(shown.label)
    if len(positions) == 1:
        ax.set_title(label, fontsize="medium")
    else:
        ax.legend(frameon=False)
    return finish(ax)


def track_section(
    track: xr.Dataset,
    ax: Axes | None = None,
    *,
    quantity: str = "residual_von_mises",
    plane: str = "y",
    position: float = 0.0,
    cells: bool = False,
) -> Axes:
    """Draw a section of a residual field along the track or across it.

    Parameters
    ----------
    track : xarray.Dataset
        Result of `Track.to_dataset`, with layers.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    quantity : {"residual_von_mises", "residual_hydrostatic", "equivalent_plastic_strain"}
        Quantity, or a component "xx", "yy", "zz", "yz", "xz", "xy" of the residual stress.
    plane : {"y", "x"}
        Coordinate that is constant on the section: "y" gives a section along the track, "x"
        one across it.
    position : float
        Value of the constant coordinate [m]; the nearest row of cells is shown.
    cells : bool, optional
        Show each cell in one colour, instead of smooth colours between the cell centres.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The track has no layers, or `quantity` or `plane` is unknown.
    """
    choice("quantity", quantity, (*_RESIDUAL_FIELDS, *COMPONENT_INDEX))
    grid = grid_of(track)
    require_volume(grid)
    if quantity in COMPONENT_INDEX:
        field = track["residual_stress"].sel(component=quantity).values
        shown = _component(quantity, "residual ")
    else:
        field, shown = track[quantity].values, CONTACT[quantity]
    along = f"x on body {track.attrs['body']}"
    return _section(grid, track["x"].values, field, ax, shown, plane, position, along, cells)


def loaded_section(
    state: State,
    ax: Axes | None = None,
    *,
    body: int = 2,
    quantity: str = "von_mises",
    plane: str = "y",
    position: float = 0.0,
    cells: bool = False,
) -> Axes:
    """Draw a section of a volume field of a moving contact under load, in the frame of a body.

    Parameters
    ----------
    state : State
        State on a grid with layers.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    body : {1, 2}
        Body whose field and frame of reference are used.
    quantity : {"von_mises", "hydrostatic", "equivalent_plastic_strain", "temperature"}
        Quantity, or a component "xx", "yy", "zz", "yz", "xz", "xy" of the stress.
    plane, position, cells
        As in `track_section`; with plane "x", `position` is x in the frame of the body.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The grid has no layers, or `body`, `quantity` or `plane` is unknown.
    """
    choice("body", body, (1, 2))
    choice("quantity", quantity, (*_LOADED_FIELDS, *COMPONENT_INDEX))
    require_volume(state.grid)
    if quantity in COMPONENT_INDEX:
        field = state.stress(body=body)[COMPONENT_INDEX[quantity]]
        shown = _component(quantity)
    else:
        field, shown = getattr(state, quantity)(body=body), CONTACT[quantity]
    x, along = positions_on_body(state, body), f"x on body {body}"
    return _section(state.grid, x, field, ax, shown, plane, position, along, cells)


def _component(name: str, before: str = "") -> Quantity:
    return CONTACT["stress"]._replace(heading=rf"{before}$\sigma_{{{name}}}$")


def _section(
    grid: Grid,
    x: FloatArray,
    field: FloatArray,
    ax: Axes | None,
    quantity: Quantity,
    plane: str,
    position: float,
    along: str,
    cells: bool,
) -> Axes:
    choice("plane", plane, ("y", "x"))
    finite("position", position)
    depths = depths_of(grid, field)
    assert grid.dz is not None
    if plane == "y":
        values, across = field[:, nearest(grid.y, position), :], edges(x, grid.dx)
        name = along
    else:
        values, across, name = field[nearest(x, position)], edges(grid.y, grid.dy), "y"
    sides = Plane(across, edges(depths, grid.dz))
    return show_section(ax, sides, values, quantity, name, titled=True, cells=cells)


def imprint_along(track: xr.Dataset, ax: Axes) -> Axes:
    """Draw the residual imprint along x, in the row of cells that `row_of_interest` selects."""
    field, x, y = (track[name].values for name in ("residual_displacement", "x", "y"))
    field = np.abs(field)
    row = row_of_interest(field.max(axis=0), y)
    track_imprint(track, ax, positions=(float(y[row]),))
    left, right = _extent(x, field.max(axis=1))
    ax.set_xlim(left * 1e6, right * 1e6)
    return ax


def residual_along(track: xr.Dataset, width: float = 5.0) -> Figure:
    """Return a figure of the residual von Mises stress in a section along a track.

    The section is at the y position that `_row_of_residual` returns. width: width of the figure
    [inches].
    """
    near, grid = _strained_part(track), grid_of(track)
    length = float(np.ptp(near["x"].values))
    figure = new_figure(width, section_height(width, length, grid.nz * (grid.dz or 0.0)))
    row = _row_of_residual(track)
    ax = track_section(near, figure.subplots(), position=row)
    add_to_title(ax, elsewhere("y", row, grid.dy))
    return figure


def _row_of_residual(track: xr.Dataset) -> float:
    """Return the y position [m] of the row of cells in which the residual stress is shown.

    This is the middle row, or the row with the maximum stress, see `row_of_interest`.
    """
    residual, y = track["residual_von_mises"].values, track["y"].values
    return float(y[row_of_interest(residual.max(axis=(0, 2)), y)])


def _strained_part(track: xr.Dataset) -> xr.Dataset:
    """Return the part of a track that has yielded, with margins at both ends (see `_extent`)."""
    x, strain = track["x"].values, track["equivalent_plastic_strain"].values
    left, right = _extent(x, strain.max(axis=(1, 2)))
    part: xr.Dataset = track.isel(x=(x >= left) & (x <= right))
    return part


def _extent(x: FloatArray, sizes: FloatArray) -> tuple[float, float]:
    """Return the limits along x of the region that figures of a track show [m].

    The region in which `sizes` exceed 2 % of their maximum is extended at each end by half its
    length plus two cells, but not beyond the track. sizes: magnitude of a field at each position x.
    """
    there = x[sizes > 0.02 * sizes.max()] if np.any(sizes) else x
    margin = 0.5 * float(np.ptp(there)) + 2.0 * float(x[1] - x[0])
    return max(float(x[0]), float(there[0]) - margin), min(float(x[-1]), float(there[-1]) + margin)


def track_summary(track: xr.Dataset, travel: FloatArray) -> dict[str, Figure]:
    """Return the figures "track_imprint" (profiles) and "track_sections" of a track, by name.

    travel: travel of the body at the end of each increment [m].
    """
    x, places = track["x"].values, -travel
    start, end = float(places.min()), float(places.max())
    depth = np.abs(track["residual_displacement"].values).max(axis=1)
    strained = track["equivalent_plastic_strain"].values.max(axis=(1, 2))
    peak_position = float(x[int(np.argmax(strained))])

    prints = new_figure(5.0, 6.0)
    along, across = prints.subplots(2, 1)
    imprint_along(track, along)
    rows = {nearest(x, place) for place in (start, 0.5 * (start + end), end, peak_position)}
    shown = [row for row in sorted(rows) if depth[row] > 0.02 * depth.max()]
    track_imprint(track, across, axis="y", positions=[float(x[row]) for row in shown or rows])

    shown_part = _strained_part(track)
    grid, width = grid_of(track), 7.0
    depth_of_grid, inner = grid.nz * (grid.dz or 0.0), 0.78 * width
    heights = [inner * depth_of_grid / float(np.ptp(shown_part["x"].values))] * len(
        _RESIDUAL_FIELDS
    )
    heights.append(min(inner * depth_of_grid / (grid.ny * grid.dy), 2.6))
    sections = new_figure(width, sum(heights) + 0.75 * len(heights))
    sections.set_layout_engine(
        "constrained"
    )  # a compressed layout would make all panels as narrow as the last
    panels = sections.subplots(len(heights), 1, height_ratios=heights)
    y = _row_of_residual(track)
    for ax, quantity in zip(panels, _RESIDUAL_FIELDS, strict=False):
        track_section(shown_part, ax, quantity=quantity, position=y)
        add_to_title(ax, elsewhere("y", y, grid.dy))
    track_section(track, panels[-1], plane="x", position=peak_position)
    add_to_title(panels[-1], place("x", peak_position))
    return {"track_imprint": prints, "track_sections": sections}
