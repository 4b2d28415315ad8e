# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures 2.35 to 2.59 of Boucly (2008): sliding contacts of a ball."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import samcontact as sc
from reference import fem

from ..drawing import axes, finish, hertz_curve
from ..page import Picture
from ..profiles import von_mises
from .setups import F1_FRICTION, F2_LOAD, HERTZ_DEPTH, MICRO_YIELD, RADIUS, SHOWN, Results
from .statements import bound, rivals


def mark_hertz_depth(ax: Axes) -> None:
    """Mark the depth of the maximum von Mises stress below a Hertz contact."""
    label = "depth of maximum\nvon Mises stress (Hertz)"
    ax.axvline(HERTZ_DEPTH, color="k", linestyle=":", linewidth=1, label=label)


def figures(results: Results) -> list[Picture]:
    return [
        rigid_elastic(results),
        rigid_plastic(results),
        onset_and_strain(results),
        pressure_and_strain(results),
        stress_profiles(results),
        maximum(results),
        residual_map(results),
        hydrostatic(results),
        first_layer(results),
    ]


def rigid_elastic(results: Results) -> Picture:
    contact = results.rigid
    a, p0 = contact.a, contact.p0
    figure, rows = axes(2, 3, (10.0, 5.4), sharey="row")
    for mu, upper, lower in zip(F1_FRICTION, *rows, strict=True):
        case = results.elastic[mu]
        hertz_curve(upper, contact, reach=1.4)
        upper.plot(case.x / a, case.pressure * 1e-9, color="C0", label="samcontact")
        upper.set_xlim(-1.4, 1.4)
        upper.set_title(f"µ = {mu:g}", fontsize="medium")
        exact = von_mises(contact.stress(0.0, 0.0, case.z, 0.3, mu))
        lower.plot(case.z / a, exact * 1e-9, "k--", linewidth=1, label="Hertz with shear µp")
        lower.plot(case.z / a, case.von_mises * 1e-9, color="C0", label="samcontact")
        finish(upper, "x/a", "pressure [GPa]" if mu == 0 else "", legend=mu == 0)
        finish(lower, "depth z/a", "von Mises stress [GPa]" if mu == 0 else "", legend=mu == 0)
    rows[0, 0].plot(0, 4.35, "ko", markerfacecolor="none", label="Boucly (2008): 4.35 GPa")
    rows[0, 0].legend(frameon=False, fontsize="small")
    rows[0, 0].set_ylim(0, 1.12 * p0 * 1e-9)
    return Picture(
        "friction_rigid_elastic",
        "Figures 2.35 to 2.40: rigid ball on an elastic half-space, 800 N. Pressure in the plane "
        "y = 0, and von Mises stress on x = y = 0. The shear acts on the half-space along +x.",
        figure,
    )


def rigid_plastic(results: Results) -> Picture:
    contact = results.rigid
    a = contact.a
    curves = fem.load("2a")
    pressure, axis = curves.pressure_r, curves.axis_loaded
    figure, rows = axes(3, 3, (8.6, 6.4), sharey="row")
    for column, mu in enumerate(F1_FRICTION):
        case = results.plastic[mu]
        first, second, third = rows[:, column]
        hertz_curve(first, contact, reach=1.4)
        first.plot(case.x / a, case.pressure * 1e-9, color="C0", label="samcontact")
        second.plot(case.z / a, case.von_mises * 1e-9, color="C0", label="samcontact")
        third.plot(case.z / a, 100 * case.gamma, color="C0", label="samcontact")
        if mu == 0:
            dots = {"color": "C3", "marker": ".", "linestyle": "none", "label": "finite elements"}
            inside, shown = pressure["r_m"] < 0.95 * a, (axis["z_m"] < 1.6 * a) & (axis["z_m"] > 0)
            first.plot(pressure["r_m"][inside] / a, pressure["p_Pa"][inside] * 1e-9, **dots)
            z = axis["z_m"][shown][::3] / a
            second.plot(z, axis["vonMises_Pa"][shown][::3] * 1e-9, **dots)
            third.plot(z, 100 * axis["gamma_p"][shown][::3], **dots)
        first.set_xlim(-1.4, 1.4)
        first.set_title(f"µ = {mu:g}", fontsize="medium")
        finish(first, "x/a", "pressure [GPa]" if mu == 0 else "", legend=mu == 0)
        finish(second, "depth z/a", "von Mises stress [GPa]" if mu == 0 else "", legend=mu == 0)
        finish(third, "depth z/a", "plastic strain [%]" if mu == 0 else "", legend=mu == 0)
        for ax in (second, third):
            ax.set_xlim(0, 1.6)
    return Picture(
        "friction_rigid_plastic",
        "Figures 2.41 to 2.49: rigid ball on M50, 800 N. Pressure in the plane y = 0, von Mises "
        "stress and equivalent plastic strain on x = y = 0.",
        figure,
    )


