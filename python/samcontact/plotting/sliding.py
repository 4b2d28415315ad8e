# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of steady sliding over viscoelastic bodies.

The functions are also available from `samcontact.plotting`. Each draws on the axes `ax` and returns
them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from .._util.checks import finite_array
from .parts import axes_or_new, edges, new_figure

if TYPE_CHECKING:
    import xarray as xr

_AREA_COLOUR = "tab:orange"


def friction_curve(
    velocity: ArrayLike,
    friction: ArrayLike,
    ax: Axes | None = None,
    *,
    contact_share: ArrayLike | None = None,
    label: str | None = None,
) -> Axes:
    """Draw the friction coefficient versus the sliding velocity, with a logarithmic velocity axis.

    Parameters
    ----------
    velocity : array_like, shape (n,)
        Velocities [m/s]. Their magnitudes are shown; a velocity of 0 is omitted.
    friction : array_like, shape (n,)
        Friction coefficients [-].
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    contact_share : array_like, shape (n,), optional
        Contact area divided by the area of the surface [-]. If given, it is drawn on a second axis
        on the right.
    label : str, optional
        Label of the friction curve.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The arrays have different lengths, or no velocity differs from 0.
    """
    count = np.size(velocity)
    v, mu = (
        finite_array(name, values, (count,))
        for name, values in (("velocity", velocity), ("friction", friction))
    )
    moving = v != 0
    if not moving.any():
        raise ValueError(f"at least one velocity must differ from 0, got {v.tolist()!r:.80}")
    ax = axes_or_new(ax)
    order = np.argsort(np.abs(v[moving]))
    speeds = np.abs(v[moving])[order]
    ax.semilogx(speeds, mu[moving][order], "o-", markersize=3, linewidth=1.2, label=label)
    if label is not None:
        ax.legend(frameon=False)
    if contact_share is not None:
        share = finite_array("contact_share", contact_share, (count,))
        right = ax.twinx()
        right.semilogx(speeds, 100 * share[moving][order], "s--", markersize=3, color=_AREA_COLOUR)
        right.set_ylabel("contact area [% of the surface]", color=_AREA_COLOUR)
        right.set_ylim(bottom=0.0)
    ax.set_xlabel("sliding velocity [m/s]")
    ax.set_ylabel("friction coefficient [-]")
    ax.set_ylim(bottom=min(0.0, float(mu.min())))
    ax.grid(True, linewidth=0.4, alpha=0.5)
    ax.set_axisbelow(True)
    return ax


def figures(dataset: xr.Dataset) -> dict[str, Figure]:
    """Return the figures of a sliding run: friction versus velocity, and maps of the pressure.

    Parameters
    ----------
    dataset : xarray.Dataset
        Result of `FrictionCurve.to_dataset`.

    Returns
    -------
    dict of str to matplotlib.figure.Figure
        Figures by name.
    """
    made = {"friction_over_velocity": new_figure()}
    friction_curve(
        dataset["velocity"].values,
        dataset["friction"].values,
        made["friction_over_velocity"].subplots(),
        contact_share=dataset["contact_share"].values if "contact_share" in dataset else None,
    )
    if "pressure" in dataset and dataset.sizes["y"] > 1:
        made["pressure_over_velocity"] = pressure_panels(dataset)
    return made


def pressure_panels(dataset: xr.Dataset) -> Figure:
    """Draw maps of the pressure at the lowest and highest velocity and at the largest friction.

    Parameters
    ----------
    dataset : xarray.Dataset
        Result of `FrictionCurve.to_dataset`.

    Returns
    -------
    matplotlib.figure.Figure
    """
    speeds = np.abs(dataset["velocity"].values)
    chosen = (np.argmin(speeds), np.argmax(dataset["friction"].values), np.argmax(speeds))
    points = list(dict.fromkeys(int(index) for index in chosen))
    figure = new_figure(3.0 * len(points) + 0.6, 3.2)
    panels = figure.subplots(1, len(points), sharey=True, squeeze=False)[0]
    highest = float(dataset["pressure"].isel(point=points).max()) * 1e-6
    sides = [1e6 * edges(dataset[axis].values, dataset.attrs[f"d{axis}"]) for axis in "xy"]
    for ax, index in zip(panels, points, strict=True):
        values = 1e-6 * dataset["pressure"].values[index]
        values = np.where(values > 0, values, np.nan)  # white: no contact
        shown = ax.pcolormesh(*sides, values.T, cmap="viridis", vmin=0.0, vmax=highest or 1.0)
        ax.set_aspect("equal")
        velocity = float(f"{dataset['velocity'].values[index]:.3g}")
        ax.set_title(f"{velocity:g} m/s", fontsize="medium")  # as the axis of the friction curve
        ax.set_xlabel("x [µm]")
    panels[0].set_ylabel("y [µm]")
    figure.colorbar(shown, ax=list(panels), label="pressure [MPa]")
    return figure
