# SPDX-License-Identifier: GPL-3.0-or-later
"""Comparison of the results of an increment with the elastic Hertz contact."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from .._util.quantities import CONTACT, Quantity
from ..hertz import EllipticContact, PointContact

if TYPE_CHECKING:
    import xarray as xr


def hertz_rows(
    dataset: xr.Dataset, peak: int, reference: PointContact | EllipticContact, body: int
) -> list[tuple[Quantity, float, float]]:
    """Return one row for each compared quantity: its name, Hertz value and computed value.

    Parameters
    ----------
    dataset : xarray.Dataset
        Results.
    peak : int
        Index of the increment, from 0.
    reference : PointContact or EllipticContact
        Hertz contact at the load of the increment.
    body : {1, 2}
        Body whose von Mises stress is compared.

    Returns
    -------
    list of (quantity, Hertz, computed)
        Values in SI units.
    """
    exact = {
        "max_pressure": reference.p0,
        "approach": reference.approach,
        "contact_area": hertz_area(reference),
    }
    nu = dataset.attrs.get(f"body{body}_nu")
    if nu is not None:
        exact[f"max_von_mises_body{body}"], _ = reference.max_von_mises(float(nu))
    return [
        (CONTACT[name.removesuffix(f"_body{body}")], value, float(dataset[name].values[peak]))
        for name, value in exact.items()
        if name in dataset
    ]


def hertz_area(contact: PointContact | EllipticContact) -> float:
    """Return the contact area of a Hertz contact [m^2]."""
    if isinstance(contact, PointContact):
        return math.pi * contact.a**2
    return math.pi * contact.a_x * contact.a_y
