# SPDX-License-Identifier: GPL-3.0-or-later
"""The command that prints Hertz values."""

from __future__ import annotations

from typing import Any

import click

from .. import hertz as _hertz
from .._checks import poisson_ratio
from .._doubts import Contact, Doubt, part_of_radius, warn_of
from .._expected import Expected
from .._verdict import Verdict
from .arguments import Bare, Quantity
from .errors import short_errors

LENGTH, STRESS = Quantity("m"), Quantity("Pa")
_USUAL = {
    "R": (False, 1.0, "m", "7.5 mm"),
    "Ry": (False, 1.0, "m", "7.5 mm"),
    "E-star": (True, 1e6, "Pa", "115 GPa"),
    "load": (False, 1e6, "N", "2 MN"),
    "approach": (False, 1e-3, "m", "5 um"),
    "p0": (True, 1e5, "Pa", "1.5 GPa"),
}
"""Whether a number without a unit has a least or a largest value, which, and an example."""


def _warn_of_slips(
    contact: _hertz.PointContact | _hertz.EllipticContact, given: dict[str, float | None]
) -> None:
    """Warn of numbers without a unit that are unusual, and of a contact that cannot be."""
    for name, value in given.items():
        at_least, limit, unit, example = _USUAL[name]
        if isinstance(value, Bare):
            verdict = Verdict(f"--{name}", value, limit, at_least, unit)
            remedy = f'A number without a unit is in {unit}: or write --{name} "{example}"'
            warn_of(Doubt(verdict, lambda remedy=remedy: remedy), stacklevel=2)  # type: ignore[misc]
    warn_of(part_of_radius(Contact(Expected(contact), (0.0, 0.0))), stacklevel=2)


@click.command()
@click.option("--R", "radius", type=LENGTH, required=True, help="Equivalent radius (Rx) [m].")
@click.option("--Ry", "radius_y", type=LENGTH, help="Second equivalent radius [m]: elliptic.")
@click.option("--E-star", "modulus", type=STRESS, required=True, help="Contact modulus [Pa].")
@click.option("--load", type=Quantity("N"), help="Normal load [N].")
@click.option("--approach", type=LENGTH, help="Rigid-body approach [m].")
@click.option("--p0", type=STRESS, help="Maximum pressure [Pa].")
@click.option("--nu", type=float, help="Poisson's ratio: adds the largest von Mises stress.")
def hertz(
    radius: float,
    radius_y: float | None,
    modulus: float,
    load: float | None,
    approach: float | None,
    p0: float | None,
    nu: float | None,
) -> None:
    """Hertz point or elliptic contact from one of --load, --approach, --p0.

    Quantities are numbers in SI units, or have a unit: --R "7.5 mm" --E-star "115 GPa".
    """
    with short_errors():
        given: dict[str, Any] = {"load": load, "approach": approach, "p0": p0}
        contact: _hertz.PointContact | _hertz.EllipticContact
        rows: list[tuple[str, float]]
        if radius_y is None:
            contact = _hertz.point(radius, modulus, **given)
            rows = [("contact radius a [m]", contact.a)]
        else:
            contact = _hertz.elliptic(radius, radius_y, modulus, **given)
            rows = [
                ("semi-axis a_x [m]", contact.a_x),
                ("semi-axis a_y [m]", contact.a_y),
                ("ellipticity a_y/a_x [-]", contact.k),
            ]
        rows += [
            ("load [N]", contact.load),
            ("maximum pressure p0 [Pa]", contact.p0),
            ("approach [m]", contact.approach),
        ]
        if nu is not None:
            poisson_ratio("nu", nu)
            if not isinstance(contact, _hertz.PointContact):
                raise ValueError("nu is for point contacts: the elliptic axis stress is not built")
            stress, depth = contact.max_von_mises(nu)
            rows += [("maximum von Mises stress [Pa]", stress), ("its depth [m]", depth)]
        _warn_of_slips(
            contact, {"R": radius, "Ry": radius_y, "E-star": modulus, "load": load,
                      "approach": approach, "p0": p0},
        )  # fmt: skip
        for label, value in rows:
            click.echo(f"{label:<32}{value:.9g}")
