# SPDX-License-Identifier: GPL-3.0-or-later
"""What the thesis states about frictional heat, beside what was computed."""

from __future__ import annotations

import numpy as np

from ..page import Number, Statement
from ..profiles import each
from .scenes import (
    FACTORS,
    HERTZ,
    SMALL_LOAD,
    SMALL_LOAD_FACTORS,
    STEEL,
    Onset,
    Plastic,
    Results,
    at_surface,
    hertz,
)

THERMO_ELASTIC = {0.0: 2537.9, 0.05: 1971.4, 0.12: 3501.6, 0.20: 7343.3}
PLASTIC = {0.0: 2349.1, 0.05: 1939.0, 0.12: 2654.4, 0.20: 3186.9}
RESIDUAL = {0.0: 135.5, 0.05: 25.7, 0.12: 877.3, 0.20: 4219.6}
ONSET = {0.0: 298.0, 0.05: 491.0, 0.12: 468.0, 0.20: 212.0}
FINE_ONSET = {0.0: 296.0, 0.05: 497.0, 0.12: 472.0, 0.20: 209.0}
FINE = {0.0: 2539.4, 0.05: 1961.9, 0.12: 3530.4, 0.20: 7391.6}
"""Of a separate computation of the thermo-elastic contact on a fine grid."""
REVERSED = 3160.0
"""Residual stress at the surface for Q_f = 0.2 m/s in the limit of thin layers [MPa]."""
STEP = 20.0
"""Of the depths of the thesis's tables [µm]."""


def stated(results: Results) -> list[Number | Statement]:
    return [
        *stated_pressure(results),
        *stated_onset(results),
        *stated_stress(results),
        *stated_residual(results),
    ]


def mesh_of(results: Results, factor: float) -> str:
    return results.mesh["plastic" if factor < 0.1 else "heated"]


def largest_residual(case: Plastic) -> tuple[float, float]:
    """Value and depth; where it is in the first layer, that at the surface."""
    if case.residual_largest[1] > case.z[0]:
        return case.residual_largest
    return at_surface(case.residual), 0.0


def stated_pressure(results: Results) -> list[Number | Statement]:
    listed, rises = [], True
    for name, (_, curves) in results.curves.items():
        top = {label: float(p.max()) * 1e-9 for label, _, p in curves}
        listed.append(
            f"{top['elastic-plastic']:.2f} to {top['thermo-elastic-plastic']:.2f} GPa ({name})"
        )
        rises &= top["thermo-elastic-plastic"] > 1.02 * top["elastic-plastic"]
    plain, hot = results.last(0.0), results.last(0.20)
    radius = [(case.area / np.pi) ** 0.5 / HERTZ.a for case in (plain, hot)]
    strain = np.interp(8.12e9, *results.strain)
    small = [results.small[factor] for factor in SMALL_LOAD_FACTORS]
    tops = [float(case.pressure.max()) * 1e-9 for case in small]
    areas = [case.area / (np.pi * hertz(SMALL_LOAD).a ** 2) for case in small]
    return [
        Statement(
            "largest pressure, from elastic-plastic to thermo-elastic-plastic",
            "increases with the heat, in a smaller contact",
            ", ".join(listed) + f"; radius {radius[0]:.2f} to {radius[1]:.2f} a (1500 N)",
            rises and radius[1] < 0.9 * radius[0],
            results.mesh["heated"],
        ),
        Number("plastic strain at a Hertz pressure of 8.12 GPa, no heat", 2.0, 100 * strain, "%",
               f"{results.mesh['plastic'].split(',')[0]}, layers a/20", tolerance=0.08,
               remark="The same on finer grids: [two inelastic bodies](two_plastic_bodies.md)."),
        Statement(
            "140 N, Q_f = 0, 0.075, 0.15, 0.225, 0.3 m/s: largest pressure, contact area",
            "increase of the pressure, decrease of the area; elastic for Q_f = 0",
            each(tops, ".3f") + " GPa; "
            + each(areas, ".2f") + f" of Hertz's; γ = {small[0].gamma:g} "
            "for Q_f = 0",
            bool(np.all(np.diff(tops) > 0) and np.all(np.diff(areas) < 0)) and small[0].gamma == 0,
            results.mesh["small"],
        ),
    ]  # fmt: skip


