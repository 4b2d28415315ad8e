# SPDX-License-Identifier: GPL-3.0-or-later
"""Common style of the pictures of the applications."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

SIZE = (8.0, 4.6)
"""Width and height of a picture [inch]; wider pictures would scroll on a phone."""


def panels(
    rows: int = 1, columns: int = 1, size: tuple[float, float] = SIZE, **more: Any
) -> tuple[Figure, Any]:
    """Return a figure and its panels."""
    figure = Figure(figsize=size, layout="constrained")
    return figure, figure.subplots(rows, columns, **more)


def lines(ax: Axes, xlabel: str, ylabel: str, title: str = "", legend: bool = True) -> None:
    """Add labels, grid lines, a title and a legend."""
    ax.set(xlabel=xlabel, ylabel=ylabel, title=title)
    ax.grid(visible=True, linewidth=0.4, alpha=0.5)
    if legend:
        ax.legend(fontsize="small")


def field(
    ax: Axes, x: Any, y: Any, values: Any, label: str, colours: str = "viridis", **more: Any
) -> None:
    """Draw contours of a field with shape (len(x), len(y)), and a colour bar."""
    levels = np.linspace(float(np.min(values)), float(np.max(values)), 13)
    bands = ax.contourf(x, y, np.asarray(values).T, levels, cmap=colours, **more)
    figure: Any = ax.figure
    digits = "%.0f" if levels[-1] >= 100.0 else "%.3g"
    figure.colorbar(bands, ax=ax, label=label, format=digits)


def cells(ax: Axes, x: Any, y: Any, values: Any, label: str) -> None:
    """Draw the cells of a field with shape (len(x), len(y)); cells with NaN are white."""
    drawn = ax.pcolormesh(x, y, np.asarray(values).T, cmap="magma_r", shading="nearest")
    figure: Any = ax.figure
    figure.colorbar(drawn, ax=ax, label=label)


def depth_down(ax: Axes, deepest: float) -> None:
    """Let the depth axis point down."""
    ax.set_ylim(deepest, 0.0)
