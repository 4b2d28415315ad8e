# SPDX-License-Identifier: GPL-3.0-or-later
"""Hertz estimate of the contact of smooth surfaces."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from .. import hertz
from .._util.cached_property import cached_property
from .._util.display import lengths, quantity

MIN_CONTACT_MODULUS = 1e4
"""Contact modulus [Pa] below which the unit of E may be wrong: only soft gels are more compliant.
"""


@dataclass(frozen=True)
class ExpectedContact:
    """Elastic Hertz contact of smooth bodies.

    The text `str(...)` gives the contact size, the maximum pressure and, if E* is very small, a
    hint on units.
    """

    contact: hertz.PointContact | hertz.EllipticContact

    @cached_property
    def semi_axes(self) -> tuple[float, float]:
        """Larger and smaller semi-axis of the contact [m]."""
        a_x, a_y = self.along_axes
        return max(a_x, a_y), min(a_x, a_y)

    @property
    def along_axes(self) -> tuple[float, float]:
        """Semi-axes along x and y [m], for a contact aligned with the axes."""
        if isinstance(self.contact, hertz.PointContact):
            return self.contact.a, self.contact.a
        return self.contact.a_x, self.contact.a_y

    def __str__(self) -> str:
        long, short = self.semi_axes
        size = f"radius {quantity(long, 'm')}"
        if long != short:
            size = f"semi-axes {lengths(long, short)}"
        text = f"Hertz: {size}, p0 = {quantity(self.contact.p0, 'Pa')}"
        if self.contact.E_star < MIN_CONTACT_MODULUS:
            text += f", with E* = {self.contact.E_star:.4g} Pa (E is in pascals: 210 GPa is 210e9)"
        return text


class ExpectedExtent(NamedTuple):
    """Hertz estimate of a contact, with half-widths along x and y [m]."""

    expected: ExpectedContact
    extent: tuple[float, float]
    driver: str = "load"

    @property
    def radii(self) -> tuple[float, float]:
        """Radii of curvature in the planes of the larger and the smaller semi-axis [m]."""
        contact = self.expected.contact
        if isinstance(contact, hertz.EllipticContact):
            return max(contact.Rx, contact.Ry), min(contact.Rx, contact.Ry)
        return contact.R, contact.R

    @property
    def part_of_radius(self) -> float:
        """Maximum ratio of semi-axis to radius of curvature [-]."""
        (long, short), (larger, smaller) = self.expected.semi_axes, self.radii
        return max(long / larger, short / smaller)
