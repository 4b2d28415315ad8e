# SPDX-License-Identifier: GPL-3.0-or-later
"""Film thickness of lubricated contacts by formulas that were fitted to numerical solutions."""

from __future__ import annotations

import math
import warnings
from typing import NamedTuple

from .._util.checks import choice, require_type
from ..lubricants import Lubricant
from .groups import Contact, FilmGroups, film_groups, sum_of_speeds

Speeds = tuple[float, float]

SOFT_SPEEDS, SOFT_LOADS = (5e-9, 5e-8), (2e-4, 2e-3)
"""Ranges of the groups U and W to which the formula for soft bodies was fitted."""
MARGIN = 50.0
"""Factor by which U or W may be outside `SOFT_SPEEDS` or `SOFT_LOADS` without a warning."""


class FilmThickness(NamedTuple):
    """Central and minimum film thickness [m]."""

    central: float
    minimum: float


class Limits(NamedTuple):
    """Film thickness by the formula of each of the four regimes, all in the same unit."""

    rigid_isoviscous: float
    elastic_isoviscous: float
    rigid_piezoviscous: float
    elastic_piezoviscous: float


def hamrock_dowson(
    contact: Contact, speed: Speeds, lubricant: Lubricant, material: str = "hard"
) -> FilmThickness:
    """Return the film thickness of an elliptic contact by Hamrock & Dowson's formulas [m].

    contact: point or elliptic contact with Ry >= Rx; speed: (u1, u2) along x [m/s]; material:
    "hard" for a viscosity that increases with the pressure (1977, doi:10.1115/1.3453074), "soft"
    for an isoviscous lubricant and soft bodies (1978, doi:10.1115/1.3453152). At heavy loads, the
    formula "hard" gives too thick a minimum film. Raises ValueError for other contacts, and for an
    isoviscous lubricant with "hard". With "soft", warns if the speed group U or the load group W
    (see `FilmGroups`) is outside the fitted range (U: 5e-9 to 5e-8, W: 2e-4 to 2e-3) by more than a
    factor of 50.
    """
    choice("material", material, ("hard", "soft"))
    found = _wide_ellipse(contact, speed, lubricant)
    U, G, W, k = found.U, found.G, found.W, found.k
    if material == "soft":
        _warn_unless_soft(found)
        central = 7.32 * (1.0 - 0.72 * math.exp(-0.28 * k)) * U**0.64 * W**-0.22
        minimum = 7.43 * (1.0 - 0.85 * math.exp(-0.31 * k)) * U**0.65 * W**-0.21
    else:
        if G == 0.0:
            raise ValueError(
                'with material="hard", lubricant must have a pressure-viscosity coefficient > 0, '
                'got 0: use material="soft" for soft bodies'
            )
        central = 2.69 * U**0.67 * G**0.53 * W**-0.067 * (1.0 - 0.61 * math.exp(-0.73 * k))
        minimum = 3.63 * U**0.68 * G**0.49 * W**-0.073 * (1.0 - math.exp(-0.68 * k))
    return FilmThickness(found.radius * central, found.radius * minimum)


def nijenbanning(contact: Contact, speed: Speeds, lubricant: Lubricant) -> float:
    """Return the central film of an elliptic contact in all regimes of lubrication [m].

    contact: point or elliptic contact with Ry >= Rx; speed: (u1, u2) along x [m/s]. Raises
    ValueError for other contacts. The formula was fitted to solutions for an incompressible
    lubricant. To account for compressibility, divide the result by the relative density of the
    lubricant at the maximum Hertz pressure. Source: Nijenbanning, Venner & Moes (1994,
    doi:10.1016/0043-1648(94)90150-3).
    """
    found = _wide_ellipse(contact, speed, lubricant)
    return found.scale * film_parts(*found.moes, found.D).film


class FilmParts(NamedTuple):
    """Central film and its isoviscous and piezoviscous parts, divided by `FilmGroups.scale` [-]."""

    film: float
    isoviscous: float
    piezoviscous: float


def film_parts(M: float, L: float, D: float) -> FilmParts:
    """Return the central film and its parts for Moes' numbers M, L and the ratio D = Rx/Ry.

    Source: Nijenbanning, Venner & Moes (1994).
    """
    limits = _nijenbanning_limits(M, L, D)
    s = 1.5 * (1.0 + math.exp(-1.2 * limits.elastic_isoviscous / limits.rigid_isoviscous))
    longest = 1.8 / D
    isoviscous = (
        limits.rigid_isoviscous**1.5 + (limits.elastic_isoviscous**-4 + longest**-4) ** (-3.0 / 8.0)
    ) ** (2.0 / 3.0)
    piezoviscous = 0.0
    if L > 0.0:
        low, high = sorted((limits.rigid_piezoviscous, limits.elastic_piezoviscous))
        # the smaller film is factored out, so that its power cannot overflow
        piezoviscous = low * (1.0 + (low / high) ** 8) ** -0.125
    film = float((isoviscous**s + piezoviscous**s) ** (1.0 / s))
    return FilmParts(film, isoviscous, piezoviscous)


