# SPDX-License-Identifier: GPL-3.0-or-later
"""Fretting of a blade root."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.figure import Figure

import samcontact as sc

from ..drawing import APPLICATION_SIZE, axes, finish_titled
from .application import Answer, Application, Work

TITANIUM = sc.Material.elastic(E=116e9, nu=0.32)
MU, P, Q = 0.5, 500.0, 150.0
LINE = sc.hertz.line(0.1, sc.hertz.effective_modulus(TITANIUM, TITANIUM), P / 1e-3)
STICK = math.sqrt(1 - Q / (MU * P))


def tension(x: np.ndarray, z: float) -> np.ndarray:
    """Stress along x at full force in closed form [Pa].

    The shear traction is that of full sliding, less that of full sliding of the stick zone alone
    (Cattaneo, Mindlin).
    """
    inner = sc.hertz.line(0.1, LINE.E_star, STICK**2 * P / 1e-3)
    nu = TITANIUM.nu
    sheared: np.ndarray = LINE.stress(x, z, nu, MU)[0]
    inside: np.ndarray = (inner.stress(x, z, nu, MU) - inner.stress(x, z, nu))[0]
    total: np.ndarray = sheared - inside
    return total


def answers(work: Work) -> list[Answer]:
    found, judged = work.dataset(), work.dataset("fatigue.nc")
    at = int(np.argmax(found["tangential_load_x"].values))
    stick = float(found["stick_fraction"].values[at])
    stuck = found["sticking"].isel(increment=at).values.sum() / found.sizes["x"]
    cell = 1.0 / (stuck * found.sizes["x"])
    force, shift = found["tangential_load_x"].values, found["shift_x"].values
    loop = slice(at, None)
    area = float(-np.trapezoid(shift[loop], force[loop]))
    work_of_cycle = float(found["friction_work"].values[-1] - found["friction_work"].values[at])
    stress = found["stress_body2"].isel(component=0, output_increment=-1, z=0)
    places, depth = found["x"].values, float(found["z"].values[0])
    p0 = float(found["max_pressure"].values[at])
    error = float(found["max_pressure_error"].values[at]) / p0
    worst = judged["findley"]
    return [
        Answer("p0", "maximum pressure", p0, "Pa", error, "Hertz", LINE.p0),
        Answer("stick", "stick fraction of the contact at full force", stick, "%", cell,
               "Cattaneo and Mindlin", STICK),
        Answer("work", "friction work per cycle and mm", work_of_cycle, "J",
               float(found["friction_work_error"].values[-1] / found["friction_work"].values[-1]),
               "area of the fretting loop (trapezoids)", abs(area)),
        Answer("tension", "tension at the edge, in the first layer of cells",
               float(stress.max()), "Pa", check="closed form (Cattaneo, Mindlin)",
               expected=float(tension(places, depth).max())),
        Answer("findley", "Findley's stress (k = 0.2), maximum", float(worst.max()), "Pa"),
        Answer("place", "distance of this maximum from the edge of the contact",
               abs(abs(float(worst.stack(c=worst.dims).idxmax("c").item()[0])) - LINE.b), "m"),
    ]  # fmt: skip


def picture(work: Work) -> Figure:
    found = work.dataset()
    x = found["x"].values * 1e3
    figure, (left, right) = axes(size=APPLICATION_SIZE)
    last = found.isel(increment=-1, y=0)
    left.plot(x, MU * last["pressure"].values / 1e6, "k--", label="friction limit μp")
    left.plot(x, last["shear_x"].values / 1e6, label="shear traction")
    stress = found["stress_body2"].isel(component=0, output_increment=-1, y=0, z=0)
    left.plot(x, stress.values / 1e6, label="stress along x, 6 µm deep")
    left.set_ylim(-380.0, 400.0)  # room for the legend
    finish_titled(left, "x [mm]", "[MPa]", "at full force")
    right.plot(found["shift_x"].values * 1e6, found["tangential_load_x"].values, ".-")
    finish_titled(right, "displacement [µm]", "tangential force [N/mm]", "fretting loop", False)
    return figure


APPLICATION = Application(
    name="blade_root",
    title="Fretting of a blade",
    kind="blade",
    gains="The slip zone, the friction work and the tension at the edge of the contact when a "
    "blade root is pressed and moved to and fro.",
    text="At full force {stick} of the contact sticks, and the edges slip. Each cycle dissipates "
    "{work} per millimetre. The tension at the trailing edge reaches {tension}; Findley's stress "
    "also has its maximum near this edge, {findley}, {place} from the edge of the contact.",
    commands=("run blade.toml",),
    shown=("Estimated grid errors", "Fatigue of body 2"),
    functions=(
        ("sc.paths.fretting_loop", "cyclic tangential force"),
        ("sc.Coulomb", "Coulomb friction with partial slip"),
        ("sc.fatigue.findley", "Findley's criterion"),
        ("sc.wear.fretting", "fretting wear"),
    ),
    guide=("fretting and wear", "fretting.md"),
    limits="The pad is a cylinder of 100 mm radius; the bulk stress of the blade is not included. "
    "The error of the stick fraction corresponds to one cell. The maximum of Findley's stress is "
    "within two cells of the edge, also on larger cells.",
    answers=answers,
    picture=picture,
    caption="Shear traction and stress along the surface at full force, and the fretting loop.",
    coarser=(
        ("nx = 108", "nx = 54"),
        ("dx = 24e-6", "dx = 48e-6"),
    ),
)