def slope(curve: Onset, low: float, high: float) -> tuple[float, float]:
    """Of the straight line through a part of the curve [MPa s/m], and its relative deviation."""
    part = (curve.factor >= low) & (curve.factor <= high)
    fit = np.polyfit(curve.factor[part], curve.p0[part], 1)
    deviation = np.abs(np.polyval(fit, curve.factor[part]) / curve.p0[part] - 1)
    return float(fit[0]) * 1e-6, float(deviation.max())


def stated_onset(results: Results) -> list[Number | Statement]:
    curve, mesh = results.onset, results.mesh["onset"]
    k = int(curve.p0.argmax())
    rise = 100 * (curve.p0[k] / curve.p0[0] - 1)
    falling, later = slope(curve, 0.08, 0.145), slope(curve, 0.158, 0.25)
    depth = np.interp((0.0, 0.07), curve.factor, curve.depth)
    ring = (curve.factor > curve.leaves_axis()) & (curve.factor < curve.reaches_surface())
    above = curve.factor >= curve.reaches_surface()
    return [
        *(
            Number(f"load at the onset of yield, Q_f = {factor:g} m/s", ONSET[factor],
                   curve.load(factor), "N", mesh, tolerance=0.02)
            for factor in FACTORS
        ),
        Number("largest rise of the Hertz pressure at the onset of yield", 38.0, rise, "%", mesh,
               remark="The thesis says nearly 38 %; on a fine grid it is 36.2 %."),
        Number("at Q_f", 0.075, float(curve.factor[k]), "m/s", mesh, tolerance=0.03),
        Statement(
            "then, up to 0.152 m/s",
            "falls linearly",
            f"by {-falling[0] / 100:.0f} MPa per 0.01 m/s, {100 * falling[1]:.1f} % from a "
            "straight line",
            falling[0] < 0 and falling[1] < 0.01,
            mesh,
        ),
        Statement(
            "above 0.152 m/s",
            "another slope",
            f"by {-later[0] / 100:.0f} MPa per 0.01 m/s up to 0.25 m/s",
            abs(later[0] / falling[0] - 1) > 0.1,
            mesh,
        ),
        Number("Q_f at which the first yield reaches the surface", 0.152, curve.reaches_surface(),
               "m/s", mesh, tolerance=0.03),
        Statement(
            "place of first yield up to 0.075 m/s",
            "on the axis, deeper with the heat",
            f"on the axis up to {curve.leaves_axis():.3f} m/s, from z/a = {depth[0]:.2f} to "
            f"{depth[1]:.2f} at 0.07 m/s",
            abs(curve.leaves_axis() - 0.075) < 0.003 and depth[1] > depth[0] + 0.02,
            mesh,
        ),
        Statement(
            "from 0.075 to 0.152 m/s",
            "moves sharply to the surface, and from the centre to the edge of the contact",
            f"z/a from {curve.depth[ring][0]:.2f} to {curve.depth[ring][-1]:.2f}, r/a from "
            f"{curve.radius[ring][0]:.2f} to {curve.radius[ring][-1]:.2f}",
            curve.depth[ring][-1] < 0.15 and bool(np.all(curve.radius[ring] > 0.6)),
            mesh,
        ),
        Statement(
            "above 0.152 m/s",
            "at the surface, in the centre of the contact",
            f"radius {curve.radius[above].max():.2f} a, depth {curve.depth[above].max():.2f} a",
            curve.radius[above].max() < 0.05 and curve.depth[above].max() == 0,
            mesh,
        ),
    ]  # fmt: skip


