# SPDX-License-Identifier: GPL-3.0-or-later
"""The command that prints Hertz values."""

from __future__ import annotations

from typing import Any

import click
import numpy as np

from .. import hertz as _hertz
from .._checks import exactly_one, poisson_ratio, positive
from .._tensors import von_mises
from .arguments import Quantity
from .errors import short_errors

LENGTH, STRESS = Quantity("m"), Quantity("Pa")
Contact = _hertz.PointContact | _hertz.EllipticContact | _hertz.LineContact
Rows = list[tuple[str, float]]


@click.command()
@click.option("--R", "radius", type=LENGTH, required=True, help="Equivalent radius (Rx) [m].")
@click.option("--Ry", "radius_y", type=LENGTH, help="Second equivalent radius [m]: elliptic.")
@click.option("--E-star", "modulus", type=STRESS, required=True, help="Contact modulus [Pa].")
@click.option("--load", type=Quantity("N"), help="Normal load [N].")
@click.option("--length", type=LENGTH, help="Length of a line contact [m].")
@click.option(
    "--load-per-length", type=Quantity("N/m"), help="Load of a line contact, per length [N/m]."
)
@click.option("--approach", type=LENGTH, help="Rigid-body approach [m].")
@click.option("--p0", type=STRESS, help="Maximum pressure [Pa].")
@click.option("--nu", type=float, help="Poisson's ratio: adds the largest von Mises stress.")
@click.option(
    "--depth", "depths", type=LENGTH, multiple=True,
    help="Depth [m] of stresses on the axis, which need --nu; may be repeated.",
)  # fmt: skip
def hertz(
    radius: float,
    radius_y: float | None,
    modulus: float,
    length: float | None,
    nu: float | None,
    depths: tuple[float, ...],
    **given: float | None,
) -> None:
    """Hertz point, elliptic or line contact from one of --load, --approach, --p0.

    A contact with --length or --load-per-length is a line contact, in plane strain.

    Quantities are numbers in SI units, or have a unit: --R "7.5 mm" --E-star "115 GPa".
    """
    with short_errors():
        per_length = given.pop("load_per_length")
        contact: Contact
        if length is not None or per_length is not None:
            if radius_y is not None:
                raise ValueError("Ry is for elliptic contacts: a line contact has no second radius")
            contact, rows = _line(radius, modulus, length, per_length, **given)
        elif radius_y is None:
            contact = _hertz.point(radius, modulus, **given)
            rows = [("contact radius a [m]", contact.a), *_loading(contact)]
        else:
            contact = _hertz.elliptic(radius, radius_y, modulus, **given)
            rows = [
                ("semi-axis a_x [m]", contact.a_x),
                ("semi-axis a_y [m]", contact.a_y),
                ("ellipticity a_y/a_x [-]", contact.k),
                *_loading(contact),
            ]
        if nu is not None:
            rows += _stresses(contact, poisson_ratio("nu", nu), depths)
        elif depths:
            raise ValueError("nu is needed for stresses at a depth: give --nu, e.g. --nu 0.3")
        for label, value in rows:
            click.echo(f"{label:<32}{value:.9g}")


def _loading(contact: _hertz.PointContact | _hertz.EllipticContact) -> Rows:
    return [
        ("load [N]", contact.load),
        ("maximum pressure p0 [Pa]", contact.p0),
        ("approach [m]", contact.approach),
    ]


def _line(
    radius: float,
    modulus: float,
    length: float | None,
    per_length: float | None,
    load: float | None,
    approach: float | None,
    p0: float | None,
) -> tuple[_hertz.LineContact, Rows]:
    """A line contact from one of load, load per length and p0, and its values."""
    if approach is not None:
        raise ValueError(
            "approach is for point and elliptic contacts: that of a line contact depends on the "
            "shape of the whole bodies; give load, load_per_length or p0"
        )
    exactly_one(load=load, load_per_length=per_length, p0=p0)
    if load is not None:
        assert length is not None  # else it is no line contact
        per_length = positive("load", load) / positive("length", length)
    contact = _hertz.line(radius, modulus, load_per_length=per_length, p0=p0)
    rows = [("half-width b [m]", contact.b), ("load per length [N/m]", contact.load_per_length)]
    if length is not None:
        rows.append(("load [N]", contact.load_per_length * positive("length", length)))
    return contact, [*rows, ("maximum pressure p0 [Pa]", contact.p0)]


def _stresses(contact: Contact, nu: float, depths: tuple[float, ...]) -> Rows:
    """The largest von Mises stress, and stresses on the axis at given depths."""
    stress, depth = contact.max_von_mises(nu)
    rows = [("maximum von Mises stress [Pa]", stress), ("its depth [m]", depth)]
    for z in depths:
        normal: Any = [float(component) for component in contact.axis_stress(z, nu)]
        if len(normal) == 2:  # radial and circumferential stress are equal
            normal.insert(0, normal[0])
        for name, value in zip(("xx", "yy", "zz"), normal, strict=True):
            rows.append((f"sigma_{name} at {z:.5g} m [Pa]", value))
        rows.append(
            (f"von Mises at {z:.5g} m [Pa]", float(von_mises(np.array([*normal, 0, 0, 0]))))
        )
    return rows
