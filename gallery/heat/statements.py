# SPDX-License-Identifier: GPL-3.0-or-later
"""Statements of Boucly (2008) on frictional heat, compared with the computed values."""

from __future__ import annotations

import numpy as np

from ..stated import Number, Stated, Statement
from .setups import (
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

STATED = Stated("heat")
FINE_ONSET = {0.0: 296.0, 0.05: 497.0, 0.12: 472.0, 0.20: 209.0}
FINE_GRID_STRESSES = {0.0: 2539.4, 0.05: 1961.9, 0.12: 3530.4, 0.20: 7391.6}
"""Results of a separate computation of the thermo-elastic contact on a fine grid."""
STEP = 20.0
"""Step of the depths in the tables of the thesis [µm]."""


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
    """Return the maximum residual stress and its depth; a surface maximum is extrapolated."""
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
        STATED.trend(
            "largest pressure",
            rises and radius[1] < 0.9 * radius[0],
            ", ".join(listed),
            radius[0],
            radius[1],
            mesh=results.mesh["heated"],
        ),
        STATED.number(
            "strain at 8.12 GPa",
            100 * strain,
            mesh=f"{results.mesh['plastic'].split(',')[0]}, layers a/20",
        ),
        STATED.trend(
            "light load",
            bool(np.all(np.diff(tops) > 0) and np.all(np.diff(areas) < 0)) and small[0].gamma == 0,
            tops,
            areas,
            small[0].gamma,
            mesh=results.mesh["small"],
        ),
    ]


def slope(curve: Onset, low: float, high: float) -> tuple[float, float]:
    """Return the slope of a line fitted to part of a curve [MPa s/m], and the largest deviation.

    The deviation is the relative difference between the line and the curve.
    """
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
    say = STATED.on(mesh)
    return [
        *(say.number("onset load", curve.load(factor), at=factor) for factor in FACTORS),
        say.number("onset rise", rise),
        say.number("onset rise factor", float(curve.factor[k])),
        say.trend(
            "onset falls", falling[0] < 0 and falling[1] < 0.01, -falling[0] / 100, 100 * falling[1]
        ),
        say.trend("onset slope", abs(later[0] / falling[0] - 1) > 0.1, -later[0] / 100),
        say.number("onset at surface", curve.reaches_surface()),
        say.trend(
            "place on axis",
            abs(curve.leaves_axis() - 0.075) < 0.003 and depth[1] > depth[0] + 0.02,
            curve.leaves_axis(),
            depth[0],
            depth[1],
        ),
        say.trend(
            "place moves",
            curve.depth[ring][-1] < 0.15 and bool(np.all(curve.radius[ring] > 0.6)),
            curve.depth[ring][0],
            curve.depth[ring][-1],
            curve.radius[ring][0],
            curve.radius[ring][-1],
        ),
        say.trend(
            "place at surface",
            curve.radius[above].max() < 0.05 and curve.depth[above].max() == 0,
            curve.radius[above].max(),
            curve.depth[above].max(),
        ),
    ]


def stated_stress(results: Results) -> list[Number | Statement]:
    return [
        *(
            STATED.number(
                "elastic stress",
                results.elastic[f].largest[0] * 1e-6,
                mesh=results.mesh["elastic"],
                thermo="thermo-" if f else "",
                at=f,
            )
            for f in FACTORS
        ),
        against_fine_grid(results),
        depths(
            "elastic",
            (200, 240, 0, 0),
            [results.elastic[f].largest[1] for f in FACTORS],
            results.mesh["elastic"],
        ),
        *stated_plastic(results),
        attenuated(results),
        *competition(results),
    ]


def against_fine_grid(results: Results) -> Statement:
    deviations = {
        "stresses": [
            results.elastic[f].largest[0] * 1e-6 / FINE_GRID_STRESSES[f] - 1 for f in FACTORS
        ],
        "loads": [results.onset.load(f) / FINE_ONSET[f] - 1 for f in FACTORS],
    }
    return STATED.trend(
        "fine grid",
        all(np.abs(d).max() < 0.01 for d in deviations.values()),
        "; ".join(
            (f"{name} at most {100 * np.abs(d).max():.2f} %" for name, d in deviations.items())
        ),
        mesh=f"{results.mesh['elastic']}, {results.mesh['onset']}",
        fine=list(FINE_GRID_STRESSES.values()),
        fine_onset=list(FINE_ONSET.values()),
    )


def stated_plastic(results: Results) -> list[Number | Statement]:
    distances = [results.last(f).distance / HERTZ.a for f in (0.12, 0.20)]
    return [
        *(
            STATED.number(
                "plastic stress",
                results.last(f).largest[0] * 1e-6,
                mesh=mesh_of(results, f),
                thermo="thermo-" if f else "",
                at=f,
            )
            for f in FACTORS
        ),
        depths(
            "elastic-plastic",
            (200, 240, 40, 40),
            [results.last(f).largest[1] for f in FACTORS],
            results.mesh["heated"],
            f"For 0.12 and 0.20 m/s the maximum is on a ring of radius {distances[0]:.2f} and "
            f"{distances[1]:.2f} a.",
        ),
        STATED.number(
            "largest plastic strain", 100 * results.last(0.0).gamma, mesh=results.mesh["plastic"]
        ),
    ]