def stated_stress(results: Results) -> list[Number | Statement]:
    return [
        *(
            Number(
                f"largest von Mises stress, {'thermo-' if f else ''}elastic, Q_f = {f:g} m/s",
                THERMO_ELASTIC[f], results.elastic[f].largest[0] * 1e-6, "MPa",
                results.mesh["elastic"], tolerance=0.02,
            )
            for f in FACTORS
        ),
        against_fine_grid(results),
        depths("elastic", (200, 240, 0, 0), [results.elastic[f].largest[1] for f in FACTORS],
               results.mesh["elastic"]),
        *stated_plastic(results),
        attenuated(results),
        *competition(results),
    ]  # fmt: skip


def against_fine_grid(results: Results) -> Statement:
    apart = {
        "stresses": [results.elastic[f].largest[0] * 1e-6 / FINE[f] - 1 for f in FACTORS],
        "loads": [results.onset.load(f) / FINE_ONSET[f] - 1 for f in FACTORS],
    }
    return Statement(
        "these stresses and loads, against a separate fine-grid solution",
        "not stated",
        "; ".join(f"{name} at most {100 * np.abs(d).max():.2f} %" for name, d in apart.items()),
        all(np.abs(d).max() < 0.01 for d in apart.values()),
        f"{results.mesh['elastic']}, {results.mesh['onset']}",
        remark=f"Fine grid: {each(FINE.values(), '.0f')} MPa and "
        f"{each(FINE_ONSET.values(), '.0f')} N. Three heated stresses of the thesis differ from "
        "these by what a constant equibiaxial stress of about -240 MPa times Q_f / (m/s) would "
        "make.",
    )


def stated_plastic(results: Results) -> list[Number | Statement]:
    distances = [results.last(f).distance / HERTZ.a for f in (0.12, 0.20)]
    return [
        *(
            Number(
                f"largest von Mises stress, {'thermo-' if f else ''}elastic-plastic, "
                f"Q_f = {f:g} m/s", PLASTIC[f], results.last(f).largest[0] * 1e-6, "MPa",
                mesh_of(results, f),
            )
            for f in FACTORS
        ),
        depths("elastic-plastic", (200, 240, 40, 40), [results.last(f).largest[1] for f in FACTORS],
               results.mesh["heated"],
               f"For 0.12 and 0.20 m/s it is on a ring of radius {distances[0]:.2f} and "
               f"{distances[1]:.2f} a."),
        Number("largest plastic strain, Q_f = 0", 0.18, 100 * results.last(0.0).gamma, "%",
               results.mesh["plastic"]),
    ]  # fmt: skip


def depths(
    name: str, thesis: tuple[int, ...], found: list[float], mesh: str, remark: str = ""
) -> Statement:
    ours = [1e6 * value for value in found]
    return Statement(
        f"depth of these stresses, {name}, Q_f = 0, 0.05, 0.12, 0.20 m/s",
        each(thesis, "d") + " µm",
        each(ours, ".0f") + " µm",
        all(abs(a - b) < STEP for a, b in zip(ours, thesis, strict=True)),
        mesh,
        remark=(f"The thesis tells depths in steps of {STEP:.0f} µm. " + remark).strip(),
    )


def attenuated(results: Results) -> Statement:
    elastic, plastic = results.elastic[0.0].largest, results.last(0.0).largest
    return Statement(
        "plasticity without heat",
        "attenuates the stress, at the same depth",
        f"{elastic[0] * 1e-6:.0f} to {plastic[0] * 1e-6:.0f} MPa, at {elastic[1] * 1e6:.0f} and "
        f"{plastic[1] * 1e6:.0f} µm",
        plastic[0] < 0.95 * elastic[0] and abs(plastic[1] - elastic[1]) < STEP,
        results.mesh["plastic"],
    )


