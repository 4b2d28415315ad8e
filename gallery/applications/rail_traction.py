# SPDX-License-Identifier: GPL-3.0-or-later
"""Rail under the traction of a wheel."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

import samcontact as sc

from ..drawing import axes, cells, depth_down, field, finish_titled
from .application import Answer, Application, Work, largest

STEEL = sc.Material.elastic(E=210e9, nu=0.3)
LOAD = 80e3


def steady() -> sc.RollingSolution:
    """Steady rolling of elastic bodies with the same creepage."""
    grid = sc.Grid(nx=27, ny=21, dx=0.65e-3, dy=0.65e-3)
    gap = sc.surfaces.paraboloid(grid, 0.46, 0.30)
    solution = sc.rolling.steady(
        grid, STEEL, STEEL, gap, load=LOAD, friction=sc.Coulomb(0.35), creepage=(-1e-3, 0.0)
    )
    assert isinstance(solution, sc.RollingSolution)
    return solution


def answers(work: Work) -> list[Answer]:
    found = work.dataset()
    force, error = largest(found, "tangential_load_x")
    at = int(np.argmax(np.abs(found["tangential_load_x"].values)))
    strain, strain_error = largest(found, "max_equivalent_plastic_strain_body2")
    p0 = float(found["max_pressure"].values[at])
    hertz = sc.hertz.elliptic(0.46, 0.30, sc.hertz.effective_modulus(STEEL, STEEL), load=LOAD)
    elastic = steady()
    stick = elastic.sticking.sum() / np.count_nonzero(elastic.pressure)
    onset, onset_error = work.row("load", 1)[0]
    note = "elastic bodies, sc.rolling.steady"
    return [
        Answer("force", "force on the rail", abs(force), "N", error, note,
               abs(float(elastic.tangential_load[0]))),
        Answer("stick", "stick fraction of the contact", float(found["stick_fraction"].values[at]),
               "%", check=note, expected=float(stick)),
        Answer("p0", "maximum pressure", p0, "Pa", check="elastic bodies, Hertz",
               expected=hertz.p0),
        Answer("strain", "plastic strain of the rail after one pass", strain, "%", strain_error),
        Answer("onset", "load of first yield at this creepage", onset, "N", onset_error),
    ]  # fmt: skip


def picture(work: Work) -> Figure:
    found = work.dataset()
    at = int(np.argmax(np.abs(found["tangential_load_x"].values)))
    x, y, z = (found[name].values * 1e3 for name in "xyz")
    figure, (above, below) = axes(2, 1, (8.0, 7.0), sharex=True)
    touching = found["pressure"].isel(increment=at).values > 0
    shear = np.where(touching, np.abs(found["shear_x"].isel(increment=at).values), np.nan)
    cells(above, x, y, shear / 1e6, "shear traction [MPa]")
    stuck = np.argwhere(found["sticking"].isel(increment=at).values > 0)
    above.plot(x[stuck[:, 0]], y[stuck[:, 1]], "k.", markersize=3)
    finish_titled(
        above,
        "",
        "y across the rail [mm]",
        "dots: cells that stick; the wheel rolls to the right",
        False,
    )
    middle = found.sizes["y"] // 2
    strain = found["equivalent_plastic_strain_body2"].isel(output_increment=-1, y=middle).values
    field(below, x, z, 100 * strain, "plastic strain [%]", "magma_r")
    depth_down(below, z[-1])
    finish_titled(below, "x along the rail [mm]", "depth [mm]", "rail after the pass", False)
    return figure


APPLICATION = Application(
    name="rail_traction",
    title="Rail under traction",
    kind="rail",
    gains="The force that a wheel transmits at a creepage of 0.1 %, the stick zone, and the "
    "plastic strain of the rail.",
    text="The wheel transmits a force of {force}; {stick} of the contact sticks. The maximum "
    "pressure is "
    "{p0}, and "
    "one pass leaves a plastic strain of {strain}. At this creepage the rail first yields at a "
    "load of {onset}.",
    commands=("run rail.toml", "find rail.toml yield"),
    shown=("Estimated grid errors", "Wheel on rail"),
    functions=(
        ("sc.rolling.steady", "steady rolling of elastic bodies"),
        ("sc.paths.rolling", "passes of a rolling contact"),
        ("sc.find_load", "load of first yield"),
        ("sc.shakedown.elliptic", "shakedown limit"),
    ),
    guide=("traction rolling of wheel and rail", "rail.md"),
    limits="The wheel is elastic. The friction coefficient does not fall with the sliding speed. "
    "For several wheels in succession use the fields `passes` and "
    "[shakedown](../case_files.md#shakedown).",
    answers=answers,
    picture=picture,
    caption="Shear traction with the stick zone at the leading edge, and the plastic strain of the "
    "rail after one pass.",
    coarser=(
        ("nx = 27", "nx = 15"),
        ("ny = 21", "ny = 11"),
        ("dx = 0.65e-3", "dx = 1.3e-3"),
        ("dy = 0.65e-3", "dy = 1.3e-3"),
        ("nz = 12", "nz = 6"),
        ("dz = 0.65e-3", "dz = 1.3e-3"),
    ),
)
