# SPDX-License-Identifier: GPL-3.0-or-later
"""Statements of Boucly (2008) on transient heat, compared with the computed values."""

from __future__ import annotations

import math

import numpy as np

from ..stated import Number, Stated, Statement
from .setups import (
    CONDUCTIVITY,
    DIFFUSIVITY,
    FACTOR,
    HERTZ,
    KINDS,
    LOAD,
    NAMES,
    SPEED,
    TIME,
    Elastic,
    Results,
)

STATED = Stated("transient_heat")


def still_missing(time: float) -> float:
    """Return the temperature [K] by which a stationary source is below its steady state.

    Long times t are assumed, and the temperature Q/(2 pi k r) erfc(r/sqrt(4 kappa t)) due to a
    point source: Carslaw & Jaeger (1959), section 10.4.
    """
    heat = FACTOR * LOAD
    return heat / (2 * math.pi * CONDUCTIVITY * math.sqrt(math.pi * DIFFUSIVITY * time))


def moving_source() -> float:
    """Return the maximum temperature rise of a moving parabolic source [K], Tian & Kennedy 1994."""
    flux = FACTOR * LOAD / (math.pi * HERTZ.a**2)
    peclet = SPEED * HERTZ.a / (2 * DIFFUSIVITY)
    return 2.32 * flux * HERTZ.a / (CONDUCTIVITY * math.sqrt(math.pi * (1.273 + peclet)))


def stated(results: Results) -> list[Number | Statement]:
    return [*stated_steady(results), *stated_rise(results), *stated_stress(results)]


def tops(results: Results) -> dict[str, float]:
    """Return the maximum elastic pressure of each case [GPa]."""
    return {kind: float(case.pressure.max()) * 1e-9 for kind, case in results.elastic.items()}


def stated_steady(results: Results) -> list[Number | Statement]:
    mesh, top = results.mesh["elastic"], tops(results)
    rise = {kind: results.elastic[kind].hottest for kind in NAMES}
    steady, time = rise["(ii)"][0], float(results.times[-1])
    missing = (steady - results.rises[-1], still_missing(time))
    pressure_error = results.pressures[-1] * 1e-9 / top["(ii)"] - 1
    say = STATED.on(mesh)
    return [
        say.number("hertz pressure", HERTZ.p0 * 1e-9),
        say.number("contact radius", HERTZ.a * 1e6),
        say.number("pressure without heat", top["no heat"]),
        say.trend(
            "steady state",
            missing[0] < 1e-3 * steady
            and abs(pressure_error) < 1e-3
            and abs(missing[0] / missing[1] - 1) < 0.02,
            time,
            missing[0],
            missing[0] / steady,
            abs(pressure_error),
            missing[1],
            rise=100 * (1 - rise["(i)"][0] / steady),
        ),
    ]


def stated_rise(results: Results) -> list[Number | Statement]:
    a, mesh, case = HERTZ.a, results.mesh["elastic"], results.elastic
    rise = {kind: case[kind].hottest for kind in NAMES}
    estimate = moving_source()
    settled = float(np.abs(results.steady.flash / case["(iii)"].flash - 1).max())
    say = STATED.on(mesh)
    return [
        say.trend(
            "temperature rise",
            rise["(iii)"][0] < rise["(i)"][0] < rise["(ii)"][0],
            ", ".join((f"{value:.0f} K" for value, _ in rise.values())),
        ),
        say.trend(
            "moving rise", abs(rise["(iii)"][0] / estimate - 1) < 0.08, rise["(iii)"][0], estimate
        ),
        say.trend(
            "moving place",
            -1.0 < rise["(iii)"][1] / a < -0.4 and ahead(case["(iii)"]) < 0.01 * rise["(iii)"][0],
            rise["(iii)"][1] / a,
            ahead(case["(iii)"]),
        ),
        say.trend("moving steady state", settled < 1e-3, settled, SPEED * TIME / a),
    ]


def stated_stress(results: Results) -> list[Number | Statement]:
    a, mesh, top = HERTZ.a, results.mesh["elastic"], tops(results)
    case, plastic = results.elastic, results.plastic
    say = STATED.on(mesh)
    return [
        say.trend(
            "pressure",
            top["no heat"] < top["(iii)"] < 1.1 * top["no heat"] < top["(i)"] < top["(ii)"],
            ", ".join(f"{top[kind]:.2f} GPa" for kind in NAMES),
            top["no heat"],
        ),
        say.trend(
            "thermo-elastic stress",
            case["(i)"].largest[2] == case["(ii)"].largest[2] == 0 < case["(iii)"].largest[2],
            "; ".join(where(case[kind].largest) for kind in NAMES),
            where(case["no heat"].largest),
        ),
        say.trend(
            "elastic-plastic stress",
            plastic["(i)"].largest[2] < 0.25 * a and plastic["(iii)"].largest[2] > 0.35 * a,
            "; ".join(where(plastic[kind].largest) for kind in NAMES),
            where(plastic["no heat"].largest),
            mesh=results.mesh["plastic"],
        ),
        say.trend(
            "plastic strain",
            plastic["(i)"].gamma < plastic["(ii)"].gamma < 0.05,
            "; ".join(
                f"{100 * one.gamma:.2f} %, {1e-6 * one.residual:.0f} MPa ({kind.strip('()')})"
                for kind, one in ((kind, plastic[kind]) for kind in KINDS)
            ),
            mesh=results.mesh["plastic"],
        ),
    ]


def ahead(case: Elastic) -> float:
    return float(np.interp(1.5 * HERTZ.a, case.x, case.flash))


def where(found: tuple[float, float, float]) -> str:
    stress, x, z = found
    a = HERTZ.a
    return f"{stress * 1e-6:.0f} MPa at x/a = ±{abs(x) / a:.2f}, z/a = {z / a:.2f}"
