# SPDX-License-Identifier: GPL-3.0-or-later
"""An ellipsoid of ellipticity k = 8 rolling under four loads: Boucly (2008), table 3.3."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes

import samcontact as sc

from .bodies import CERAMIC, ELASTIC, STEEL_52100, tolerance
from .drawing import axes, finish
from .page import Picture
from .profiles import grows
from .stated import Number, Stated, Statement
from .track import BALL, Mesh, Run, both_cycles, roll, table_ellipse

STATED = Stated("rolling_load")
TITLE = "Rolling: influence of the load"
INTRODUCTION = """
This page shows how the load of a rolling contact changes the track, strain and residual stress, and
compares the results with section 3.2.1.3 of Boucly's thesis (2008), tables 3.2 and 3.3. A ceramic
ellipsoid rolls twice by 4 mm along the minor axis of its contact over a flat of steel 52100, under
loads of 3690 to 25 499 N, and returns unloaded. The semi-major axis of the contact is k times the
semi-minor axis a. The tables give R_x = 4.7625 mm, R_y / R_x = k^(pi/2) = 26.2 for k = 8, and a
load that is k times the load of a ball whose contact radius equals the semi-minor axis. These
values are inconsistent: by the exact solution, the radii and loads give k = 8.18 and a Hertz
pressure 15 % below the value stated in the thesis.

