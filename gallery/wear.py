# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear of a flat surface: Boucly (2008), section 5.2.1, figures 5.9 to 5.11."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes

import samcontact as sc
from samcontact.plotting import wear

from .bodies import ELASTIC
from .drawing import axes, finish
from .page import Picture
from .stated import Number, Stated, Statement

STATED = Stated("wear")
TITLE = "Wear of a flat surface"
INTRODUCTION = """
This page shows the wear of smooth balls and the limits of the wear model, and compares the results
with section 5.2.1 of Boucly's thesis (2008). Two smooth balls of 15 mm radius are loaded thirteen
times with 2000 N and a friction coefficient of 0.4; the shear traction follows the load. After each
cycle the surface material with more than 0.2 % accumulated plastic strain is removed. The steel has
Swift hardening with B = 1735 MPa, C = 16 and n = 0.067. The thesis states neither whether both
balls are elastic-plastic nor the width of its smoothing filter. Here body 2 is elastic-plastic and
wears, body 1 is elastic, and the filter is 300 µm wide and of second order. After the border of the
worn region has been smoothed, the plastic strain that remains in the material is shifted towards
the new surface. The shift is either the wear depth before smoothing, as described in the thesis, or
the smoothed wear depth ([theory](../theory/wear.md)).

As stated in the thesis, wear does not cease. The wear rate is constant if the strain moves by the
smoothed depth, and decreases if it moves by the depth before smoothing. However, both calculations
leave the range of the theory in the second cycle. The first cycle removes a lens 47 µm deep,
whereas the approach of the balls is 28 µm. The next contact is therefore on the rim of the pit, at
a pressure far above the Hertz pressure. The plastic zone below the rim then joins the plastic zone
below the surface that figure 5.9 shows, and material down to a depth of 200 µm breaks out. Each
further cycle removes the rim and creates a new rim further out. Plastic strains in the rim are
several times the small-strain limit, and the walls of the rim are steep. The wear rates are
therefore results of this model on this mesh, and not wear rates of a steel.
"""

STEEL = sc.Material.swift(E=210e9, nu=0.3, B=1735e6, C=16.0, n=0.067)
RADIUS, LOAD, FRICTION, THRESHOLD, CYCLES = 7.5e-3, 2000.0, 0.4, 2e-3, 13
WINDOW = 300e-6
E_STAR = sc.hertz.effective_modulus(ELASTIC, STEEL)
HERTZ = sc.hertz.point(R=RADIUS, E_star=E_STAR, load=LOAD)
TITLES = ("strain moved by depth before smoothing", "strain moved by smoothed depth")
STEADY = slice(3, None)
"""Cycles after the third."""


@dataclass
class Results:
    exact: sc.wear.WearResult
    smoothed: sc.wear.WearResult
    """Results with strain moved up by the depth before smoothing, and by the smoothed depth."""
    mesh: str
    allowed: float
    """Maximum relative difference of the wear in a single cycle from the mean."""


def compute(quick: bool) -> Results:
    dx, dz, side = (75e-6, 30e-6, 4.2e-3) if quick else (45e-6, 12e-6, 3.6e-3)
    cells = int(side / dx) | 1
    grid = sc.Grid(cells, cells, dx, dx, int(650e-6 / dz), dz)
    exact, smoothed = (
        sc.wear.run(
            grid,
            ELASTIC,
            STEEL,
            sc.surfaces.paraboloid(grid, RADIUS),
            cycle=sc.paths.load_unload(load=LOAD, increments=1 + (not quick), unload_increments=1),
            threshold=THRESHOLD,
            cycles=CYCLES,
            window=round(WINDOW / grid.dx) | 1,
            strain_depth=strain_depth,
            friction=FRICTION,
            progress=False,
            tol=1e-4,
        )
        for strain_depth in ("exact", "smoothed")
    )
    # On the coarse grid the rim is only a few cells wide, so a single cell has an effect.
    mesh = f"cells {dx * 1e6:.0f} µm, layers {dz * 1e6:.0f} µm"
    return Results(exact, smoothed, mesh, 0.3 if quick else 0.15)


def stated(results: Results) -> list[Number | Statement]:
    return [*stated_first_cycle(results), *stated_rate(results), *stated_largest(results)]