def onset_and_strain(results: Results) -> Picture:
    ball = results.ball
    figure, (left, right) = axes()
    mu = np.linspace(0.0, 0.5, 51)
    found = [sc.critical.onset_sliding(RADIUS, ball.E_star, 0.3, MICRO_YIELD, m) for m in mu]
    left.plot(mu, [f.load / found[0].load for f in found], "C0", label="critical load")
    left.plot(mu, [f.interference / found[0].interference for f in found], "C3",
              label="critical interference")  # fmt: skip
    left.axvline(
        0.3, color="k", linestyle="--", linewidth=1, label="Boucly (2008): surface yields above 0.3"
    )
    left.set_ylim(0, 1.1)
    finish(left, "friction coefficient µ", "value / value for µ = 0 [-]")
    for k, friction in enumerate(SHOWN):
        case = results.sliding[friction]
        pressure = ball.p0 * (case.loads / F2_LOAD) ** (1 / 3) / MICRO_YIELD
        positive = case.gamma_max > 0
        right.semilogy(
            pressure[positive], 100 * case.gamma_max[positive], color=f"C{k}",
            label=f"µ = {friction:g}",
        )  # fmt: skip
    end, stated = ball.p0 / MICRO_YIELD, [0.34, 5.34]
    (marks,) = right.plot([end, end], stated, "ko", markerfacecolor="none")
    stated = right.legend([marks], ["Boucly (2008): 0.34 and 5.34 %"],
                          loc="lower right", fontsize="small",
                          frameon=False)  # fmt: skip
    right.add_artist(stated)
    right.set_ylim(1e-3, 20)
    finish(right, "Hertz pressure / micro-yield stress", "maximum plastic strain [%]")
    return Picture(
        "friction_onset",
        "Figures 2.50 and 2.51: critical load and interference at the onset of yield (closed "
        "form), and maximum plastic strain versus Hertz pressure, for six values of µ.",
        figure,
    )


def by_friction(ax: Axes, results: Results, name: str, scale: float, position: str = "z") -> None:
    """Draw one profile of each sliding contact of the elastic ball."""
    for k, mu in enumerate(SHOWN):
        case = results.sliding[mu]
        x = getattr(case, position) / results.ball.a
        ax.plot(x, scale * getattr(case, name), color=f"C{k}", label=f"µ = {mu:g}")


def pressure_and_strain(results: Results) -> Picture:
    ball = results.ball
    figure, (left, right) = axes()
    hertz_curve(left, ball)
    by_friction(left, results, "pressure", 1e-9, "x")
    by_friction(right, results, "gamma", 100)
    left.set_xlim(-1.5, 1.5)
    right.set_xlim(0, 1.6)
    right.set_ylim(-0.05, 1.5)
    mark_hertz_depth(right)
    finish(left, "x/a", "pressure [GPa]")
    finish(right, "depth z/a", "plastic strain [%]")
    return Picture(
        "friction_pressure",
        "Figures 2.52 and 2.57: pressure in the plane y = 0, and equivalent plastic strain on "
        "x = y = 0, at 5000 N. For µ = 0.5 the strain increases up to the surface.",
        figure,
    )


def stress_profiles(results: Results) -> Picture:
    ball = results.ball
    figure, (left, right) = axes()
    z = np.linspace(0.0, 1.8, 181) * ball.a
    radial, axial = ball.axis_stress(z, 0.3)
    left.plot(z / ball.a, np.abs(axial - radial) * 1e-9, "k--", linewidth=1, label="elastic, µ = 0")
    by_friction(left, results, "von_mises", 1e-9)
    by_friction(right, results, "residual", 1e-6)
    mark_hertz_depth(right)
    for ax in (left, right):
        ax.set_xlim(0, 1.8)
    finish(left, "depth z/a", "von Mises stress [GPa]")
    finish(right, "depth z/a", "residual von Mises stress [MPa]")
    return Picture(
        "friction_von_mises",
        "Figures 2.53 and 2.54: von Mises stress on x = y = 0 at 5000 N and after unloading.",
        figure,
    )


