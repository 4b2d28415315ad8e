# SPDX-License-Identifier: GPL-3.0-or-later
"""Statements of Boucly (2008) on friction, compared with the computed values."""

from __future__ import annotations

import math

import numpy as np

import samcontact as sc
from reference import fem

from ..bodies import MICRO_STRAIN, STEEL_M50
from ..profiles import succession
from ..stated import Number, Stated, Statement
from .setups import F1_FRICTION, HERTZ_DEPTH, MICRO_YIELD, RADIUS, SHOWN, Elastic, Plastic, Results

STATED = Stated("friction")


def peak_position(x: np.ndarray, pressure: np.ndarray) -> float:
    """Return the position of the maximum of a profile, by a parabola through five cells."""
    k = int(pressure.argmax())
    c = np.polyfit(x[k - 2 : k + 3], pressure[k - 2 : k + 3], 2)
    return float(-c[1] / (2 * c[0]))


def contact_radius(x: np.ndarray, pressure: np.ndarray) -> float:
    """Return the contact radius, by a line fitted to squared pressure over squared distance."""
    rim = (x > 0.75) & (x < 0.95)
    slope, at_centre = np.polyfit(x[rim] ** 2, pressure[rim] ** 2, 1)
    return float(np.sqrt(-at_centre / slope))


def crossing(mu: list[float], difference: list[float]) -> float:
    """Return the first µ at which a difference changes from negative to positive, interpolated."""
    for k in range(1, len(mu)):
        if difference[k - 1] < 0 <= difference[k]:
            share = difference[k - 1] / (difference[k - 1] - difference[k])
            return mu[k - 1] + share * (mu[k] - mu[k - 1])
    return math.nan


def surface_jump() -> float:
    """Return the friction coefficient above which a Hertz contact yields first at the surface."""
    low, high = 0.2, 0.4
    while high - low > 1e-6:
        mu = 0.5 * (low + high)
        below = sc.critical.onset_sliding(1.0, 1.0, 0.3, 1.0, mu).z > 0
        low, high = (mu, high) if below else (low, mu)
    return low


def stated(results: Results) -> list[Number | Statement]:
    return [*stated_rigid(results), *stated_elastic_ball(results), *stated_residual(results)]


def stated_rigid(results: Results) -> list[Number | Statement]:
    a = results.rigid.a
    entries: list[Number | Statement] = [
        STATED.number("rigid pressure", results.rigid.p0 * 1e-9),
        STATED.number("rigid radius", a * 1e6),
    ]
    for name, cases, mesh_name in (
        ("elastic", results.elastic, "elastic"),
        ("elastic-plastic", results.plastic, "rigid ball"),
    ):
        shift = [peak_position(cases[mu].x, cases[mu].pressure) / a for mu in F1_FRICTION]
        entries.append(
            STATED.trend(
                "pressure shift",
                abs(shift[0]) < 1e-3 and shift[2] < shift[1] < -0.02,
                [round(s, 3) + 0.0 for s in shift],
                mesh=results.mesh[mesh_name],
                at=name,
            )
        )
    depth = {mu: results.elastic[mu].largest_at[1] / a for mu in F1_FRICTION}
    entries += [
        STATED.trend(
            "elastic depth",
            depth[0.0] > 0.3 and depth[0.2] > 0.3 and depth[0.4] == 0.0,
            ", ".join(f"z/a = {depth[mu]:.2f} (µ = {mu:g})" for mu in F1_FRICTION),
            mesh=results.mesh["elastic"],
        ),
        STATED.number("elastic surface friction", surface_jump()),
    ]
    return [*entries, *without_friction(results)]


def without_friction(results: Results) -> list[Number | Statement]:
    """Compare the rigid ball with the elastic contact and with finite elements."""
    a, mesh = results.rigid.a, results.mesh["rigid ball"]
    both: tuple[Elastic, Plastic] = (results.elastic[0.0], results.plastic[0.0])
    top = [float(case.pressure.max()) * 1e-9 for case in both]
    edge = [contact_radius(case.x / a, case.pressure) for case in both]
    curves = fem.load("2a")
    r, p, axis = curves.pressure_r["r_m"], curves.pressure_r["p_Pa"], curves.axis_loaded
    ours, z = results.plastic[0.0], axis["z_m"]
    inside = (ours.x > 0) & (ours.x < 0.9 * a)
    rms = {
        "pressure": deviation(ours.x[inside], ours.pressure[inside], r, p),
        "von Mises stress": deviation(ours.z, ours.von_mises, z, axis["vonMises_Pa"]),
        "plastic strain": deviation(ours.z, ours.gamma, z, axis["gamma_p"]),
    }
    say = STATED.on(mesh)
    return [
        say.trend(
            "plasticity",
            top[1] < 0.98 * top[0] and edge[1] > edge[0],
            top[1],
            top[0],
            edge[1],
            edge[0],
        ),
        say.trend(
            "finite elements",
            all(value < 0.02 for value in rms.values()),
            ", ".join((f"{name} {100 * value:.2f} %" for name, value in rms.items())),
        ),
    ]


