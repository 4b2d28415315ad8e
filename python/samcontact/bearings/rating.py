# SPDX-License-Identifier: GPL-3.0-or-later
"""Static capacity: the load rating by a largest pressure, and Palmgren's permanent deformation."""

from __future__ import annotations

import math
from collections.abc import Sequence

from .. import hertz
from .._util.checks import integer, non_negative, positive, require_type
from .._util.short_text import in_short
from .loads import stribeck_load
from .races import RaceContact

STEEL = 2.07e11 / (1.0 - 0.3**2) / 2.0
"""Contact modulus of the factors of ISO 76 [Pa]: both bodies of 207 GPa and 0.3."""
PALMGREN = 1.3e-19
"""1.3e-7 with mm and N: [m^4/N^2]."""


def static_load_rating(
    races: Sequence[RaceContact],
    balls: int,
    contact_angle: float = 0.0,
    *,
    pressure: float = 4.2e9,
    length: float | None = None,
    rows: int = 1,
    E_star: float = STEEL,
) -> float:
    """Basic static radial load rating as of ISO 76.

    The radial load under which the most loaded element, by Stribeck's rule `stribeck_load`, has
    the given Hertz pressure on one of its races, and less on the other.

    Parameters
    ----------
    races : sequence of RaceContact
        Of the inner and of the outer ring, usually with conformities of 0.52 and 0.53.
    balls : int
        Or rollers, in a row, Z >= 1.
    contact_angle : float, optional
        [rad], below pi/2.
    pressure : float, optional
        Largest one by Hertz [Pa]: 4.2e9 of ball bearings (the default), 4.6e9 of self-aligning
        ball bearings, 4.0e9 of roller bearings.
    length : float, optional
        Of the contact of a roller without a crown [m]; for no others.
    rows : int, optional
        >= 1.
    E_star : float, optional
        Contact modulus [Pa]; as ISO 76 has it unless given.

    Returns
    -------
    float
        C_0r [N].

    Raises
    ------
    ValueError
        An argument is outside its range, or `length` is missing or without use.

    Notes
    -----
    The pressures stand for a permanent deformation of element and race together of about 1e-4 of
    the element's diameter; nothing here knows how they yield. The factors f_0 of the standard
    (C_0r = f_0 i Z D^2 cos(alpha) with N and mm) follow to their digits, as does its 44 of rollers:
    they are made by the same formulas, so that this is no evidence of what a bearing bears.
    Sources: ISO 76:2006, *Static load ratings*; ISO/TR 10657, *Explanatory notes on ISO 76*.
    """
    if not isinstance(races, Sequence) or not all(isinstance(r, RaceContact) for r in races):
        raise TypeError(
            f"races must be a list of samcontact.bearings.RaceContact, got {in_short(races)}"
        )
    if len(races) == 0:
        raise ValueError("races must have one contact at least, got none")
    load = min(_load_at(race, positive("pressure", pressure), E_star, length) for race in races)
    return integer("rows", rows, 1) * load / stribeck_load(1.0, balls, contact_angle)


def _load_at(race: RaceContact, pressure: float, E_star: float, length: float | None) -> float:
    if math.isinf(race.Ry):
        if length is None:
            raise ValueError("length must be given with a roller without a crown, got None")
        line = hertz.line(race.Rx, E_star, p0=pressure)
        return line.load_per_length * positive("length", length)
    if length is not None:
        raise ValueError(f"length is of rollers without a crown only, got {in_short(length)}")
    return hertz.elliptic(race.Rx, race.Ry, E_star, p0=pressure).load


def palmgren_deformation(race: RaceContact, load: float, ball_diameter: float) -> float:
    """Permanent deformation of ball and race together by Palmgren's formula.

    1.3e-7 Q^2/D (rho_I1 + rho_II1)(rho_I2 + rho_II2) with N and mm, where the sums of curvatures
    along and across are 1/Rx and 1/Ry: fitted to tests with bearing steel of 63.5 to 65.5 HRC (A.
    Palmgren, *Ball and Roller Bearing Engineering*, 3rd ed., 1959, as given by Harris, *Rolling
    Bearing Analysis*, on permanent deformations).

    Parameters
    ----------
    race : RaceContact
        As of `ball_on_race`; a ball on a flat has Rx = Ry = ball_diameter/2.
    load : float
        Q of the ball [N], >= 0.
    ball_diameter : float
        D [m].

    Returns
    -------
    float
        [m].

    Raises
    ------
    ValueError
        An argument is outside its range.

    Notes
    -----
    Formula and pressures of `static_load_rating` stand for the same experience: that both have
    about 1e-4 of the diameter together is no evidence of either.
    """
    require_type("race", race, RaceContact)
    Q, D = non_negative("load", load), positive("ball_diameter", ball_diameter)
    return PALMGREN * Q**2 / (D * race.Rx * race.Ry)
