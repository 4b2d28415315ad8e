# SPDX-License-Identifier: GPL-3.0-or-later
"""Two elastic-plastic asperities that slide past each other: Boucly (2008), part 4."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.figure import Figure

import samcontact as sc
from samcontact import asperities
from samcontact.asperities import Collision, CollisionResult
from samcontact.plotting import asperities as asperity_figures

from .bodies import tolerance
from .limits import first_order
from .page import Picture
from .profiles import each, grows
from .stated import Number, Stated, Statement

STATED = Stated("asperities")
TITLE = "Collision of two asperities"
INTRODUCTION = """
This page shows the forces, energy and imprints of two colliding asperities (called tugging in the
thesis), and compares the results with part 4 of Boucly's thesis (2008). Two perfectly plastic
spheres with a radius of 1 m and a yield stress of 0.9115 GPa pass each other at constant height,
without friction or rotation. Forces, energy U and interference ω are divided by their critical
values (U_c, ω_c and so on), i.e. by their values at the onset of yield (Green 2005). X is the
offset of the sphere centres, negative before the centres are aligned, and R = 0.5 m is the
equivalent radius. The load ratio is the tangential force divided by the normal force. A positive
tangential force resists the motion. The figures show the forces in the first pass, as in the
thesis. The kinematics are derived independently of the thesis, because equations (4.2), (4.13) and
(4.15) of the thesis contain errors
([theory](../theory/moving_contacts.md#collision-of-two-asperities)).
"""

STEEL = sc.Material.perfect_plastic(200e9, 0.32, 0.9115e9)
ELASTIC = sc.Material.elastic(200e9, 0.32)
CRITICAL = sc.critical.green(0.5, sc.hertz.effective_modulus(STEEL, STEEL), 0.32, 0.9115e9)


@dataclass
class Results:
    runs: dict[float, CollisionResult]
    """Results by ratio of the interference to the critical interference."""
    elastic: CollisionResult
    again: CollisionResult
    """Result of three passes."""
    energies: dict[int, float]
    """Net energy over the critical energy at 9 critical interferences, by number of increments."""
    mesh: str


def compute(quick: bool) -> Results:
    relative = (1.0, 1.15, 3.0, 9.0) if quick else (1.0, 1.15, 3.0, 5.0, 7.0, 9.0, 11.0, 13.0, 15.0)
    increments, counts = (20, (10, 14, 20)) if quick else (36, (24, 36, 48))

    def run(
        ratio: float, material: sc.Material, passes: int = 1, count: int = increments
    ) -> CollisionResult:
        which = Collision(1.0, 1.0, ratio * CRITICAL.interference)
        grid = which.grid(count, depth=1.7)
        # `collide` sets a small tolerance for elastic spheres, whose net energy is zero
        settings: dict[str, Any] = {"tol": tolerance(quick)} if material.is_plastic else {}
        return asperities.collide(
            which, material, material, grid, passes=passes, progress=False, **settings
        )

    runs = {ratio: run(ratio, STEEL) for ratio in relative}
    again = run(relative[-1], STEEL, 3, counts[1])
    known = {increments: runs[9.0]} | ({counts[1]: again} if quick else {})
    grid = runs[9.0].simulation.grid
    mesh = f"{grid.nx} x {grid.ny} x {grid.nz}, {increments} increments"
    energies = {}
    for count in counts:
        found = known[count] if count in known else run(9.0, STEEL, count=count)
        energies[count] = float(found.series.net_energy[0]) / CRITICAL.energy
    elastic = run(relative[-1], ELASTIC, count=counts[1])
    return Results(runs, elastic, again, energies, mesh)


def stated(results: Results) -> list[Number | Statement]:
    return [*critical_values(results), *forces(results), *ratios(results), *energies(results)]


def critical_values(results: Results) -> list[Number | Statement]:
    return [
        STATED.number("critical interference", CRITICAL.interference),
        STATED.number("critical load", CRITICAL.load),
        STATED.number("critical energy", CRITICAL.energy),
    ]


def curve(result: CollisionResult, name: str) -> tuple[np.ndarray, np.ndarray]:
    """Return the offset of the centres and one force component in the first pass."""
    series = result.series.isel({"pass": 0})
    return series["offset"].values, series[name].values


def asymmetry(result: CollisionResult, name: str, sign: float) -> float:
    """Return the maximum deviation of a curve from symmetry, relative to the maximum of the curve.

    sign: 1 for the deviation from an even curve, -1 for the deviation from an odd curve.
    """
    x, f = curve(result, name)
    return float(np.abs(f - sign * np.interp(-x, x, f)).max() / np.abs(f).max())


def forces(results: Results) -> list[Number | Statement]:
    runs, mesh = results.runs, results.mesh
    name = "ω/ωc = " + each(list(runs))
    odd = [asymmetry(run, "force_x", -1.0) for run in runs.values()]
    even = [asymmetry(run, "force_z", 1.0) for run in runs.values()]
    aligned = [float(np.interp(0.0, *curve(run, "force_x"))) for run in runs.values()]
    of_peak = [
        f / curve(r, "force_x")[1].max() for f, r in zip(aligned, runs.values(), strict=True)
    ]
    last = list(runs.values())[-1]
    x, f = curve(last, "force_x")
    before, after = (float(np.trapezoid(np.where(part, f, 0.0), x)) for part in (x < 0, x > 0))
    say = STATED.on(mesh, which=name)
    return [
        say.trend(
            "tangential force",
            max(odd[:2]) < 0.01 and odd[-1] > 0.5 and grows(odd),
            [100 * value for value in odd],
        ),
        say.trend(
            "normal force",
            max(even[:2]) < 0.01
            and all(e < o for e, o in zip(even, odd, strict=True))
            and grows(even[1:]),
            [100 * value for value in even],
        ),
        say.trend(
            "tangential force aligned",
            abs(of_peak[0]) < 0.005 and of_peak[-1] > 0.2 and grows(of_peak),
            [100 * value for value in of_peak],
        ),
        say.trend(
            "work", 0 < -after < 0.5 * before, before / CRITICAL.energy, after / CRITICAL.energy
        ),
        say.trend(
            "elastic spheres",
            abs(float(results.elastic.series.net_energy[0])) < 1e-6 * CRITICAL.energy,
            float(results.elastic.series.net_energy[0]) / CRITICAL.energy,
        ),
    ]


def at_exit(result: CollisionResult) -> float:
    """Return the load ratio at the end of contact, by a parabola through the last 4 values."""
    series = result.series.isel({"pass": 0})
    touching = np.flatnonzero(series["normal_force"].values > 0)[-4:]
    end = result.collision.half_distance
    x, ratio = (series[name].values[touching] for name in ("offset", "load_ratio"))
    return float(np.polyval(np.polyfit(x / end - 1.0, ratio, 2), 0.0))


def ratios(results: Results) -> list[Number | Statement]:
    runs, mesh = results.runs, results.mesh
    name = "ω/ωc = " + each(list(runs))
    high = [at_exit(run) for ratio, run in runs.items() if ratio >= 9]
    entry = [float(np.nanmax(curve(run, "load_ratio")[1])) for run in runs.values()]
    aligned = []
    for run in runs.values():
        x, ratio = curve(run, "load_ratio")
        touching = np.isfinite(ratio)
        aligned.append(float(np.interp(0.0, x[touching], ratio[touching])))
    say = STATED.on(mesh, which=name)
    return [
        say.trend(
            "load ratio end",
            all(-0.055 < value < -0.03 for value in high),
            high,
            ratios=[ratio for ratio in runs if ratio >= 9],
        ),
        say.trend("largest load ratio", grows(entry), entry),
        say.trend("load ratio aligned", grows(aligned) and aligned[-1] > 3e-3, aligned),
    ]


def energies(results: Results) -> list[Number | Statement]:
    runs, mesh = results.runs, results.mesh
    name = "ω/ωc = " + each(list(runs))
    net = [float(run.series.net_energy[0]) / CRITICAL.energy for run in runs.values()]
    missing = [
        abs(float(run.series.energy_imbalance[0] / run.series.net_energy[0]))
        for ratio, run in runs.items()
        if ratio >= 3
    ]
    deepest = [float(run.series.residual_displacement[0].max()) for run in runs.values()]
    share = [d / r.collision.interference for d, r in zip(deepest, runs.values(), strict=True)]
    limit = first_order(list(results.energies), list(results.energies.values()), "increments")
    again = results.again.series.net_energy.values / results.again.series.net_energy.values[0]
    say = STATED.on(mesh, which=name)
    return [
        say.trend("net energy", grows(net), net),
        say.trend(
            "net energy limit",
            limit.error < 0.03 * limit.value and abs(limit.value / 189.5 - 1) < 0.03,
            limit.value,
            limit.error,
            limit=limit.text,
        ),
        say.trend("energy balance", max(missing) < 0.03, 100 * max(missing)),
        say.trend(
            "residual displacement",
            grows(share) and 0.22 < share[list(runs).index(9.0)] < 0.27,
            [100 * s for s in share],
        ),
        say.trend("three passes", 0.2 > again[1] > again[2], again),
    ]


def figures(results: Results) -> list[Picture]:
    shown = [run.series for ratio, run in results.runs.items() if ratio != 1.15]
    pictures = []
    for name, draw, caption in (
        ("x", asperity_figures.force, "Figure 4.7: tangential force."),
        ("z", asperity_figures.force, "Figure 4.8: normal force."),
        ("energy", asperity_figures.net_energy, "Figure 4.9: net energy of a pass."),
        ("ratio", asperity_figures.load_ratio, "Figure 4.10: load ratio. Dotted: thesis, 0.045."),
        ("imprint", asperity_figures.residual_displacement, "Figure 4.11: maximum imprint depth."),
    ):
        figure = Figure(figsize=(6.2, 4.2), layout="constrained")
        options = {"component": name} if draw is asperity_figures.force else {}
        ax = draw(shown, figure.subplots(), critical=CRITICAL, **options)
        if name == "ratio":
            ax.axhline(-0.045, color="k", linestyle=":", linewidth=1)
        pictures.append(Picture(f"asperities_{name}", caption, figure))
    return pictures
