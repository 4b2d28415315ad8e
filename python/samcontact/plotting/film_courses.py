# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of a lubricated contact over time, and of elastic-plastic bodies under a film."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from .._util.checks import FloatArray
from ..problem.grid import Grid
from .parts import axes_or_new, finish, new_figure, prefixed
from .section import section

if TYPE_CHECKING:
    import xarray as xr


def film_over_time(dataset: xr.Dataset, ax: Axes | None = None) -> Axes:
    """Draw central film thickness, minimum film thickness and maximum pressure over time.

    dataset: dataset of `samcontact.results.films_dataset` from the films of
    `samcontact.lubrication.transient`; ax: axes to draw on, default a new figure. Returns the axes
    of the film thickness. Raises ValueError for other datasets.
    """
    if "time" not in dataset:
        raise ValueError(
            "dataset must contain times, got films of steady contacts: compute films over time "
            "with samcontact.lubrication.transient"
        )
    ax = axes_or_new(ax)
    factor, seconds = prefixed(float(dataset["time"].max()), "s")
    time = dataset["time"].values * factor
    thickness, unit = prefixed(float(dataset["central_film"].max()), "m")
    for name, style in (("central_film", "C3-"), ("minimum_film", "C3--")):
        label = name.replace("_", " ")
        ax.plot(time, dataset[name].values * thickness, style, label=label)
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2, frameon=False)
    ax.set_xlabel(f"time [{seconds}]")
    ax.set_ylabel(f"film thickness [{unit}]", color="C3")
    ax.set_ylim(bottom=0.0)
    right = ax.twinx()
    largest, pascals = prefixed(float(dataset["max_pressure"].max()), "Pa")
    right.plot(time, dataset["max_pressure"].values * largest, "C0-")
    right.set_ylabel(f"maximum pressure [{pascals}]", color="C0")
    right.set_ylim(bottom=0.0)
    return finish(ax)


def film_stress_figure(dataset: xr.Dataset, grid: Grid) -> Figure:
    """Return a figure with sections of stress, plastic strain and residual stress in one body.

    The figure shows the body with the larger plastic strain, in sections through the cell with the
    maximum plastic strain.
    """
    body = 1 + int(np.argmax(dataset["equivalent_plastic_strain"].max(dim=("x", "y", "z")).values))
    strain = dataset["equivalent_plastic_strain"].sel(body=body).values
    row = int(np.unravel_index(int(np.argmax(strain)), strain.shape)[1])
    figure = new_figure(4.8, 7.2)
    names = "von_mises", "equivalent_plastic_strain", "residual_von_mises"
    for ax, name in zip(figure.subplots(3, 1), names, strict=True):
        values: FloatArray = dataset[name].sel(body=body).values
        section(values, grid, ax, quantity=name, position=float(grid.y[row]))
    figure.suptitle(f"body {body}", fontsize="medium")
    return figure


def film_imprint(dataset: xr.Dataset, ax: Axes | None = None) -> Axes:
    """Draw the residual height under a film along x, with one line for each load.

    The residual height is the sum of the residual displacements of both bodies, positive outward.
    The profile passes through the cell with the smallest initial gap. dataset: dataset of
    `samcontact.results.films_dataset` from the films of `samcontact.lubrication.press_loads`; ax:
    axes to draw on, default a new figure. Returns the axes. Raises ValueError for other datasets.
    """
    if "residual_displacement" not in dataset:
        raise ValueError(
            "dataset must contain residual displacements, got films between elastic bodies: "
            "compute films between elastic-plastic bodies with samcontact.lubrication.press_loads"
        )
    ax = axes_or_new(ax)
    moved = -dataset["residual_displacement"].sum("body").values
    row = int(np.unravel_index(int(np.argmin(dataset["initial_gap"].values)), moved.shape[1:])[1])
    factor, metres = prefixed(float(np.abs(dataset["x"]).max()), "m")
    height, unit = prefixed(max(float(np.abs(moved).max()), 1e-12), "m")
    for load, profile in zip(dataset["load"].values, moved[:, :, row], strict=True):
        ax.plot(dataset["x"].values * factor, profile * height, label=f"{load:.4g} N")
    ax.set_xlabel(f"x [{metres}]")
    ax.set_ylabel(f"residual height [{unit}]")
    ax.legend(title="load", fontsize="small", title_fontsize="small")
    return finish(ax)
