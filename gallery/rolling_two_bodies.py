# SPDX-License-Identifier: GPL-3.0-or-later
"""Indentation and rolling of one or two elastic-plastic bodies: Boucly (2008), section 3.2.2."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

import samcontact as sc

from .bodies import CERAMIC, ELASTIC, MICRO_STRAIN, STEEL_52100, tolerance
from .drawing import axes, finish, hertz_curve
from .page import Picture
from .profiles import each, grows, top
from .stated import Number, Stated, Statement
from .track import BALL, Mesh, Run, ellipse, roll

STATED = Stated("rolling_two_bodies")
TITLE = "Indentation and rolling compared"
INTRODUCTION = """
This page compares indentation with rolling, and compares the computed values with section 3.2.2 of
Boucly's thesis (2008). In the first part two bodies of steel 52100 have a circular (k = 1) or
elliptic (k = 8) contact. Either one body is elastic (E_EP) or both are elastic-plastic (EP_EP). The
bodies are pressed together, or they roll twice along the minor axis of the contact. Radii and loads
follow from k and the Hertz pressure p0 by the exact solution. The thesis does not state which radii
and loads it uses for k = 8 (see [influence of the ellipticity](rolling_ellipticity.md)). a is the
semi-axis of the contact along x, the rolling direction.

