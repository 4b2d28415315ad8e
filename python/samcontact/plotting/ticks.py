# SPDX-License-Identifier: GPL-3.0-or-later
"""Ticks whose labels do not overlap, even on short axes."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib import rcParams
from matplotlib.axes import Axes
from matplotlib.font_manager import FontProperties
from matplotlib.ticker import AutoLocator, MaxNLocator

from .._util.checks import FloatArray

_DIGIT_WIDTH = 0.64  # width of a digit, relative to the font size
_MIN_LABEL_GAPS = (
    0.8,
    1.0,
)  # horizontal and vertical distance between labels, relative to the font size


class FittedLocator(MaxNLocator):
    """Tick locator that places as many round numbers as fit on the axis, but at least one."""

    def __init__(self, **options: Any) -> None:
        super().__init__(9, steps=[1, 2, 2.5, 5, 10], **options)

    def tick_values(self, vmin: float, vmax: float) -> Any:
        """Return the ticks from `vmin` to `vmax`, in the units of the axis."""
        ticks = np.zeros(0)
        for count in range(9, 0, -1):
            self.set_params(nbins=count)
            ticks = np.asarray(super().tick_values(vmin, vmax), dtype=np.float64)
            ends = min(vmin, vmax), max(vmin, vmax)
            ticks = ticks[(ticks >= ends[0]) & (ticks <= ends[1])]
            if self._fit(ticks, ends[1] - ends[0]):
                return ticks
        return ticks[[np.argmin(np.abs(ticks - np.clip(0.0, *ends)))]] if len(ticks) else ticks

    def _fit(self, ticks: FloatArray, span: float) -> bool:
        axis: Any = self.axis
        if getattr(axis, "axes", None) is None or len(ticks) < 2 or not span > 0:
            return True
        across = axis.axis_name == "x"
        box, dots = axis.axes.bbox, axis.axes.figure.dpi
        length = (box.width if across else box.height) * 72 / dots
        usual = rcParams["xtick.labelsize"] if across else rcParams["ytick.labelsize"]
        given = axis.get_tick_params().get("labelsize", usual)
        size = FontProperties(size=given).get_size_in_points()
        labels = axis.get_major_formatter().format_ticks(list(ticks))
        widths = np.array([_DIGIT_WIDTH * len(label) if across else 1.0 for label in labels])
        needed = 0.5 * (widths[1:] + widths[:-1]) + _MIN_LABEL_GAPS[0 if across else 1]
        return bool(np.all(np.diff(ticks) / span * length >= needed * size))


def fit_ticks(ax: Axes) -> None:
    """Use `FittedLocator` on each axis that still has the default ticks of Matplotlib."""
    for axis in (ax.xaxis, ax.yaxis):
        if type(axis.get_major_locator()) is AutoLocator:
            axis.set_major_locator(FittedLocator())
