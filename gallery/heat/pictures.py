# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures 2.21 to 2.34 of Boucly (2008): contacts with frictional heat."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from ..drawing import axes, finish
from ..page import Picture
from .setups import FACTORS, HERTZ, SMALL_LOAD, SMALL_LOAD_FACTORS, YIELD, Results, hertz
from .statements import STATED


def figures(results: Results) -> list[Picture]:
    return [
        pressures(results),
        strain(results),
        onset_figure(results),
        small_load(results),
        *sections(results),
        residual_figure(results),
    ]


def pressures(results: Results) -> Picture:
    figure = Figure(figsize=(9.0, 3.8), layout="constrained")
    for ax, (name, (load, curves)) in zip(
        figure.subplots(1, 2), results.curves.items(), strict=True
    ):
        a = hertz(load).a
        for k, (label, x, p) in enumerate(curves):
            ax.plot(
                x / a, p * 1e-9, color=("k", "C0", "C1", "C3")[k],
                linestyle="--" if label == "elastic" else "-",
                label="Hertz, elastic" if label == "elastic" else label, linewidth=1.3,
            )  # fmt: skip
        ax.set_xlim(-1.4, 1.4)
        ax.set_ylim(0, 1.45 * max(float(p.max()) for _, _, p in curves) * 1e-9)
        ax.set_title(name.replace("Q_f", "$Q_f$"), fontsize="medium")
        finish(ax, "x/a", "pressure [GPa]")
    return Picture(
        "heat_pressure",
        "Figure 2.21: pressure in the plane y = 0. Thesis: the heat raises the largest pressure, "
        "in a smaller contact.",
        figure,
    )


def strain(results: Results) -> Picture:
    figure, ax = axes(1, 1, (5.0, 3.6))
    p0, gamma = results.strain
    ax.plot(p0 / YIELD, 100 * gamma, "o-", markersize=3, label="samcontact")
    ax.plot(5.5, 2.0, "ko", markerfacecolor="none", label="Boucly (2008): 2 % at 5.5")
    ax.set_ylim(0, None)
    finish(ax, "Hertz pressure / micro-yield stress", "largest plastic strain [%]")
    return Picture(
        "heat_strain",
        "Figure 2.22: largest equivalent plastic strain against the Hertz pressure, no heat.",
        figure,
    )


def onset_figure(results: Results) -> Picture:
    curve = results.onset
    figure, (left, middle, right) = axes(1, 3, (10.0, 3.4))
    left.plot(curve.factor, curve.p0 / YIELD, "C0")
    top = 1.38 * curve.p0[0] / YIELD
    left.plot(0.075, top, "ko", markerfacecolor="none", label="Boucly (2008): +38 % at 0.075")
    loads = [hertz(load).p0 / YIELD for load in STATED.values("onset load").values()]
    left.plot(FACTORS, loads, "k+", label="Boucly (2008), Table 2.2")
    middle.plot(curve.factor, curve.depth, "C0")
    right.plot(curve.factor, curve.radius, "C0")
    for ax in (left, middle, right):
        for value in (0.075, 0.152):
            ax.axvline(value, color="k", linestyle="--", linewidth=0.8)
        ax.set_xlim(0, 0.3)
    left.set_ylim(0, 3.2)
    middle.set_ylim(0.6, -0.02)
    left.plot([], [], "k--", linewidth=0.8, label="Boucly (2008): 0.075 and 0.152 m/s")
    finish(left, "heat factor $Q_f$ [m/s]", "Hertz pressure / micro-yield stress")
    finish(middle, "heat factor $Q_f$ [m/s]", "depth z/a", legend=False)
    finish(right, "heat factor $Q_f$ [m/s]", "radius r/a", legend=False)
    return Picture(
        "heat_onset",
        "Figures 2.23 to 2.25: Hertz pressure at the onset of yield, and depth and radius of the "
        "point that yields first, against the heat factor. a is the Hertz radius at that load.",
        figure,
    )


