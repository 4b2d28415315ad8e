# SPDX-License-Identifier: GPL-3.0-or-later
"""Running-in of a rough surface: Boucly (2008), section 5.2.2, figures 5.12 to 5.15."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

import samcontact as sc
from samcontact.plotting import wear

from .bodies import ELASTIC, tolerance
from .drawing import axes, finish
from .page import Picture
from .stated import Number, Stated, Statement
from .wear import E_STAR, FRICTION, RADIUS, STEEL, THRESHOLD
from .wear import HERTZ as SMOOTH

STATED = Stated("running_in")
TITLE = "Running-in of a rough surface"
INTRODUCTION = """
This page shows the running-in of a rough surface, and compares the results with section 5.2.2 of
Boucly's thesis (2008). The balls and the steel are the same as on the page [wear of a flat
surface](wear.md); the load is 30 N. One surface has the roughness A sin(2πx/λ) sin(2πy/λ) with A =
0.5 µm and λ = 50 µm. The friction coefficient is 0.4, and surface material is removed if its
plastic strain exceeds 0.2 %. Body 2 is rough, elastic-plastic and wears; body 1 is smooth and
elastic. The thesis does not state the width of the filter that smooths the border of the worn
region. Here the filter is a Gaussian that is equivalent to a moving average over half a wavelength.
With this filter the results converge as cells, layers and increments become smaller. With the
filter of the thesis, a polynomial over a fixed number of cells, the results do not converge
([convergence](../wear_convergence.md)). Sections are taken through the crests next to the centre,
at y = 12.5 µm.
"""

LOAD, AMPLITUDE, WAVELENGTH = 30.0, 0.5e-6, 50e-6
SMOOTHING = 0.5 * WAVELENGTH / 12**0.5
CREST = 0.25 * WAVELENGTH
STATED_CYCLES = 7


@dataclass
class Results:
    wear: sc.wear.WearResult
    mesh: str


def compute(quick: bool) -> Results:
    cells, dz, depth = (117, 1e-6, 15e-6) if quick else (135, 0.5e-6, 25e-6)
    grid = sc.Grid(cells, cells, 2.5e-6, 2.5e-6, round(depth / dz), dz)
    found = sc.wear.run(
        grid,
        ELASTIC,
        STEEL,
        sc.surfaces.paraboloid(grid, RADIUS),
        cycle=sc.paths.load_unload(load=LOAD, increments=1 if quick else 4, unload_increments=1),
        threshold=THRESHOLD,
        cycles=30,
        smoothing_length=SMOOTHING,
        friction=FRICTION,
        relief2=sc.Relief(sc.surfaces.sinusoidal(grid, AMPLITUDE, WAVELENGTH, WAVELENGTH)),
        progress=False,
        tol=tolerance(quick),
    )
    return Results(found, f"cells 2.5 µm, layers {dz * 1e6:g} µm")


def stated(results: Results) -> list[Number | Statement]:
    return [*stated_begin(results), *stated_cycles(results), *stated_end(results)]


def stated_begin(results: Results) -> list[Statement]:
    first = results.wear.cycles[0]
    micro = float(STEEL.yield_stress(20e-6))
    critical = sc.critical.onset_sliding(RADIUS, E_STAR, 0.3, micro, FRICTION)
    return [
        STATED.trend("smooth surfaces", critical.load > LOAD, critical.load),
        STATED.trend(
            "first pressure",
            0.7 < first.max_pressure / SMOOTH.p0 < 1.4,
            first.max_pressure * 1e-9,
            SMOOTH.p0 * 1e-9,
            mesh=results.mesh,
        ),
    ]


def stated_cycles(results: Results) -> list[Statement]:
    found, mesh = results.wear, results.mesh
    worn = len(found.cycles) - 1
    share = found.rate[:2].sum() / found.rate.sum()
    say = STATED.on(mesh)
    return [
        say.trend("running", found.stopped, worn + 1),
        say.trend("cycles", 2 <= worn <= STATED_CYCLES, worn, stated_cycles=STATED_CYCLES),
        say.trend("first cycles", share > 0.99, 100 * share),
    ]


def stated_end(results: Results) -> list[Statement]:
    found, mesh = results.wear, results.mesh
    first, last = found.cycles[0], found.cycles[-1]
    conserved = max(abs(c.lost_volume[0] / c.volume[0] - 1) for c in found.cycles[:-1])
    x, y = found.x(), found.grid.y
    middle = np.hypot(x[:, None], y[None, :]) < 75e-6
    before, after = (float(found.profile(n)[middle].std()) for n in (0, -1))
    say = STATED.on(mesh)
    return [
        say.trend("roughness", after < 0.8 * before, 1e6 * before, 1e6 * after),
        say.trend(
            "plastic strain", last.surface_strain[0] <= THRESHOLD, 100 * last.surface_strain[0]
        ),
        say.trend(
            "stress level",
            last.max_pressure < 0.97 * first.max_pressure
            and last.max_von_mises < 0.92 * first.max_von_mises,
            first.max_pressure * 1e-9,
            last.max_pressure * 1e-9,
            first.max_von_mises * 1e-9,
            last.max_von_mises * 1e-9,
        ),
        say.trend(
            "volume",
            conserved < 1e-12,
            f"equal, relative difference {conserved:.0e}" if conserved > 0 else "equal",
        ),
    ]


def figures(results: Results) -> list[Picture]:
    found = results.wear
    return [
        surface(found, 0, "running_in_initial", "Figure 5.12: initial surface."),
        panels(found.first, "running_in_first", "Figure 5.13: first cycle, plane y = 12.5 µm."),
        surface(found, -1, "running_in_final", "Figure 5.14: surface after running-in."),
        panels(found.last, "running_in_last", "Figure 5.15: last cycle, plane y = 12.5 µm."),
        history(found),
    ]


def surface(found: sc.wear.WearResult, cycle: int, name: str, caption: str) -> Picture:
    figure, (left, right) = axes()
    last = len(found.cycles)
    data, shown = found.to_dataset(), (0,) if cycle == 0 else (0, 1, 2, last)
    wear.surface_map(data, left, cycle=cycle)
    wear.worn_profile(data, right, position=CREST, cycles=shown)
    for ax in (left, right):
        ax.set_xlim(-150, 150)
    left.set_ylim(-150, 150)
    return Picture(name, caption + " Right: profile along y = 12.5 µm.", figure)


def panels(moments: tuple[sc.State, sc.State], name: str, caption: str) -> Picture:
    figure = wear.cycle_panels(moments, position=CREST, width=150e-6, depth=18e-6)
    return Picture(name, caption, figure)


def history(found: sc.wear.WearResult) -> Picture:
    figure, (left, right) = axes(1, 2, (9.0, 3.6))
    wear.wear_rate(found.to_dataset(), left)
    left.axvline(
        STATED_CYCLES, color="k", linestyle="--", linewidth=1, label="Boucly (2008): 7 cycles"
    )
    finish(left, "cycle", "worn volume per cycle [µm³]")
    left.legend(loc="upper center", fontsize="small", frameon=False)
    numbers = np.arange(1, len(found.cycles) + 1)
    for name, label in (("max_pressure", "pressure"), ("max_von_mises", "von Mises stress")):
        values = [getattr(cycle, name) * 1e-9 for cycle in found.cycles]
        right.plot(numbers, values, "o-", markersize=3, label=label)
    right.set_ylim(bottom=0)
    finish(right, "cycle", "maximum in the cycle [GPa]")
    return Picture(
        "running_in_history",
        "Not in the thesis: worn volume, maximum pressure and maximum von Mises stress of each "
        "cycle.",
        figure,
    )
