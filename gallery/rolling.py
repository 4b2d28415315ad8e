# SPDX-License-Identifier: GPL-3.0-or-later
"""A ceramic ball rolling over a steel flat: Boucly (2008), sections 3.2.1.1 and 3.2.1.2."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import samcontact as sc

from .bodies import CERAMIC, STEEL_52100, STEEL_M50, tolerance
from .drawing import axes, finish
from .limits import first_order
from .page import Picture
from .profiles import succession
from .stated import Number, Stated, Statement
from .track import BALL, RADIUS, Cycle, Mesh, Run, ellipse, roll

STATED = Stated("rolling")
TITLE = "Rolling and repeated passes"
INTRODUCTION = """
This page shows the track and the residual stress of a rolling ball, and compares the results with
sections 3.2.1.1 and 3.2.1.2 of Boucly's thesis (2008). A ceramic ball of 9.525 mm diameter rolls
over a steel flat without friction. In the first part, a load of 460 N acts on steel M50 or 52100,
as in a thrust bearing. The thesis gives no numbers for the profiles measured in this part (figures
3.8, 3.9 and 3.12), so only computed profiles are shown. Figures 3.6 and 3.7 of the thesis show the
bearing. In the second part, the flat is of steel 52100 and the Hertz pressure is p0 = 5.7 GPa. Each
cycle consists of loading, rolling to the right, unloading, and returning unloaded. a is the Hertz
contact radius at 5.7 GPa. Section 3.2.1.1 of the thesis gives the moduli as 310 and 210 MPa; 310
GPa (ceramic) and 210 GPa (steel) are used here. Sections across the track are taken at 60 % of the
rolling distance. Tensile stress is positive.
"""

BEARING_LOAD = 460.0
BODIES = (CERAMIC, STEEL_52100)


@dataclass
class Results:
    bearing: dict[str, Run]
    rolled: Run
    """Result of two rolling cycles of 4 mm."""
    repeated: Run
    """Result of three rolling cycles of 2 mm."""
    strains: dict[float, float]
    """Largest plastic strain after two cycles of 2 mm [-], by cells (and steps) per radius."""
    mesh: str
    bearing_mesh: str


def compute(quick: bool) -> Results:
    fine = BALL.a / 25e-6
    tol = tolerance(quick)
    mesh = Mesh(6, 8, tol=tol) if quick else Mesh(fine, fine)
    coarse = Mesh(6, 8, tol=tol) if quick else Mesh(12, 12)
    distance = 5 if quick else 8
    contact = sc.hertz.elliptic(RADIUS, RADIUS, BALL.E_star, load=BEARING_LOAD)
    bearing = {
        name: roll((CERAMIC, steel), contact, coarse, distance * contact.a_x)
        for name, steel in (("52100", STEEL_52100), ("M50", STEEL_M50))
    }
    strains = {}
    for cells in (4.0, 5.0, 7.0) if quick else (8.0, fine, 16.0):
        run = roll(
            BODIES, ellipse(1), Mesh(cells, cells, tol=tol), 1.4e-3 if quick else 2e-3, cycles=2
        )
        strains[cells] = run.cycles[1].peak("gamma")[0]
    repeated = roll(BODIES, ellipse(1), mesh, 2.1e-3 if quick else 2e-3, cycles=3)
    return Results(
        bearing,
        repeated if quick else roll(BODIES, ellipse(1), mesh, 4e-3, cycles=2),
        repeated,
        strains,
        str(mesh),
        str(coarse),
    )


def stated(results: Results) -> list[Number | Statement]:
    return [*stated_bearing(results), *stated_imprint(results), *stated_stress(results)]


def stated_bearing(results: Results) -> list[Number | Statement]:
    soft, hard = (results.bearing[name].steady for name in ("52100", "M50"))
    p0 = results.bearing["M50"].p0
    return [
        STATED.number("pressure at 460 N", p0 * 1e-9),
        STATED.trend(
            "imprints at 460 N",
            0 < hard.depth < soft.depth and hard.width() < soft.width(),
            soft.depth * 1e9,
            hard.depth * 1e9,
            soft.width() * 1e6,
            hard.width() * 1e6,
            mesh=results.bearing_mesh,
        ),
    ]


def stated_imprint(results: Results) -> list[Number | Statement]:
    return [*stated_depth(results), *stated_shoulders(results), *stated_cycles(results)]


def stated_depth(results: Results) -> list[Number | Statement]:
    mesh, a, run = results.mesh, BALL.a, results.rolled
    first, pressed = run.cycles[0], run.vertical
    deepest, pressed_depth = float(first.along.max()), float(pressed.along.max())
    inside = (first.x > 4 * a) & (first.x < run.distance - 2 * a)
    change = float(np.ptp(first.along[inside])) / first.depth
    say = STATED.on(mesh)
    return [
        say.number("contact radius", a * 1e6),
        say.number("load", BALL.load),
        say.trend(
            "rolled and pressed",
            deepest > 1.1 * pressed_depth,
            deepest * 1e6,
            pressed_depth * 1e6,
        ),
        say.trend(
            "depth along the track",
            first.depth < 0.85 * deepest and change < 0.03,
            deepest * 1e6,
            first.x[first.along.argmax()] / a,
            first.depth * 1e6,
            first.steady / a,
            100 * change,
        ),
    ]


def stated_shoulders(results: Results) -> list[Number | Statement]:
    mesh, first = results.mesh, results.rolled.cycles[0]
    before, beyond, side = (1e9 * height for height in first.shoulders())
    say = STATED.on(mesh)
    return [
        say.trend("end shoulders", beyond > 1.5 * before, beyond, before),
        say.trend("side shoulders", 0.75 * side < beyond < side, beyond, side),
    ]


def stated_cycles(results: Results) -> list[Number | Statement]:
    mesh, run = results.mesh, results.rolled
    depths = [cycle.depth for cycle in results.repeated.cycles]
    growth = np.diff(depths) / depths[-1]
    counters = run.counters
    say = STATED.on(mesh)
    return [
        say.trend(
            "imprint by cycles",
            0 < growth[1] < 0.5 * growth[0] and growth[1] < 0.015,
            [depth * 1e6 for depth in depths],
        ),
        say.trend(
            "work",
            counters["halvings"] == 0 and counters["plastic_iterations"] < 15 * run.increments,
            run.increments,
            counters["plastic_iterations"],
            counters["contact_iterations"],
            counters["halvings"],
            distance=run.distance * 1e3,
        ),
    ]


def surface_peak(y: np.ndarray, values: np.ndarray) -> float:
    """Return the y position of the maximum stress in the first layer of cells [m]."""
    return abs(float(y[int(values[:, 0].argmax())]))


def stated_stress(results: Results) -> list[Number | Statement]:
    return [*stated_largest(results), *stated_residual(results)]


def stated_largest(results: Results) -> list[Number | Statement]:
    mesh, a = results.mesh, BALL.a
    second = results.rolled.cycles[1]
    gamma, gamma_depth = second.peak("gamma")
    stress = second.peak("von_mises")[0]
    loaded, elastic = float(results.rolled.loaded.max()), BALL.max_von_mises(0.3)[0]
    percent = [100 * strain for strain in results.strains.values()]
    limit = first_order(list(results.strains), percent, "cells and steps per radius")
    say = STATED.on(mesh)
    return [
        say.trend("stress under load", loaded < 0.9 * elastic, loaded * 1e-9, elastic * 1e-9),
        say.number(
            "largest plastic strain",
            limit.value,
            error=limit.error,
            made_of=limit.text,
            gamma=100 * gamma,
        ),
        say.number("strain depth", gamma_depth / a),
        say.number("residual stress", stress * 1e-6),
    ]


def stated_residual(results: Results) -> list[Number | Statement]:
    mesh, a = results.mesh, BALL.a
    first, second = results.rolled.cycles[:2]
    stress, depth = second.peak("von_mises")
    band = surface_peak(second.y, second.von_mises_across)
    tension = surface_peak(second.y, second.hydrostatic_across)
    half_width, middle = 0.5 * second.width(), len(second.y) // 2
    surface = second.hydrostatic_across[:, 0] * 1e-6
    signs = ", ".join(succession(second.profile("hydrostatic"), 2e-3 * BALL.p0))
    expected = "tensile, compressive, tensile"
    again = np.abs(second.von_mises_across - first.von_mises_across).max()
    say = STATED.on(mesh)
    return [
        say.trend(
            "residual bands",
            0.4 < depth / a < 0.6
            and 0.4 * a < band < half_width
            and second.von_mises_across[:, 0].max() > 2 * second.von_mises_across[middle, 0],
            stress * 1e-6,
            depth / a,
            second.von_mises_across[:, 0].max() * 1e-6,
            band / a,
            second.von_mises_across[middle, 0] * 1e-6,
            half_width=half_width / a,
        ),
        say.trend("hydrostatic below", signs == expected, signs, thesis=expected),
        say.trend(
            "hydrostatic at surface",
            tension > 0.3 * a and 0 < surface[middle] < 0.8 * surface.max(),
            surface.max(),
            tension / a,
            surface[middle],
        ),
        say.trend("residual by cycles", float(again) < 0.1 * stress, again * 1e-6),
    ]


def figures(results: Results) -> list[Picture]:
    return [bearing(results), imprints(results), across(results), along(results)]


def bearing(results: Results) -> Picture:
    figure, (left, right) = axes(1, 2, (9.0, 3.4), sharey=True)
    for k, (name, run) in enumerate(results.bearing.items()):
        last = run.steady
        left.plot(last.y * 1e6, -last.across * 1e6, color=f"C{k}", label=name)
        right.plot(last.x * 1e6, -last.along * 1e6, color=f"C{k}", label=name)
    finish(left, "across the track y [µm]", "height of the surface [µm]")
    finish(right, "rolling direction x [µm]")
    return Picture(
        "rolling_bearing",
        "Figures 3.8 and 3.9: imprints across and along the track, 460 N (computed profiles only).",
        figure,
    )


def imprints(results: Results) -> Picture:
    a, run = BALL.a, results.rolled
    figure, (upper, lower) = axes(2, 1, (9.0, 6.4))
    shown = run.vertical
    upper.plot(shown.x / a, -1e3 * shown.along / a, "ks", markersize=3, markerfacecolor="none",
               label="pressed and unloaded")  # fmt: skip
    upper.plot(run.cycles[0].x / a, -1e3 * run.cycles[0].along / a, color="C0", label="rolled")
    upper.set_xlim(-3, run.distance / a + 3)
    finish(upper, "rolling direction x/a", "height of the surface [a/1000]")
    left, right = lower.get_subplotspec().subgridspec(1, 2).subplots(sharey=True)
    lower.remove()
    for n, cycle in enumerate(results.repeated.cycles):
        label = f"{n + 1} cycle{'s' if n else ''}"
        left.plot(cycle.x / a, -1e3 * cycle.along / a, color=f"C{n}", label=label)
        right.plot(cycle.y / a, -1e3 * cycle.across / a, color=f"C{n}", label=label)
    finish(left, "rolling direction x/a", "height of the surface [a/1000]")
    finish(right, "across the track y/a")
    return Picture(
        "rolling_imprints",
        "Figures 3.10 to 3.12. Top: imprint of a ball that is only pressed, and of a ball that "
        f"rolls to the right once by {run.distance * 1e3:.2g} mm. Bottom: imprints after one to "
        "three cycles of 2 mm, along and across the track (figure 3.12: computed profiles only).",
        figure,
    )


def contours(
    ax: Axes, x: np.ndarray, z: np.ndarray, values: np.ndarray, title: str, colours: str
) -> None:
    figure = ax.get_figure()
    assert figure is not None
    shown = ax.contourf(x / BALL.a, z / BALL.a, values.T, levels=12, cmap=colours)
    figure.colorbar(shown, ax=ax, shrink=0.9, aspect=12)
    ax.set(ylim=(2.0, 0.0), ylabel="depth z/a")
    ax.set_title(title, fontsize="medium")


def across(results: Results) -> Picture:
    run: Run = results.rolled
    last: Cycle = run.steady
    figure = Figure(figsize=(10.0, 2.6), layout="constrained")
    fields = (
        ("von Mises stress under load / p0", run.loaded, "viridis"),
        ("residual von Mises stress / p0", last.von_mises_across, "viridis"),
        ("residual hydrostatic stress / p0", last.hydrostatic_across, "coolwarm"),
    )
    for ax, (title, values, colours) in zip(figure.subplots(1, 3), fields, strict=True):
        contours(ax, last.y, last.z, values / BALL.p0, title, colours)
        ax.set(xlabel="y/a", xlim=(-1.6, 1.6))
    return Picture(
        "rolling_across",
        "Figures 3.13, 3.14 and 3.16: sections across the track in the second cycle.",
        figure,
    )


def along(results: Results) -> Picture:
    run = results.rolled
    last = run.steady
    figure = Figure(figsize=(9.0, 4.6), layout="constrained")
    fields = (
        ("residual von Mises stress / p0", last.von_mises / BALL.p0),
        ("equivalent plastic strain [%]", 100 * last.gamma),
    )
    for ax, (title, values) in zip(figure.subplots(2, 1), fields, strict=True):
        contours(ax, last.x, last.z, values, title, "viridis")
        ax.set(xlabel="rolling direction x/a", xlim=(-2, run.distance / BALL.a + 2))
    return Picture(
        "rolling_along",
        "Figures 3.15 and 3.17: plane y = 0 after the second cycle, rolled to the right.",
        figure,
    )
