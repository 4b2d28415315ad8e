# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts, load distribution and static capacity of rolling bearings.

x is the rolling direction, y the transverse direction; angles are in radians. Symbols follow T. A.
Harris, M. N. Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2006), chapters 2 and 7. Radii are
defined as in B. J. Hamrock, D. E. Brewe, *J. Lubr. Technol.* 105 (1983) 171-177,
doi:10.1115/1.3254558.
"""

from .bearing import Bearing
from .equilibrium import ElementLoads
from .loads import LoadZone, ball_load, load_zone, sjovall, stribeck_load
from .races import RaceContact, ball_on_race, roller_on_race
from .rating import palmgren_deformation, static_load_rating
from .standard import from_boundary, standard

__all__ = [
    "Bearing",
    "ElementLoads",
    "LoadZone",
    "RaceContact",
    "ball_load",
    "ball_on_race",
    "from_boundary",
    "load_zone",
    "palmgren_deformation",
    "roller_on_race",
    "sjovall",
    "standard",
    "static_load_rating",
    "stribeck_load",
]
