# SPDX-License-Identifier: GPL-3.0-or-later
"""What the thesis states about friction, beside what was computed."""

from __future__ import annotations

import math

import numpy as np

import samcontact as sc
from reference import fem

from ..bodies import MICRO_STRAIN, STEEL_M50
from ..page import Number, Statement
from ..profiles import each, succession
from .scenes import F1_FRICTION, HERTZ_DEPTH, MICRO_YIELD, RADIUS, SHOWN, Elastic, Plastic, Results


def peak_position(x: np.ndarray, pressure: np.ndarray) -> float:
    """Where a profile has its maximum, by a parabola through five cells."""
    k = int(pressure.argmax())
    c = np.polyfit(x[k - 2 : k + 3], pressure[k - 2 : k + 3], 2)
    return float(-c[1] / (2 * c[0]))


def contact_radius(x: np.ndarray, pressure: np.ndarray) -> float:
    """Where the pressure ends: its square falls linearly with the square of the distance."""
    rim = (x > 0.75) & (x < 0.95)
    slope, at_centre = np.polyfit(x[rim] ** 2, pressure[rim] ** 2, 1)
    return float(np.sqrt(-at_centre / slope))


def crossing(mu: list[float], difference: list[float]) -> float:
    """First µ at which a difference turns from negative to positive (linear between values)."""
    for k in range(1, len(mu)):
        if difference[k - 1] < 0 <= difference[k]:
            share = difference[k - 1] / (difference[k - 1] - difference[k])
            return mu[k - 1] + share * (mu[k] - mu[k - 1])
    return math.nan


def surface_jump() -> float:
    """Friction above which a sliding Hertz contact yields first at its surface, ν = 0.3."""
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
        Number("800 N, rigid ball: Hertz pressure", 4.35, results.rigid.p0 * 1e-9, "GPa",
               "closed form"),
        Number("its contact radius", 296.0, a * 1e6, "µm", "closed form"),
    ]  # fmt: skip
    for name, cases, mesh_name in (
        ("elastic", results.elastic, "elastic"),
        ("elastic-plastic", results.plastic, "rigid ball"),
    ):
        shift = [peak_position(cases[mu].x, cases[mu].pressure) / a for mu in F1_FRICTION]
        entries.append(
            Statement(
                f"pressure with µ = 0, 0.2, 0.4, {name}",
                "asymmetric with µ, maximum shifted in the direction of the traction",
                "maximum at x/a = " + ", ".join(f"{round(s, 3) + 0.0:.3f}" for s in shift),
                abs(shift[0]) < 1e-3 and shift[2] < shift[1] < -0.02,
                results.mesh[mesh_name],
                remark="That is the direction of the traction on the ball, -x; the text does not "
                "say on which body. The surface of the half-space sinks ahead of a shear along +x "
                "and rises behind it (Cerruti), so a rigid ball presses more behind its centre."
                if name == "elastic"
                else "",
            )
        )
    depth = {mu: results.elastic[mu].largest_at[1] / a for mu in F1_FRICTION}
    entries += [
        Statement(
            "elastic: largest von Mises stress",
            "at the surface for µ > 0.3",
            ", ".join(f"z/a = {depth[mu]:.2f} (µ = {mu:g})" for mu in F1_FRICTION),
            depth[0.0] > 0.3 and depth[0.2] > 0.3 and depth[0.4] == 0.0,
            results.mesh["elastic"],
        ),
        Number(
            "friction above which the largest elastic von Mises stress is at the surface",
            0.3, surface_jump(), "", "closed form",
            remark="Hertz pressure with the shear µp, `samcontact.critical.onset_sliding`.",
        ),
    ]  # fmt: skip
    return [*entries, *without_friction(results)]


