# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of asperities that tug at each other, for the series of one or several tuggings.

Each function takes an `ax` and returns it. Values are shown over those at the onset of yield where
`critical` gives them (e.g. `samcontact.critical.green`). Boucly (2008), figures 4.7 to 4.11.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes

from .._util.checks import FloatArray, choice
from .._util.display import quantity
from .._util.quantities import TUGGING
from .parts import axes_or_new, finish, prefixed

if TYPE_CHECKING:
    import xarray as xr

    from ..critical import CriticalSphere

__all__ = ["force", "load_ratio", "net_energy", "residual_displacement"]

Results = Sequence["xr.Dataset"]


def _offset(series: xr.Dataset) -> FloatArray:
    """Of the centres over the equivalent radius."""
    first, second = (float(series.attrs[name]) for name in ("R1", "R2"))
    offset: FloatArray = series["offset"].values / (first * second / (first + second))
    return offset


def _label(series: xr.Dataset, critical: CriticalSphere | None) -> str:
    interference = series.attrs["interference"]
    if critical is None:
        return quantity(interference, "m")
    return f"ω/ωc = {interference / critical.interference:.3g}"


def _one_pass(series: xr.Dataset, number: int) -> xr.Dataset:
    passes = series.sizes["pass"]
    if not 1 <= number <= passes:
        raise ValueError(f"number must be that of a pass, 1 to {passes}, got {number!r}")
    one: xr.Dataset = series.sel({"pass": number})
    return one


def force(
    results: Results,
    ax: Axes | None = None,
    *,
    component: str = "x",
    number: int = 1,
    critical: CriticalSphere | None = None,
) -> Axes:
    """Force of the upper sphere on the lower one against the offset of their centres over R.

    Parameters
    ----------
    results : sequence of xarray.Dataset
        `Tugging.series` of each collision; one line is drawn for each.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    component : {"x", "z"}
        Tangential (what it takes to move the upper sphere along +X), or normal.
    number : int
        Of the pass, from 1.
    critical : CriticalSphere, optional
        Show force over its load, else in N, kN, or what reads well.
    """
    choice("component", component, ("x", "z"))
    name = f"force_{component}"
    passes = [_one_pass(result, number) for result in results]
    # without contact there is no force
    largest = max((float(np.abs(np.nan_to_num(s[name])).max()) for s in passes), default=0.0)
    factor, unit = prefixed(largest, "N") if critical is None else (1.0 / critical.load, "")
    ax = axes_or_new(ax)
    for series in passes:
        force, label = series[name].values * factor, _label(series, critical)
        ax.plot(_offset(series), force, ".-", markersize=3, linewidth=1.0, label=label)
    beside = f"[{unit}]" if critical is None else "/ critical load"
    ax.set_ylabel(f"{TUGGING[name].heading} {beside}")
    return _against_offset(ax, critical)


def load_ratio(
    results: Results,
    ax: Axes | None = None,
    *,
    number: int = 1,
    critical: CriticalSphere | None = None,
) -> Axes:
    """Tangential over normal force against the offset of the centres over R; arguments of `force`.

    `critical` is for the labels only.
    """
    ax = axes_or_new(ax)
    for result in results:
        series = _one_pass(result, number)
        x = _offset(series)
        ratio = series["load_ratio"].values
        ax.plot(x, ratio, ".-", markersize=3, linewidth=1.0, label=_label(result, critical))
    ax.set_ylabel("tangential / normal force")
    return _against_offset(ax, critical)


def net_energy(
    results: Results, ax: Axes | None = None, *, critical: CriticalSphere | None = None
) -> Axes:
    """Energy that each pass takes against the interference, and the part that stays as stress.

    Parameters
    ----------
    results : sequence of xarray.Dataset
        A point for each `Tugging.series`; with as many passes.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    critical : CriticalSphere, optional
        Show energy and interference over its own, else [J], [m].
    """
    unit = 1.0 if critical is None else critical.energy
    ax = axes_or_new(ax)
    for number in results[0]["pass"].values:
        energies = [float(_one_pass(r, int(number))["net_energy"]) / unit for r in results]
        label = "net energy" if number == 1 else f"pass {number}"
        ax.plot(_interferences(results, critical), energies, "o-", markersize=3, label=label)
    stored = [float(_one_pass(r, 1)["residual_energy"]) / unit for r in results]
    label = "of this in residual stress"
    ax.plot(_interferences(results, critical), stored, "s--", markersize=3, label=label)
    ax.set_ylabel("energy [J]" if critical is None else "energy / critical energy")
    return _finished(ax, _interference_label(critical))


def residual_displacement(
    results: Results, ax: Axes | None = None, *, critical: CriticalSphere | None = None
) -> Axes:
    """Largest depth of the print that a pass leaves in each body, against the interference.

    Arguments as in `net_energy`.
    """
    unit = 1.0 if critical is None else critical.interference
    ax = axes_or_new(ax)
    for number in results[0]["pass"].values:
        for body, style in ((1, "o-"), (2, "s--")):
            depths = [
                float(_one_pass(r, int(number))["residual_displacement"].sel(body=body)) / unit
                for r in results
            ]
            label = f"body {body}, pass {number}"
            ax.plot(_interferences(results, critical), depths, style, markersize=3, label=label)
    of = "[m]" if critical is None else "/ critical interference"
    ax.set_ylabel(f"residual displacement {of}")
    return _finished(ax, _interference_label(critical))


def _interferences(results: Results, critical: CriticalSphere | None) -> list[float]:
    unit = 1.0 if critical is None else critical.interference
    return [result.attrs["interference"] / unit for result in results]


def _interference_label(critical: CriticalSphere | None) -> str:
    return "interference [m]" if critical is None else "interference / critical interference"


def _against_offset(ax: Axes, critical: CriticalSphere | None) -> Axes:
    return _finished(ax, "offset X/R", "interference" if critical is None else None)


def _finished(ax: Axes, label: str, title: str | None = None) -> Axes:
    ax.axhline(0.0, color="k", linewidth=0.6)
    ax.set_xlabel(label)
    ax.legend(title=title, fontsize="small", title_fontsize="small")
    return finish(ax)
