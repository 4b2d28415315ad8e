# SPDX-License-Identifier: GPL-3.0-or-later
"""Figure of many realisations of a random case: distribution of each quantity."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from .._util.checks import FloatArray
from .._util.quantities import Quantity
from .parts import finish, new_figure
from .sweeps import MAX_PANELS

_MAX_BINS = 30


def realisations_figure(
    quantities: Mapping[str, Quantity], samples: Mapping[str, FloatArray]
) -> Figure | None:
    """Return a figure with one histogram for each quantity that varies between realisations.

    A solid line marks the mean; dashed lines mark the mean plus and minus one standard deviation.
    At most `MAX_PANELS` quantities are drawn. Return None if no quantity varies.
    """
    shown = [n for n in quantities if samples[n].size > 2 and np.ptp(samples[n]) > 0][:MAX_PANELS]
    if not shown:
        return None
    columns = min(len(shown), 3)
    rows = math.ceil(len(shown) / columns)
    figure = new_figure(max(5.0, 3.4 * columns), 2.9 * rows)
    panels = figure.subplots(rows, columns, squeeze=False).ravel()
    for ax, name in zip(panels, shown, strict=False):
        _panel(ax, quantities[name], samples[name] * quantities[name].factor)
    for ax in panels[len(shown) :]:
        ax.set_visible(False)
    return figure


def _panel(ax: Axes, quantity: Quantity, sample: FloatArray) -> None:
    bins = min(_MAX_BINS, max(5, math.ceil(math.sqrt(sample.size))))
    ax.hist(sample, bins=bins, color="C0", alpha=0.5)
    mean, deviation = float(np.mean(sample)), float(np.std(sample, ddof=1))
    ax.axvline(mean, color="C1", linewidth=1.4)
    for side in (-1, 1):
        ax.axvline(mean + side * deviation, color="C1", linewidth=1.0, linestyle="--")
    heading = (quantity.heading or quantity.short).replace("\n", " ")
    ax.set(xlabel=f"{heading} [{quantity.shown}]" if quantity.shown else heading,
           ylabel="realisations")  # fmt: skip
    ax.set_title(f"mean {mean:.4g}, deviation {deviation:.3g}", fontsize="small")
    ax.xaxis.label.set_fontsize("small")
    finish(ax)
