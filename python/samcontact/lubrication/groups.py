# SPDX-License-Identifier: GPL-3.0-or-later
"""Dimensionless groups of lubricated Hertz contacts."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

from .._util.checks import finite, finite_array, require_type
from .._util.short_text import in_short
from ..hertz import EllipticContact, LineContact, PointContact
from ..lubricants import Lubricant

Contact = PointContact | EllipticContact | LineContact


class MoesNumbers(NamedTuple):
    """Moes' load number M and lubricant number L [-], from `moes`."""

    M: float
    L: float


@dataclass(frozen=True)
class FilmGroups:
    """Dimensionless groups of a lubricated contact.

    The groups contain the modulus E' = 2 E*, the mean speed u of the surfaces, the viscosity eta0
    and the pressure-viscosity coefficient alpha.

    Attributes
    ----------
    U : float
        Speed group eta0 u/(E' Rx) [-].
    G : float
        Lubricant group alpha E' [-].
    W : float
        Load group F/(E' Rx^2) with the load F, or F'/(E' R) for a line contact with the load per
        length F' [-].
    k : float
        Ellipticity a_y/a_x; infinite for a line contact [-].
    D : float
        Ratio of the radii Rx/Ry; zero for a line contact [-].
    radius : float
        Reduced radius of curvature along the direction of motion [m].
    approach : float
        Approach of the dry contact [m]; NaN for a line contact, whose approach is undefined.
    """

    U: float
    G: float
    W: float
    k: float
    D: float
    radius: float
    approach: float

    @property
    def moes(self) -> MoesNumbers:
        """Moes' numbers M and L, which contain the sum of the speeds instead of their mean."""
        power = 0.5 if self.D == 0.0 else 0.75
        return MoesNumbers(self.W / (2.0 * self.U) ** power, self.G * (2.0 * self.U) ** 0.25)

    @property
    def scale(self) -> float:
        """Length R (2 U)^(1/2) by which films are divided in Moes' formulas [m]."""
        return self.radius * math.sqrt(2.0 * self.U)


class _Shape(NamedTuple):
    radius: float
    W: float
    k: float
    D: float
    approach: float


def _of_point(contact: PointContact) -> _Shape:
    W = contact.load / (2.0 * contact.E_star * contact.R**2)
    return _Shape(contact.R, W, 1.0, 1.0, contact.approach)


def _of_ellipse(contact: EllipticContact) -> _Shape:
    W = contact.load / (2.0 * contact.E_star * contact.Rx**2)
    return _Shape(contact.Rx, W, contact.k, contact.Rx / contact.Ry, contact.approach)


def _of_line(contact: LineContact) -> _Shape:
    W = contact.load_per_length / (2.0 * contact.E_star * contact.R)
    return _Shape(contact.R, W, math.inf, 0.0, math.nan)


_SHAPES: dict[type, Callable[[Any], _Shape]] = {
    PointContact: _of_point,
    EllipticContact: _of_ellipse,
    LineContact: _of_line,
}


def sum_of_speeds(speed: Any) -> float:
    """Return the magnitude of u1 + u2 [m/s] for a pair of surface speeds along x."""
    if not isinstance(speed, (tuple, list)) or len(speed) != 2:
        raise TypeError(
            f"speed must be a pair (u1, u2) of surface speeds [m/s], got {in_short(speed)}: for "
            "pure rolling give the same number twice"
        )
    u1, u2 = (finite("speed", value) for value in finite_array("speed", speed))
    if u1 + u2 == 0.0:
        raise ValueError(
            f"the sum u1 + u2 of the speeds must differ from 0, got ({u1!r}, {u2!r}): with a sum "
            "of 0, no lubricant is drawn into the contact"
        )
    return abs(u1 + u2)


def film_groups(contact: Contact, speed: tuple[float, float], lubricant: Lubricant) -> FilmGroups:
    """Return the dimensionless groups and the shape of a lubricated contact.

    Raises TypeError or ValueError unless the contact is a Hertz contact under load and u1 + u2 is
    not zero.
    """
    if type(contact) not in _SHAPES:
        raise TypeError(
            "contact must be a Hertz contact from samcontact.hertz, Bearing.hertz or "
            f"FlankContact.hertz, got {in_short(contact)}"
        )
    require_type("lubricant", lubricant, Lubricant)
    shape = _SHAPES[type(contact)](contact)
    if not shape.W > 0.0:
        raise ValueError("contact must carry a load > 0, got 0: give load, load_per_length or p0")
    modulus = 2.0 * contact.E_star
    U = lubricant.eta0 * 0.5 * sum_of_speeds(speed) / (modulus * shape.radius)
    G = lubricant.pressure_viscosity * modulus
    return FilmGroups(U, G, shape.W, shape.k, shape.D, shape.radius, shape.approach)


def moes(contact: Contact, speed: tuple[float, float], lubricant: Lubricant) -> MoesNumbers:
    """Return Moes' numbers M and L [-] of a lubricated Hertz contact.

    contact: from `samcontact.hertz`, a bearing or a pair of gears; speed: speeds (u1, u2) of the
    surfaces along x [m/s]. Raises TypeError or ValueError for other arguments.
    M = F/(E' R^2) (E' R/(eta0 us))^(3/4) and L = alpha E' (eta0 us/(E' R))^(1/4), where E' = 2 E*,
    us = abs(u1 + u2), F is the load and R the reduced radius along x. For a line contact with the
    load per length F', M = F'/(E' R) (E' R/(eta0 us))^(1/2). Source: Moes (1992,
    doi:10.1016/0043-1648(92)90010-H).
    """
    return film_groups(contact, speed, lubricant).moes
