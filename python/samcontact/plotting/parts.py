# SPDX-License-Identifier: GPL-3.0-or-later
"""What the figures share: a figure without pyplot, labels and units, lines through fields."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import TwoSlopeNorm
from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from .._checks import FloatArray, choice, finite_array

if TYPE_CHECKING:
    from ..grid import Grid

# quantity: (label, factor to the displayed unit, unit, colour map)
QUANTITIES = {
    "von_mises": ("von Mises stress", 1e-6, "MPa", "viridis"),
    "hydrostatic": ("hydrostatic stress", 1e-6, "MPa", "RdBu_r"),
    "equivalent_plastic_strain": ("equivalent plastic strain", 1e2, "%", "magma_r"),
    "residual_von_mises": ("residual von Mises stress", 1e-6, "MPa", "viridis"),
    "residual_hydrostatic": ("residual hydrostatic stress", 1e-6, "MPa", "RdBu_r"),
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


def show_section(
    ax: Axes | None,
    across: FloatArray,
    depth: FloatArray,
    values: FloatArray,
    quantity: str,
    name: str,
    label: str | None,
    *,
    titled: bool = False,
) -> Axes:
    """A plane of a volume field with a colour bar, depth downward.

    `across` and `depth` are edges of cells [m], `values` the field on them in SI units, `name` that
    of the coordinate, and `label`, if any, replaces that of the quantity. `titled`: the label is
    the title, for sections that are too flat for it beside them.
    """
    text, factor, unit, colours = QUANTITIES[quantity]
    shown = values * factor
    ax = axes_or_new(ax)
    options: dict[str, Any] = {}
    if colours == "RdBu_r" and np.any(shown):
        span = float(np.max(np.abs(shown)))  # white is zero
        options["norm"] = TwoSlopeNorm(0.0, -span, span)
    mesh = ax.pcolormesh(
        across * 1e6, depth * 1e6, shown.T, cmap=colours, rasterized=True, **options
    )
    full = f"{label or text} [{unit}]"
    ax.figure.colorbar(mesh, ax=ax, label="" if titled else full)
    if titled:
        ax.set_title(full, fontsize="medium")
    ax.set_aspect("equal")
    ax.set_xlabel(f"{name} [µm]")
    ax.set_ylabel("depth z [µm]")
    ax.invert_yaxis()
    return ax