def maximum(results: Results) -> Picture:
    a = results.ball.a
    mus = sorted(results.sliding)
    found = np.array([results.sliding[mu].von_mises_at for mu in mus])
    figure, (left, right) = axes()
    left.plot(mus, found[:, 0] * 1e-9, "o-", markersize=3, color="C0", label="maximum")
    near, below = np.array([rivals(results.sliding[mu], a) for mu in mus]).T
    left.plot(mus, below * 1e-9, ":", color="C2", label="maximum for z > 0.2 a")
    left.plot(mus, near * 1e-9, ":", color="C3", label="maximum for z < 0.2 a")
    right.plot(mus, found[:, 1] / a, "o-", markersize=3, color="C0", label="x/a")
    right.plot(mus, found[:, 2] / a, "s-", markersize=3, color="C3", label="z/a")
    for ax in (left, right):
        ax.axvline(
            0.32,
            color="k",
            linestyle="--",
            linewidth=1,
            label="Boucly (2008): maximum at z = 0 for µ > 0.32",
        )
    finish(left, "friction coefficient µ", "maximum von Mises stress [GPa]")
    finish(right, "friction coefficient µ", "position of the maximum [-]")
    return Picture(
        "friction_maximum",
        "Figure 2.55: value and position of the maximum von Mises stress at 5000 N. Positions are "
        "cell centres.",
        figure,
    )


def residual_map(results: Results) -> Picture:
    case, a = results.sliding[0.0], results.ball.a
    figure = Figure(figsize=(6.0, 3.0))
    figure.subplots_adjust(left=0.12, right=0.98, bottom=0.16, top=0.96)
    ax = figure.subplots()
    levels = np.arange(0.0, 261.0, 20.0)
    filled = ax.contourf(
        case.x / a, case.z / a, case.surface_plane.T * 1e-6, levels, cmap="viridis"
    )
    figure.colorbar(filled, ax=ax, label="residual von Mises stress [MPa]")
    ax.axhline(HERTZ_DEPTH, color="w", linestyle=":", linewidth=1)
    ax.set(xlim=(-1.5, 1.5), ylim=(1.5, 0), aspect="equal", xlabel="x/a", ylabel="depth z/a")
    return Picture(
        "friction_residual_map",
        "Figure 2.56: residual von Mises stress in the plane y = 0 after a load of 5000 N, µ = 0. "
        "Dotted: depth of the maximum von Mises stress (Hertz).",
        figure,
    )


def hydrostatic(results: Results) -> Picture:
    a = results.ball.a
    figure, (left, right) = axes(sharey=True)
    z = results.sliding[0.0].z / a
    for k, load in enumerate(sorted(results.by_load)):
        left.plot(z, results.by_load[load] * 1e-6, color=f"C{k}", label=f"{load:.0f} N")
    by_friction(right, results, "hydrostatic", 1e-6)
    for ax in (left, right):
        ax.axhline(0, color="k", linewidth=0.6)
        mark_hertz_depth(ax)
        ax.set_xlim(0, 1.8)
        ax.set_ylim(-250, 80)
    finish(left, "depth z/a", "residual hydrostatic stress [MPa]")
    finish(right, "depth z/a")
    return Picture(
        "friction_hydrostatic",
        "Figures 2.58 and 2.59: residual hydrostatic stress on x = y = 0. Left: µ = 0 and loads up "
        "to 5000 N. Right: 5000 N and µ up to 0.5. a is the Hertz radius at 5000 N.",
        figure,
    )


def first_layer(results: Results) -> Picture:
    figure, ax = axes(1, 1, (5.0, 3.6))
    depth, gamma = np.array(results.layers).T
    ax.plot(depth, 100 * gamma, "o-", color="C0", label="simulation")
    required = bound(0.5, float(results.sliding[0.5].pressure.max()))
    label = "minimum required by the shear at z = 0"
    ax.axhline(100 * required, color="C3", linestyle=":", label=label)
    ax.axhline(5.34, color="k", linestyle="--", linewidth=1, label="Boucly (2008): 5.34 %")
    ax.set(xlim=(0, 1.1 * depth.max()), ylim=(0, 14))
    finish(ax, "depth of the first layer z/a", "maximum plastic strain [%]")
    return Picture(
        "friction_first_layer",
        "Not in the thesis: maximum plastic strain for µ = 0.5 and 5000 N versus depth of the "
        "first layer, at which it occurs.",
        figure,
    )
