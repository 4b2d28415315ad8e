# SPDX-License-Identifier: GPL-3.0-or-later
"""Static capacity: load rating from a maximum pressure, and permanent deformation by Palmgren."""

from __future__ import annotations

import math
from collections.abc import Sequence

from .. import hertz
from .._util.checks import integer, non_negative, positive, require_type
from .._util.short_text import in_short
from .loads import stribeck_load
from .races import RaceContact

STEEL_CONTACT_MODULUS = 2.07e11 / (1.0 - 0.3**2) / 2.0
"""Contact modulus used for the factors of ISO 76 [Pa]: E = 207 GPa, nu = 0.3 for both bodies."""
PALMGREN_FACTOR = 1.3e-19
"""Factor of Palmgren's formula (`palmgren_deformation`) [m^4/N^2]; 1.3e-7 in mm and N."""


def static_load_rating(
    races: Sequence[RaceContact],
    balls: int,
    contact_angle: float = 0.0,
    *,
    pressure: float = 4.2e9,
    length: float | None = None,
    rows: int = 1,
    E_star: float = STEEL_CONTACT_MODULUS,
) -> float:
    """Basic static radial load rating according to ISO 76.

    The rating is the radial load at which the Hertz pressure of the most heavily loaded element
    reaches `pressure` on one raceway; the pressure on the other raceway is lower. The element load
    follows from Stribeck's rule (`stribeck_load`).

    Parameters
    ----------
    races : sequence of RaceContact
        Contacts on the inner and the outer ring, usually with conformities of 0.52 and 0.53.
    balls : int
        Number of balls or rollers in a row, Z >= 1.
    contact_angle : float, optional
        Contact angle [rad], < pi/2.
    pressure : float, optional
        Maximum Hertz pressure [Pa]: 4.2e9 for ball bearings (default), 4.6e9 for self-aligning ball
        bearings, 4.0e9 for roller bearings.
    length : float, optional
        Contact length of a roller [m]. Required for uncrowned rollers, not allowed otherwise.
    rows : int, optional
        Number of rows of rolling elements, >= 1.
    E_star : float, optional
        Contact modulus [Pa]. Default: value in ISO 76.

    Returns
    -------
    float
        Static load rating C_0r [N].

    Raises
    ------
    ValueError
        An argument is outside its range, or `length` is missing or not applicable.

    Notes
    -----
    At the pressures given for `pressure` above, the permanent deformation of element and raceway
    together is about 1e-4 of the element diameter. This function does not compute plastic
    deformation. The factors f_0 of the standard (C_0r = f_0 i Z D^2 cos(alpha) with N and mm) are
    reproduced to all published digits, as is the factor 44 that the standard uses for rollers. The
    standard uses the same formulas, so this agreement does not validate the actual capacity of a
    bearing. Sources: ISO 76:2006, *Static load ratings*; ISO/TR 10657, *Explanatory notes on ISO
    76*.
    """
    if not isinstance(races, Sequence) or not all(isinstance(r, RaceContact) for r in races):
        raise TypeError(
            f"races must be a list of samcontact.bearings.RaceContact, got {in_short(races)}"
        )
    if len(races) == 0:
        raise ValueError("races must contain at least one contact, got none")
    load = min(_load_at(race, positive("pressure", pressure), E_star, length) for race in races)
    return integer("rows", rows, 1) * load / stribeck_load(1.0, balls, contact_angle)


def _load_at(race: RaceContact, pressure: float, E_star: float, length: float | None) -> float:
    if math.isinf(race.Ry):
        if length is None:
            raise ValueError(
                "length must be a number > 0 [m] for rollers without "
                "crowning, got None: give the effective length of the roller"
            )
        line = hertz.line(race.Rx, E_star, p0=pressure)
        return line.load_per_length * positive("length", length)
    if length is not None:
        raise ValueError(
            f"length must be None for balls and crowned rollers, got {in_short(length)}"
        )
    return hertz.elliptic(race.Rx, race.Ry, E_star, p0=pressure).load


def palmgren_deformation(race: RaceContact, load: float, ball_diameter: float) -> float:
    """Permanent deformation of ball and raceway together, by Palmgren's formula.

    The formula is 1.3e-7 Q^2/D (rho_I1 + rho_II1)(rho_I2 + rho_II2), in N and mm. The curvature
    sums along and transverse to the rolling direction, rho_I1 + rho_II1 and rho_I2 + rho_II2, are
    1/Rx and 1/Ry. The formula was fitted to tests of bearing steel with 63.5 to 65.5 HRC (A.
    Palmgren, *Ball and Roller Bearing Engineering*, 3rd ed., 1959, cited by Harris, *Rolling
    Bearing Analysis*).

    Parameters
    ----------
    race : RaceContact
        Contact from `ball_on_race`; a ball on a flat has Rx = Ry = ball_diameter/2.
    load : float
        Ball load Q [N], >= 0.
    ball_diameter : float
        Ball diameter D [m].

    Returns
    -------
    float
        Permanent deformation [m].

    Raises
    ------
    ValueError
        An argument is outside its range.

    Notes
    -----
    At the pressures listed in `static_load_rating`, the formula gives a deformation of about 1e-4
    of the ball diameter, as the standard states. Formula and pressures were derived from the same
    tests, so this agreement validates neither of them.
    """
    require_type("race", race, RaceContact)
    Q, D = non_negative("load", load), positive("ball_diameter", ball_diameter)
    return PALMGREN_FACTOR * Q**2 / (D * race.Rx * race.Ry)
