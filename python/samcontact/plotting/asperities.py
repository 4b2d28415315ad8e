# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of one or several asperity collisions.

Each function draws on the axes `ax` and returns them. If `critical` is given (e.g. from
`samcontact.critical.green`), each quantity is divided by its value at first yield, as in Boucly
(2008), figures 4.7 to 4.11.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes

from .._util.checks import FloatArray, choice
from .._util.display import quantity
from .._util.quantities import ASPERITIES
from .parts import axes_or_new, finish, prefixed

if TYPE_CHECKING:
    import xarray as xr

    from ..critical import CriticalSphere

__all__ = ["force", "load_ratio", "net_energy", "residual_displacement"]

Results = Sequence["xr.Dataset"]


def _offset(series: xr.Dataset) -> FloatArray:
    """Return X/R [-]: the offset X of the sphere centres, divided by the equivalent radius R."""
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
        raise ValueError(f"number must be that of a pass, from 1 to {passes}, got {number!r}")
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
    """Draw the force of the upper sphere on the lower sphere versus the offset X/R.

    X is the offset of the sphere centres, R the equivalent radius.

    Parameters
    ----------
    results : sequence of xarray.Dataset
        `CollisionResult.series` of each collision; one line is drawn for each.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    component : {"x", "z"}
        "x": tangential force, required to move the upper sphere along +X; "z": normal force.
    number : int
        Number of the pass, from 1.
    critical : CriticalSphere, optional
        Critical values of the spheres; the force is divided by the critical load. If omitted, the
        force is drawn in newtons with a suitable prefix, e.g. mN.
    """
    choice("component", component, ("x", "z"))
    name = f"force_{component}"
    passes = [_one_pass(result, number) for result in results]
    # NaN: no contact, hence no force
    largest = max((float(np.abs(np.nan_to_num(s[name])).max()) for s in passes), default=0.0)
    factor, unit = prefixed(largest, "N") if critical is None else (1.0 / critical.load, "")
    ax = axes_or_new(ax)
    for series in passes:
        force, label = series[name].values * factor, _label(series, critical)
        ax.plot(_offset(series), force, ".-", markersize=3, linewidth=1.0, label=label)
    unit_text = f"[{unit}]" if critical is None else "/ critical load"
    ax.set_ylabel(f"{ASPERITIES[name].heading} {unit_text}")
    return _against_offset(ax, critical)


def load_ratio(
    results: Results,
    ax: Axes | None = None,
    *,
    number: int = 1,
    critical: CriticalSphere | None = None,
) -> Axes:
    """Draw the ratio of tangential to normal force versus the offset X/R.

    X is the offset of the sphere centres, R the equivalent radius. The arguments are those of
    `force`; `critical` changes the labels only, because the ratio has no unit.
    """
    ax = axes_or_new(ax)
    for result in results:
        series = _one_pass(result, number)
        x = _offset(series)
        ratio = series["load_ratio"].values
        ax.plot(x, ratio, ".-", markersize=3, linewidth=1.0, label=_label(result, critical))
    ax.set_ylabel("tangential force / normal force [-]")
    return _against_offset(ax, critical)


def over_passes(
    series: xr.Dataset, ax: Axes | None = None, *, quantity: str, max_lines: int = 6
) -> Axes:
    """Draw force_x, force_z or load_ratio versus the offset X/R, with one line for each pass.

    X is the offset of the sphere centres, R the equivalent radius. If there are more than
    `max_lines` passes, only `max_lines` of them are drawn, evenly spaced from the first to the
    last.
    """
    ax, count = axes_or_new(ax), series.sizes["pass"]
    values, factor, label = series[quantity].values, 1.0, "tangential force / normal force [-]"
    if quantity != "load_ratio":
        factor, unit = prefixed(float(np.abs(np.nan_to_num(values)).max()), "N")
        label = f"{ASPERITIES[quantity].heading} [{unit}]"
    shown = np.unique(np.linspace(0, count - 1, min(count, max_lines)).round().astype(int))
    for index in shown:
        number = int(series["pass"].values[index])
        one = _one_pass(series, number)
        style: dict[str, Any] = {"label": f"pass {number}", "markersize": 3, "linewidth": 1.0}
        ax.plot(_offset(one), one[quantity].values * factor, ".-", **style)
    ax.set_ylabel(label)
    ax = _against_offset(ax, None)
    legend = ax.legend(fontsize="small", frameon=False)
    legend.set_visible(count > 1)
    return ax


def net_energy(
    results: Results, ax: Axes | None = None, *, critical: CriticalSphere | None = None
) -> Axes:
    """Draw the net energy of each pass and the energy of residual stress versus interference.

    The energy of residual stress is drawn after the first pass only.

    Parameters
    ----------
    results : sequence of xarray.Dataset
        `CollisionResult.series` of each collision, with equal numbers of passes; one point is drawn
        for each.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    critical : CriticalSphere, optional
        Critical values of the spheres, by which energy and interference are divided. If omitted,
        energy is in J and interference in m.
    """
    unit = 1.0 if critical is None else critical.energy
    ax = axes_or_new(ax)
    for number in results[0]["pass"].values:
        energies = [float(_one_pass(r, int(number))["net_energy"]) / unit for r in results]
        label = "net energy" if number == 1 else f"pass {number}"
        ax.plot(_interferences(results, critical), energies, "o-", markersize=3, label=label)
    stored = [float(_one_pass(r, 1)["residual_energy"]) / unit for r in results]
    label = "energy of residual stress"
    ax.plot(_interferences(results, critical), stored, "s--", markersize=3, label=label)
    ax.set_ylabel("energy [J]" if critical is None else "energy / critical energy")
    return _finished(ax, _interference_label(critical))


def residual_displacement(
    results: Results, ax: Axes | None = None, *, critical: CriticalSphere | None = None
) -> Axes:
    """Draw the residual imprint depth of each body after each pass, versus interference.

    The arguments are those of `net_energy`.
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
    unit_text = "[m]" if critical is None else "/ critical interference"
    ax.set_ylabel(f"residual imprint depth {unit_text}")
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
