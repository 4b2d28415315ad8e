# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed-form Hertz contact: point, elliptic and line contact, with their stresses.

Symbols follow K. L. Johnson, *Contact Mechanics* (1985), doi:10.1017/CBO9781139171731.
Pressure is positive in compression. Stress is positive in tension. z points into the body.
"""

from .elliptic_contact import EllipticContact, elliptic
from .line_contact import LineContact, line
from .modulus import effective_modulus
from .point_contact import PointContact, point

__all__ = [
    "EllipticContact",
    "LineContact",
    "PointContact",
    "effective_modulus",
    "elliptic",
    "line",
    "point",
]
