# SPDX-License-Identifier: GPL-3.0-or-later
"""Case depth of a gear flank."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

import samcontact as sc

from ..drawing import APPLICATION_SIZE, axes, depth_down, finish_titled
from .application import Answer, Application, Work, largest

STEEL = sc.Material.elastic(E=206e9, nu=0.3)
FLANK = sc.hertz.line(25e-3, sc.hertz.effective_modulus(STEEL, STEEL), p0=1.5e9)
CRITERIA = {"yield": "yield", "dang_van": "Dang Van", "orthogonal_shear": "orthogonal shear"}


def exposure(depth: float) -> sc.fatigue.Exposure:
    """Exposure by the closed form of a line contact. depth: case hardening depth [m]."""
    case = sc.hardness.hardened_case(surface=620.0, core=400.0, depth=depth)
    return sc.fatigue.exposure(sc.fatigue.hertz_cycle(FLANK, STEEL), case, slope=0.3, defect=20e-6)


def answers(work: Work) -> list[Answer]:
    found, judged = work.dataset(), work.dataset("fatigue.nc")
    swept = work.dataset("sweep/sweep.nc")
    p0, error = largest(found, "max_pressure")
    closed = "closed form"
    rows = [
        Answer("p0", "maximum pressure", p0, "Pa", error, "Hertz", FLANK.p0),
        Answer("dang_van", "Dang Van's stress (slope 0.3), maximum",
               float(judged["dang_van"].max()), "Pa", check="0.1707 p0, closed form",
               expected=0.1707 * FLANK.p0),
    ]  # fmt: skip
    for number, depth in enumerate(swept["body2.hardness.depth"].values):
        one = swept.sel({"body2.hardness.depth": depth})
        rows.append(
            Answer(f"chd{number}", f"exposure (orthogonal shear) with a CHD of {depth * 1e3:g} mm",
                   float(one["exposure_orthogonal_shear"]), "", check=closed,
                   expected=exposure(depth).max_value("orthogonal_shear"))
        )  # fmt: skip
    return rows


def picture(work: Work) -> Figure:
    judged, swept = work.dataset("fatigue.nc"), work.dataset("sweep/sweep.nc")
    figure, (left, right) = axes(size=APPLICATION_SIZE)
    z = judged["z"].values * 1e3
    for name, label in CRITERIA.items():
        left.plot(judged[f"exposure_{name}"].values, z, label=label)
        depths = swept["body2.hardness.depth"].values * 1e3
        right.plot(depths, np.ravel(swept[f"exposure_{name}"].values), "o-", label=label)
    depth_down(left, 1.5)
    finish_titled(left, "exposure: stress / local strength", "depth [mm]", "case of 0.5 mm")
    finish_titled(
        right, "case hardening depth (CHD) [mm]", "largest exposure", "how deep must it be?"
    )
    return figure


APPLICATION = Application(
    name="case_depth",
    title="Case depth of a gear",
    kind="case_depth",
    gains="Stress divided by local strength at each depth of a hardened flank, and the case depth "
    "beyond which a deeper case gains little.",
    text="The exposure is the orthogonal shear stress divided by the local strength. It is {chd0} "
    "with a case hardening depth (CHD) of 0.3 mm, {chd1} with 0.5 mm, {chd2} with 0.7 mm and "
    "{chd4} with "
    "1.1 mm. A value of 1 is the limit: the thinnest case is not deep enough, and further "
    "depth gains little.",
    commands=(
        "run case_depth.toml",
        "sweep case_depth.toml --set body2.hardness.depth=0.3e-3,0.5e-3,0.7e-3,0.9e-3,1.1e-3",
    ),
    shown=("Exposure of body 2",),
    functions=(
        ("sc.hardness.hardened_case", "hardness over depth"),
        ("sc.fatigue.hertz_cycle", "stress cycle of a line contact in closed form"),
        ("sc.fatigue.exposure", "stress over local strength"),
        ("sc.sweep", "parameter study"),
    ),
    guide=("case depth of a gear tooth", "gear.md#exposure-over-depth"),
    limits="Root bending, dynamic loads and the lubricant are not modelled. The strengths follow "
    "from the hardness by the correlations on the page [life](../theory/life.md).",
    answers=answers,
    picture=picture,
    caption="Exposure (stress divided by local strength) over depth for a case of 0.5 mm, and "
    "largest exposure for each case depth.",
    coarser=(
        ("nx = 96", "nx = 48"),
        ("dx = 20e-6", "dx = 40e-6"),
        ("nz = 80", "nz = 40"),
        ("dz = 20e-6", "dz = 40e-6"),
    ),
)
