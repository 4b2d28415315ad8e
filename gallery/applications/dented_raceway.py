# SPDX-License-Identifier: GPL-3.0-or-later
"""Raceway dented by a hard particle, then rolled over by a ball."""

from __future__ import annotations

import math

from matplotlib.figure import Figure

import samcontact as sc

from ..drawing import axes, depth_down, field, finish_titled
from .application import Answer, Application, Work, largest

E_STAR = sc.hertz.effective_modulus(*[sc.Material.elastic(210e9, 0.3)] * 2)
HERTZ = sc.hertz.point(4.7625e-3, E_STAR, load=79.0)
DENT = 160e-6
"""Position of the particle on the raceway [m]."""
BELOW = 25e-6
"""Depth that separates the stress at the shoulder from that below the whole contact [m]."""


def answers(work: Work) -> list[Answer]:
    found, worst = work.dataset(), work.dataset("fatigue.nc")["dang_van"]
    peak, error = largest(found, "max_pressure")
    depth, depth_error = largest(found, "imprint_depth_body2")
    away = float(found["max_pressure"].values[3])  # loaded, before the pass
    top = worst.isel(z=0)
    x, y = top.stack(cell=top.dims).idxmax("cell").item()
    deep = worst.max(("x", "y")).where(worst["z"] > BELOW)
    return [
        Answer("depth", "depth of the dent", depth, "m", depth_error),
        Answer("away", "maximum pressure before the dent", away, "Pa", check="Hertz",
               expected=HERTZ.p0),
        Answer("peak", "maximum pressure over the dent", peak, "Pa", error),
        Answer("dang_van", "Dang Van's stress (slope 0.3) at the shoulder, in the first layer",
               float(top.max()), "Pa"),
        Answer("place", "distance of this maximum from the middle of the dent",
               math.hypot(x - DENT, y), "m"),
        Answer("deep", "maximum of Dang Van's stress below the contact", float(deep.max()), "Pa"),
        Answer("below", "depth of this maximum", float(deep.idxmax("z")), "m"),
    ]  # fmt: skip


def picture(work: Work) -> Figure:
    found = work.dataset()
    figure, (above, below) = axes(2, 1, (8.0, 6.4), sharex=True)
    loaded = found["load"].values > 78.9
    position = -found["travel_body2"].values[loaded] * 1e6
    above.plot(position, found["max_pressure"].values[loaded] / 1e9, "o-", label="over the dent")
    above.axhline(HERTZ.p0 / 1e9, color="k", linestyle="--", label="smooth raceway (Hertz)")
    finish_titled(above, "", "maximum pressure [GPa]", "position of the ball on the raceway")
    track = found["track_residual_von_mises_body2"]
    x, z = found["track_position_body2"].values * 1e6, found["z"].values * 1e6
    middle = found.sizes["y"] // 2
    field(below, x, z, track.isel(y=middle).values / 1e6, "residual von Mises [MPa]", "magma_r")
    depth_down(below, z[-1])
    below.set_xlim(-40.0, 360.0)
    finish_titled(below, "position on the raceway [µm]", "depth [µm]", "after the pass", False)
    return figure


APPLICATION = Application(
    name="dented_raceway",
    title="Dented raceway, rolled over",
    kind="dent",
    gains="The pressure peak and the fatigue stress at the dent left by a hard particle when a "
    "ball rolls "
    "over it.",
    text="The particle leaves a dent with a depth of {depth}. The ball then causes a pressure of "
    "{peak} at the "
    "shoulder of the dent; before the dent the pressure is {away}. Dang Van's stress is largest at "
    "the shoulder: {dang_van} at {place} from the middle of the dent. Below the contact it reaches "
    "{deep}, {below} deep. Cracks are therefore expected to start at the shoulder.",
    commands=("run dent.toml",),
    shown=("Estimated grid errors", "Fatigue of body 2"),
    functions=(
        ("sc.overrolling.indent", "dents of particles"),
        ("sc.overrolling.roll_over", "pass over the dents"),
        ("sc.overrolling.particles", "random particles"),
        ("sc.fatigue.dang_van", "Dang Van's criterion"),
    ),
    guide=("gears, cams, wheels and indenters", "parts.md#dents-of-hard-particles"),
    limits="The particle is rigid and does not break. The lubricant is not modelled. For several "
    "dents give a list of particles, or draw random particles with "
    "[[dents.random]](../case_files.md#dents).",
    answers=answers,
    picture=picture,
    caption="Maximum pressure while the ball passes the dent, and the residual stress below it.",
    coarser=(
        ("nx = 69", "nx = 35"),
        ("ny = 45", "ny = 23"),
        ("dx = 8e-6", "dx = 16e-6"),
        ("dy = 8e-6", "dy = 16e-6"),
        ("nz = 40", "nz = 20"),
        ("dz = 4e-6", "dz = 8e-6"),
    ),
)