def small_load(results: Results) -> Picture:
    contact = hertz(SMALL_LOAD)
    figure, ax = axes(1, 1, (5.6, 3.8))
    fine = np.linspace(-1.5, 1.5, 31)
    ax.plot(fine, contact.pressure(fine * contact.a) * 1e-9, "k+", label="Hertz")
    for k, factor in enumerate(SMALL_LOAD_FACTORS):
        case = results.small[factor]
        ax.plot(case.x / contact.a, case.pressure * 1e-9, color=f"C{k}",
                label=f"$Q_f$ = {factor:g} m/s")  # fmt: skip
    ax.set_xlim(-1.5, 1.5)
    finish(ax, "x/a", "pressure [GPa]")
    return Picture(
        "heat_small_load",
        "Figure 2.26: pressure at 140 N, elastic-plastic with heat. Thesis: the pressure rises "
        "and the area falls with the heat; for no heat it is that of Hertz.",
        figure,
    )


def sections(results: Results) -> list[Picture]:
    """Draw the von Mises stress in the plane y = 0, in two figures with four panels each."""
    pictures = []
    for name, numbers, cases, row in (
        ("elastic", "2.27, 2.29 to 2.31", results.elastic, "elastic stress"),
        ("plastic", "2.28, 2.32 to 2.34", {f: results.last(f) for f in FACTORS}, "plastic stress"),
    ):
        figure = Figure(figsize=(9.0, 4.6), layout="compressed")
        for ax, factor in zip(figure.subplots(2, 2).flat, FACTORS, strict=True):
            case = cases[factor]
            x, z, plane = case.x / HERTZ.a, case.z / HERTZ.a, case.plane * 1e-6
            filled = ax.contourf(x, z, plane.T, levels=12, cmap="viridis")
            figure.colorbar(
                filled, ax=ax, label="von Mises stress [MPa]", shrink=0.7, ticks=MaxNLocator(5)
            )
            i, k = np.unravel_index(int(plane.argmax()), plane.shape)
            ax.plot(x[i], z[k], "wx", markersize=7, clip_on=False, zorder=4)
            ax.set_title(
                f"$Q_f$ = {factor:g} m/s: {case.largest[0] * 1e-6:.0f} MPa at "
                f"{case.largest[1] * 1e6:.0f} µm (stated {STATED.values(row)[factor]:.0f})",
                fontsize="small",
            )
            ax.set(xlim=(-1.5, 1.5), ylim=(1.2, 0), aspect="equal", xlabel="x/a",
                   ylabel="depth z/a")  # fmt: skip
        pictures.append(
            Picture(
                f"heat_sections_{name}",
                f"Figures {numbers}: von Mises stress in the plane y = 0, "
                f"{'elastic' if name == 'elastic' else 'elastic-plastic'}, 1500 N. Cross: the "
                "largest in this plane.",
                figure,
            )
        )
    return pictures


def residual_figure(results: Results) -> Picture:
    figure = Figure(figsize=(9.0, 3.8), layout="constrained")
    for ax, factor in zip(figure.subplots(1, 2), (0.12, 0.20), strict=True):
        for k, case in enumerate(results.plastic[factor]):
            thickness = (case.z[1] - case.z[0]) * 1e6
            ax.plot(case.z * 1e6, case.residual * 1e-6, ".-", color=f"C{k}", markersize=3,
                    linewidth=1, label=f"layers of {thickness:g} µm")  # fmt: skip
        if factor == 0.20:
            ax.plot(case.z * 1e6, case.elastic_unloading * 1e-6, "k:", linewidth=1.2,
                    label="elastic unloading")  # fmt: skip
        stated = STATED.values("residual stress")[factor]
        ax.plot(0, stated, "ko", markerfacecolor="none", clip_on=False, zorder=4,
                label=f"Boucly (2008): {stated:.0f} MPa")  # fmt: skip
        ax.set_xlim(0, 60)
        ax.set_ylim(0, None)
        ax.set_title(f"$Q_f$ = {factor:g} m/s", fontsize="medium")
        finish(ax, "depth [µm]", "residual von Mises stress [MPa]")
    return Picture(
        "heat_residual",
        "Not in the thesis: residual von Mises stress on the axis near the surface, with thinner "
        "and thinner layers, and the values of Table 2.3.",
        figure,
    )