def deviation(x: np.ndarray, ours: np.ndarray, at: np.ndarray, theirs: np.ndarray) -> float:
    """Return the rms difference of two profiles, relative to the maximum of the second profile."""
    return float(np.sqrt(np.mean((ours - np.interp(x, at, theirs)) ** 2)) / theirs.max())


def by_friction(values: dict[float, float], form: str = ".2f") -> str:
    return ", ".join(f"{value:{form}} (µ = {mu:g})" for mu, value in values.items())


def bound(mu: float, pressure: float) -> float:
    """Return the minimum plastic strain at a surface point under a pressure p and the shear µp.

    The von Mises stress is at least sqrt(3) µp there, and must not exceed the yield stress.
    """
    B, C, n = (float(STEEL_M50.parameters[name]) for name in "BCn")
    return max(0.0, float((math.sqrt(3) * mu * pressure / B) ** (1 / n)) - C) * 1e-6


def stated_elastic_ball(results: Results) -> list[Number | Statement]:
    return [
        *stated_onset(results),
        stated_first_layer(results),
        *stated_depths(results),
        *stated_maximum(results),
    ]


def stated_onset(results: Results) -> list[Number | Statement]:
    ball, mesh, sliding = results.ball, results.mesh["elastic ball"], results.sliding
    at_rest = sc.critical.onset(RADIUS, ball.E_star, 0.3, MICRO_YIELD)
    last = sc.critical.onset_sliding(RADIUS, ball.E_star, 0.3, MICRO_YIELD, 0.5)
    return [
        STATED.number("elastic ball pressure", ball.p0 * 1e-9),
        STATED.number("micro yield stress", MICRO_YIELD * 1e-6),
        STATED.number("yield stress gamma", float(STEEL_M50.yield_stress(2e-3)) * 1e-6),
        STATED.number("interference", ball.approach / at_rest.interference),
        STATED.trend(
            "critical load interference",
            last.load < 0.5 * at_rest.load,
            last.load / at_rest.load,
            last.interference / at_rest.interference,
        ),
        STATED.number("largest plastic strain", 100 * sliding[0.0].gamma_max[-1], mesh=mesh),
    ]


def stated_first_layer(results: Results) -> Statement:
    least = bound(0.5, float(results.sliding[0.5].pressure.max()))
    depth, gamma = np.array(results.layers).T
    there = float(np.interp(0.0534, gamma, depth))
    return STATED.trend(
        "sliding strain",
        gamma.min() < 0.0534 < gamma.max() and 0.03 < there < 0.05,
        ", ".join((f"{100 * g:.1f} % (first layer at {z:.4f} a)" for z, g in results.layers)),
        there,
        layers=2 * there * results.ball.a * 1e6,
        least=100 * least,
    )


def stated_depths(results: Results) -> list[Statement]:
    a, mesh, sliding = results.ball.a, results.mesh["elastic ball"], results.sliding
    depths = {mu: sliding[mu].gamma_at[1] for mu in SHOWN}
    first = float(sliding[0.0].z[0])
    frictionless = sliding[0.0]
    outside = (frictionless.gamma == 0) & (frictionless.z > HERTZ_DEPTH * a)
    z = frictionless.z[outside]
    radial, axial = results.ball.axis_stress(z, 0.3)
    error = float(np.abs(frictionless.von_mises[outside] / np.abs(axial - radial) - 1).max())
    say = STATED.on(mesh)
    return [
        say.trend(
            "strain depth",
            depths[0.4] == depths[0.5] == first and abs(depths[0.0] / a - HERTZ_DEPTH) < 0.05,
            by_friction({mu: depths[mu] / a for mu in SHOWN}),
            first / a,
        ),
        say.trend("stress below the zone", error < 0.05, 100 * error),
    ]


def rivals(case: Plastic, a: float) -> tuple[float, float]:
    """Return the maxima of the von Mises stress above and below the depth z = 0.2 a."""
    near = case.z < 0.2 * a
    return float(case.largest_by_depth[near].max()), float(case.largest_by_depth[~near].max())