def without_friction(results: Results) -> list[Number | Statement]:
    """The rigid ball beside the elastic contact and finite elements."""
    a, mesh = results.rigid.a, results.mesh["rigid ball"]
    both: tuple[Elastic, Plastic] = (results.elastic[0.0], results.plastic[0.0])
    top = [float(case.pressure.max()) * 1e-9 for case in both]
    edge = [contact_radius(case.x / a, case.pressure) for case in both]
    curves = fem.load("2a")
    r, p, axis = curves.pressure_r["r_m"], curves.pressure_r["p_Pa"], curves.axis_loaded
    ours, z = results.plastic[0.0], axis["z_m"]
    inside = (ours.x > 0) & (ours.x < 0.9 * a)
    rms = {
        "pressure": apart(ours.x[inside], ours.pressure[inside], r, p),
        "von Mises stress": apart(ours.z, ours.von_mises, z, axis["vonMises_Pa"]),
        "plastic strain": apart(ours.z, ours.gamma, z, axis["gamma_p"]),
    }
    return [
        Statement(
            "plasticity, µ = 0: largest pressure, and contact radius",
            "lower; area tends to increase",
            f"{top[1]:.3f} instead of {top[0]:.3f} GPa; {edge[1]:.3f} a instead of {edge[0]:.3f} a",
            top[1] < 0.98 * top[0] and edge[1] > edge[0],
            mesh,
        ),
        Statement(
            "profiles for µ = 0 against finite elements",
            "fairly good agreement",
            "rms of the difference over the maximum: "
            + ", ".join(f"{name} {100 * value:.2f} %" for name, value in rms.items()),
            all(value < 0.02 for value in rms.values()),
            mesh,
            remark="Finite elements of `reference/fem/README.md`, case 2a.",
        ),
    ]


def apart(x: np.ndarray, ours: np.ndarray, at: np.ndarray, theirs: np.ndarray) -> float:
    """Root mean square of the difference of two profiles over the largest of the second."""
    return float(np.sqrt(np.mean((ours - np.interp(x, at, theirs)) ** 2)) / theirs.max())


def by_friction(values: dict[float, float], form: str = ".2f") -> str:
    return ", ".join(f"{value:{form}} (µ = {mu:g})" for mu, value in values.items())


