# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of wear and running-in.

Most functions draw on the axes `ax` (default: new ones) and return them. As in all of
`samcontact.plotting`, pyplot is not used, lengths are in micrometres, and depth points downward.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, choice, finite, integer
from .._util.quantities import CONTACT
from .._util.wear_quantities import WEAR
from ..results.reading import cell_size
from .fields import Plane, show_section, show_surface
from .parts import (
    axes_or_new,
    counted,
    depths_of,
    edges,
    finish,
    nearest,
    new_figure,
    place,
    row_of_interest,
)

if TYPE_CHECKING:
    import xarray as xr

    from ..solutions.state import State

__all__ = ["cycle_panels", "fretting_panels", "surface_map", "tresca", "wear_rate", "worn_profile"]


def tresca(stress: ArrayLike) -> FloatArray:
    """Return the Tresca stress: maximum difference of principal stresses [Pa].

    Parameters
    ----------
    stress : array_like, shape (6, ...)
        Components xx, yy, zz, yz, xz, xy [Pa].

    Returns
    -------
    ndarray, shape (...)

    Raises
    ------
    ValueError
        The stress does not have six components.
    """
    tensor = np.asarray(stress, dtype=np.float64)
    if tensor.ndim == 0 or tensor.shape[0] != 6:
        raise ValueError(f"stress must have shape (6, ...), got {tensor.shape}")
    xx, yy, zz, yz, xz, xy = tensor
    full = np.stack([np.stack([xx, xy, xz]), np.stack([xy, yy, yz]), np.stack([xz, yz, zz])])
    principal = np.linalg.eigvalsh(np.moveaxis(full, (0, 1), (-2, -1)))
    return np.asarray(principal[..., 2] - principal[..., 0], dtype=np.float64)


def worn_profile(
    dataset: xr.Dataset,
    ax: Axes | None = None,
    *,
    body: int | None = None,
    axis: str = "x",
    position: float | None = None,
    cycles: Sequence[int] | None = None,
) -> Axes:
    """Draw the heights of a worn body after several cycles, along x or y.

    Parameters
    ----------
    dataset : xarray.Dataset
        Result of `WearResult.to_dataset` or `FrettingResult.to_dataset`.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    body : {1, 2}, optional
        Worn body. Default: body 2 if it is worn, otherwise body 1.
    axis : {"x", "y"}
        Direction of the profile.
    position : float, optional
        Position of the profile [m]: y for a profile along x, x for a profile along y. The nearest
        row of cells is used. Default: the middle row, or the row of maximum wear depth if the
        middle row has less than 90 % of this depth.
    cycles : sequence of int, optional
        Numbers of the cycles after which the heights are drawn; 0 gives the initial heights.
        Default: all cycles.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The axis is unknown, the body is not worn, or a cycle was not computed.
    """
    choice("axis", axis, ("x", "y"))
    heights, x = _heights(dataset, body)
    y, count = dataset["y"].values, dataset.sizes["cycle"]
    shown = range(count + 1) if cycles is None else cycles
    ax = axes_or_new(ax)
    last = max(count, 1)
    across = y if axis == "x" else x
    if position is None:
        worn = heights[0] - heights[-1]
        index = row_of_interest(np.abs(worn).max(axis=0 if axis == "x" else 1), across)
    else:
        index = nearest(across, finite("position", position))
    for n in shown:
        cycle = heights[_cycle(dataset, integer("cycles", n, 0))]
        line = cycle[:, index] if axis == "x" else cycle[index]
        along = x if axis == "x" else y
        # light to dark: identifies the cycle if there are too many for a legend
        colour = (0.85 - 0.85 * n / last, 0.75 - 0.55 * n / last, 0.9 - 0.4 * n / last)
        ax.plot(along * 1e6, line * 1e6, linewidth=1.0, color=colour, label=f"{n}")
    ax.set_xlabel(f"{axis} [µm]")
    ax.set_ylabel(WEAR["heights"].label)
    ax.set_title(place("y" if axis == "x" else "x", float(across[index])), fontsize="medium")
    if len(shown) > 1:
        legend_options: dict[str, Any] = {
            "loc": "center left",
            "bbox_to_anchor": (1.0, 0.5),
            "ncols": 1 + len(shown) // 16,
        }
        ax.legend(title="cycles", frameon=False, fontsize="small", **legend_options)
    return finish(ax)


def surface_map(
    dataset: xr.Dataset,
    ax: Axes | None = None,
    *,
    body: int | None = None,
    cycle: int = -1,
    cells: bool = False,
) -> Axes:
    """Draw a map of the heights of a worn body after a cycle; cycle 0 is the initial surface.

    Parameters
    ----------
    dataset : xarray.Dataset
        Result of `WearResult.to_dataset` or `FrettingResult.to_dataset`.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    body : {1, 2}, optional
        Worn body. Default: body 2 if it is worn, otherwise body 1.
    cycle : int
        Number of the cycle; default: the last one.
    cells : bool, optional
        Show each cell in one colour, instead of smooth colours between the cell centres.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The body is not worn, or the cycle was not computed.
    """
    heights, x = _heights(dataset, body)
    plane = Plane(edges(x, x[1] - x[0]), edges(dataset["y"].values, cell_size(dataset, "y")))
    values = heights[_cycle(dataset, cycle)]
    return show_surface(ax, plane, values, WEAR["heights"], "x", cells=cells)


def _heights(dataset: xr.Dataset, body: int | None) -> tuple[FloatArray, FloatArray]:
    """Return the heights of a worn body, initially and after each cycle [m], and x [m]."""
    worn = tuple(dataset["body"].values.tolist())
    chosen = choice("body", worn[-1] if body is None else body, worn)
    return dataset[f"heights_body{chosen}"].values, dataset[f"x_body{chosen}"].values


