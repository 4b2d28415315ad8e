# SPDX-License-Identifier: GPL-3.0-or-later
"""Quantities of a contact of viscoelastic bodies over time."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from .._util.checks import FloatArray, choice
from .._util.quantities import CONTACT
from .parts import axes_or_new, finish, new_figure

if TYPE_CHECKING:
    import xarray as xr

QUANTITIES = ("approach", "contact_radius", "max_pressure", "load")
_MIN_DECADES = 1.5
"""Smallest number of decades of time for which the time axis is logarithmic."""


def over_time(dataset: xr.Dataset, ax: Axes | None = None, *, quantity: str = "approach") -> Axes:
    """Draw a quantity of a contact over time.

    The time axis is logarithmic if the times after the start span 1.5 decades or more. Because a
    logarithmic axis cannot show time 0, a dotted line then marks the last value at time 0, i.e.
    after the initial elastic steps, which have no duration.

    Parameters
    ----------
    dataset : xarray.Dataset
        Results of `samcontact.results.to_dataset` with times, e.g. of viscoelastic bodies.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    quantity : {"approach", "contact_radius", "max_pressure", "load"}
        Quantity to draw. The contact radius is the radius of a circle with the contact area.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The quantity is unknown, or the dataset has no times.
    """
    choice("quantity", quantity, QUANTITIES)
    if "time" not in dataset:
        raise ValueError(
            "dataset must contain times, got results of a run without durations: run it with "
            "viscoelastic bodies or heat.history"
        )
    time, (values, label) = dataset["time"].values, _values(dataset, quantity)
    ax = axes_or_new(ax)
    later = time > 0
    if is_logarithmic(time):
        first = np.flatnonzero(~later)
        if first.size:
            ax.axhline(values[first[-1]], color="0.5", linewidth=0.9, linestyle=":")
        ax.plot(time[later], values[later], "-o", markersize=3, linewidth=1.2)
        ax.set_xscale("log")
    else:
        ax.plot(time, values, "-o", markersize=3, linewidth=1.2)
    ax.set_xlabel(CONTACT["time"].label)
    ax.set_ylabel(label)
    return finish(ax)


def is_logarithmic(time: FloatArray) -> bool:
    """Whether the times after the start [s] span enough decades for a logarithmic axis."""
    later = time[time > 0]
    return later.size > 1 and bool(np.log10(later.max() / later.min()) >= _MIN_DECADES)


def has_times(dataset: xr.Dataset) -> bool:
    """Whether a figure over time is possible: viscoelastic bodies with several increments."""
    viscous = any(f"viscous_work_body{body}" in dataset for body in (1, 2))
    return viscous and dataset.sizes["increment"] > 1


def time_figure(dataset: xr.Dataset) -> Figure:
    """Return a figure of approach, contact radius and maximum pressure over time."""
    figure = new_figure(9.0, 3.0)
    if "time" not in dataset:  # elastic steps only
        dataset = dataset.assign(time=("increment", np.zeros(dataset.sizes["increment"])))
    for ax, quantity in zip(figure.subplots(1, 3), QUANTITIES[:3], strict=True):
        over_time(dataset, ax, quantity=quantity)
    return figure


def _values(dataset: xr.Dataset, quantity: str) -> tuple[FloatArray, str]:
    if quantity == "contact_radius":
        return np.sqrt(dataset["contact_area"].values / np.pi) * 1e6, "contact radius [µm]"
    shown = CONTACT[quantity]
    return dataset[quantity].values * shown.factor, shown.label
