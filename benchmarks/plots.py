# SPDX-License-Identifier: GPL-3.0-or-later
"""Work-precision diagrams with one row of axes per error and one column per kind of work."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import matplotlib.pyplot as plt
import pandas as pd
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter

# Okabe & Ito: distinguishable for all kinds of colour vision.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
MARKERS = "osD^vPX"
LABELS = {
    "time_s": "time [s]",
    "memory_MB": "peak memory [MB]",
    "contact_iterations": "conjugate-gradient iterations [-]",
    "surface_applications": "applications of the surface operator [-]",
    "volume_applications": "applications of the volume operator [-]",
    "shear_work": "work of the shear, in its applications [-]",
    "box_cells": "cells of the plastic box [-]",
    "us_per_cell_and_application": "time per cell and application [µs]",
    "bytes_per_cell": "peak memory per cell [bytes]",
    "cells": "cells [-]",
    "time_ratio": "time over that of the reference [-]",
}
APPLICATIONS = ("volume_applications", "surface_applications", "contact_iterations")


def label(column: str) -> str:
    """Return the axis label of a column, with name and unit; errors are relative."""
    name = column.removeprefix("error: ")
    return LABELS.get(column, f"error of {name} [-]" if name != column else column)


def axes_of(rows: pd.DataFrame, part: ModuleType) -> tuple[list[str], list[str]]:
    """Return the columns for the x and y axes, as set by the part; default: work and errors."""
    if hasattr(part, "AXES"):
        across, up = part.AXES
        return list(across), list(up)
    # A constant number of applications contains no information.
    counted = [c for c in APPLICATIONS if c in rows and rows[c].nunique() > 1]
    errors = [c for c in rows if c.startswith("error: ") and rows[c].notna().any()]
    return ["time_s", "memory_MB", *counted[:1]], errors


def series(rows: pd.DataFrame, part: ModuleType) -> Iterator[tuple[str, pd.DataFrame]]:
    """Iterate over the lines of a diagram, as pairs of name and rows."""
    by = list(getattr(part, "SERIES", ("case", "method")))
    varying = [column for column in by if rows[column].nunique() > 1] or by[:1]
    for key, group in rows.groupby(varying, sort=False):
        yield ", ".join(key), group


def label_sparsely(axis: Axis) -> None:
    """Set tick labels that do not overlap: decades, or 1, 2 and 5 within about one decade."""
    low, high = axis.get_view_interval()
    if high < 30 * low:
        axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axis.set_major_formatter("{x:g}")
    axis.set_minor_formatter(NullFormatter())


def diagram(rows: pd.DataFrame, part: ModuleType) -> Figure | None:
    """Return the double-logarithmic diagrams of a part; None if no line has two points."""
    across, up = axes_of(rows, part)
    across = [c for c in across if c in rows]
    up = [c for c in up if c in rows]
    lines = [(name, g) for name, g in series(rows.dropna(subset=up, how="all"), part)]
    if not up or max((len(group) for _, group in lines), default=0) < 2:
        return None
    size = (4.2 * len(across), 3.2 * len(up) + 0.6)
    figure, grid = plt.subplots(
        len(up), len(across), figsize=size, squeeze=False, layout="constrained"
    )
    for row, y in zip(grid, up, strict=True):
        for axes, x in zip(row, across, strict=True):
            for n, (name, group) in enumerate(lines):
                style = {"color": COLOURS[n % len(COLOURS)], "marker": MARKERS[n % len(MARKERS)]}
                points = group[[x, y]].dropna()
                axes.loglog(points[x], points[y], label=name, markersize=5, **style)
            label_sparsely(axes.xaxis)
            label_sparsely(axes.yaxis)
            axes.set(xlabel=label(x), ylabel=label(y))
            axes.grid(True, which="major", alpha=0.3)
    handles, names = grid[0][0].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside lower center", ncols=min(4, len(names)))
    figure.suptitle(part.TITLE)
    return figure


def write(rows: pd.DataFrame, part: ModuleType, folder: Path) -> Path | None:
    """Write NAME.png if there is anything to draw."""
    figure = diagram(rows, part)
    if figure is None:
        return None
    path = folder / f"{part.NAME}.png"
    figure.savefig(path, dpi=150)
    plt.close(figure)
    return path