def bound(mu: float, pressure: float) -> float:
    """Least plastic strain at a surface point with this pressure and the shear µp.

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
        Number("5000 N, elastic ball: Hertz pressure", 5.05, ball.p0 * 1e-9, "GPa", "closed form"),
        Number("micro-yield stress, γ = 20e-6", 1731.0, MICRO_YIELD * 1e-6, "MPa", "closed form"),
        Number("yield stress at γ = 0.2 %", 2636.0, float(STEEL_M50.yield_stress(2e-3)) * 1e-6,
               "MPa", "closed form"),
        Number("ω/ω_c0", 3.2, ball.approach / at_rest.interference, "", "closed form",
               remark="ω_c0 where the elastic von Mises stress reaches the micro-yield stress."),
        Statement(
            "critical load and interference",
            "very important effect of friction",
            f"W_c/W_c0 = {last.load / at_rest.load:.3f}, "
            f"ω_c/ω_c0 = {last.interference / at_rest.interference:.3f} for µ = 0.5",
            last.load < 0.5 * at_rest.load,
            "closed form",
        ),
        Number("largest plastic strain, µ = 0", 0.34, 100 * sliding[0.0].gamma_max[-1], "%", mesh),
    ]  # fmt: skip


def stated_first_layer(results: Results) -> Statement:
    least = bound(0.5, float(results.sliding[0.5].pressure.max()))
    depth, gamma = np.array(results.layers).T
    there = float(np.interp(0.0534, gamma, depth))
    return Statement(
        "largest plastic strain, µ = 0.5",
        "5.34 %, on a mesh that is not stated",
        ", ".join(f"{100 * g:.1f} % (first layer at {z:.4f} a)" for z, g in results.layers)
        + f"; 5.34 % at {there:.3f} a",
        gamma.min() < 0.0534 < gamma.max() and 0.03 < there < 0.05,
        "a/12, layers a/12 and thinner",
        remark="The maximum is at the surface, where the strain has a steep gradient: what a "
        "mesh shows is the strain of its first layer. The thesis's value is that of layers of "
        f"about {2 * there * results.ball.a * 1e6:.0f} µm, and not converged. At z = 0 more is "
        "needed: under the largest pressure the von Mises stress is at least √3 µ p, which the "
        f"yield stress of M50 reaches at γ = {100 * least:.1f} %. That is beyond the 5 % up to "
        "which the thesis takes small strains as acceptable.",
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
    return [
        Statement(
            "depth z/a of the largest plastic strain",
            "at the surface for µ = 0.4 and 0.5, at the Hertz depth for µ = 0",
            by_friction({mu: depths[mu] / a for mu in SHOWN}) + f"; first layer at {first / a:.3f}",
            depths[0.4] == depths[0.5] == first and abs(depths[0.0] / a - HERTZ_DEPTH) < 0.05,
            mesh,
        ),
        Statement(
            "von Mises stress below the plastic zone, µ = 0",
            "follows the elastic solution",
            f"within {100 * error:.1f} % of it",
            error < 0.05,
            mesh,
        ),
    ]


def rivals(case: Plastic, a: float) -> tuple[float, float]:
    """Largest von Mises stress close to the surface (z < 0.2 a), and below."""
    near = case.z < 0.2 * a
    return float(case.largest_by_depth[near].max()), float(case.largest_by_depth[~near].max())


def stated_maximum(results: Results) -> list[Number | Statement]:
    a, mesh, sliding = results.ball.a, results.mesh["elastic ball"], results.sliding
    range_ = [mu for mu in sorted(sliding) if 0.25 <= mu <= 0.4]
    pairs = [rivals(sliding[mu], a) for mu in range_]
    jump = crossing(range_, [near - below for near, below in pairs])
    ahead = {mu: sliding[mu].von_mises_at[1] / a for mu in sorted(sliding)}
    shown = by_friction({mu: ahead[mu] for mu in SHOWN})
    return [
        Number(
            "friction above which the largest von Mises stress under load is at the surface",
            0.32,
            jump,
            "",
            mesh,
            remark="It depends on how close to the surface the stress is taken: with first layers "
            "at z/a = 0.042, 0.021, 0.010 and 0.005 (cells of a/12) it is 0.340, 0.321, 0.314 and "
            "0.312. The thesis's value is in this range.",
        ),
        Statement(
            "x/a of the largest von Mises stress under load",
            "ahead of the centre, more so with µ; then jumps behind; then back to the centre",
            shown,
            ahead[0.0] == 0 < ahead[0.1] < ahead[0.2] < ahead[0.3]
            and ahead[0.35] < 0
            and ahead[0.35] < ahead[0.5] <= 0,
            mesh,
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
    return [
        Statement(
            "residual von Mises stress on the axis, µ = 0",
            "two zones, at the Hertz depth and at the surface",
            f"{zones[0]:.0f} MPa in the first layer, {zones[1]:.0f} MPa below it, "
            f"{zones[2]:.0f} MPa at the Hertz depth",
            zones[1] < 0.2 * min(zones[0], zones[2]),
            mesh,
        ),
        Statement(
            "residual von Mises stress on the axis: largest near the surface / at Hertz depth",
            "higher at the surface for µ > 0.3",
            ", ".join(f"{near[m] * 1e-6:.0f}/{deep[m] * 1e-6:.0f} MPa (µ = {m:g})"
                      for m in (0.2, 0.3, 0.4, 0.5)) + f"; equal at µ = {exceeds:.2f}",
            near[0.3] < deep[0.3] and near[0.4] > deep[0.4],
            mesh,
        ),
        Statement(
            "residual von Mises stress at the Hertz depth (0.48 a)",
            "pronounced decrease for µ > 0.4",
            ", ".join(f"{deep[m] * 1e-6:.0f} MPa (µ = {m:g})" for m in (0.2, 0.3, 0.4, 0.5)),
            deep[0.5] < 0.85 * deep[0.4] and deep[0.4] > 0.9 * deep[0.2],
            mesh,
        ),
        Statement(
            "friction at which the plastic zone reaches the surface, x = y = 0",
            "approximately 0.2",
            f"γ of the first layer passes 20e-6 at µ = {reaches:.2f}",
            0.15 < reaches < 0.25,
            mesh,
        ),
    ]  # fmt: skip


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
    wanted = ["compressive", "tensile", "compressive", "tensile"]
    return [
        Statement(
            "residual hydrostatic stress on the axis, µ = 0, from the surface down",
            ", ".join(wanted),
            "; ".join(f"{load:.0f} N: {', '.join(found)}" for load, found in signs.items()
                      if load >= 4000.0),
            all(signs[load] == wanted for load in (4000.0, 5000.0)),
            mesh,
        ),
        Statement(
            "its amplitude at 1000, 2000, ... 5000 N",
            "increases with the load",
            each(amplitude) + " MPa",
            amplitude == sorted(amplitude),
            mesh,
        ),
        Statement(
            "largest hydrostatic residual stress between surface and Hertz depth",
            "turns compressive for µ between 0.2 and 0.3",
            ", ".join(f"{quiet[mu] * 1e-6:.0f} MPa (µ = {mu:g})" for mu in (0.2, 0.25, 0.3))
            + f"; zero at µ = {turns:.2f}",
            0.2 < turns < 0.3,
            mesh,
        ),
    ]  # fmt: skip


def at_hertz_depth(case: Plastic, a: float) -> float:
    return float(np.interp(HERTZ_DEPTH * a, case.z, case.residual))


def quiescent(case: Plastic, a: float) -> float:
    """Largest hydrostatic residual stress between the surface and the Hertz depth."""
    between = (case.z > 0.04 * a) & (case.z < 0.4 * a)
    return float(case.hydrostatic[between].max())
