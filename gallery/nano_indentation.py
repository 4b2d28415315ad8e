# SPDX-License-Identifier: GPL-3.0-or-later
"""Nano-indentation of nitrided steel: figures 2.9, 2.14 and 2.15 of Boucly (2008)."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure

import samcontact as sc

from .bodies import RIGID
from .drawing import gridded
from .page import Picture
from .stated import Number, Stated, Statement

STATED = Stated("nano_indentation")
TITLE = "Nano-indentation"
INTRODUCTION = """
This page compares a computed nano-indentation with sections 2.3.1.1 and 2.3.1.3 of Boucly's thesis
(2008). A rigid spherical tip of radius 105 µm is pressed onto nitrided steel with 0.650 N and
unloaded. The steel has E = 210 GPa, ν = 0.3 and Swift hardening with B = 1240 MPa, C = 30 and n =
0.085. The thesis gives a Young's modulus of 210 MPa, but the elastic approach stated in the thesis
requires 210 GPa. The indentation is computed twice: with prescribed load and with prescribed
rigid-body approach, which the thesis calls interference. The thesis gives the measured imprints of
figure 2.9 neither in a table nor in the text, so they are not shown here.
"""

TIP = 105e-6
LOAD = 0.650
STEEL = sc.Material.swift(E=210e9, nu=0.3, B=1240e6, C=30.0, n=0.085)
MESH = 31, 17, 44
"""Mesh of the thesis: cells along x, y and z."""
SHOWN = 4
"""Number of loads in the figure of the pressure."""


@dataclass(frozen=True)
class Results:
    """States of two runs (prescribed load, prescribed approach); each run loads and unloads."""

    grid: sc.Grid
    by_load: list[sc.State]
    by_approach: list[sc.State]

    @property
    def top(self) -> int:
        """Index of the state at the largest load."""
        return len(self.by_load) // 2 - 1

    @property
    def mesh(self) -> str:
        n = self.grid
        return f"{n.nx}x{n.ny}x{n.nz}, {len(self.by_load)} increments"


def hertz(load: float) -> sc.hertz.PointContact:
    """Return the Hertz contact of the spherical tip and the steel."""
    E_star = sc.hertz.effective_modulus(RIGID, STEEL)
    return sc.hertz.point(R=TIP, E_star=E_star, load=load)


def compute(quick: bool) -> Results:
    """Solve both runs, on the mesh of the thesis if quick, else with half-size cells and steps."""
    finer = 1 if quick else 2
    # odd numbers of cells along x and y, so that one cell centre lies on the axis
    nx, ny = ((n - 1) * finer + 1 for n in MESH[:2])
    grid = sc.Grid(nx, ny, 0.6e-6 / finer, 1.2e-6 / finer, MESH[2] * finer, 0.3e-6 / finer)
    gap = sc.surfaces.paraboloid(grid, TIP)
    count = 13 * finer
    by_load = sc.Simulation(grid, RIGID, STEEL, gap)
    loaded = by_load.run(sc.paths.load_unload(load=LOAD, increments=count), progress=False)
    by_approach = sc.Simulation(grid, RIGID, STEEL, gap)
    # unload to the separation of the bodies, as in the load-controlled run
    path = sc.paths.load_unload(
        approach=loaded[count - 1].approach, end=loaded[-1].approach, increments=count
    )
    return Results(grid, loaded, by_approach.run(path, progress=False))


def curve(states: list[sc.State]) -> tuple[np.ndarray, np.ndarray]:
    """Return approach [m] and load [N] of each state."""
    return np.array([s.approach for s in states]), np.array([s.load for s in states])


def control_difference(results: Results) -> float:
    """Return the maximum difference of the two loads at equal approach, over the maximum load."""
    split = results.top + 1
    found = []
    for part in (slice(0, split), slice(split - 1, None)):
        w, load = curve(results.by_load[part])
        w_other, other = curve(results.by_approach[part])
        if part.start == 0:
            w, load = np.append(0.0, w), np.append(0.0, load)
        # on both branches the load is about a power 3/2 of the distance from first touch
        start = w.min()
        order = np.argsort(w)
        at = np.interp((w_other - start) ** 1.5, (w[order] - start) ** 1.5, load[order])
        found.append(np.abs(at - other).max())
    return float(max(found) / LOAD)


def imprints(states: list[sc.State]) -> np.ndarray:
    """Return the residual imprint depth at the centre [m] after unloading from each load.

    Unloading is elastic, so the depth follows from the plastic strain under load.
    """
    return np.array([s.residual_displacement().max() for s in states])


def stated(results: Results) -> list[Number | Statement]:
    """Return the values that the thesis states, each with the computed value."""
    grid, top = results.grid, results.by_load[results.top]
    elastic = hertz(LOAD)
    difference = control_difference(results)
    radius = float(np.sqrt(top.contact_area / np.pi))
    flattened = top.pressure.max() < elastic.p0 and radius > elastic.a
    say = STATED.on(results.mesh)
    return [
        say.number("largest interference", top.approach * 1e9),
        say.number("elastic interference", elastic.approach * 1e9),
        say.trend("control", difference < 0.01, 100 * difference),
        say.trend(
            "pressure",
            bool(flattened),
            top.pressure.max() * 1e-9,
            elastic.p0 * 1e-9,
            radius * 1e6,
            elastic.a * 1e6,
        ),
        say.number(
            "cells",
            float(math.prod(MESH)),
            mesh=f"here {results.grid.nx}x{grid.ny}x{grid.nz}",
        ),
    ]


def figures(results: Results) -> list[Picture]:
    """Draw figures 2.9, 2.14 and 2.15."""
    return [
        Picture(
            "nano_imprint",
            "Figure 2.9: residual imprint depth at the centre versus maximum load.",
            imprint_figure(results),
        ),
        Picture(
            "nano_load_interference",
            "Figure 2.14: load versus rigid-body approach during loading and unloading, with "
            "prescribed load and with prescribed approach. Dashed: approach at 0.650 N in the "
            "thesis, 372 nm, and 349 nm for elastic steel.",
            load_figure(results),
        ),
        Picture(
            "nano_pressure",
            "Figure 2.15: pressure along x in the plane y = 0 for increasing loads up to 0.650 N, "
            "and the Hertz pressure (dashed). According to the thesis, the pressure is flatter "
            "than the Hertz pressure, and equal for prescribed load and prescribed approach.",
            pressure_figure(results),
        ),
    ]


def imprint_figure(results: Results) -> Figure:
    figure, ax = gridded()
    loading = results.by_load[: results.top + 1]
    _, load = curve(loading)
    ax.plot(
        np.append(0, load) * 1e3,
        np.append(0, imprints(loading)) * 1e9,
        "o-",
        ms=3,
        label="simulation",
    )
    last = results.by_load[-1].residual_displacement().max()
    ax.plot(LOAD * 1e3, last * 1e9, "ks", mfc="none", label="after unloading")
    ax.axvline(LOAD * 1e3, color="k", linestyle="--", linewidth=0.8)
    label = "Boucly (2008): maximum load, 650 mN"
    ax.text(LOAD * 1e3 - 8, 1, label, rotation=90, ha="right", va="bottom")
    ax.set_xlabel("load [mN]")
    ax.set_ylabel("residual imprint depth [nm]")
    ax.set_ylim(bottom=0)
    ax.legend(frameon=False)
    return figure


def load_figure(results: Results) -> Figure:
    figure, ax = gridded()
    w, load = (np.append(0.0, values) for values in curve(results.by_load))
    ax.plot(w * 1e9, load * 1e3, "-", label="prescribed load")
    w, load = curve(results.by_approach)
    ax.plot(w * 1e9, load * 1e3, "o", ms=4, mfc="none", label="prescribed approach")
    elastic = np.linspace(0, LOAD, 60)
    hertzian = [0.0, *(hertz(value).approach for value in elastic[1:])]
    ax.plot(np.multiply(hertzian, 1e9), elastic * 1e3, "k-", linewidth=0.8, label="elastic (Hertz)")
    for value, label in ((349, "Boucly (2008), elastic: 349 nm"), (372, "Boucly (2008): 372 nm")):
        ax.axvline(value, color="k", linestyle="--", linewidth=0.8)
        ax.text(value - 2, 8, label, rotation=90, ha="right", va="bottom")
    ax.set_xlabel("rigid-body approach [nm]")
    ax.set_ylabel("load [mN]")
    ax.legend(frameon=False, loc="upper left")
    return figure


def pressure_figure(results: Results) -> Figure:
    figure, ax = gridded()
    x, row = results.grid.x * 1e6, results.grid.ny // 2
    fine = np.linspace(x[0], x[-1], 400)
    count = results.top + 1
    for k in range(SHOWN):
        state = results.by_load[round(count * (k + 1) / SHOWN) - 1]
        elastic = hertz(state.load)
        label = f"{state.load * 1e3:.0f} mN"
        (line,) = ax.plot(x, state.pressure[:, row] * 1e-9, "-", label=label)
        ax.plot(
            fine, elastic.pressure(fine * 1e-6, 0.0) * 1e-9, "--", lw=0.9, color=line.get_color()
        )
    top = results.by_approach[results.top]
    ax.plot(
        x, top.pressure[:, row] * 1e-9, "o", ms=4, mfc="none", color=line.get_color(),
        label=f"prescribed approach, {top.approach * 1e9:.0f} nm",
    )  # fmt: skip
    ax.plot([], [], "k--", lw=0.9, label="Hertz, equal load")
    ax.set_xlabel("x [µm]")
    ax.set_ylabel("pressure [GPa]")
    ax.set_xlim(-9.5, 9.5)
    ax.set_ylim(0, 10.5)
    ax.legend(frameon=False, ncols=3, fontsize=8, loc="upper center")
    return figure
