# SPDX-License-Identifier: GPL-3.0-or-later
"""What the thesis states about transient heat, beside what was computed."""

from __future__ import annotations

import math

import numpy as np

from ..page import Number, Statement
from .scenes import (
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


def still_missing(time: float) -> float:
    """What a source at rest lacks of its steady temperature after a long time [K].

    A point source has Q/(2 pi k r) erfc(r/sqrt(4 kappa t)): Carslaw & Jaeger (1959), section 10.4.
    """
    heat = FACTOR * LOAD
    return heat / (2 * math.pi * CONDUCTIVITY * math.sqrt(math.pi * DIFFUSIVITY * time))


def moving_source() -> float:
    """Largest rise below a parabolic source that moves [K], Tian & Kennedy (1994)."""
    flux = FACTOR * LOAD / (math.pi * HERTZ.a**2)
    peclet = SPEED * HERTZ.a / (2 * DIFFUSIVITY)
    return 2.32 * flux * HERTZ.a / (CONDUCTIVITY * math.sqrt(math.pi * (1.273 + peclet)))


def stated(results: Results) -> list[Number | Statement]:
    return [*stated_steady(results), *stated_rise(results), *stated_stress(results)]


def tops(results: Results) -> dict[str, float]:
    """Largest elastic pressures [GPa]."""
    return {kind: float(case.pressure.max()) * 1e-9 for kind, case in results.elastic.items()}


def stated_steady(results: Results) -> list[Number | Statement]:
    mesh, top = results.mesh["elastic"], tops(results)
    rise = {kind: results.elastic[kind].hottest for kind in NAMES}
    steady, time = rise["(ii)"][0], float(results.times[-1])
    missing = (steady - results.rises[-1], still_missing(time))
    pressure_error = results.pressures[-1] * 1e-9 / top["(ii)"] - 1
    return [
        Number("Hertz pressure", 6.5, HERTZ.p0 * 1e-9, "GPa", "closed form"),
        Number("its contact radius", 332.0, HERTZ.a * 1e6, "µm", "closed form"),
        Number("largest pressure without heat", 6.5, top["no heat"], "GPa", mesh, tolerance=0.01),
        Statement(
            "time of observation set to infinity",
            "the steady state is reached",
            f"at {time:.0f} s the largest rise is {missing[0]:.2f} K ({missing[0] / steady:.1e}) "
            f"below the steady one, the largest pressure {abs(pressure_error):.0e}; a point source "
            f"lacks {missing[1]:.2f} K",
            missing[0] < 1e-3 * steady
            and abs(pressure_error) < 1e-3
            and abs(missing[0] / missing[1] - 1) < 0.02,
            mesh,
            remark="With the square root of time: after 23 ms "
            f"{100 * (1 - rise['(i)'][0] / steady):.0f} % of the rise is missing.",
        ),
    ]


def stated_rise(results: Results) -> list[Number | Statement]:
    a, mesh, case = HERTZ.a, results.mesh["elastic"], results.elastic
    rise = {kind: case[kind].hottest for kind in NAMES}
    estimate = moving_source()
    settled = float(np.abs(results.steady.flash / case["(iii)"].flash - 1).max())
    return [
        Statement(
            "largest rise of temperature in (i), (ii), (iii)",
            "maps, no numbers",
            ", ".join(f"{value:.0f} K" for value, _ in rise.values()),
            rise["(iii)"][0] < rise["(i)"][0] < rise["(ii)"][0],
            mesh,
        ),
        Statement(
            "(iii): largest rise",
            "not stated",
            f"{rise['(iii)'][0]:.0f} K; {estimate:.0f} K by the formula of Tian and Kennedy for a "
            "parabolic source with the radius a",
            abs(rise["(iii)"][0] / estimate - 1) < 0.08,
            mesh,
            remark="That formula is a fit, 1.5 % below the exact value of a semi-ellipsoidal "
            "source without motion.",
        ),
        Statement(
            "(iii): place of the largest rise",
            "not stated",
            f"behind the centre, at x/a = {rise['(iii)'][1] / a:.2f}; ahead of the contact "
            f"(x/a = 1.5) {ahead(case['(iii)']):.1f} K",
            -1.0 < rise["(iii)"][1] / a < -0.4 and ahead(case["(iii)"]) < 0.01 * rise["(iii)"][0],
            mesh,
        ),
        Statement(
            "(iii) at 23 ms against its steady state",
            "not stated",
            f"flash temperature {settled:.0e} apart: the tool has moved {SPEED * TIME / a:.0f} a",
            settled < 1e-3,
            mesh,
        ),
    ]


def stated_stress(results: Results) -> list[Number | Statement]:
    a, mesh, top = HERTZ.a, results.mesh["elastic"], tops(results)
    case, plastic = results.elastic, results.plastic
    return [
        Statement(
            "largest pressure in (i), (ii), (iii)",
            "not stated",
            ", ".join(f"{top[kind]:.2f} GPa" for kind in NAMES)
            + f", without heat {top['no heat']:.2f}",
            top["no heat"] < top["(iii)"] < 1.1 * top["no heat"] < top["(i)"] < top["(ii)"],
            mesh,
            remark="The flux is the same, but the flat carries the heat away, and bulges behind "
            "the tool: that widens the contact there.",
        ),
        Statement(
            "thermo-elastic: largest von Mises stress in (i), (ii), (iii)",
            "maps, no numbers",
            "; ".join(where(case[kind].largest) for kind in NAMES)
            + f"; without heat {where(case['no heat'].largest)}",
            case["(i)"].largest[2] == case["(ii)"].largest[2] == 0 < case["(iii)"].largest[2],
            mesh,
        ),
        Statement(
            "elastic-plastic: the same",
            "maps, no numbers",
            "; ".join(where(plastic[kind].largest) for kind in NAMES)
            + f"; without heat {where(plastic['no heat'].largest)}",
            plastic["(i)"].largest[2] < 0.25 * a and plastic["(iii)"].largest[2] > 0.35 * a,
            results.mesh["plastic"],
        ),
        Statement(
            "largest plastic strain; largest residual von Mises stress",
            "not stated",
            "; ".join(
                f"{100 * plastic[kind].gamma:.2f} %, {plastic[kind].residual * 1e-6:.0f} MPa "
                f"({kind.strip('()')})"
                for kind in KINDS
            ),
            plastic["(i)"].gamma < plastic["(ii)"].gamma < 0.05,
            results.mesh["plastic"],
            remark="The residual stress at the surface depends on the thickness of the layers: see "
            "[frictional heat](heat.md).",
        ),
    ]


def ahead(case: Elastic) -> float:
    return float(np.interp(1.5 * HERTZ.a, case.x, case.flash))


def where(found: tuple[float, float, float]) -> str:
    stress, x, z = found
    a = HERTZ.a
    return f"{stress * 1e-6:.0f} MPa at |x|/a = {abs(x) / a:.2f}, z/a = {z / a:.2f}"
