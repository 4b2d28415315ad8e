# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures 3.34 to 3.36 of Boucly (2008): temperature and stress under a hot tool."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from ..drawing import axes, finish
from ..page import Picture
from .setups import HERTZ, KINDS, NAMES, TIME, Results
from .statements import still_missing


def figures(results: Results) -> list[Picture]:
    return [flash(results), temperatures(results), stresses(results), approach(results)]


def flash(results: Results) -> Picture:
    figure, (left, right) = axes()
    for k, kind in enumerate(KINDS):
        case = results.elastic[kind]
        colour = "k" if kind == "no heat" else f"C{k - 1}"
        label = NAMES.get(kind, kind)
        if kind != "no heat":
            left.plot(case.x / HERTZ.a, case.flash, color=colour, label=label)
        right.plot(case.x / HERTZ.a, case.pressure * 1e-9, color=colour, label=label,
                   linestyle="--" if kind == "no heat" else "-")  # fmt: skip
    right.plot(0, 6.5, "ko", markerfacecolor="none", label="Boucly (2008): 6.5 GPa")
    right.plot([-332 / HERTZ.a / 1e6, 332 / HERTZ.a / 1e6], [0, 0], "k|", markersize=12,
               label="Boucly (2008): ±332 µm")  # fmt: skip
    left.set_ylim(-200, 6500)
    left.annotate("tool moves", xy=(1.7, 4200), xytext=(0.75, 4200), fontsize="small",
                  va="center", arrowprops={"arrowstyle": "->"})  # fmt: skip
    for ax in (left, right):
        ax.set_xlim(-1.8, 1.8)
    right.set_ylim(-0.2, 13)
    finish(left, "x/a", "temperature rise of the surface [K]")
    finish(right, "x/a", "pressure [GPa]")
    return Picture(
        "transient_heat_flash",
        "Flash temperature along the direction of motion, and pressure; elastic flat.",
        figure,
    )


def temperatures(results: Results) -> Picture:
    figure = Figure(figsize=(10.0, 2.9), layout="compressed")
    for ax, kind in zip(figure.subplots(1, 3, sharey=True), NAMES, strict=True):
        case = results.elastic[kind]
        value, x = case.hottest
        shown = panel(ax, case.x, case.z, case.temperature, "inferno", NAMES[kind])
        figure.colorbar(shown, ax=ax, label="temperature rise [K]", shrink=0.85,
                        location="bottom", ticks=MaxNLocator(5))  # fmt: skip
        ax.plot(x / HERTZ.a, 0, "wx", clip_on=False, zorder=4)
        ax.text(0.02, 0.05, f"largest: {value:.0f} K", transform=ax.transAxes, color="w",
                fontsize="small")  # fmt: skip
    figure.axes[0].set_ylabel("depth z/a")
    return Picture(
        "transient_heat_temperature",
        "Figures 3.34 to 3.36: temperature rise in the plane y = 0, elastic flat. In (iii) the "
        "tool moves to the right. Cross: the largest.",
        figure,
    )


def stresses(results: Results) -> Picture:
    figure, rows = axes(2, 3, (10.0, 5.4), layout="compressed", sharex=True, sharey=True)
    both: tuple[dict[str, Any], ...] = (results.elastic, results.plastic)
    for row, cases, name in zip(rows, both, ("elastic", "elastic-plastic"), strict=True):
        for ax, kind in zip(row, NAMES, strict=True):
            case = cases[kind]
            stress, x, z = case.largest
            shown = panel(
                ax,
                case.x,
                case.z,
                case.von_mises * 1e-6,
                "viridis",
                NAMES[kind] if name == "elastic" else "",
            )
            figure.colorbar(shown, ax=ax, label="von Mises stress [MPa]", shrink=0.85,
                            location="bottom", ticks=MaxNLocator(6))  # fmt: skip
            ax.plot(x / HERTZ.a, z / HERTZ.a, "wx", clip_on=False, zorder=4)
            ax.text(0.02, 0.05, f"largest: {stress * 1e-6:.0f} MPa", transform=ax.transAxes,
                    color="w", fontsize="small")  # fmt: skip
        row[0].set_ylabel(f"{name}\ndepth z/a")
    return Picture(
        "transient_heat_von_mises",
        "Figures 3.34 to 3.36: von Mises stress in the plane y = 0; above an elastic flat, below "
        "an elastic-plastic one. Cross: the largest.",
        figure,
    )


def panel(
    ax: Axes, x: np.ndarray, z: np.ndarray, field: np.ndarray, colours: str, title: str
) -> Any:
    shown = ax.contourf(x / HERTZ.a, z / HERTZ.a, field.T, levels=12, cmap=colours)
    ax.set(xlim=(-1.7, 1.7), ylim=(1.15, 0), aspect="equal", xlabel="x/a")
    ax.set_title(title, fontsize="medium")
    return shown


def approach(results: Results) -> Picture:
    figure, ax = axes(1, 1, (5.6, 3.8))
    steady = results.elastic["(ii)"].hottest[0]
    top = float(results.elastic["(ii)"].pressure.max())
    ax.loglog(results.times, 1 - results.rises / steady, "o-", markersize=3, label="temperature")
    ax.loglog(results.times, 1 - results.pressures / top, "s-", markersize=3, label="pressure")
    ax.loglog(results.times, [still_missing(t) / steady for t in results.times], "k--",
              linewidth=1, label="point source, long times")  # fmt: skip
    ax.axvline(TIME, color="k", linestyle=":", linewidth=1, label="23 ms")
    ax.set_ylim(1e-9, 3)
    finish(ax, "time of heating [s]", "relative difference from steady maximum [-]")
    return Picture(
        "transient_heat_steady",
        "Not in the thesis: approach of case (i) to case (ii). Relative differences of the maximum "
        "temperature rise and the maximum pressure from their steady values.",
        figure,
    )
