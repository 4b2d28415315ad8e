# SPDX-License-Identifier: GPL-3.0-or-later
"""Common style of the figures of the gallery."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import samcontact as sc

APPLICATION_SIZE = (8.0, 4.6)
"""Width and height of a picture of an application [inch]; wider ones would scroll on a phone."""


def axes(
    rows: int = 1,
    columns: int = 2,
    size: tuple[float, float] = (9.0, 3.8),
    layout: Any = "constrained",
    **shared: Any,
) -> tuple[Figure, Any]:
    """Return a figure with rows and columns of axes; `shared` is passed to `Figure.subplots`."""
    figure = Figure(figsize=size, layout=layout)
    return figure, figure.subplots(rows, columns, **shared)


def gridded() -> tuple[Figure, Axes]:
    """Return a figure and its axes with grid lines."""
    figure, ax = axes(1, 1, (6.0, 4.2))
    ax.grid(True, linewidth=0.4, alpha=0.5)
    return figure, ax


def finish(ax: Axes, xlabel: str = "", ylabel: str = "", legend: bool = True) -> None:
    """Add axis labels, grid lines and a legend to axes."""
    ax.set(xlabel=xlabel, ylabel=ylabel)
    ax.grid(True, linewidth=0.4, alpha=0.5)
    if legend:
        ax.legend(fontsize="small", framealpha=1.0, edgecolor="none")  # no line lies there


def finish_titled(ax: Axes, xlabel: str, ylabel: str, title: str = "", legend: bool = True) -> None:
    """Add axis labels, grid lines, a title and a legend that lets lines shine through."""
    finish(ax, xlabel, ylabel, legend=False)
    ax.set_title(title)
    if legend:
        ax.legend(fontsize="small")


def hertz_curve(
    ax: Axes,
    contact: sc.hertz.PointContact,
    unit: float = 1e9,
    reach: float = 1.5,
    label: str = "Hertz",
) -> None:
    """Draw the Hertz pressure, in units of `unit` [Pa], against x/a up to `reach`."""
    x = np.linspace(-reach, reach, round(200 * reach) + 1)
    ax.plot(x, contact.pressure(x * contact.a) / unit, "k--", linewidth=1, label=label)


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
