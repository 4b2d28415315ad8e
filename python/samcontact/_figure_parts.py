# SPDX-License-Identifier: GPL-3.0-or-later
"""What the figures share: a figure without pyplot, labels and units, lines through fields."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from ._checks import FloatArray, choice, finite_array

if TYPE_CHECKING:
    from .grid import Grid

# quantity: (label, factor to the displayed unit, unit, colour map)
QUANTITIES = {
    "von_mises": ("von Mises stress", 1e-6, "MPa", "viridis"),
    "hydrostatic": ("hydrostatic stress", 1e-6, "MPa", "RdBu_r"),
    "equivalent_plastic_strain": ("equivalent plastic strain", 1e2, "%", "magma_r"),
    "residual_von_mises": ("residual von Mises stress", 1e-6, "MPa", "viridis"),
    "stress": ("stress", 1e-6, "MPa", "RdBu_r"),
    "temperature": ("rise of temperature", 1.0, "K", "inferno"),
}
COMPONENTS = {"xx": 0, "yy": 1, "zz": 2, "yz": 3, "xz": 4, "xy": 5}


def new_figure(width: float = 5.0, height: float = 3.6) -> Figure:
    figure = Figure(figsize=(width, height), layout="compressed", dpi=200)
    FigureCanvasAgg(figure)
    return figure


def axes_or_new(ax: Axes | None) -> Axes:
    return new_figure().subplots() if ax is None else ax


def finish(ax: Axes) -> Axes:
    ax.grid(True, linewidth=0.4, alpha=0.5)
    ax.set_axisbelow(True)
    return ax


def nearest(values: ArrayLike, position: float) -> int:
    return int(np.argmin(np.abs(np.asarray(values) - position)))


def edges(centres: ArrayLike, step: float) -> FloatArray:
    centres = np.asarray(centres, dtype=np.float64)
    return np.append(centres - 0.5 * step, centres[-1] + 0.5 * step)


def surface_line(
    field: ArrayLike, name: str, grid: Grid, axis: str
) -> tuple[FloatArray, FloatArray]:
    """Coordinates and values of a surface field along an axis, through the cell nearest to 0."""
    choice("axis", axis, ("x", "y"))
    values = finite_array(name, field, (grid.nx, grid.ny))
    if axis == "x":
        return np.asarray(grid.x), values[:, nearest(grid.y, 0.0)]
    return np.asarray(grid.y), values[nearest(grid.x, 0.0), :]
