# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of a contact with adhesion: load–approach curve, cohesive zone, pull-off force."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from .. import adhesion
from .._util.checks import FloatArray
from .._util.display import quantity
from ..results.reading import grid_of
from .parts import (
    add_to_title,
    axes_or_new,
    elsewhere,
    finish,
    new_figure,
    prefixed,
    row_of_interest,
)

if TYPE_CHECKING:
    import xarray as xr

_JUMP_SHARE, _JUMP_RATIO = 0.2, 4.0
"""A change of load between two increments is a jump if it exceeds both limits: the first number
times the largest tension, and the second number times the median change of load."""
_LAWS: tuple[dict[str, Any], ...] = (
    {"color": "0.35", "linewidth": 1.0, "linestyle": "-", "label": "JKR"},
    {"color": "0.35", "linewidth": 1.0, "linestyle": ":", "label": "Maugis, equal peak"},
    {"color": "0.6", "linewidth": 1.0, "linestyle": "-.", "label": "DMT"},
)
_RADII = 160
"""Number of points of each theoretical curve."""


def is_adhesive(dataset: xr.Dataset) -> bool:
    """Whether results are from a run with a law of adhesion (attraction depending on the gap)."""
    return "adhesion_stress" in dataset


def adhesion_curve(dataset: xr.Dataset, ax: Axes | None = None) -> Axes:
    """Draw the load–approach curve of a contact with adhesion; see also `load_approach`.

    Approach and retraction have different colours. A dashed line joins two increments between which
    the load jumps, see `jumps_of`. For a sphere, three theoretical curves are added: those of
    Johnson, Kendall & Roberts (JKR), of Maugis, for the maximum attraction of the law of adhesion,
    and of Derjaguin, Muller & Toporov (DMT).
    """
    ax = axes_or_new(ax)
    load, approach = dataset["load"].values, dataset["approach"].values
    (length, metres), (force, newtons) = (
        prefixed(float(np.abs(values).max()), unit)
        for values, unit in ((approach, "m"), (load, "N"))
    )
    rises = np.append(True, np.diff(approach) >= 0)
    for rising, colour, label in ((True, "C0", "approach"), (False, "C3", "retraction")):
        at = rises == rising
        if at.any():
            ax.plot(
                approach[at] * length, load[at] * force, "o", color=colour, markersize=3,
                label=label,
            )  # fmt: skip
    for n, jumped in enumerate(jumps_of(load)):
        ends = slice(n, n + 2)
        style: dict[str, Any] = {"linestyle": "--" if jumped else "-", "linewidth": 0.9}
        style["color"] = "C0" if rises[n + 1] else "C3"
        ax.plot(approach[ends] * length, load[ends] * force, **style)
    for style, (at, loads) in zip(_LAWS, _closed_forms(dataset), strict=False):
        shown = (at >= approach.min()) & (at <= approach.max())
        ax.plot(at[shown] * length, loads[shown] * force, zorder=1, **style)
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3, frameon=False)
    ax.set_xlabel(f"approach [{metres}]")
    ax.set_ylabel(f"load [{newtons}]")
    return finish(ax)


def jumps_of(load: FloatArray) -> NDArray[np.bool_]:
    """Return whether the load jumps between successive increments, shape (increments - 1,).

    In a jump, the load changes by more than a fifth of the largest tension and by more than four
    times the median change between increments. load: load of each increment [N].
    """
    change = np.abs(np.diff(load))
    if not change.size:
        return change > 0
    usual = float(np.median(change))
    found: NDArray[np.bool_] = change > max(
        _JUMP_SHARE * max(-load.min(), 0.0), _JUMP_RATIO * usual
    )
    return found


def _closed_forms(dataset: xr.Dataset) -> Iterator[tuple[FloatArray, FloatArray]]:
    """Iterate over the JKR, Maugis and DMT curves as pairs of approach [m] and load [N].

    There are no curves on a periodic grid or for bodies other than a sphere.
    """
    attrs = dataset.attrs
    if "radius_used" not in attrs or attrs.get("periodic"):
        return
    R, w, E_star = (float(attrs[f"{name}_used"]) for name in ("radius", "work", "modulus"))
    jkr = adhesion.jkr(R, w, E_star)
    highest = max(float(dataset["load"].max()), 0.0)
    radius = np.linspace(0.02, 1.2, _RADII) * float(jkr.radius(highest))
    yield jkr.approach(radius), jkr.load(radius)
    maugis = adhesion.maugis(R, w, E_star, float(attrs["peak_used"]))
    yield maugis.approach(radius), maugis.load(radius)
    approach = np.linspace(0.0, float(dataset["approach"].max()), _RADII)
    approach = approach[approach >= 0]
    yield approach, 4 / 3 * E_star * np.sqrt(R * approach**3) - adhesion.dmt(R, w)