def _nijenbanning_limits(M: float, L: float, D: float) -> Limits:
    """Return the central films of the four regimes, divided by `FilmGroups.scale` [-].

    Source: Nijenbanning, Venner & Moes (1994).
    """
    shape = 1.0 + 0.006 * math.log(D) + 0.63 * D ** (4.0 / 7.0)
    return Limits(
        145.0 * (1.0 + 0.796 * D ** (14.0 / 15.0)) ** (-15.0 / 7.0) / D * M**-2,
        3.18 * shape ** (-14.0 / 25.0) * D ** (-1.0 / 15.0) * M ** (-2.0 / 15.0),
        1.29 * (1.0 + 0.691 * D) ** (-2.0 / 3.0) * L ** (2.0 / 3.0),
        1.48 * shape ** (-7.0 / 20.0) * D ** (-1.0 / 24.0) * M ** (-1.0 / 12.0) * L**0.75,
    )


def rigid_isoviscous(contact: Contact, speed: Speeds, lubricant: Lubricant) -> float:
    """Return the film thickness between rigid bodies at constant viscosity [m].

    contact: point or elliptic contact with Ry >= Rx; speed: (u1, u2) along x [m/s]. Raises
    ValueError for other contacts. Source: Brewe, Hamrock & Taylor (1979, doi:10.1115/1.3453338).
    """
    found = _wide_ellipse(contact, speed, lubricant)
    D = found.D
    shape = 128.0 / D / (1.0 + 2.0 * D / 3.0) ** 2 * (0.131 * math.atan(0.5 / D) + 1.683) ** 2
    return found.radius * (found.U / found.W) ** 2 * shape


def regime(contact: Contact, speed: Speeds, lubricant: Lubricant) -> str:
    """Return the regime of lubrication of a contact.

    The result is "rigid-isoviscous", "elastic-isoviscous", "rigid-piezoviscous" or
    "elastic-piezoviscous", after Johnson (1970, doi:10.1243/JMES_JOUR_1970_012_004_02).
    contact: line contact, or point or elliptic contact with Ry >= Rx; speed: (u1, u2) along x
    [m/s]. Raises ValueError for other contacts.

    A point or elliptic contact is elastic if its Hertz approach is larger than the central film by
    `nijenbanning`. It is piezoviscous if the piezoviscous part of this film is larger than the
    isoviscous part.

    For a line contact, the isoviscous film is the thicker of the films by Martin's and Herrebrugh's
    formulas, and the piezoviscous film is the thinner of those by Blok's and Dowson & Higginson's.
    The contact is elastic if b^2/(2 R) exceeds both films, where b is the half-width. It is
    piezoviscous if the piezoviscous film is thicker than the isoviscous film.
    """
    found = film_groups(contact, speed, lubricant)
    if found.D == 0.0:
        return _line_regime(found)
    found = _wide_ellipse(contact, speed, lubricant)
    return regime_of(*found.moes, found.D, found.approach / found.scale)


def regime_of(M: float, L: float, D: float, approach: float) -> str:
    """Return the regime of an elliptic contact with Moes' numbers M, L and D = Rx/Ry.

    approach: Hertz approach divided by `FilmGroups.scale` [-].
    """
    parts = film_parts(M, L, D)
    solid = "elastic" if approach > parts.film else "rigid"
    fluid = "piezoviscous" if parts.piezoviscous > parts.isoviscous else "isoviscous"
    return f"{solid}-{fluid}"


def dowson_higginson(contact: Contact, speed: Speeds, lubricant: Lubricant) -> float:
    """Return the minimum film of a line contact [m].

    contact: line contact of hard bodies; speed: (u1, u2) along x [m/s]. Raises ValueError for other
    contacts and for isoviscous lubricants, and warns unless the regime is elastic-piezoviscous.
    Source: Dowson (1968, doi:10.1243/PIME_CONF_1967_182_011_02).
    """
    found = _line(contact, speed, lubricant)
    if found.G == 0.0:
        raise ValueError(
            "lubricant must have a pressure-viscosity coefficient > 0, got 0: use "
            "lubrication.estimate, which chooses a formula for isoviscous lubricants"
        )
    if (regime := _line_regime(found)) != "elastic-piezoviscous":
        warnings.warn(
            "Dowson & Higginson's formula holds for elastic-piezoviscous contacts, got the regime "
            f"{regime}: use lubrication.estimate, which chooses the formula for the regime",
            UserWarning,
            stacklevel=2,
        )
    return dowson_higginson_of(found)


