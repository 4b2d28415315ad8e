# SPDX-License-Identifier: GPL-3.0-or-later
"""Estimate of the film thickness in a contact, a bearing or a pair of gears."""

from __future__ import annotations

import math
from dataclasses import dataclass

from .._util.checks import finite, non_negative, positive, require_type
from .._util.display import HtmlTable, Rows, quantity
from ..bearings import Bearing
from ..hertz import LineContact
from ..lubricants import Lubricant
from .formulas import Speeds, hamrock_dowson, line_film, regime, rigid_isoviscous
from .groups import Contact, MoesNumbers, moes


@dataclass(frozen=True)
class FilmEstimate(HtmlTable):
    """Film thickness that `estimate` finds by a formula.

    Attributes
    ----------
    central : float, or None
        Central film thickness [m]; None for line contacts, whose formula gives the minimum only.
    minimum : float
        Minimum film thickness [m].
    regime : str
        Regime of lubrication; see the function `regime`.
    formula : str
        Name of the formula used.
    numbers : MoesNumbers
        Moes' numbers M and L [-].
    """

    central: float | None
    minimum: float
    regime: str
    formula: str
    numbers: MoesNumbers

    def lambda_ratio(self, roughness1: float, roughness2: float = 0.0) -> float:
        """Ratio of the minimum film to the combined roughness; see the function `lambda_ratio`."""
        return lambda_ratio(self.minimum, roughness1, roughness2)

    def _rows(self) -> Rows:
        films = [("minimum", quantity(self.minimum, "m"))]
        if self.central is not None:
            films.insert(0, ("central", quantity(self.central, "m")))
        numbers = f"{self.numbers.M:.4g}, {self.numbers.L:.4g}"
        return [*films, ("regime", self.regime), ("formula", self.formula), ("M, L", numbers)]


def estimate(contact: Contact, speed: Speeds, lubricant: Lubricant) -> FilmEstimate:
    """Return the film thickness of a contact by the formula for its regime of lubrication.

    For line contacts, the formulas are those of Martin (rigid-isoviscous), Herrebrugh
    (elastic-isoviscous), Blok (rigid-piezoviscous) and Dowson & Higginson (elastic-piezoviscous).
    For point and elliptic contacts, they are `rigid_isoviscous` in that regime, and
    `hamrock_dowson` in the others (with material "soft" if elastic-isoviscous, else "hard").

    contact: from `samcontact.hertz`, `Bearing.hertz` or `FlankContact.hertz`; speed: (u1, u2) along
    x [m/s]. Raises TypeError or ValueError outside the range of the formulas. Warns if hard bodies
    have an isoviscous lubricant, because the formula "soft" was not fitted to hard bodies.
    """
    numbers = moes(contact, speed, lubricant)
    if type(contact) is LineContact:
        return FilmEstimate(None, *line_film(contact, speed, lubricant), numbers)
    found = regime(contact, speed, lubricant)
    if found == "rigid-isoviscous":
        h = rigid_isoviscous(contact, speed, lubricant)
        return FilmEstimate(h, h, found, "Brewe, Hamrock & Taylor", numbers)
    material = "soft" if found == "elastic-isoviscous" else "hard"
    films = hamrock_dowson(contact, speed, lubricant, material)
    return FilmEstimate(*films, found, f"Hamrock & Dowson, {material}", numbers)


def lambda_ratio(film: float, roughness1: float, roughness2: float = 0.0) -> float:
    """Return the ratio of film thickness to roughness, film/(Rq1^2 + Rq2^2)^(1/2) [-].

    film: film thickness of smooth surfaces [m]; roughness1, roughness2: rms heights Rq1, Rq2 [m].
    Above a ratio of about 3 the surfaces are separated; below 1 asperities carry load. In heavily
    loaded contacts these limits are lower, because the asperities are flattened. Raises ValueError
    if both surfaces are smooth.
    """
    film = positive("film", film)
    heights = non_negative("roughness1", roughness1), non_negative("roughness2", roughness2)
    if not any(heights):
        raise ValueError("roughness1 or roughness2 must be > 0, got two smooth surfaces")
    return film / math.hypot(*heights)


def bearing_speeds(bearing: Bearing, inner: float, outer: float = 0.0) -> Speeds:
    """Return the surface speeds (u, u) of raceway and rolling element of a bearing [m/s].

    inner, outer: angular velocities of the rings about the axis of the bearing [rad/s]. In pure
    rolling, the speed at the contacts with both rings is u = abs(inner - outer) dm/4 (1 - gamma^2),
    where gamma = D cos(contact angle)/dm, with the element diameter D and the pitch diameter dm;
    Harris & Kotzalas (2006), section 10.2. Raises ValueError unless the rings turn relative to each
    other.
    """
    require_type("bearing", bearing, Bearing)
    rate = finite("inner", inner) - finite("outer", outer)
    if rate == 0.0:
        raise ValueError(
            f"inner must differ from outer, got {inner!r} rad/s for both: the bearing does not roll"
        )
    ratio = bearing.element_diameter * math.cos(bearing.contact_angle) / bearing.pitch_diameter
    u = abs(rate) * bearing.pitch_diameter / 4.0 * (1.0 - ratio**2)
    return u, u