def cohesive_zone(dataset: xr.Dataset, ax: Axes | None = None, *, index: int | None = None) -> Axes:
    """Draw pressure, repulsion and attraction along x.

    The profile lies in the middle row of cells if the attraction in this row reaches at least 90 %
    of the maximum attraction; otherwise it lies in the row with the maximum attraction.

    Parameters
    ----------
    dataset : xarray.Dataset
        Results of `samcontact.results.to_dataset` with a law of adhesion.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    index : int, optional
        Index of the increment, from 0. Default: the increment with the largest tension.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The results are from a run without a law of adhesion.
    """
    if not is_adhesive(dataset):
        raise ValueError(
            "dataset must be from a run with a law of adhesion, got results without "
            "adhesion_stress: draw them with pressure_profile"
        )
    index = int(dataset["load"].values.argmin()) if index is None else index
    grid = grid_of(dataset)
    fields = {
        name: dataset[name].values[index] for name in ("pressure", "repulsion", "adhesion_stress")
    }
    row = row_of_interest(fields["adhesion_stress"].max(axis=0), grid.y)
    (length, metres), (factor, pascals) = (
        prefixed(float(np.abs(values).max()), unit)
        for values, unit in ((grid.x, "m"), (fields["pressure"], "Pa"))
    )
    x, ax = grid.x * length, axes_or_new(ax)
    repulsion, attraction = (fields[n][:, row] * factor for n in ("repulsion", "adhesion_stress"))
    ax.fill_between(x, 0.0, repulsion, color="C0", alpha=0.35, linewidth=0, label="repulsion")
    ax.fill_between(x, 0.0, -attraction, color="C3", alpha=0.35, linewidth=0, label="attraction")
    ax.plot(x, fields["pressure"][:, row] * factor, "k-", linewidth=1.2, label="pressure")
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.12), ncols=3, frameon=False)
    ax.set_xlabel(f"x [{metres}]")
    ax.set_ylabel(f"pressure [{pascals}]")
    load, approach = (float(dataset[name].values[index]) for name in ("load", "approach"))
    text = f"load {quantity(load, 'N')}, approach {quantity(approach, 'm')}"
    add_to_title(ax, text, elsewhere("y", float(grid.y[row]), grid.dy))
    return finish(ax)


def pull_off_over_tabor(dataset: xr.Dataset, ax: Axes | None = None) -> Axes:
    """Draw the pull-off force of a sphere at its Tabor number, in comparison with Maugis' curve.

    The pull-off force is the largest tension of the run. It is divided by pi w R, where w is the
    work of adhesion and R the radius of the sphere. Horizontal lines show the limits of JKR (1.5)
    and DMT (2).

    Parameters
    ----------
    dataset : xarray.Dataset
        Results of `samcontact.results.to_dataset` from a run in which an adhesive sphere came under
        tension.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        The results have no Tabor number or no tension.
    """
    attrs = dataset.attrs
    if "tabor" not in attrs or "pull_off" not in attrs:
        raise ValueError(
            "dataset must be from a run in which an adhesive sphere came under tension, got "
            "results without tabor or pull_off"
        )
    ax = axes_or_new(ax)
    unit = np.pi * float(attrs["work_used"]) * float(attrs["radius_used"])
    here = float(attrs["tabor"])
    numbers = np.geomspace(min(0.03, 0.5 * here), max(10.0, 2.0 * here), 41)
    w = 1e-4
    tension = [adhesion.maugis(1.0, w, 1.0, w ** (1 / 3) * n).pull_off / np.pi / w for n in numbers]
    for value, style in ((1.5, _LAWS[0]), (2.0, _LAWS[2])):
        ax.axhline(value, **style)
    ax.plot(numbers, tension, **_LAWS[1])
    ax.plot([here], [float(attrs["pull_off"]) / unit], "o", color="C3", label="computed")
    ax.set_xscale("log")
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2, frameon=False)
    ax.set_xlabel("Tabor number [-]")
    ax.set_ylabel("largest tension / (π w R) [-]")
    return finish(ax)


def adhesion_figures(dataset: xr.Dataset) -> dict[str, Figure]:
    """Return the figures of a run with adhesion, except the load–approach curve."""
    if not is_adhesive(dataset):
        return {}
    figures = {"cohesive_zone": new_figure()}
    cohesive_zone(dataset, figures["cohesive_zone"].subplots())
    if "tabor" in dataset.attrs and "pull_off" in dataset.attrs:
        figures["pull_off"] = new_figure()
        pull_off_over_tabor(dataset, figures["pull_off"].subplots())
    return figures