def competition(results: Results) -> list[Statement]:
    """Of the stresses of pressure and heat, on the axis."""
    middle = len(results.elastic[0.0].x) // 2
    axis = {f: results.elastic[f].plane[middle] * 1e-6 for f in FACTORS}
    z = results.elastic[0.0].z
    near, hot = z < 50e-6, (0.12, 0.20)
    hertz_depth = float(z[int(axis[0.0].argmax())])
    at_depth = {f: float(np.interp(hertz_depth, z, axis[f])) for f in FACTORS}
    mesh = results.mesh["elastic"]
    return [
        Statement(
            "Q_f = 0.05 m/s against no heat, thermo-elastic",
            "lower stress near the surface; the Hertzian zone is deeper, and its stress lower",
            f"on the axis {axis[0.05][near].mean():.0f} instead of {axis[0.0][near].mean():.0f} "
            f"MPa down to 50 µm, maximum at {results.elastic[0.05].largest[1] * 1e6:.0f} instead "
            f"of {hertz_depth * 1e6:.0f} µm",
            axis[0.05][near].mean() < axis[0.0][near].mean()
            and results.elastic[0.05].largest[1] > hertz_depth
            and axis[0.05].max() < axis[0.0].max(),
            mesh,
        ),
        Statement(
            "Q_f = 0.12 and 0.20 m/s, thermo-elastic",
            "stress at the Hertz depth lower than elsewhere",
            "at the Hertz depth "
            + ", ".join(f"{at_depth[f]:.0f} MPa instead of {at_depth[0.0]:.0f}" for f in hot)
            + ", where the largest is "
            + each([axis[f].max() for f in hot], ".0f"),
            all(at_depth[f] < 0.6 * axis[f].max() for f in hot),
            mesh,
        ),
    ]  # fmt: skip


def stated_residual(results: Results) -> list[Number | Statement]:
    case, found = results.last(0.20), [largest_residual(results.last(f)) for f in FACTORS]
    remarks = {
        0.12: "At the surface, where its gradient is steep: extrapolated to z = 0 from the "
        f"first two layers. {study(results, 0.12)}.",
        0.20: reversed_flow(results),
    }
    free = at_surface(case.elastic_unloading) * 1e-6
    where = [1e6 * depth for _, depth in found]
    return [
        *(
            Number(
                f"largest residual von Mises stress, Q_f = {f:g} m/s", RESIDUAL[f],
                value * 1e-6, "MPa", mesh_of(results, f), remark=remarks.get(f, ""),
                converged=REVERSED if f == 0.20 else None,
            )
            for f, (value, _) in zip(FACTORS, found, strict=True)
        ),
        Number(
            "the same without yielding on unloading", RESIDUAL[0.20], free, "MPa",
            results.mesh["heated"], tolerance=0.06,
            remark="The stress of the plastic strain under load, which an elastic unloading would "
            "leave. The value of the thesis is near it: it seems to leave out the yielding of "
            "unloading. At 0.12 m/s nothing yields on unloading, and both agree.",
        ),
        Statement(
            "their depths",
            "220, 240, 0, 0 µm",
            each(where, ".0f") + " µm",
            all(abs(a - b) < STEP for a, b in zip(where, (220, 240, 0, 0), strict=True)),
            results.mesh["heated"],
        ),
    ]  # fmt: skip


def reversed_flow(results: Results) -> str:
    gamma = results.last(0.20).gamma
    B, C, n = (float(STEEL.parameters[name]) for name in "BCn")
    needed = ((RESIDUAL[0.20] * 1e6 / B) ** (1 / n) - C) * 1e-6
    return (
        "No residual stress can be larger than the yield stress, "
        f"{1e-6 * float(STEEL.yield_stress(gamma)):.0f} MPa at the largest strain of "
        f"{100 * gamma:.1f} %; 4219.6 MPa would need {100 * needed:.0f} %. The body "
        f"yields again, in tension, while it cools. {study(results, 0.20)}."
    )


def study(results: Results, factor: float) -> str:
    """What the layers do to the residual stress on the axis."""
    rows = [
        f"{(case.z[1] - case.z[0]) * 1e6:g} µm: {case.residual[0] * 1e-6:.0f}, "
        f"{at_surface(case.residual) * 1e-6:.0f}"
        for case in results.plastic[factor]
    ]
    return "Layers, first of them and surface [MPa]: " + "; ".join(rows)