def stated_maximum(results: Results) -> list[Number | Statement]:
    a, mesh, sliding = results.ball.a, results.mesh["elastic ball"], results.sliding
    range_ = [mu for mu in sorted(sliding) if 0.25 <= mu <= 0.4]
    pairs = [rivals(sliding[mu], a) for mu in range_]
    jump = crossing(range_, [near - below for near, below in pairs])
    ahead = {mu: sliding[mu].von_mises_at[1] / a for mu in sorted(sliding)}
    shown = by_friction({mu: ahead[mu] for mu in SHOWN})
    say = STATED.on(mesh)
    return [
        say.number("surface friction", jump),
        say.trend(
            "stress place",
            ahead[0.0] == 0 < ahead[0.1] < ahead[0.2] < ahead[0.3]
            and ahead[0.35] < 0
            and ahead[0.35] < ahead[0.5] <= 0,
            shown,
        ),
    ]


def stated_residual(results: Results) -> list[Number | Statement]:
    return [*stated_residual_von_mises(results), *stated_residual_hydrostatic(results)]


def stated_residual_von_mises(results: Results) -> list[Statement]:
    a, mesh, sliding = results.ball.a, results.mesh["elastic ball"], results.sliding
    both = sorted(mu for mu in sliding if mu >= 0.2)
    near = {mu: float(sliding[mu].residual[sliding[mu].z < 0.2 * a].max()) for mu in both}
    deep = {mu: at_hertz_depth(sliding[mu], a) for mu in both}
    exceeds = crossing(both, [near[mu] - deep[mu] for mu in both])
    reach = {mu: float(sliding[mu].gamma[0]) for mu in sorted(sliding)}
    mus = [mu for mu in reach if reach[mu] > 0 and mu <= 0.3]
    reaches = crossing(mus, [math.log(reach[mu] / MICRO_STRAIN) for mu in mus])
    rest, z = sliding[0.0].residual * 1e-6, sliding[0.0].z
    zones = rest[0], rest[z < HERTZ_DEPTH * a].min(), rest[z > 0.3 * a].max()
    say = STATED.on(mesh)
    return [
        say.trend(
            "residual zones", zones[1] < 0.2 * min(zones[0], zones[2]), zones[0], zones[1], zones[2]
        ),
        say.trend(
            "residual at surface",
            near[0.3] < deep[0.3] and near[0.4] > deep[0.4],
            ", ".join(
                f"{near[m] * 1e-6:.0f}/{deep[m] * 1e-6:.0f} MPa (µ = {m:g})"
                for m in (0.2, 0.3, 0.4, 0.5)
            ),
            exceeds,
        ),
        say.trend(
            "residual at Hertz depth",
            deep[0.5] < 0.85 * deep[0.4] and deep[0.4] > 0.9 * deep[0.2],
            ", ".join(f"{deep[m] * 1e-6:.0f} MPa (µ = {m:g})" for m in (0.2, 0.3, 0.4, 0.5)),
        ),
        say.trend("zone reaches surface", 0.15 < reaches < 0.25, reaches),
    ]


def stated_residual_hydrostatic(results: Results) -> list[Statement]:
    a, mesh, sliding = results.ball.a, results.mesh["elastic ball"], results.sliding
    both = sorted(mu for mu in sliding if mu >= 0.2)
    quiet = {mu: quiescent(sliding[mu], a) for mu in both}
    turns = crossing(both, [-quiet[mu] for mu in both])
    by_load = results.by_load
    amplitude = [float(np.ptp(by_load[load])) * 1e-6 for load in sorted(by_load)]
    signs = {
        load: succession(by_load[load], 0.02 * float(np.abs(by_load[load]).max()))
        for load in sorted(by_load)
    }
    expected = ["compressive", "tensile", "compressive", "tensile"]
    say = STATED.on(mesh)
    return [
        say.trend(
            "hydrostatic",
            all(signs[load] == expected for load in (4000.0, 5000.0)),
            "; ".join(
                (
                    f"{load:.0f} N: {', '.join(found)}"
                    for load, found in signs.items()
                    if load >= 4000.0
                )
            ),
            thesis=", ".join(expected),
        ),
        say.trend("hydrostatic amplitude", amplitude == sorted(amplitude), amplitude),
        say.trend(
            "quiescent zone",
            0.2 < turns < 0.3,
            ", ".join(f"{quiet[mu] * 1e-6:.0f} MPa (µ = {mu:g})" for mu in (0.2, 0.25, 0.3)),
            turns,
        ),
    ]


def at_hertz_depth(case: Plastic, a: float) -> float:
    return float(np.interp(HERTZ_DEPTH * a, case.z, case.residual))


def quiescent(case: Plastic, a: float) -> float:
    """Return the maximum hydrostatic residual stress between the surface and the Hertz depth."""
    between = (case.z > 0.04 * a) & (case.z < 0.4 * a)
    return float(case.hydrostatic[between].max())
