# SPDX-License-Identifier: GPL-3.0-or-later
"""Rough contact after running-in."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from ..drawing import axes, field, finish_titled
from .application import Answer, Application, Work

SWEEP = (
    "sweep rough.toml --zip --set grid.nx=67,135 --set grid.ny=67,135 --set grid.dx=5e-6,2.5e-6 "
    "--set grid.dy=5e-6,2.5e-6 --set grid.dz=2e-6,1e-6"
)


def answers(work: Work) -> list[Answer]:
    found, swept = work.dataset("wear.nc"), work.dataset("sweep/sweep.nc")
    pressure = swept["max_pressure"].values
    first = [float(row[0]) for row in pressure]
    last = [float(row[np.isfinite(row)][-1]) for row in pressure]
    cycles = [int(np.isfinite(row).sum()) for row in pressure]
    volume = float(found["volume"].sum())
    volumes = [float(np.nansum(row)) for row in swept["volume_body2"].values]
    heights = found["heights_body2"].values
    x, y = found["x_body2"].values, found["y"].values
    cell = float((x[1] - x[0]) * (y[1] - y[0]))
    removed = float((heights[0] - heights[-1]).sum() * cell)
    of_cycle = found["max_pressure"].values
    return [
        Answer("first", "maximum pressure of the new surface", float(of_cycle[0]), "Pa",
               abs(first[0] / first[1] - 1)),
        Answer("last", "maximum pressure after running-in", float(of_cycle[-1]), "Pa",
               abs(last[0] / last[1] - 1)),
        Answer("volume", "worn volume", volume, "µm³", abs(volumes[0] / volumes[1] - 1),
               "difference of the surfaces", removed),
        Answer("cycles", "cycles until wear ceases", float(found.sizes["cycle"]), "",
               abs(cycles[0] / cycles[1] - 1)),
    ]  # fmt: skip


def picture(work: Work) -> Figure:
    found = work.dataset("wear.nc")
    heights = found["heights_body2"].values * 1e6
    x, y = found["x_body2"].values * 1e6, found["y"].values * 1e6
    row = int(np.unravel_index(np.argmax(heights[0] - heights[-1]), heights[0].shape)[1])
    figure, (above, below) = axes(2, 1, (8.0, 7.4))
    for cycle in range(1, len(heights)):
        worn = heights[cycle][:, row] - heights[0][:, row]
        above.plot(x, worn, label=f"after cycle {cycle}")
    finish_titled(above, "x [µm]", "change of height [µm]", f"wear at y = {y[row]:.0f} µm")
    field(below, x, y, heights[0] - heights[-1], "worn depth [µm]", "magma_r")
    finish_titled(below, "x [µm]", "y [µm]", "", False)
    below.set_aspect("equal")
    return figure


APPLICATION = Application(
    name="running_in",
    title="Rough contact after running-in",
    kind="rough",
    gains="The material that the crests of a rough surface lose until wear ceases, and the "
    "pressure before and after.",
    text="Crests wear where their plastic strain exceeds 0.2 %. After {cycles} cycles wear "
    "ceases. The "
    "maximum pressure falls from {first} to {last}, and {volume} are removed.",
    commands=("run rough.toml", SWEEP),
    shown=("Cycles",),
    functions=(
        ("sc.wear.run", "wear by plastic strain"),
        ("sc.surfaces.sinusoidal", "sinusoidal roughness"),
        ("sc.measured.read", "measured surface"),
    ),
    guide=("rough surfaces", "roughness.md"),
    limits="The command `sweep` solves the case twice: first on cells of twice the size, then on "
    "the cells of the case file. "
    "Lubricant and debris are not modelled. The threshold of 0.2 % is a constant of the material.",
    answers=answers,
    picture=picture,
    caption="Wear along a line after each cycle, and a map of the worn depth at the end.",
)
