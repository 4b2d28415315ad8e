# SPDX-License-Identifier: GPL-3.0-or-later
"""Coated gear flank under friction."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

import samcontact as sc

from ..drawing import APPLICATION_SIZE, axes, depth_down, finish_titled
from .application import Answer, Application, Work, largest

STEEL, COATING = sc.Material.elastic(206e9, 0.3), sc.Material.elastic(300e9, 0.22)
XX, YY, ZZ = 0, 1, 2


def in_coating(below: np.ndarray) -> np.ndarray:
    """Stress along x in the coating from the stress below the interface.

    The strains along the interface and the stress normal to it are continuous.
    """
    xx, yy, zz = below[XX], below[YY], below[ZZ]
    e_xx = (xx - STEEL.nu * (yy + zz)) / STEEL.E
    e_yy = (yy - STEEL.nu * (xx + zz)) / STEEL.E
    E, nu = COATING.E, COATING.nu
    found: np.ndarray = E / (1 - nu**2) * (e_xx + nu * e_yy) + nu / (1 - nu) * zz
    return found


def flank() -> sc.hertz.EllipticContact:
    """Hertz contact of the flanks without coating."""
    pair = sc.parts.GearPair(
        module=4.5e-3, teeth=(16, 24), face_width=14e-3, profile_shift=(0.1817, 0.1715),
        tip_diameter=(82.5e-3, 118.4e-3), crowning=20e-6,
    )  # fmt: skip
    contact = pair.at("B")
    E_star = sc.hertz.effective_modulus(STEEL, STEEL)
    return sc.hertz.elliptic(contact.radius, 14e-3**2 / (8 * 20e-6), E_star, contact.load(150.0))


def sides(work: Work) -> tuple[np.ndarray, np.ndarray]:
    """Stress in the coating and in the steel at the interface, shape (6, nx, ny)."""
    stress = work.dataset()["interface_stress_body2"].isel(output_increment=-1)
    stress = stress.isel(interface_body2=0).transpose("side", "component", "x", "y").values
    return stress[0], stress[1]


def answers(work: Work) -> list[Answer]:
    p0, error = largest(work.dataset(), "max_pressure")
    above, below = sides(work)
    return [
        Answer("p0", "maximum pressure", p0, "Pa", error, "Hertz, without coating", flank().p0),
        Answer("tension", "largest tension along x in the coating", float(above[XX].max()), "Pa",
               check="from the steel, with equal strain", expected=float(in_coating(below).max())),
        Answer("steel", "largest tension along x in the steel below", float(below[XX].max()), "Pa"),
        Answer("shear", "largest shear stress at the interface", float(np.abs(above[4]).max()),
               "Pa", check="on the steel side", expected=float(np.abs(below[4]).max())),
    ]  # fmt: skip


def picture(work: Work) -> Figure:
    found = work.dataset()
    above, below = sides(work)
    middle = found.sizes["y"] // 2
    x = found["x"].values * 1e6
    figure, (left, right) = axes(size=APPLICATION_SIZE)
    left.plot(x, above[XX, :, middle] / 1e6, label="coating")
    left.plot(x, below[XX, :, middle] / 1e6, label="steel")
    finish_titled(left, "x along the profile [µm]", "stress along x [MPa]", "at the interface")
    stress = found["stress_body2"].isel(output_increment=-1, y=middle, component=0)
    trailing, z = int(np.argmax(above[XX, :, middle])), found["z"].values * 1e6
    of_cells = stress.isel(x=trailing).values
    ends = above[XX, trailing, middle], below[XX, trailing, middle]
    coating, steel = of_cells[z < 3.0], of_cells[z > 3.0]
    right.plot(np.append(coating, ends[0]) / 1e6, np.append(z[z < 3.0], 3.0), "o-", label="coating")
    right.plot(np.append(ends[1], steel) / 1e6, np.append(3.0, z[z > 3.0]), "o-", label="steel")
    depth_down(right, 6.0)
    right.axhline(3.0, color="k", linestyle="--", label="interface")
    finish_titled(right, "stress along x [MPa]", "depth [µm]", f"at x = {x[trailing]:.0f} µm")
    return figure


APPLICATION = Application(
    name="coated_gear",
    title="Coated gear",
    kind="coated_gear",
    gains="Tension in the coating of a gear flank under friction, and the shear stress at the "
    "interface between coating and steel.",
    text="Behind the contact, friction causes a tension of {tension} in the coating, and of "
    "{steel} in the steel below, which is softer and has the same strain. The interface transmits "
    "a shear stress of {shear}. The coating hardly changes the maximum pressure, which is {p0}.",
    commands=("run coated_gear.toml",),
    shown=("Estimated grid errors",),
    functions=(
        ("sc.Layered", "coated body"),
        ("sc.parts.GearPair", "flanks from module, teeth and torque"),
        ("sc.ContactSolver.stress", "stress at given depths, on both sides of an interface"),
        ("sc.State.interface_stress", "the same in a simulation"),
    ),
    guide=("coatings and layers", "coating.md"),
    limits="The coating adheres perfectly. It has no growth stress here; the field "
    "`residual_stress` of a layer prescribes one. Roughness and lubricant are not modelled.",
    answers=answers,
    picture=picture,
    caption="Stress along the profile at the interface, on both sides, and over depth where the "
    "tension is largest.",
    coarser=(
        ("nx = 41", "nx = 21"),
        ("ny = 41", "ny = 21"),
        ("dx = 24e-6", "dx = 48e-6"),
        ("dy = 0.36e-3", "dy = 0.72e-3"),
    ),
)
