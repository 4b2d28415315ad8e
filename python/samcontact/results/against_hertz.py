# SPDX-License-Identifier: GPL-3.0-or-later
"""Computed values at the peak next to those of elastic Hertz contact."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ..hertz import EllipticContact, PointContact

if TYPE_CHECKING:
    import xarray as xr


def hertz_rows(
    dataset: xr.Dataset, peak: int, reference: PointContact | EllipticContact, body: int
) -> list[tuple[str, str, float, float]]:
    """Rows of a comparison.

    Parameters
    ----------
    dataset : xarray.Dataset
        Results.
    peak : int
        Position of the increment, from 0.
    reference : PointContact or EllipticContact
        At its load.
    body : {1, 2}
        Whose von Mises stress is compared.

    Returns
    -------
    list of (name, unit, Hertz, computed)
        SI units.
    """
    rows = [
        ("maximum pressure", "Pa", reference.p0, "max_pressure"),
        ("approach", "m", reference.approach, "approach"),
        ("contact area", "m²", hertz_area(reference), "contact_area"),
    ]
    nu = dataset.attrs.get(f"body{body}_nu")
    if isinstance(reference, PointContact) and nu is not None:
        stress, _ = reference.max_von_mises(float(nu))
        rows.append(("maximum von Mises stress", "Pa", stress, f"max_von_mises_body{body}"))
    return [
        (name, unit, exact, float(dataset[variable].values[peak]))
        for name, unit, exact, variable in rows
        if variable in dataset
    ]


def hertz_area(contact: PointContact | EllipticContact) -> float:
    """Area of the contact [m^2]."""
    if isinstance(contact, PointContact):
        return math.pi * contact.a**2
    return math.pi * contact.a_x * contact.a_y