def depths(
    name: str, thesis: tuple[int, ...], found: list[float], mesh: str, remark: str = ""
) -> Statement:
    ours = [1e6 * value for value in found]
    return STATED.trend(
        "stress depths",
        all(abs(a - b) < STEP for a, b in zip(ours, thesis, strict=True)),
        ours,
        remark=(f"The thesis states depths in steps of {STEP:.0f} µm. " + remark).strip(),
        mesh=mesh,
        which=name,
        depths=thesis,
    )


def attenuated(results: Results) -> Statement:
    elastic, plastic = results.elastic[0.0].largest, results.last(0.0).largest
    return STATED.trend(
        "plasticity",
        plastic[0] < 0.95 * elastic[0] and abs(plastic[1] - elastic[1]) < STEP,
        elastic[0] * 1e-6,
        plastic[0] * 1e-6,
        elastic[1] * 1e6,
        plastic[1] * 1e6,
        mesh=results.mesh["plastic"],
    )


def competition(results: Results) -> list[Statement]:
    """Return the statements on the stress on the axis, with little heat and with much heat."""
    middle = len(results.elastic[0.0].x) // 2
    axis = {f: results.elastic[f].plane[middle] * 1e-6 for f in FACTORS}
    z = results.elastic[0.0].z
    near, hot = z < 50e-6, (0.12, 0.20)
    hertz_depth = float(z[int(axis[0.0].argmax())])
    at_depth = {f: float(np.interp(hertz_depth, z, axis[f])) for f in FACTORS}
    mesh = results.mesh["elastic"]
    say = STATED.on(mesh)
    return [
        say.trend(
            "little heat",
            axis[0.05][near].mean() < axis[0.0][near].mean()
            and results.elastic[0.05].largest[1] > hertz_depth
            and axis[0.05].max() < axis[0.0].max(),
            axis[0.05][near].mean(),
            axis[0.0][near].mean(),
            results.elastic[0.05].largest[1] * 1e6,
            hertz_depth * 1e6,
        ),
        say.trend(
            "much heat",
            all(at_depth[f] < 0.6 * axis[f].max() for f in hot),
            ", ".join(f"{at_depth[f]:.0f} MPa instead of {at_depth[0.0]:.0f}" for f in hot),
            [axis[f].max() for f in hot],
        ),
    ]


def stated_residual(results: Results) -> list[Number | Statement]:
    case, found = results.last(0.20), [largest_residual(results.last(f)) for f in FACTORS]
    remarks = {
        0.12: "The maximum is at the surface, where the stress has a steep gradient. It is "
        f"extrapolated to z = 0 from the first two layers. {study(results, 0.12)}.",
        0.20: reversed_flow(results),
    }
    free = at_surface(case.elastic_unloading) * 1e-6
    where = [1e6 * depth for _, depth in found]
    say = STATED.on(results.mesh["heated"])
    return [
        *(
            say.number(
                "residual stress",
                value * 1e-6,
                remark=remarks.get(f, ""),
                mesh=mesh_of(results, f),
                at=f,
            )
            for f, (value, _) in zip(FACTORS, found, strict=True)
        ),
        say.number("elastic unloading", free),
        say.trend(
            "residual depths",
            all(abs(a - b) < STEP for a, b in zip(where, (220, 240, 0, 0), strict=True)),
            where,
        ),
    ]


def reversed_flow(results: Results) -> str:
    gamma = results.last(0.20).gamma
    B, C, n = (float(STEEL.parameters[name]) for name in "BCn")
    needed = ((STATED.values("residual stress")[0.20] * 1e6 / B) ** (1 / n) - C) * 1e-6
    return (
        "No residual stress can be larger than the yield stress, "
        f"{1e-6 * float(STEEL.yield_stress(gamma)):.0f} MPa at the maximum plastic strain of "
        f"{100 * gamma:.1f} %; 4219.6 MPa would require a strain of {100 * needed:.0f} %. The body "
        f"yields again, in tension, while it cools. {study(results, 0.20)}."
    )


def study(results: Results, factor: float) -> str:
    """Describe how the residual stress on the axis depends on the thickness of the layers."""
    rows = [
        f"{(case.z[1] - case.z[0]) * 1e6:g} µm: {case.residual[0] * 1e-6:.0f}, "
        f"{at_surface(case.residual) * 1e-6:.0f}"
        for case in results.plastic[factor]
    ]
    return (
        "Stress in the first layer and extrapolated to the surface [MPa], by layer thickness: "
        + "; ".join(rows)
    )
