# SPDX-License-Identifier: GPL-3.0-or-later
"""Two balls of steel 52100, one or both elastic-plastic: Boucly (2008), section 2.3.1.4."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

import samcontact as sc

from .bodies import ELASTIC, STEEL_52100, STEEL_M50, square, tolerance
from .drawing import axes, finish, hertz_curve
from .page import Picture
from .profiles import succession, top
from .stated import Number, Stated, Statement

STATED = Stated("two_plastic_bodies")
TITLE = "Two elastic-plastic bodies"
INTRODUCTION = """
This page shows the contact of two steel balls of which one or both are elastic-plastic, and
compares the results with section 2.3.1.4 of Boucly's thesis (2008). The balls are made of steel
52100 and have a radius of 15 mm (equivalent radius 7.5 mm). They are loaded with 11 179 N, which
corresponds to a Hertz pressure of 8 GPa. Either one ball is elastic-plastic and the other elastic
(E_EP), or both are elastic-plastic (EP_EP). L is the load, and L_c is the load at which the maximum
equivalent plastic strain reaches 0.2 %. p_max is the maximum pressure. The Hertz pressure p0 and
the Hertz contact radius a are for 11 179 N. Values for loads up to 1900 N are computed on a finer
grid.
"""

RADIUS = 7.5e-3
PEAK = 11179.0
MICRO_YIELD = 1476.7e6  # at a plastic strain of 20e-6
LC = STATED.values("critical load")
PAIRS = {
    "E_EP": (ELASTIC, STEEL_52100),
    "EP_EP": (STEEL_52100, STEEL_52100),
    "M50 against 52100": (STEEL_M50, STEEL_52100),
}
COLOURS = {"E_EP": "C0", "EP_EP": "C3", "M50 against 52100": "C2"}


@dataclass
class Case:
    """Results of a pair of bodies: maxima at each load, fields at maximum load and unloaded."""

    load: np.ndarray
    p_max: np.ndarray
    gamma: np.ndarray
    x: np.ndarray
    pressure: np.ndarray
    z: np.ndarray
    hydrostatic: np.ndarray

    def at(self, load: float) -> tuple[float, float]:
        """Return maximum pressure and plastic strain, interpolated at a load."""
        return (
            float(np.interp(load, self.load, self.p_max)),
            float(np.interp(load, self.load, self.gamma)),
        )

    @property
    def critical(self) -> float:
        """Load at a plastic strain of 0.2 % [N]."""
        return float(np.interp(2e-3, self.gamma, self.load))


@dataclass
class Results:
    cases: dict[str, Case]
    peak: sc.hertz.PointContact
    beyond: tuple[np.ndarray, np.ndarray]
    """Hertz pressures and maximum plastic strains of E_EP, for strains around 2 %."""
    mesh: str
    low_mesh: str


def hertz(load: float) -> sc.hertz.PointContact:
    return sc.hertz.point(
        R=RADIUS, E_star=sc.hertz.effective_modulus(ELASTIC, STEEL_52100), load=load
    )


def simulation(
    pair: str, a: float, cells: int, width: float, depth: float, **options: Any
) -> tuple[sc.Grid, sc.Simulation]:
    grid = square(a, cells, width, depth)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    return grid, sc.Simulation(grid, *PAIRS[pair], gap, **options)


def largest_strain(state: sc.State, pair: str) -> float:
    inelastic = [body for body, material in enumerate(PAIRS[pair], 1) if material.is_plastic]
    return max(float(state.equivalent_plastic_strain(body=b).max()) for b in inelastic)


def compute(quick: bool) -> Results:
    cells, low_cells, low_peak = (12, 12, 1900.0) if quick else (28, 32, 1900.0)
    increments, increment_tol = (8, 1e-2) if quick else (16, 2e-3)
    tol = tolerance(quick)
    peak = hertz(PEAK)
    cases = {}
    beyond: list[tuple[float, float]] = []
    for pair in PAIRS:
        found = []
        _, run = simulation(pair, hertz(low_peak).a, low_cells, 1.4, 1.7, tol=tol)
        for load in np.arange(100.0, low_peak + 1.0, 200.0 if quick else 100.0):
            state = run.step(load=float(load))
            found.append((load, state.pressure.max(), largest_strain(state, pair)))
        grid, run = simulation(pair, peak.a, cells, 1.9, 2.6, tol=tol, increment_tol=increment_tol)
        for load in np.linspace(0.0, PEAK, increments + 1)[1:]:
            state = run.step(load=float(load))
            if load > low_peak:
                found.append((load, state.pressure.max(), largest_strain(state, pair)))
        unloaded = run.step(load=0.0)
        middle = grid.nx // 2
        load, p_max, gamma = np.array(found).T
        hydrostatic = unloaded.hydrostatic()[middle, middle]
        cases[pair] = Case(
            load, p_max, gamma, grid.x, state.pressure[:, middle].copy(), grid.z, hydrostatic
        )
        if pair == "E_EP":  # unloading is elastic and may precede further loading
            beyond = [(peak.p0, float(gamma[-1]))]
            for p0 in (8.12e9, 8.3e9):
                state = run.step(load=sc.hertz.point(R=RADIUS, E_star=peak.E_star, p0=p0).load)
                beyond.append((p0, largest_strain(state, pair)))
    pressures, strains = np.array(beyond).T
    return Results(
        cases, peak, (pressures, strains), f"a/{cells}", f"a/{low_cells}, a at {low_peak:.0f} N"
    )


def difference(results: Results, other: str) -> tuple[np.ndarray, np.ndarray]:
    """Return loads, and the difference of p_max between two pairs, E_EP and `other` [%].

    The difference is defined by equation (2.168) of the thesis.
    """
    one, two = results.cases["E_EP"], results.cases[other]
    return one.load, 100 * np.abs(one.p_max / two.p_max - 1)


def stated(results: Results) -> list[Number | Statement]:
    peak, cases = results.peak, results.cases
    return [
        STATED.number("peak pressure", peak.p0 * 1e-9),
        STATED.number("peak radius", peak.a * 1e6),
        *(
            STATED.number("critical load", cases[pair].critical, mesh=results.low_mesh, at=pair)
            for pair in LC
        ),
        *stated_pressure(results),
        *stated_axis(results),
        *stated_beyond(results),
    ]


def stated_pressure(results: Results) -> list[Number | Statement]:
    two, mesh, low_mesh = results.cases["EP_EP"], results.mesh, results.low_mesh
    at_lc = two.at(LC["EP_EP"])[0] / hertz(LC["EP_EP"]).p0
    load, percent = difference(results, "EP_EP")
    below = float(percent[load <= LC["EP_EP"]].max())
    other = float(difference(results, "M50 against 52100")[1][-1])
    say = STATED.on(low_mesh)
    return [
        say.number("pressure at the critical load", at_lc),
        say.trend("pressure below the critical load", below < 3, below),
        say.number("peak pressure of one", float(percent[-1]), mesh=mesh),
        say.trend("two hardening laws", other < percent[-1], other, percent[-1], mesh=mesh),
    ]


def stated_axis(results: Results) -> list[Number | Statement]:
    """Return the statements on the residual hydrostatic stress on the axis."""
    one, two = results.cases["E_EP"], results.cases["EP_EP"]
    a, p0, mesh = results.peak.a, results.peak.p0, results.mesh
    (low, depth), (low2, depth2) = (top(c.z / a, -c.hydrostatic / p0) for c in (one, two))
    value, value2 = -low, -low2
    signs = {pair: ", ".join(succession(results.cases[pair].hydrostatic, 1e-3 * p0)) for pair in LC}
    expected = "compressive, tensile, compressive, tensile"
    gaps = [
        abs(np.max(one.hydrostatic[part]) - np.max(two.hydrostatic[part])) / p0
        for part in (one.z < 0.4 * a, one.z > a)
    ]
    say = STATED.on(mesh)
    return [
        say.number("compression depth", depth),
        say.trend("compression depth of both", min(depth, depth2) > 0.5, depth, depth2),
        say.trend("compression", value < value2, value, value2),
        say.trend(
            "hydrostatic",
            all(found == expected for found in signs.values()),
            "; ".join((f"{pair}: {found}" for pair, found in signs.items())),
            thesis=expected,
        ),
        say.trend(
            "tension", max(gaps) < 0.25 * abs(value - value2), max(gaps), abs(value - value2)
        ),
    ]


def stated_beyond(results: Results) -> list[Number | Statement]:
    pressures, strains = results.beyond
    p0 = float(np.interp(0.02, strains, pressures))
    say = STATED.on(results.mesh)
    return [
        say.number("pressure at 2 %", p0 * 1e-9),
        say.number("pressure over yield", p0 / MICRO_YIELD),
    ]


def figures(results: Results) -> list[Picture]:
    return [fields(results), loads(results), differences(results)]


def fields(results: Results) -> Picture:
    a, p0 = results.peak.a, results.peak.p0
    figure, (left, right) = axes()
    hertz_curve(left, results.peak, p0)
    for pair in LC:
        case = results.cases[pair]
        left.plot(case.x / a, case.pressure / p0, color=COLOURS[pair], label=pair)
        right.plot(case.z / a, case.hydrostatic / p0, color=COLOURS[pair], label=pair)
    left.set_xlim(-1.5, 1.5)
    right.axvline(
        0.68, color="k", linestyle="--", linewidth=1, label="Boucly (2008): minimum, 0.68"
    )
    right.axvline(0.48, color="k", linestyle=":", linewidth=1, label="Hertz depth, 0.48")
    right.axhline(0, color="k", linewidth=0.6)
    finish(left, "x/a", "pressure / Hertz pressure")
    finish(right, "depth z/a", "residual hydrostatic stress / Hertz pressure")
    return Picture(
        "two_plastic_bodies_fields",
        "Figures 2.16 and 2.17: pressure at 11 179 N (8 GPa) in the plane y = 0, and residual "
        "hydrostatic stress on the axis.",
        figure,
    )


def loads(results: Results) -> Picture:
    p0 = results.peak.p0
    figure, (left, right) = axes()
    strain_axis = left.twinx()
    load = np.linspace(1.0, PEAK, 300)
    elastic = np.array([hertz(w).p0 for w in load])
    left.plot(load * 1e-3, elastic * 1e-9, "k--", linewidth=1, label="Hertz")
    right.plot(load / LC["EP_EP"], elastic / p0, "k--", linewidth=1, label="Hertz")
    for pair in LC:
        case, colour = results.cases[pair], COLOURS[pair]
        left.plot(case.load * 1e-3, case.p_max * 1e-9, color=colour, label=pair)
        strain_axis.plot(case.load * 1e-3, 100 * case.gamma, color=colour, linestyle="-.")
        strain_axis.plot(LC[pair] * 1e-3, 0.2, "o", color=colour, markerfacecolor="none")
        right.plot(case.load / LC["EP_EP"], case.p_max / p0, color=colour, label=pair)
    strain_axis.axhline(0.2, color="k", linestyle=":", linewidth=1)
    strain_axis.set_ylabel("maximum plastic strain [%], dash-dotted")
    strain_axis.set_ylim(0, 3)
    finish(left, "load [kN]", "maximum pressure [GPa]")
    right.plot(
        1, 0.95 * hertz(LC["EP_EP"]).p0 / p0, "o", color="k", markerfacecolor="none",
        label="Boucly (2008): 5 % below Hertz",
    )  # fmt: skip
    finish(right, "load $L/L_c$", "maximum pressure / 8 GPa")
    return Picture(
        "two_plastic_bodies_load",
        "Figures 2.18 and 2.19: maximum pressure and maximum plastic strain versus load. Circles "
        "on the left: loads L_c at a strain of 0.2 % in the thesis. L_c on the right: 1743 N, the "
        "value of the thesis for EP_EP.",
        figure,
    )


def differences(results: Results) -> Picture:
    figure, ax = axes(1, 1, (5.0, 3.6))
    for pair, label in (("EP_EP", "both 52100"), ("M50 against 52100", "M50 and 52100")):
        load, percent = difference(results, pair)
        ax.plot(load / LC["EP_EP"], percent, color=COLOURS[pair], label=label)
    ax.plot([0, 1], [3, 3], "k--", linewidth=1, label="Boucly (2008): below 3 % for $L < L_c$")
    ax.plot(PEAK / LC["EP_EP"], 11, "ko", markerfacecolor="none", label="Boucly (2008): 11 %")
    ylabel = "excess of $p_{max}$ of E_EP over $p_{max}$\nof two elastic-plastic bodies [%]"
    finish(ax, "load $L/L_c$", ylabel)
    return Picture(
        "two_plastic_bodies_difference",
        "Figure 2.20: error of the maximum pressure if one of two elastic-plastic bodies is taken "
        "as elastic. For M50 and 52100, the harder M50 is taken as elastic. L_c is 1743 N.",
        figure,
    )