The strains, stresses and imprints stated in the thesis are results for these radii and loads. These
radii and loads are therefore used here as well. The results are labelled with the Hertz pressures
stated in the thesis. For an actual Hertz pressure of 5.7 GPa see [influence of the
ellipticity](rolling_ellipticity.md). Profiles are taken at 60 % of the rolling distance, after two
cycles. Tensile stress is positive.
"""

K = 8
LOADS = {4.2: 3689.8, 5.7: 9223.2, 6.5: 13677.2, 8.0: 25499.0}
BODIES = (CERAMIC, STEEL_52100)
HERTZ_DEPTH = 0.78


@dataclass
class Results:
    runs: dict[float, Run]
    elastic: np.ndarray
    """Elastic von Mises stress on the axis under the largest load."""
    mesh: str


def compute(quick: bool) -> Results:
    runs = {}
    for pressure, load in LOADS.items():
        # with cells of a/5 the residual stress at 5.7 GPa is too high
        cells = 10 if not quick else 7 if pressure == 5.7 else 5
        layers = max(cells, 6)
        depth = 2.6 if pressure < 5 else 4.3 if pressure < 7 else 4.6
        width, loading = (1.45, 5) if quick else (1.8, 10)
        mesh = Mesh(cells, layers, 2.5, width, depth, loading, tolerance(quick))
        # the depth of the steady imprint and the tension below, which need a long track and two
        # cycles, are stated for 8 GPa
        distance, cycles = (2.4e-3, 1) if quick and pressure < 8 else (4e-3, 2)
        runs[pressure] = roll(BODIES, table_ellipse(K, load), mesh, distance, cycles)
    contact = runs[8.0].contact
    grid = mesh.grid(contact)
    flat = sc.Simulation(
        grid, CERAMIC, ELASTIC, sc.surfaces.paraboloid(grid, contact.Rx, contact.Ry)
    )
    elastic = flat.step(load=contact.load).von_mises()[grid.nx // 2, grid.ny // 2]
    return Results(runs, elastic, str(mesh))


def stated(results: Results) -> list[Number | Statement]:
    return [*contacts(results), *numbers(results), *trends(results), *hydrostatic_trends(results)]


def contacts(results: Results) -> list[Number | Statement]:
    runs = results.runs
    actual = [run.p0 * 1e-9 for run in runs.values()]
    ratios = [run.contact.k for run in runs.values()]
    kept = [BALL.a * 1e6 * pressure / 5.7 for pressure in runs]
    return [
        STATED.trend(
            "pressure of the table",
            all(value < 0.87 * name for value, name in zip(actual, runs, strict=True)),
            actual,
            ratios[0],
        ),
        STATED.number("semi minor axis", kept[-1]),
    ]


def numbers(results: Results) -> list[Number | Statement]:
    runs, mesh = results.runs, results.mesh
    say = STATED.on(mesh)
    strains = [100 * float(run.steady.gamma.max()) for run in runs.values()]
    steady = [100 * run.steady.peak("gamma")[0] for run in runs.values()]
    lower = zip(steady[1:], [*STATED.values("strain").values()][1:], strict=True)
    stresses = [1e-6 * run.steady.peak("von_mises")[0] for run in runs.values()]
    last = runs[8.0].steady
    below = last.z > 1.5 * runs[8.0].a
    profile = last.profile("hydrostatic") * 1e-6
    return [
        *(say.number("strain", ours, at=at) for at, ours in zip(runs, strains, strict=True)),
        say.trend("steady strain", all(value < number for value, number in lower), steady),
        *(
            say.number("residual stress", ours, at=at)
            for at, ours in zip(runs, stresses, strict=True)
        ),
        say.number("compression", float(profile.min())),
        say.number("tension", float(profile[below].max())),
        say.number("largest depth", float(last.along.max()) * 1e6),
        say.number("steady depth", last.depth * 1e6),
    ]


def trends(results: Results) -> list[Number | Statement]:
    runs, mesh = results.runs, results.mesh
    depths = [run.steady.peak("gamma")[1] * 1e6 for run in runs.values()]
    zones = [np.ptp(run.z[run.steady.profile("gamma") > 0]) * 1e6 for run in runs.values()]
    loaded = float(runs[8.0].loaded_axis[-1].max())
    say = STATED.on(mesh)
    return [
        say.trend("strain depth", grows(depths), depths),
        say.trend("plastic zone", grows(zones) and zones[-1] > 2 * zones[0], zones),
        say.trend(
            "stress under load",
            0.7 < loaded / results.elastic.max() < 0.95,
            loaded * 1e-9,
            results.elastic.max() * 1e-9,
        ),
    ]


def zero(run: Run) -> float:
    """Return the depth at which the residual compression ends [m]."""
    profile = run.steady.profile("hydrostatic")
    k = int(profile.argmin())
    end = k + int(np.flatnonzero(profile[k:] > 0)[0])
    return float(np.interp(0.0, profile[end - 1 : end + 1], run.z[end - 1 : end + 1]))


def hydrostatic_trends(results: Results) -> list[Number | Statement]:
    runs, mesh = results.runs, results.mesh
    surface = [run.steady.profile("hydrostatic")[0] * 1e-6 for run in runs.values()]
    ends = [zero(run) / (HERTZ_DEPTH * run.a) for run in runs.values()]
    say = STATED.on(mesh)
    return [
        say.trend("tensile surface", min(surface) > 0 and surface[-1] > surface[0], surface),
        say.trend(
            "compressive zone",
            1.7 < ends[2] < 2.6 and ends[2] < ends[3] < 3.2,
            ends[2],
            ends[3],
            hertz_depth=HERTZ_DEPTH,
        ),
    ]


def figures(results: Results) -> list[Picture]:
    return [strains(results), hydrostatic(results), imprints(results)]


def curves(ax: Axes, results: Results, name: str, scale: float) -> None:
    """Draw profiles of one quantity below the middle of the track, for each load."""

    def points(run: Run, n: int) -> tuple[np.ndarray, np.ndarray]:
        return 1e6 * run.cycles[n].z, scale * run.cycles[n].profile(name)

    both_cycles(ax, results.runs, "{:g} GPa", points)
    ax.set_xlim(0, 1400)


def marks(ax: Axes, stated: dict[float, float]) -> None:
    for k, value in enumerate(stated.values()):
        ax.plot(0, value, ">", color=f"C{k}", markerfacecolor="none", clip_on=False, zorder=4)


def strains(results: Results) -> Picture:
    figure, (left, right) = axes()
    curves(left, results, "gamma", 100.0)
    curves(right, results, "von_mises", 1e-6)
    marks(left, STATED.values("strain"))
    marks(right, STATED.values("residual stress"))
    finish(left, "depth [µm]", "equivalent plastic strain [%]")
    finish(right, "depth [µm]", "residual von Mises stress [MPa]")
    return Picture(
        "rolling_load_strain",
        "Figures 3.25 and 3.26: plastic strain and residual von Mises stress below the middle of "
        "the steady track after one (dashed) and two cycles. Triangles: maxima stated in the "
        "thesis.",
        figure,
    )


def hydrostatic(results: Results) -> Picture:
    figure, ax = axes(1, 1, (5.4, 3.8))
    curves(ax, results, "hydrostatic", 1e-6)
    ax.axhline(0, color="k", linewidth=0.6)
    ax.axhspan(-390, 180, color="C3", alpha=0.08, label="Boucly (2008): range at 8 GPa")
    finish(ax, "depth [µm]", "residual hydrostatic stress [MPa]")
    return Picture(
        "rolling_load_hydrostatic",
        "Figure 3.27: residual hydrostatic stress below the middle of the steady track after one "
        "(dashed) and two cycles.",
        figure,
    )


def imprints(results: Results) -> Picture:
    figure, ax = axes(1, 1, (9.0, 3.6))
    both_cycles(ax, results.runs, "{:g} GPa",
                lambda run, n: (1e3 * run.cycles[n].x, -1e6 * run.cycles[n].along))  # fmt: skip
    for depth in (6.93, 2.96):
        ax.axhline(-depth, color="k", linestyle=":", linewidth=1,
                   label="Boucly (2008): 6.93 and 2.96 µm" if depth == 2.96 else None)  # fmt: skip
    ax.set_xlim(-1.2, 5.2)
    finish(ax, "rolling direction x [mm]", "height of the surface [µm]")
    return Picture(
        "rolling_load_imprints",
        "Figure 3.28: imprint in the middle of the track after one (dashed) and two cycles of "
        "rolling to the right. Dotted: maximum and steady depth at 8 GPa stated in the thesis.",
        figure,
    )
