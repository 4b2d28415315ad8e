# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures 2.10 to 2.13 of Boucly (2008), and a figure of two empirical models."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from reference import fem

from ..drawing import axes, gridded
from ..page import Picture
from .setups import CRITICAL, YIELD, Point, Results, models

SMALL_INTERFERENCES, LARGE_INTERFERENCES = (
    (2.0, 4.0, 6.0, 8.0, 11.0),
    (12.0, 20.0, 40.0, 70.0, 110.0),
)


def figures(results: Results) -> list[Picture]:
    """Draw figures 2.10 to 2.13, and compare load, area and mean pressure with two models."""
    return [
        Picture(
            "flattening_zone_small",
            "Figure 2.10: outlines of the plastic zone in the plane y = 0, for ω/ω_c from 2 to 11. "
            "According to the thesis, an elastic core lies at the surface at ω/ω_c = 2, and the "
            "zone reaches the surface at 6.",
            zones(results, SMALL_INTERFERENCES, zoom=True),
        ),
        Picture(
            "flattening_zone_large",
            "Figure 2.11: outlines of the plastic zone for ω/ω_c from 12 to 110.",
            zones(results, LARGE_INTERFERENCES, zoom=False),
        ),
        Picture(
            "flattening_strain",
            "Figure 2.12: maximum equivalent plastic strain as a multiple of Y/E (left axis), and "
            "in percent for a material whose strain at ω/ω_c = 28 is 5 %, as stated in the thesis "
            "(right axis).",
            strain_figure(results),
        ),
        Picture(
            "flattening_friction",
            "Figure 2.13: interference at which the plastic zone reaches the surface. The thesis "
            "states 6 without friction, less with friction, and below 1 for high friction.",
            friction_figure(results),
        ),
        Picture(
            "flattening_models",
            "Load, contact area and mean pressure, compared with the models of Kogut and Etsion "
            "and of Jackson and Green, and with finite elements for ν = 0.32. Between the dashed "
            "lines at ω/ω_c = 2 and 30, the load agrees with both models to 7 %. P_c and A_c are "
            "the critical load and contact area, Y is the yield stress.",
            model_figure(results),
        ),
    ]


