# SPDX-License-Identifier: GPL-3.0-or-later
"""Ellipsoids rolling along the minor axis of the contact: Boucly (2008), section 3.2.1.3."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from matplotlib.axes import Axes

from .bodies import CERAMIC, STEEL_52100, tolerance
from .drawing import axes, finish, hertz_curve
from .page import Picture
from .profiles import falls, grows, succession, top
from .stated import Number, Stated, Statement
from .track import BALL, Mesh, Run, both_cycles, ellipse, roll, table_ellipse

STATED = Stated("rolling_ellipticity")
TITLE = "Rolling: influence of the ellipticity"
INTRODUCTION = """
This page shows how the ellipticity of a rolling contact changes the track, strain and residual
stress, and compares the results with section 3.2.1.3 of Boucly's thesis (2008). A ceramic ellipsoid
rolls twice by 4 mm along the minor axis of its contact over a flat of steel 52100. The semi-major
axis is k times the semi-minor axis, and the grid is stretched across the track by the same factor.
The thesis intends a Hertz pressure of 5.7 GPa for every k. By exact elliptic integrals, however,
the radii and loads of table 3.2 in the thesis (R_x = 4.7625 mm, R_y / R_x = k^(pi/2), load 1152.9 N
times k) give only 4.9 to 5.2 GPa for k > 1.

