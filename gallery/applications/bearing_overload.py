# SPDX-License-Identifier: GPL-3.0-or-later
"""Static overload of a deep groove bearing 6208."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

import samcontact as sc

from ..drawing import APPLICATION_SIZE, axes, depth_down, field, finish_titled
from .application import Answer, Application, Work

BEARING = sc.bearings.standard("6208")


def palmgren_load(race: str) -> float:
    """Load at which Palmgren's formula gives 1e-4 of the ball diameter [N]."""
    D, contact = BEARING.element_diameter, BEARING.race(race)
    loads = np.geomspace(5e3, 50e3, 400)
    depths = [sc.bearings.palmgren_deformation(contact, load, D) for load in loads]
    return float(np.interp(1e-4 * D, depths, loads))


def answers(work: Work) -> list[Answer]:
    inner, outer = work.row("contact load")
    radial = work.row("radial load on the bearing")[0]
    rated = work.row("static load rating")[0][0]
    ball = "load on the ball that leaves 1e-4 D"
    text = "estimate by Palmgren's formula"
    return [
        Answer("inner", f"{ball}, inner race", inner[0], "N", inner[1], text,
               palmgren_load("inner")),
        Answer("outer", f"{ball}, outer race", outer[0], "N", outer[1], text,
               palmgren_load("outer")),
        Answer("radial", "radial load on the bearing", radial[0], "N", radial[1],
               "Stribeck's rule, 9/5 of the ball load", 1.8 * inner[0]),
        Answer("rated", "static load rating C₀", rated, "N", 3e-4, "ISO 76",
               expected=BEARING.static_load_rating),
    ]  # fmt: skip


def picture(work: Work) -> Figure:
    found = work.dataset()
    middle = found.sizes["y"] // 2
    x = found["x"].values * 1e6
    figure, (left, right) = axes(size=APPLICATION_SIZE)
    strain = found["equivalent_plastic_strain_body2"].isel(output_increment=-1, y=middle)
    z = found["z"].values * 1e6
    field(left, x, z, 100 * strain.values, "equivalent plastic strain [%]", "magma_r")
    depth_down(left, min(z[-1], 1000.0))
    finish_titled(
        left, "x along the groove [µm]", "depth [µm]", "plastic zone of the inner race", False
    )
    for body, name, style in ((1, "ball", "-"), (2, "inner race", "k--")):
        depth = found[f"residual_displacement_body{body}"].isel(increment=-1, y=middle)
        right.plot(x, depth.values * 1e6, style, label=name)
    right.invert_yaxis()
    finish_titled(
        right, "x along the groove [µm]", "residual imprint [µm]", "after 24 kN on the bearing"
    )
    return figure


APPLICATION = Application(
    name="bearing_overload",
    title="Static overload of a bearing",
    kind="bearing",
    gains="The load on a bearing 6208 that leaves the permanent deformation permitted by ISO 76, "
    "compared with the static load rating.",
    text="A radial load of {radial} on the bearing leaves a permanent deformation of 1e-4 of the "
    "ball diameter at the inner race. The rating C₀ is {rated}: before the deformation exceeds "
    "the permitted value, the bearing withstands more than its rating. The same deformation at "
    "the outer race needs a higher load on the ball, {outer} instead of {inner}.",
    commands=('find bearing.toml "permanent_deformation=1e-4 D"', "run bearing.toml"),
    shown=("Bearing 6208",),
    functions=(
        ("sc.bearings.standard", "sizes of the bearing"),
        ("sc.bearings.Bearing.element_loads", "loads on the balls"),
        ("sc.bearings.palmgren_deformation", "Palmgren's formula"),
        ("sc.find_load", "load for a given permanent deformation"),
    ),
    guide=("static overload of a bearing", "bearing.md"),
    limits="Manufacturers do not publish internal dimensions; ball and pitch diameter are "
    "estimates. Palmgren's formula is a fit to tests of steel with 63.5 to 65.5 HRC, which "
    "is not the steel in the case file.",
    answers=answers,
    picture=picture,
    caption="Plastic zone below the inner race, and the imprints that remain in ball and race.",
)