def dowson_higginson_of(groups: FilmGroups) -> float:
    """Return the minimum film by Dowson & Higginson [m]; 0 for an isoviscous lubricant."""
    return groups.radius * float(2.65 * groups.U**0.70 * groups.G**0.54 * groups.W**-0.13)


def _line(contact: Contact, speed: Speeds, lubricant: Lubricant) -> FilmGroups:
    """Return the dimensionless groups of a line contact; raise ValueError for other contacts."""
    found = film_groups(contact, speed, lubricant)
    if found.D > 0.0:
        raise ValueError(
            f"contact must be a line contact, got {type(contact).__name__}: use hamrock_dowson "
            "for point and elliptic contacts"
        )
    return found


def line_limits(groups: FilmGroups) -> Limits:
    """Return the films of a line contact by the formulas of the four regimes [m].

    Sources: Martin (1916), Herrebrugh (1968, doi:10.1115/1.3601554), Blok (1952), and Dowson &
    Higginson (see `dowson_higginson`).
    """
    U, G, W, R = groups.U, groups.G, groups.W, groups.radius
    return Limits(
        4.9 * R * U / W,
        3.1 * R * U**0.6 * W**-0.2,
        1.67 * R * (G * U) ** (2.0 / 3.0),
        dowson_higginson_of(groups),
    )


def _line_regime(groups: FilmGroups) -> str:
    limits = line_limits(groups)
    isoviscous = max(limits.rigid_isoviscous, limits.elastic_isoviscous)
    piezoviscous = min(limits.rigid_piezoviscous, limits.elastic_piezoviscous)
    flattened = 4.0 * groups.radius * groups.W / math.pi  # b^2/(2 R)
    solid = "elastic" if flattened > max(isoviscous, piezoviscous) else "rigid"
    fluid = "piezoviscous" if piezoviscous > isoviscous else "isoviscous"
    return f"{solid}-{fluid}"


def line_film(contact: Contact, speed: Speeds, lubricant: Lubricant) -> tuple[float, str, str]:
    """Return the minimum film of a line contact [m], its regime, and the name of the formula."""
    groups = _line(contact, speed, lubricant)
    regime = _line_regime(groups)
    name = regime.replace("-", "_")
    return float(getattr(line_limits(groups), name)), regime, _LINE_FORMULAS[name]


_LINE_FORMULAS = {
    "rigid_isoviscous": "Martin", "elastic_isoviscous": "Herrebrugh",
    "rigid_piezoviscous": "Blok", "elastic_piezoviscous": "Dowson & Higginson",
}  # fmt: skip


def _warn_unless_soft(found: FilmGroups) -> None:
    """Warn if U or W is far from the range to which the formula for soft bodies was fitted."""
    for name, value, (low, high) in (("U", found.U, SOFT_SPEEDS), ("W", found.W, SOFT_LOADS)):
        if not low / MARGIN <= value <= high * MARGIN:
            warnings.warn(
                f"the group {name} should be near {low:g} to {high:g}, the range to which the "
                f"formula for soft bodies was fitted, got {value:.3g}: use nijenbanning for the "
                "central film",
                UserWarning,
                stacklevel=3,
            )


def inlet_heating_factor(speed: Speeds, lubricant: Lubricant) -> float:
    """Return the ratio of the film with inlet heating to the isothermal film, in pure rolling [-].

    speed: (u1, u2) along x [m/s]; lubricant: with thermal constants. The ratio is 3.94/(3.94 +
    L^0.62) with the thermal loading L = beta eta0 u^2/k, where beta is the temperature coefficient
    of the viscosity, eta0 the viscosity, u the mean speed and k the conductivity (Murch & Wilson
    1975, J. Lubr. Technol. 97, 212-216). Raises ValueError without thermal constants.
    """
    require_type("lubricant", lubricant, Lubricant)
    if lubricant.heat is None:
        raise ValueError(
            "lubricant must have thermal constants, got none: use Lubricant.with_thermal"
        )
    mean, heat = 0.5 * sum_of_speeds(speed), lubricant.heat
    loading = heat.beta * lubricant.eta0 * mean**2 / heat.conductivity
    return float(3.94 / (3.94 + loading**0.62))


def _wide_ellipse(contact: Contact, speed: Speeds, lubricant: Lubricant) -> FilmGroups:
    """Return the dimensionless groups of a point or elliptic contact.

    Raises ValueError for a line contact, or for an ellipse that is longer along the motion than
    across it.
    """
    found = film_groups(contact, speed, lubricant)
    if found.D == 0.0:
        raise ValueError(
            "contact must be a point or elliptic contact, got a line contact: use dowson_higginson"
        )
    if found.D > 1.0:
        raise ValueError(
            f"contact must have Ry >= Rx (x is the direction of motion), got Rx/Ry = {found.D:.4g}:"
            " the formula was not fitted to ellipses that are long in the direction of motion"
        )
    return found