The values and trends stated in the thesis are results for these radii and loads. Most rows and
figures below therefore use these radii and loads. The rows and figures labelled "Hertz pressure of
5.7 GPa" use exact radii and loads instead: k, the semi-minor axis and the Hertz pressure have their
nominal values, and R_x falls from 4.7625 mm (k = 1) to 3.76 mm (k = 16). In all rows, lengths are
divided by a = 310.8 µm and stresses by p0 = 5.7 GPa. These are the nominal values of the semi-minor
axis and the Hertz pressure, whatever the actual values in the contact. Profiles are taken at 60 %
of the rolling distance.
"""

BODIES = (CERAMIC, STEEL_52100)
LOAD = 1152.9
RATIOS = (2, 4, 8, 16)
"""R_y / R_x of table 3.2."""


@dataclass
class Results:
    runs: dict[int, Run]
    """Results with the radii and loads of table 3.2, after two cycles."""
    exact: dict[int, Run]
    """Results with a Hertz pressure of 5.7 GPa, after one cycle."""
    mesh: str
    exact_mesh: str


def compute(quick: bool) -> Results:
    tol = tolerance(quick)
    table = Mesh(5, 6, 2.5, 1.45, 3.8, 5, tol) if quick else Mesh(10, 10, 2.5, 1.8, 3.6)
    exact = Mesh(5, 6, 2.5, 1.45, 4.5, 5, tol) if quick else Mesh(8, 8, 2.5, 1.8, 4.5)
    distance = 1.8e-3 if quick else 4e-3
    kept = (1, 2, 8, 16) if quick else (1, *RATIOS)
    runs = {k: roll(BODIES, table_ellipse(k, k * LOAD), table, distance, 2) for k in kept}
    others = {k: roll(BODIES, ellipse(k), exact, distance) for k in kept if k < 16 or not quick}
    return Results(runs, others, str(table), str(exact))


def stated(results: Results) -> list[Number | Statement]:
    return [
        *contacts(results),
        *imprint_trends(results),
        *pressure_trends(results),
        *profile_trends(results),
        *at_pressure(results),
    ]


def contacts(results: Results) -> list[Number | Statement]:
    exact = {k: ellipse(k).Ry / ellipse(k).Rx for k in RATIOS}
    table = [table_ellipse(k, k * LOAD) for k in RATIOS]
    widest = max(abs(contact.p0 / BALL.p0 - 1) for contact in table)
    return [
        STATED.trend(
            "pressure of the table",
            widest > 0.1,
            [contact.p0 * 1e-9 for contact in table],
            ratios=[contact.k for contact in table],
            minor=[1e6 * contact.a_x for contact in table],
        ),
        *(STATED.number("ratio of radii", exact[k], at=k) for k in RATIOS),
        STATED.number("semi major axis", ellipse(16).a_y * 1e6),
        STATED.number("distance", 4e-3 / BALL.a),
    ]


def imprint_trends(results: Results) -> list[Number | Statement]:
    runs, mesh = results.runs, results.mesh
    name = "k = " + ", ".join(str(k) for k in runs)
    steady = [run.steady for run in runs.values()]
    depths = [cycle.depth * 1e6 for cycle in steady]
    widths = [cycle.width() / BALL.a for cycle in steady]
    beyond = [cycle.shoulders()[1] * 1e9 for cycle in steady]
    side_heights = [cycle.shoulders()[2] * 1e9 for cycle in steady]
    x = np.linspace(-2 * BALL.a, 2.4e-3, 400)
    along = [np.interp(x, cycle.x, cycle.along) for cycle in steady]
    change = [float(np.abs(b - a).max()) * 1e6 for a, b in pairwise(along)]
    say = STATED.on(mesh, which=name)
    return [
        say.trend("depth", falls(depths), depths),
        say.trend("width", grows(widths), widths),
        say.trend("shoulder beyond end", grows(beyond) and beyond[-1] > 2 * beyond[0], beyond),
        say.trend("shoulders at sides", falls(side_heights), side_heights),
        say.trend(
            "highest shoulder",
            0.7 < beyond[0] / side_heights[0] < 1.0
            and all(b > s for b, s in zip(beyond[1:], side_heights[1:], strict=True)),
            [b / s for b, s in zip(beyond, side_heights, strict=True)],
        ),
        say.trend(
            "line contact",
            change[-1] < min(0.5 * max(change), 0.25 * steady[-1].depth * 1e6),
            change,
        ),
    ]


def pressure_trends(results: Results) -> list[Number | Statement]:
    runs, mesh = results.runs, results.mesh
    name = "k = " + ", ".join(str(k) for k in runs)
    tops = [run.p_max() * 1e-9 for run in runs.values()]
    own = [run.p_max() / run.p0 for run in runs.values()]
    drops = -np.diff(tops)
    return [
        STATED.trend(
            "pressure",
            tops[0] == max(tops) and abs(drops[-1]) < 0.3 * drops[0],
            tops,
            mesh=mesh,
            which=name,
            own=own,
        )
    ]


def profile_trends(results: Results) -> list[Number | Statement]:
    runs, mesh = results.runs, results.mesh
    name = "k = " + ", ".join(str(k) for k in runs)
    steady = [run.steady for run in runs.values()]
    gamma = [cycle.peak("gamma") for cycle in steady]
    stress = [cycle.peak("von_mises") for cycle in steady]
    loaded = [top(run.z, run.loaded_axis[-1]) for run in runs.values()]
    lowest = [float(run.z[run.steady.profile("gamma") > 1e-5].max()) for run in runs.values()]
    signs = [", ".join(succession(c.profile("hydrostatic"), 1e-3 * BALL.p0)) for c in steady]
    expected = "tensile, compressive, tensile"
    stresses = [
        np.abs(run.cycles[1].profile("von_mises") - run.cycles[0].profile("von_mises")).max()
        for run in runs.values()
    ]
    share = [float(a) / s for a, (s, _) in zip(stresses, stress, strict=True)]
    a = BALL.a
    say = STATED.on(mesh, which=name)
    return [
        say.trend("strain", falls([g for g, _ in gamma]), [100 * g for g, _ in gamma]),
        say.trend(
            "strain depth",
            grows([z for _, z in gamma][:-1])
            and abs(gamma[0][1] / a - 0.48) < 0.03
            and abs(gamma[-1][1] / a - 0.78) < 0.08,
            [z / a for _, z in gamma],
        ),
        say.trend("lowest strain", lowest[-1] > 1.5 * lowest[0], [z / a for z in lowest]),
        say.trend(
            "stress under load",
            loaded[-1][0] < loaded[0][0] == max(s for s, _ in loaded)
            and loaded[-1][1] > 1.3 * loaded[0][1],
            [s * 1e-9 for s, _ in loaded],
            [z / a for _, z in loaded],
        ),
        say.trend(
            "residual stress",
            falls([s for s, _ in stress]) and abs(stress[0][0] / BALL.p0 - 0.106) < 0.006,
            [100 * s / BALL.p0 for s, _ in stress],
        ),
        say.trend("residual by cycles", max(share) < 0.1, 100 * max(share)),
        say.trend(
            "hydrostatic",
            all(found == expected for found in signs),
            expected if set(signs) == {expected} else "; ".join(signs),
            thesis=expected,
        ),
    ]


def at_pressure(results: Results) -> list[Number | Statement]:
    runs, mesh = results.exact, results.exact_mesh
    name = "k = " + ", ".join(str(k) for k in runs)
    tops = [run.p_max() * 1e-9 for run in runs.values()]
    gamma = [100 * run.steady.peak("gamma")[0] for run in runs.values()]
    stress = [1e-6 * run.steady.peak("von_mises")[0] for run in runs.values()]
    depths = [run.steady.depth * 1e6 for run in runs.values()]
    say = STATED.on(mesh, which=name)
    return [
        say.trend("exact pressure", grows(tops), tops),
        say.trend("exact strain", falls(gamma) and gamma[list(runs).index(8)] > 1.7 * 0.4, gamma),
        say.trend("exact residual stress", stress[-1] < stress[0], stress),
        say.trend("exact depth", depths[1] > depths[0] and falls(depths[1:]), depths),
    ]


def figures(results: Results) -> list[Picture]:
    return [imprints(results), pressures(results), profiles(results), stresses(results)]


def curves(ax: Axes, results: Results, name: str, scale: float) -> None:
    """Draw profiles of one quantity below the middle of the track, for each ellipticity."""

    def points(run: Run, n: int) -> tuple[np.ndarray, np.ndarray]:
        return run.cycles[n].z / BALL.a, scale * run.cycles[n].profile(name)

    both_cycles(ax, results.runs, "k = {}", points)
    ax.set_xlim(0, 2.2)


def imprints(results: Results) -> Picture:
    a = BALL.a
    figure, (left, right) = axes(sharey=True)
    both_cycles(
        left,
        results.runs,
        "k = {}",
        lambda run, n: (run.cycles[n].x / a, -1e3 * run.cycles[n].along / a),
    )
    both_cycles(right, results.runs, "k = {}",
                lambda run, n: (run.cycles[n].y / a, -1e3 * run.cycles[n].across / a))  # fmt: skip
    right.set_xlim(-15, 15)
    finish(left, "rolling direction x/a", "height of the surface [a/1000]")
    finish(right, "across the track y/a")
    return Picture(
        "rolling_ellipticity_imprints",
        "Figures 3.18 and 3.19: imprints along and across the track after one (dashed) and two "
        "cycles of rolling to the right.",
        figure,
    )


def pressures(results: Results) -> Picture:
    a, p0 = BALL.a, BALL.p0
    figure, (left, right) = axes(sharey=True)
    for ax, runs in ((left, results.runs), (right, results.exact)):
        hertz_curve(ax, BALL, p0, 1.6, "Hertz, 5.7 GPa")
        for n, k in enumerate(results.runs):
            if k in runs:
                run = runs[k]
                ax.plot(run.x / a, run.pressure_along[-1] / p0, f"C{n}", label=f"k = {k}")
        ax.set_xlim(-1.6, 1.6)
    left.set_title("radii and loads of table 3.2", fontsize="medium")
    right.set_title("Hertz pressure of 5.7 GPa", fontsize="medium")
    finish(left, "rolling direction x/a", "pressure / 5.7 GPa")
    finish(right, "rolling direction x/a")
    return Picture(
        "rolling_ellipticity_pressure",
        "Figure 3.20: steady pressure in the plane y = 0. Right, not in the thesis: contacts with "
        "a Hertz pressure of 5.7 GPa for every k.",
        figure,
    )


def profiles(results: Results) -> Picture:
    figure, (left, right) = axes()
    curves(left, results, "gamma", 100.0)
    both_cycles(right, results.runs, "k = {}",
                lambda run, n: (run.z / BALL.a, run.loaded_axis[n] / BALL.p0))  # fmt: skip
    left.axvline(0.48, color="k", linestyle=":", linewidth=1)
    left.axvline(0.8, color="k", linestyle=":", linewidth=1)
    right.set_xlim(0, 2.2)
    finish(left, "depth z/a", "equivalent plastic strain [%]")
    finish(right, "depth z/a", "von Mises stress under load / p0")
    return Picture(
        "rolling_ellipticity_strain",
        "Figures 3.21 and 3.22: plastic strain, and von Mises stress under load, below the middle "
        "of the track after one (dashed) and two cycles. Dotted: depth of the maximum elastic von "
        "Mises stress in a point contact (0.48), and of the maximum elastic shear stress in a line "
        "contact (0.8).",
        figure,
    )


def stresses(results: Results) -> Picture:
    figure, (left, right) = axes()
    curves(left, results, "von_mises", 1 / BALL.p0)
    curves(right, results, "hydrostatic", 1 / BALL.p0)
    left.axhline(0.1, color="k", linestyle=":", linewidth=1, label="Boucly (2008): 10 % for k = 1")
    right.axhline(0, color="k", linewidth=0.6)
    finish(left, "depth z/a", "residual von Mises stress / p0")
    finish(right, "depth z/a", "residual hydrostatic stress / p0")
    return Picture(
        "rolling_ellipticity_stress",
        "Figures 3.23 and 3.24: residual von Mises and hydrostatic stress below the middle of the "
        "track after one (dashed) and two cycles.",
        figure,
    )
