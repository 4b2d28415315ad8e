# SPDX-License-Identifier: GPL-3.0-or-later
"""Common style of the figures of the gallery."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import samcontact as sc


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