In the second part a ceramic ball of 9.525 mm diameter is pressed on a flat with linear hardening,
or rolls over it. The tangent modulus E_t is 0 to 0.8 times Young's modulus E. The thesis states
neither yield stress nor load. The micro-yield stress of steel 52100, 1477 MPa, and a Hertz pressure
of 5.7 GPa are assumed.
"""

MICRO_YIELD = float(STEEL_52100.yield_stress(MICRO_STRAIN))
PAIRS = {"E_EP": (ELASTIC, STEEL_52100), "EP_EP": (STEEL_52100, STEEL_52100)}
E_STAR = sc.hertz.effective_modulus(ELASTIC, STEEL_52100)
SLOPES = (0.0, 0.2, 0.4, 0.6, 0.8)
Key = tuple[str, int]


@dataclass
class Results:
    runs: dict[Key, dict[float, Run]]
    """Results by pair of bodies and ellipticity k, then by Hertz pressure [GPa]."""
    again: Run
    """Result of two load cycles without rolling."""
    hardening: dict[float, Run]
    mesh: str
    hardening_mesh: str


def compute(quick: bool) -> Results:
    tol = tolerance(quick)
    cells, loading = (4, 8) if quick else (8, 16)
    pressures = (4.5, 6.5) if quick else (4.0, 5.0, 6.0, 7.0, 8.0)
    runs: dict[Key, dict[float, Run]] = {}
    for pair, bodies in PAIRS.items():
        for k in (1, 8):
            depths = {p: 2.0 + (0.5 * (k > 1) + 0.3) * max(p - 3.0, 0.0) for p in pressures}
            runs[pair, k] = {}
            for pressure, depth in depths.items():
                length = 2.5 if quick else 3.5
                mesh = Mesh(cells, cells, length, 1.8, depth, loading, tol)
                contact = ellipse(k, pressure * 1e9, E_STAR)
                distance = (4 if quick else 6) * contact.a_x
                runs[pair, k][pressure] = roll(bodies, contact, mesh, distance, 2, 0.7)
    fine = Mesh(5, 5, loading=8, tol=tol) if quick else Mesh(12, 12, depth=3.0, loading=16)
    hardening, distance = {}, (4 if quick else 6) * BALL.a
    for slope in SLOPES[::2] if quick else SLOPES:
        E = STEEL_52100.E
        flat = sc.Material.linear_hardening(E, STEEL_52100.nu, MICRO_YIELD, slope * E)
        hardening[slope] = roll((CERAMIC, flat), ellipse(1), fine, distance)
    # growth of 1e-4 must not be hidden by the tolerance
    again = roll(PAIRS["E_EP"], ellipse(1, 8e9, E_STAR), replace(mesh, tol=1e-6), 0.0, 2)
    return Results(runs, again, hardening, str(mesh), str(fine))


def stated(results: Results) -> list[Number | Statement]:
    return [*stated_pairs(results), *stated_hardening(results)]


@dataclass(frozen=True)
class Curves:
    """Maximum pressure and maximum plastic strain as functions of the Hertz pressure."""

    p0: np.ndarray
    pressed: np.ndarray
    pressed_gamma: np.ndarray
    rolled: np.ndarray
    rolled_gamma: np.ndarray


def curves(runs: dict[float, Run]) -> Curves:
    p0 = np.array([run.p0 for run in runs.values()])
    return Curves(
        p0,
        np.array([run.loading[-1, 1] for run in runs.values()]) / p0,
        np.array([run.loading[-1, 2] for run in runs.values()]),
        np.array([run.p_max() for run in runs.values()]) / p0,
        np.array([run.steady.peak("gamma")[0] for run in runs.values()]),
    )


def percents(values: np.ndarray) -> str:
    return each(100 * values) + " %"


def stated_pairs(results: Results) -> list[Number | Statement]:
    found = {key: curves(runs) for key, runs in results.runs.items()}
    return [
        *stated_rolled(results, found),
        *stated_second_body(results, found),
        *stated_geometry(results, found),
    ]


def stated_rolled(results: Results, found: dict[Key, Curves]) -> list[Statement]:
    mesh, loads = results.mesh, each(next(iter(results.runs.values())), "g")
    entries = []
    for (pair, k), c in found.items():
        entries.append(
            STATED.trend(
                "pressure rolled",
                bool(np.all(c.rolled > c.pressed)) and c.rolled[-1] > 1.02 * c.pressed[-1],
                percents(c.pressed),
                percents(c.rolled),
                mesh=mesh,
                pair=pair,
                k=k,
                loads=loads,
            )
        )
        entries.append(
            STATED.trend(
                "strain rolled",
                c.rolled_gamma[-1] > 1.15 * c.pressed_gamma[-1]
                and bool(np.all(c.rolled_gamma >= 0.98 * c.pressed_gamma)),
                percents(c.pressed_gamma),
                percents(c.rolled_gamma),
                mesh=mesh,
                pair=pair,
                k=k,
                loads=loads,
            )
        )
    return entries


def stated_second_body(results: Results, found: dict[Key, Curves]) -> list[Statement]:
    entries = []
    for k in (1, 8):
        one, two = found["E_EP", k], found["EP_EP", k]
        lower = [(two.pressed, one.pressed), (two.rolled, one.rolled),
                 (two.pressed_gamma, one.pressed_gamma),
                 (two.rolled_gamma, one.rolled_gamma)]  # fmt: skip
        change = ", ".join(f"{100 * (b[-1] / a[-1] - 1):.1f}" for b, a in lower)
        entries.append(
            STATED.trend(
                "two plastic bodies",
                all(bool(np.all(b < a)) for b, a in lower),
                change.split(", ")[0],
                change.split(", ")[1],
                change.split(", ")[2],
                change.split(", ")[3],
                mesh=results.mesh,
                k=k,
            )
        )
    return entries


def stated_geometry(results: Results, found: dict[Key, Curves]) -> list[Statement]:
    mesh = results.mesh
    round_, long = found["E_EP", 1], found["E_EP", 8]
    say = STATED.on(mesh)
    return [
        say.trend(
            "geometry",
            abs(round_.rolled[-1] / long.rolled[-1] - 1) > 0.01
            and abs(round_.rolled_gamma[-1] / long.rolled_gamma[-1] - 1) > 0.02,
            100 * round_.rolled[-1],
            100 * long.rolled[-1],
            100 * round_.rolled_gamma[-1],
            100 * long.rolled_gamma[-1],
        ),
        say.trend("pressed again", again(results) < 1e-4, 100 * again(results)),
    ]


def again(results: Results) -> float:
    """Return the relative increase of the plastic strain in the second load cycle."""
    first, second = results.again.cycles
    return float(second.gamma.max() / first.gamma.max() - 1)


def lean(run: Run) -> tuple[float, float]:
    """Return the positions x/a of maximum pressure and resultant force under a rolling ball."""
    p = run.pressure_along[-1]
    return top(run.x, p)[1] / run.a, float(np.sum(p * run.x) / np.sum(p)) / run.a


def stated_hardening(results: Results) -> list[Number | Statement]:
    runs, mesh = results.hardening, results.hardening_mesh
    pressed = [run.loading[-1, 1] * 1e-9 for run in runs.values()]
    rolled = [run.p_max() * 1e-9 for run in runs.values()]
    places = [lean(run)[0] for run in runs.values()]
    steady = [float(np.ptp(run.history[-1][-8:, 1])) / run.p_max() for run in runs.values()]
    across = [run.pressure_across[-1] for run in runs.values()]
    side_excess = [float(p.max() / p[len(p) // 2] - 1) for p in across]
    skew = [
        float(np.abs(run.vertical_pressure - run.vertical_pressure[::-1]).max()) / run.p0
        for run in runs.values()
    ]
    name = each(runs, "g")
    say = STATED.on(mesh, which=name)
    return [
        say.trend("hardening pressed", grows(pressed) and pressed[-1] < 5.7, pressed),
        say.trend(
            "hardening rolled", all(r > p for r, p in zip(rolled, pressed, strict=True)), rolled
        ),
        say.trend("steady regime", max(steady) < 0.02, 100 * max(steady)),
        say.trend(
            "pressure place",
            min(places) > 0 and max(skew) < 1e-6,
            places,
            places=[lean(run)[1] for run in runs.values()],
        ),
        say.trend(
            "pressure across",
            max(side_excess) < 0.01 and max(side_excess[1:]) == 0,
            f"; only for E_t = 0 next to the middle, with a pressure {100 * side_excess[0]:.1f} % "
            "above the pressure in the middle"
            if side_excess[0] > 0
            else "",
        ),
    ]


def figures(results: Results) -> list[Picture]:
    return [loads(results), laws(), distributions(results)]


def loads(results: Results) -> Picture:
    figure, ((first, second), (third, fourth)) = axes(2, 2, (9.0, 6.4), sharex=True, sharey="row")
    for n, (pair, k) in enumerate(results.runs):
        c, label = curves(results.runs[pair, k]), f"{pair}, k = {k}"
        x = c.p0 / MICRO_YIELD
        first.plot(x, c.pressed, f"C{n}o-", markersize=3, label=label)
        second.plot(x, c.rolled, f"C{n}o-", markersize=3, label=label)
        third.plot(x, 100 * c.pressed_gamma, f"C{n}o-", markersize=3)
        fourth.plot(x, 100 * c.rolled_gamma, f"C{n}o-", markersize=3)
    for ax, title in ((first, "pressed"), (second, "rolled, second cycle")):
        ax.axhline(1.0, color="k", linestyle="--", linewidth=1, label="E_E (Hertz)")
        ax.set_title(title, fontsize="medium")
    finish(first, "", "maximum pressure / p0")
    finish(second, legend=False)
    finish(third, "p0 / micro-yield stress", "maximum plastic strain [%]", legend=False)
    finish(fourth, "p0 / micro-yield stress", legend=False)
    return Picture(
        "rolling_two_bodies_load",
        "Figure 3.29: maximum pressure and maximum plastic strain versus Hertz pressure p0.",
        figure,
    )


def laws() -> Picture:
    figure, ax = axes(1, 1, (5.0, 3.4))
    strain = np.linspace(0.0, 0.02, 101)
    for slope in SLOPES:
        flat = sc.Material.linear_hardening(STEEL_52100.E, 0.3, MICRO_YIELD, slope * STEEL_52100.E)
        ax.plot(100 * strain, flat.uniaxial_stress(strain) * 1e-9, label=f"{slope:g}")
    finish(ax, "strain [%]", "stress [GPa]")
    ax.legend(fontsize="small", title="$E_t/E$")
    return Picture(
        "rolling_two_bodies_laws",
        "Figure 3.30: stress-strain curves of linear hardening in uniaxial tension.",
        figure,
    )


def distributions(results: Results) -> Picture:
    figure, (left, middle, right) = axes(1, 3, (10.0, 3.8), sharey=True)
    for ax in (left, middle, right):
        hertz_curve(ax, BALL, reach=1.6)
        ax.set_xlim(-1.6, 1.6)
    for slope, run in results.hardening.items():
        label = f"$E_t/E$ = {slope:g}"
        left.plot(run.x / BALL.a, run.vertical_pressure * 1e-9, label=label)
        middle.plot(run.x / BALL.a, run.pressure_along[-1] * 1e-9, label=label)
        right.plot(run.y / BALL.a, run.pressure_across[-1] * 1e-9, label=label)
    left.set_title("pressed", fontsize="medium")
    middle.set_title("rolled to the right", fontsize="medium")
    right.set_title("rolled, across the track", fontsize="medium")
    finish(left, "x/a", "pressure [GPa]")
    finish(middle, "x/a", legend=False)
    finish(right, "y/a", legend=False)
    return Picture(
        "rolling_two_bodies_pressure",
        "Figures 3.31 to 3.33: pressure of a ball that is pressed (left) and of a ball that rolls "
        "to the right, along the track (middle) and across it through the maximum (right).",
        figure,
    )
