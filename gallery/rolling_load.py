# SPDX-License-Identifier: GPL-3.0-or-later
"""An ellipsoid of k = 8 that rolls under four loads: end of section 3.2.1.3, table 3.3."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes

import samcontact as sc

from .bodies import CERAMIC, ELASTIC, STEEL_52100
from .drawing import axes, finish
from .page import Number, Picture, Statement
from .profiles import each, grows
from .track import BALL, Mesh, Run, both_cycles, roll, table_ellipse

TITLE = "Rolling, effect of the load"
INTRODUCTION = """
Section 3.2.1.3 of the thesis, tables 3.2 and 3.3: a ceramic ellipsoid rolls twice by 4 mm along the
minor axis of its contact over a flat of steel 52100, under 3690 to 25 499 N, unloaded on the way
back. The tables give R_x = 4.7625 mm, R_y / R_x = k^(pi/2) = 26.2 for k = 8, and a load k times
that of a ball with the same semi-minor axis. These do not belong together: the exact contact of
these radii and loads has k = 8.18, and a Hertz pressure 15 % below the stated one. The stated
strains, stresses and prints are those of the radii and loads, which are used here; they are named
by the stated pressures. What a pressure of 5.7 GPa would do is in
[effect of the ellipticity](rolling_ellipticity.md). Profiles are taken at 60 % of the way, after
two cycles. Tensile stress is positive.
"""

K = 8
LOADS = {4.2: 3689.8, 5.7: 9223.2, 6.5: 13677.2, 8.0: 25499.0}
BODIES = (CERAMIC, STEEL_52100)
STRAIN = {4.2: 0.05, 5.7: 0.4, 6.5: 0.8, 8.0: 2.1}
STRESS = {4.2: 40.0, 5.7: 253.0, 6.5: 445.0, 8.0: 935.0}
HERTZ_DEPTH = 0.78
FINE_STRESS = {4.2: 48.2, 8.0: 867.0}
FINE_COMPRESSION, FINE_TENSION = -573.0, 101.0
STRESS_NOTE = {
    4.2: "52, 50 and 48 MPa with cells of a/5, a/8 and a/16.",
    5.7: "278, 267 and 265 MPa with cells of a/5, a/8 and a/10.",
    8.0: "867 MPa with a/8 and a/10, 878 and 874 MPa after one cycle with a/8 and a/16. 4 mm are "
    "less than the width of the contact: 16 mm give a steady 931 MPa (a/6).",
}
HYDROSTATIC_NOTE = (
    "Second cycle: -585 and -573 MPa with a/5 and a/10; first: -582 and -581 MPa with a/10 and "
    "a/16. A longer or deeper grid, or layers half as thick, change it by less than 1 MPa; 16 mm "
    "give -599 MPa. The exact sum over the plastic strain of one section, continued without end "
    "along the track, gives -604 MPa where the track of 26 a it is from has -588 MPa (a/5)."
)
STRAIN_NOTE = (
    "Of the whole plane y = 0: it is near the start. With cells and steps of a/16 0.0518, 0.797 "
    "and 2.15 % at 4.2, 6.5 and 8 GPa."
)
SURFACE_NOTE = (
    "It falls along the way: for 8 GPa from 250 MPa at 6 a to a steady 140 MPa on a way of 16 mm "
    "(a/6), where the second layer has 164 MPa; it is there with layers of a/10 and a/20, "
    "and in the exact sum of the remark on the lowest stress."
)


@dataclass
class Results:
    runs: dict[float, Run]
    elastic: np.ndarray
    """Von Mises stress on the axis under the largest load, had the flat not yielded."""
    mesh: str


def compute(quick: bool) -> Results:
    runs = {}
    for pressure, load in LOADS.items():
        # the residual stress of 5.7 GPa is too high on a/5
        cells = 10 if not quick else 7 if pressure == 5.7 else 5
        layers = max(cells, 6)
        depth = 2.6 if pressure < 5 else 4.3 if pressure < 7 else 4.6
        mesh = Mesh(cells, layers, 2.5, 1.45 if quick else 1.8, depth, 5 if quick else 10)
        runs[pressure] = roll(BODIES, table_ellipse(K, load), mesh, 4e-3, cycles=2)
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
        Statement(
            "Hertz pressure and k of the radii and loads",
            "4.2, 5.7, 6.5, 8 GPa, 8",
            f"{each(actual)} GPa, {ratios[0]:.3g}",
            all(value < 0.87 * name for value, name in zip(actual, runs, strict=True)),
            "closed form",
            remark="Exact, with elliptic integrals. A pressure of 5.7 GPa on the stated semi-axes "
            "needs R_x = 3.80 mm and R_y / R_x = 25.3.",
            contradicted=True,
        ),
        Number(
            "semi-minor axis at 8 GPa, as the table has it", 436.2, kept[-1], "µm", "closed form"
        ),
    ]


def numbers(results: Results) -> list[Number | Statement]:
    runs, mesh = results.runs, results.mesh
    entries: list[Number | Statement] = []
    for name, run in runs.items():
        ours = 100 * float(run.steady.gamma.max())
        entries.append(Number(f"largest plastic strain, {name:g} GPa", STRAIN[name], ours, "%",
                              mesh, 0.06, STRAIN_NOTE if name == 8 else ""))  # fmt: skip
    steady = [100 * run.steady.peak("gamma")[0] for run in runs.values()]
    entries.append(
        Statement(
            "the same in the steady region",
            "profiles, no other numbers",
            f"{each(steady)} %",
            all(value < number for value, number in zip(steady[1:], list(STRAIN.values())[1:],
                                                       strict=True)),
            mesh,
            remark="0.0508, 0.70 and 1.90 % at 4.2, 6.5 and 8 GPa with cells and steps of a/16.",
        )
    )  # fmt: skip
    for name, run in runs.items():
        ours = 1e-6 * run.steady.peak("von_mises")[0]
        entries.append(
            Number(f"largest residual von Mises stress, {name:g} GPa", STRESS[name], ours, "MPa",
                   mesh, 0.1, STRESS_NOTE.get(name, ""), converged=FINE_STRESS.get(name))
        )  # fmt: skip
    last = runs[8.0].steady
    below = last.z > 1.5 * runs[8.0].a
    profile = last.profile("hydrostatic") * 1e-6
    return [
        *entries,
        Number("lowest residual hydrostatic stress, 8 GPa", -390.0, float(profile.min()), "MPa",
               mesh, remark=HYDROSTATIC_NOTE, converged=FINE_COMPRESSION),
        Number("highest below the compressive zone, 8 GPa", 180.0, float(profile[below].max()),
               "MPa", mesh, remark="See the remark before.", converged=FINE_TENSION),
        Number("largest depth of the print, 8 GPa", 6.93, float(last.along.max()) * 1e6, "µm",
               mesh),
        Number("depth in the stationary region, 8 GPa", 2.96, last.depth * 1e6, "µm", mesh,
               remark="At half of the way it is 3.04 µm (a/10), at 80 % 2.72; on a way of 16 mm "
               "2.53 (a/6)."),
    ]  # fmt: skip


def trends(results: Results) -> list[Number | Statement]:
    runs, mesh = results.runs, results.mesh
    depths = [run.steady.peak("gamma")[1] * 1e6 for run in runs.values()]
    zones = [np.ptp(run.z[run.steady.profile("gamma") > 0]) * 1e6 for run in runs.values()]
    loaded = float(runs[8.0].loaded_axis[-1].max())
    return [
        Statement(
            "depth of the largest plastic strain, from 4.2 to 8 GPa",
            "increases with the load",
            f"{each(depths, '.0f')} µm",
            grows(depths),
            mesh,
        ),
        Statement(
            "plastic zone, from 4.2 to 8 GPa",
            "grows significantly with the load",
            f"{each(zones, '.0f')} µm high on the axis",
            grows(zones) and zones[-1] > 2 * zones[0],
            mesh,
        ),
        Statement(
            "largest von Mises stress under load on the axis, 8 GPa",
            "close to the elastic solution",
            f"{loaded * 1e-9:.2f} GPa, elastic {results.elastic.max() * 1e-9:.2f}",
            0.7 < loaded / results.elastic.max() < 0.95,
            mesh,
            remark="No number is stated. It cannot exceed the yield stress, which is 3.09 GPa at a "
            "plastic strain of 1.8 %.",
        ),
    ]


def zero(run: Run) -> float:
    """Depth at which the compression ends [m]."""
    profile = run.steady.profile("hydrostatic")
    k = int(profile.argmin())
    end = k + int(np.flatnonzero(profile[k:] > 0)[0])
    return float(np.interp(0.0, profile[end - 1 : end + 1], run.z[end - 1 : end + 1]))


def hydrostatic_trends(results: Results) -> list[Number | Statement]:
    runs, mesh = results.runs, results.mesh
    surface = [run.steady.profile("hydrostatic")[0] * 1e-6 for run in runs.values()]
    ends = [zero(run) / (HERTZ_DEPTH * run.a) for run in runs.values()]
    return [
        Statement(
            "tensile zone at the surface, from 4.2 to 8 GPa",
            "gone at 6.5 GPa and above",
            f"{each(surface, '.0f')} MPa in the first layer",
            min(surface) > 0 and surface[-1] > surface[0],
            mesh,
            remark=SURFACE_NOTE,
            contradicted=True,
        ),
        Statement(
            "end of the compressive zone, 6.5 and 8 GPa",
            "about two Hertz depths, tensile below",
            f"{ends[2]:.1f} and {ends[3]:.1f} Hertz depths",
            1.7 < ends[2] < 2.6 and ends[2] < ends[3] < 3.2,
            mesh,
            remark=f"The Hertz depth of a line contact, {HERTZ_DEPTH} of the semi-minor axis.",
        ),
    ]


def figures(results: Results) -> list[Picture]:
    return [strains(results), hydrostatic(results), prints(results)]


def curves(ax: Axes, results: Results, name: str, scale: float) -> None:
    """Profiles on the axis."""

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
    marks(left, STRAIN)
    marks(right, STRESS)
    finish(left, "depth [µm]", "equivalent plastic strain [%]")
    finish(right, "depth [µm]", "residual von Mises stress [MPa]")
    return Picture(
        "rolling_load_strain",
        "Figures 3.25 and 3.26: plastic strain and residual von Mises stress below the middle of "
        "the steady track after one (dashed) and two cycles. Triangles: stated largest values.",
        figure,
    )


def hydrostatic(results: Results) -> Picture:
    figure, ax = axes(1, 1, (5.4, 3.8))
    curves(ax, results, "hydrostatic", 1e-6)
    ax.axhline(0, color="k", linewidth=0.6)
    ax.axhspan(-390, 180, color="C3", alpha=0.08, label="stated range, 8 GPa")
    finish(ax, "depth [µm]", "residual hydrostatic stress [MPa]")
    return Picture(
        "rolling_load_hydrostatic",
        "Figure 3.27: residual hydrostatic stress on the same lines.",
        figure,
    )


def prints(results: Results) -> Picture:
    figure, ax = axes(1, 1, (9.0, 3.6))
    both_cycles(ax, results.runs, "{:g} GPa",
                lambda run, n: (1e3 * run.cycles[n].x, -1e6 * run.cycles[n].along))  # fmt: skip
    for depth in (6.93, 2.96):
        ax.axhline(-depth, color="k", linestyle=":", linewidth=1,
                   label="stated: 6.93 and 2.96 µm" if depth == 2.96 else None)  # fmt: skip
    ax.set_xlim(-1.2, 5.2)
    finish(ax, "rolling direction x [mm]", "height of the surface [µm]")
    return Picture(
        "rolling_load_prints",
        "Figure 3.28: print in the middle of the track after one (dashed) and two cycles, rolled "
        "to the right.",
        figure,
    )