def stated_first_cycle(results: Results) -> list[Statement]:
    first = results.exact.cycles[0]
    critical = sc.critical.onset_sliding(
        RADIUS, E_STAR, 0.3, float(STEEL.yield_stress(20e-6)), FRICTION
    )
    return [
        STATED.trend(
            "onset of yield",
            HERTZ.load > 2 * critical.load,
            HERTZ.p0 * 1e-9,
            (HERTZ.load / critical.load) ** (1 / 3),
        ),
        STATED.trend(
            "first plastic zone",
            first.max_equivalent_plastic_strain == first.surface_strain,
            100 * first.max_equivalent_plastic_strain[0],
            mesh=results.mesh,
        ),
    ]


def stated_rate(results: Results) -> list[Statement]:
    found, mesh = results.exact, results.mesh
    falling, rate = (1e9 * run.rate[STEADY] for run in (found, results.smoothed))
    spread = rate.max() / rate.mean() - 1, rate.min() / rate.mean() - 1
    say = STATED.on(mesh)
    return [
        say.trend(
            "thirteen cycles",
            all(
                run.rate[-1] > run.rate[0] and len(run.cycles) == CYCLES
                for run in (found, results.smoothed)
            ),
            1e9 * results.smoothed.rate.sum(),
            1e9 * found.rate.sum(),
        ),
        say.trend(
            "wear rate",
            rate.mean() > 1e9 * found.rate[0],
            rate.mean(),
            found.rate[0] * 1e9,
        ),
        say.trend(
            "single cycles",
            max(spread[0], -spread[1]) < results.allowed,
            100 * spread[0],
            100 * spread[1],
        ),
        say.trend(
            "exact wear rate",
            0.1 < falling[-3:].mean() / falling[:3].mean() < 0.7,
            falling[0],
            falling[-1],
        ),
    ]


def stated_largest(results: Results) -> list[Statement]:
    found, mesh = results.exact, results.mesh
    first = found.cycles[0]
    pressure = max(cycle.max_pressure for cycle in found.cycles)
    strain = max(cycle.max_equivalent_plastic_strain[0] for cycle in found.cycles)
    conserved = max(abs(c.lost_volume[0] / c.volume[0] - 1) for c in found.cycles)
    say = STATED.on(mesh)
    return [
        say.trend(
            "pressure",
            pressure > 2 * first.max_pressure,
            first.max_pressure * 1e-9,
            pressure * 1e-9,
        ),
        say.trend("plastic strain", strain > 0.05, 100 * strain),
        say.trend(
            "volume",
            conserved < 1e-12,
            f"equal, relative difference {conserved:.0e}" if conserved > 0 else "equal",
        ),
    ]


def figures(results: Results) -> list[Picture]:
    figure, (left, middle, right) = axes(1, 3, (12.0, 3.8))
    runs = (results.exact, results.smoothed)
    for ax, found, title in zip((left, middle), runs, TITLES, strict=True):
        wear.worn_profile(found.to_dataset(), ax, position=0.0)
        ax.set_xlim(-1500, 1500)
        ax.set_title(title, fontsize="medium")
    volumes(results, right)
    return [
        panels(results.exact.first, "wear_first", "Figure 5.9: first cycle, plane y = 0."),
        Picture(
            "wear_profile",
            "Figure 5.10: worn surface in the plane y = 0 after each cycle, and worn volume per "
            "cycle.",
            figure,
        ),
        panels(
            results.smoothed.last,
            "wear_last",
            "Figure 5.11: thirteenth cycle, plane y = 0, strain moved by the smoothed depth.",
        ),
    ]


def panels(moments: tuple[sc.State, sc.State], name: str, caption: str) -> Picture:
    figure = wear.cycle_panels(moments, position=0.0, width=1.2e-3, depth=500e-6)
    return Picture(name, caption, figure)


def volumes(results: Results, ax: Axes) -> None:
    for found, label in zip((results.exact, results.smoothed), TITLES, strict=True):
        wear.wear_rate(found.to_dataset(), ax)
        ax.get_lines()[-1].set_label(label)
    mean = float(np.mean(results.smoothed.rate[STEADY])) * 1e18
    label = "mean of cycles 4 to 13, ±15 %"
    ax.axhspan(0.85 * mean, 1.15 * mean, color="C1", alpha=0.15, label=label)
    finish(ax, "cycle", "worn volume per cycle [µm³]")
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.06), fontsize="small", frameon=False)