def _cycle(dataset: xr.Dataset, number: int) -> int:
    count = dataset.sizes["cycle"]
    if not -count - 1 <= integer("cycle", number) <= count:
        raise ValueError(f"cycle must be from 0 (initial surface) to {count}, got {number}")
    return number


def wear_rate(dataset: xr.Dataset, ax: Axes | None = None) -> Axes:
    """Draw the worn volume of each cycle.

    Parameters
    ----------
    dataset : xarray.Dataset
        Result of `WearResult.to_dataset` or `FrettingResult.to_dataset`.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.

    Returns
    -------
    matplotlib.axes.Axes
    """
    ax = axes_or_new(ax)
    shown, rate = WEAR["wear_rate"], dataset["wear_rate"].values
    ax.plot(dataset["cycle"].values, rate * shown.factor, "o-", markersize=3, linewidth=1.2)
    largest = float(np.nanmax(rate)) * shown.factor
    ax.set_ylim(0.0, 1.08 * largest if largest > 0 else None)
    ax.set_xlabel("cycle")
    ax.set_ylabel(shown.label)
    return finish(counted(ax))


def fretting_panels(
    first: Sequence[State], last: Sequence[State], *, position: float | None = None
) -> Figure:
    """Draw profiles along x of pressure and sliding distance, in the first and the last cycle.

    The sliding distance is that of one repeat of the loop; a cycle may stand for many repeats.

    Parameters
    ----------
    first, last : sequence of State
        `FrettingResult.first` and `last`.
    position : float, optional
        Value of y [m]; the nearest row of cells is shown. Default: the middle row, or the row of
        maximum pressure in the first cycle if the middle row has less than 90 % of this pressure.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    ValueError
        The states are from full sliding and have no slip field.
    """
    grid = last[-1].grid
    if position is None:
        j = row_of_interest(first[-1].pressure.max(axis=0), grid.y)
    else:
        j = nearest(grid.y, finite("position", position))
    figure = new_figure(6.4, 5.6)
    above, below = figure.subplots(2, 1, sharex=True)
    for states, label, colour in ((first, "first", "0.55"), (last, "last", "C0")):
        x = np.asarray(states[-1].grid.x) * 1e6
        slip_distance = np.sum([np.hypot(*state.slip) for state in states], axis=0)
        style: dict[str, Any] = {"color": colour, "linewidth": 1.2, "label": f"{label} cycle"}
        above.plot(x, states[-1].pressure[:, j] * 1e-9, **style)
        below.plot(x, slip_distance[:, j] * 1e6, **style)
    above.set_ylabel("pressure [GPa]")
    above.set_title(place("y", float(grid.y[j])), fontsize="medium")
    above.legend(frameon=False, fontsize="small")
    below.set_ylabel("sliding distance per repeat [µm]")
    below.set_xlabel("x [µm]")
    for ax in (above, below):
        ax.set_ylim(bottom=0)
        finish(ax)
    return figure


def cycle_panels(
    moments: tuple[State, State],
    *,
    body: int = 2,
    position: float | None = None,
    width: float | None = None,
    depth: float | None = None,
) -> Figure:
    """Draw four panels of a cycle: pressure, Tresca stress, mean normal stress, plastic strain.

    Pressure and Tresca stress are shown under load, mean normal stress and plastic strain after
    unloading.

    Parameters
    ----------
    moments : pair of State
        Loaded and unloaded state: `WearResult.first` or `WearResult.last`, on a grid with layers.
    body : {1, 2}
        Body whose stress and strain are shown.
    position : float, optional
        Value of y [m]; the nearest row of cells is shown. Default: the middle row, or the row of
        maximum pressure if the middle row has less than 90 % of this pressure.
    width, depth : float, optional
        Limits of the figure [m]: x from -`width` to `width`, z from 0 to `depth`. Default: the
        whole grid.

    Returns
    -------
    matplotlib.figure.Figure
    """
    loaded, unloaded = moments
    grid = loaded.grid
    figure = new_figure(9.0, 5.6)
    (first, second), (third, fourth) = figure.subplots(2, 2)
    x = np.asarray(grid.x)
    if position is None:
        j = row_of_interest(loaded.pressure.max(axis=0), grid.y)
    else:
        j = nearest(grid.y, finite("position", position))
    first.plot(x * 1e6, loaded.pressure[:, j] * 1e-9, linewidth=1.2)
    first.set_xlabel("x [µm]")
    first.set_ylabel("pressure [GPa]")
    first.set_title(place("y", float(grid.y[j])), fontsize="medium")
    finish(first)
    sections = (
        (second, tresca(loaded.stress(body=body)[:, :, j]), "von_mises", "Tresca stress, loaded"),
        (
            third,
            unloaded.hydrostatic(body=body)[:, j],
            "hydrostatic",
            "mean normal stress, unloaded",
        ),
        (
            fourth,
            unloaded.equivalent_plastic_strain(body=body)[:, j],
            "equivalent_plastic_strain",
            "equivalent plastic strain",
        ),
    )
    assert grid.dz is not None
    bottom = grid.dz * min(values.shape[-1] for _, values, _, _ in sections)
    for ax, values, quantity, label in sections:
        plane = Plane(edges(x, grid.dx), edges(depths_of(grid, values), grid.dz))
        shown = CONTACT[quantity]._replace(heading=label)
        show_section(ax, plane, values, shown, "x", titled=True, equal=False)
        ax.set_ylim((bottom if depth is None else depth) * 1e6, 0)
    if width is not None:
        for ax in (first, second, third, fourth):
            ax.set_xlim(-width * 1e6, width * 1e6)
    return figure