def zones(results: Results, ratios: tuple[float, ...], zoom: bool) -> Figure:
    figure = Figure(figsize=(8.5, 4.6) if zoom else (6.0, 4.6), layout="constrained")
    panels = figure.subplots(1, 2, width_ratios=(1, 1.15)) if zoom else [figure.subplots()]
    colours = colormaps["viridis"](np.linspace(0.0, 0.9, len(ratios)))
    for ax in panels:
        ax.grid(True, linewidth=0.4, alpha=0.5)
        for ratio, colour in zip(ratios, colours, strict=True):
            outline(ax, results.at(ratio), colour)
        ax.plot([], [], "kv", label="edge of the contact")
        ax.set_xlabel("$x / a_c$")
    x, z, g = results.at(ratios[-1]).outline
    panels[0].set_xlim(0, 1.12 * x[(g > 0).any(axis=1)].max())
    panels[0].set_ylim(1.08 * z[(g > 0).any(axis=0)].max(), 0)
    panels[0].set_aspect("equal")
    panels[0].set_ylabel("$z / a_c$")
    if zoom:
        surface(panels[1], results.surface[0].ratio)
    panels[-1].legend(frameon=False, fontsize=9, loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


def outline(ax: Axes, at: Point, colour: np.ndarray) -> None:
    x, z, g = at.outline
    # extended to the surface with the strain of the first layer
    z, g = np.append(0.0, z), np.column_stack([g[:, :1], g])
    ax.contour(x, z, g.T, levels=[1e-2], colors=[colour], linewidths=1.4)
    ax.plot([], [], color=colour, label=rf"$\omega/\omega_c$ = {at.ratio:g}")
    ax.plot(at.area**0.5, 0.0, "v", color=colour, clip_on=False, zorder=3)


def surface(ax: Axes, reached: float) -> None:
    """Draw the plastic zones near the surface, with values from the thesis."""
    ax.set_title("near the surface", fontsize=10)
    ax.set_xlim(0, 4.4)
    ax.set_ylim(1.0, 0)
    edge = reached**0.5 * 1.04
    ax.axvline(edge, color="k", linestyle="--", linewidth=0.8)
    text_style: dict[str, Any] = {"fontsize": 9, "transform": ax.transAxes}
    text = "elastic core above the lines;\nBoucly (2008): found at 2,\nshrinks above 6"
    ax.text(1.03, 1.0, text, va="top", **text_style)
    text = f"dashed: zone reaches the surface\nat {reached:.1f}; Boucly (2008): at 6"
    ax.text(1.03, 0.0, text, va="bottom", **text_style)


def strain_figure(results: Results) -> Figure:
    figure, ax = gridded()
    ratio = [p.ratio for p in results.points]
    strain = np.array([p.strain for p in results.points])
    ax.plot(ratio, strain, "o-", ms=3)
    at = results.at(28.0).strain
    ax.axvline(28, color="k", linestyle="--", linewidth=0.8)
    ax.axhline(at, color="k", linestyle="--", linewidth=0.8)
    ax.text(29, 0.2, "Boucly (2008): 28", rotation=90, va="bottom")
    ax.text(109, at - 0.15, "Boucly (2008): 5 %", ha="right", va="top")
    right = ax.secondary_yaxis(
        "right", functions=(lambda g: np.multiply(g, 5 / at), lambda p: np.multiply(p, at / 5))
    )
    right.set_ylabel(f"maximum plastic strain for Y/E = {5 / at:.2f} % [%]")
    ax.set_xlim(0, 112)
    ax.set_ylim(0, None)
    ax.set_xlabel(r"$\omega/\omega_c$")
    ax.set_ylabel("maximum equivalent plastic strain / (Y/E) [-]")
    return figure


def friction_figure(results: Results) -> Figure:
    figure, ax = gridded()
    ax.plot(
        [s.friction for s in results.surface],
        [s.ratio for s in results.surface],
        "o-",
        ms=4,
        label="simulation",
    )
    for value, label in (
        (6, "Boucly (2008), no friction: 6"),
        (1, "Boucly (2008), high friction: below 1"),
    ):
        ax.axhline(value, color="k", linestyle="--", linewidth=0.8)
        ax.text(0.5, value + 0.25 * (value < 2) + 0.06, label, ha="right", va="bottom")
    ax.set_xlim(-0.01, 0.51)
    ax.set_ylim(0, 6.6)
    ax.set_xlabel("friction coefficient μ")
    ax.set_ylabel(r"$\omega/\omega_c$ when the zone reaches the surface")
    ax.legend(frameon=False, loc="center right")
    return figure


def model_figure(results: Results) -> Figure:
    figure, panels = axes(1, 3, (9.0, 3.4))
    ratio = np.array([p.ratio for p in results.points])
    load, area = (np.array([getattr(p, k) for p in results.points]) for k in ("load", "area"))
    w = np.geomspace(1.0, 110.0, 300)
    unit = CRITICAL.load / (np.pi * CRITICAL.a**2) / YIELD
    curve = fem.load("2d").load_displacement
    rising = curve[1 : int(np.argmax(curve["approach_m"])) + 1]
    rising = rising[rising["approach_over_wc"] >= 1][::4]
    for ax in panels:
        ax.grid(True, linewidth=0.4, alpha=0.5)
        ax.set_xscale("log")
        ax.set_xlabel(r"$\omega/\omega_c$")
        for value in (2, 30):
            ax.axvline(value, color="k", linestyle="--", linewidth=0.8)
    for (name, model), style in zip(models().items(), ("C1-", "C2-"), strict=True):
        # loads over w^(5/4): the range of three decades would hide the differences
        relative = np.asarray(model.load) / CRITICAL.load
        area_ratio = np.asarray(model.area) / (np.pi * CRITICAL.a**2)
        panels[0].plot(w, relative / w**1.25, style, label=name)
        panels[1].plot(w, area_ratio / w, style)
        panels[2].plot(w, relative / area_ratio * unit, style)
    panels[0].plot(ratio, load / ratio**1.25, "C0o", ms=3, label="simulation")
    panels[0].plot(
        rising["approach_over_wc"], rising["load_over_Wc"] / rising["approach_over_wc"] ** 1.25,
        "k+", ms=5, label="finite elements",
    )  # fmt: skip
    panels[1].plot(ratio, area / ratio, "C0o", ms=3)
    panels[2].plot(ratio, load / area * unit, "C0o", ms=3)
    for ax, label in zip(
        panels,
        (
            r"load / $[P_c\,(\omega/\omega_c)^{1.25}]$",
            r"area / $[A_c\,(\omega/\omega_c)]$",
            "mean pressure / Y",
        ),
        strict=True,
    ):  # fmt: skip
        ax.set_ylabel(label)
    panels[0].legend(fontsize=8, framealpha=1.0, edgecolor="none")
    return figure
