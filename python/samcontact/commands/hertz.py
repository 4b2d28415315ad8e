# SPDX-License-Identifier: GPL-3.0-or-later
"""Command `hertz`: Hertz contact of a given geometry and load."""

from __future__ import annotations

from typing import Any

import click
import numpy as np

from .. import hertz as _hertz
from .._util.check import Check
from .._util.checks import exactly_one, poisson_ratio, positive
from .._util.tensors import von_mises
from ..diagnostics.expected_contact import ExpectedContact, ExpectedExtent
from ..diagnostics.plausibility import (
    MAX_HALF_WIDTH_RATIO,
    PlausibilityCheck,
    part_of_radius,
    warn_if_implausible,
)
from .arguments import QuantityArgument, UnitlessNumber
from .errors import short_errors

LENGTH, STRESS = QuantityArgument("m"), QuantityArgument("Pa")
HertzContact = _hertz.PointContact | _hertz.EllipticContact | _hertz.LineContact
Rows = list[tuple[str, float]]
_PLAUSIBLE_LIMITS = {
    "R": (False, 1.0, "m", "7.5 mm"),
    "Ry": (False, 1.0, "m", "7.5 mm"),
    "E_star": (True, 1e6, "Pa", "115 GPa"),
    "load": (False, 1e6, "N", "2 MN"),
    "length": (False, 10.0, "m", "12 mm"),
    "load_per_length": (False, 1e9, "N/m", "500 N/mm"),
    "depth": (False, 1.0, "m", "0.2 mm"),
    "approach": (False, 1e-3, "m", "5 um"),
    "p0": (True, 1e5, "Pa", "1.5 GPa"),
}
"""Limit beyond which a number without a unit is implausible, by option.

Each entry contains: whether the limit is a lower limit, its value, its unit, and an example of a
value with a unit."""


@click.command(short_help="Print a Hertz solution.")
@click.option("--R", "radius", type=LENGTH, required=True, help="Equivalent radius (Rx) [m].")
@click.option(
    "--Ry", "radius_y", type=LENGTH, help="Second equivalent radius [m], for an elliptic contact."
)
@click.option("--E-star", "modulus", type=STRESS, required=True, help="Contact modulus [Pa].")
@click.option("--load", type=QuantityArgument("N"), help="Normal load [N].")
@click.option("--length", type=LENGTH, help="Length of a line contact [m].")
@click.option(
    "--load-per-length",
    type=QuantityArgument("N/m"),
    help="Load per length of a line contact [N/m].",
)
@click.option("--approach", type=LENGTH, help="Rigid-body approach [m].")
@click.option("--p0", type=STRESS, help="Maximum pressure [Pa].")
@click.option("--nu", type=float, help="Poisson's ratio; adds the maximum von Mises stress.")
@click.option(
    "--depth", "depths", type=LENGTH, multiple=True,
    help="Depth [m] at which to print the stresses on the axis (requires --nu); may be repeated.",
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
    """Print the Hertz solution for a given --load, --approach or --p0.

    Without further options, the contact is a circular point contact. It is elliptic with --Ry, and
    a line contact in plane strain with --length or --load-per-length.

    Quantities are numbers in SI units or numbers with a unit: --R "7.5 mm" --E-star "115 GPa".
    """
    with short_errors():
        per_length = given.pop("load_per_length")
        contact: HertzContact
        if length is not None or per_length is not None:
            if radius_y is not None:
                raise ValueError("Ry cannot be combined with a line contact: omit --Ry")
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
            raise ValueError("nu is required for stresses at a depth: add --nu, e.g. --nu 0.3")
        numbers = {"R": radius, "Ry": radius_y, "E_star": modulus, "length": length}
        _warn_of_unit_errors(contact, {**numbers, "load_per_length": per_length, **given})
        for label, value in rows:
            click.echo(f"{label:<40}{value:.9g}")


def _check_of_number(name: str, value: float) -> PlausibilityCheck:
    """Return the plausibility check of an option whose value was given without a unit."""
    at_least, limit, unit, example = _PLAUSIBLE_LIMITS[name]
    option = "--" + name.replace("_", "-")
    remedy = f'Numbers without a unit are in {unit}; for other units, write {option} "{example}"'
    return PlausibilityCheck(Check(option, value, limit, at_least, unit), lambda: remedy)


def _warn_of_unit_errors(contact: HertzContact, given: dict[str, float | None]) -> None:
    """Warn if a number without a unit is implausible, or if the contact size is implausible."""
    for name, value in given.items():
        if isinstance(value, UnitlessNumber):
            warn_if_implausible(_check_of_number(name, value), stacklevel=2)
    if isinstance(contact, _hertz.LineContact):
        check = Check("half-width over the radius", contact.b / contact.R, MAX_HALF_WIDTH_RATIO)
        finding = PlausibilityCheck(check, lambda: "The bodies are modelled as half-spaces")
    else:
        finding = part_of_radius(ExpectedExtent(ExpectedContact(contact), (0.0, 0.0)))
    warn_if_implausible(finding, stacklevel=2)


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
    """Return the line contact for a given load, load per length or p0, and its table rows."""
    if approach is not None:
        raise ValueError(
            "approach is not supported for a line contact, because it depends on the shape of the "
            "whole bodies: use load, load_per_length or p0"
        )
    exactly_one(load=load, load_per_length=per_length, p0=p0)
    if load is not None:
        assert length is not None  # without length or load per length, `_line` is not called
        per_length = positive("load", load) / positive("length", length)
    contact = _hertz.line(radius, modulus, load_per_length=per_length, p0=p0)
    rows = [("half-width b [m]", contact.b), ("load per length [N/m]", contact.load_per_length)]
    if length is not None:
        rows.append(("load [N]", contact.load_per_length * positive("length", length)))
    return contact, [*rows, ("maximum pressure p0 [Pa]", contact.p0)]


def _stresses(contact: HertzContact, nu: float, depths: tuple[float, ...]) -> Rows:
    """Return the table rows of stresses: maximum von Mises stress, and stresses at given depths."""
    stress, depth = contact.max_von_mises(nu)
    rows = [
        ("maximum von Mises stress [Pa]", stress),
        ("depth of maximum von Mises stress [m]", depth),
    ]
    for z in depths:
        normal: Any = [float(component) for component in contact.axis_stress(z, nu)]
        if len(normal) == 2:  # radial and circumferential stress are equal
            normal.insert(0, normal[0])
        for name, value in zip(("xx", "yy", "zz"), normal, strict=True):
            rows.append((f"sigma_{name} at {z:.5g} m [Pa]", value))
        rows.append(
            (f"von Mises stress at {z:.5g} m [Pa]", float(von_mises(np.array([*normal, 0, 0, 0]))))
        )
    return rows
