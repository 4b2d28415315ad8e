# SPDX-License-Identifier: GPL-3.0-or-later
"""Equivalent radii of rolling elements on raceways."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass

from .._util.checks import choice, finite, positive
from .._util.errors import UnitWarning

MAX_DIAMETER = 1.0
"""Maximum diameter of rolling elements [m]; even the largest bearings have smaller elements."""


@dataclass(frozen=True)
class RaceContact:
    """Equivalent radii of a rolling element on a raceway.

    Use them in ``hertz.elliptic(c.Rx, c.Ry, E_star, load)`` and
    ``surfaces.paraboloid(grid, c.Rx, c.Ry)``. An uncrowned roller has Ry = inf: use
    ``hertz.line(c.Rx, E_star, load_per_length)``.

    Attributes
    ----------
    Rx, Ry : float
        Equivalent radii along and transverse to the rolling direction [m]; Ry may be inf.
    """

    Rx: float
    Ry: float

    @property
    def curvature_sum(self) -> float:
        """Sum of the four principal curvatures, 1/Rx + 1/Ry [1/m]."""
        return 1.0 / self.Rx + 1.0 / self.Ry

    @property
    def curvature_difference(self) -> float:
        """F(rho) = (1/Rx - 1/Ry)/(1/Rx + 1/Ry), 0 for a circular and 1 for a line contact [-]."""
        return (1.0 / self.Rx - 1.0 / self.Ry) / self.curvature_sum


def _rolling_radius(diameter: float, pitch: float, contact_angle: float, race: str) -> float:
    """Equivalent radius in the rolling direction [m], on the inner or the outer ring.

    It is D (1 - gamma)/2 on the inner ring and D (1 + gamma)/2 on the outer ring, where gamma =
    D cos(alpha)/(pitch diameter), with the element diameter D and the contact angle alpha. The
    formula is exact: the circumferential curvature of the raceway, a surface of revolution, is
    cos(alpha) divided by the radius of the circle on which the contact point lies (Meusnier).
    """
    gamma = diameter * math.cos(contact_angle) / pitch
    if gamma >= 1.0:
        raise ValueError(
            "pitch_diameter must be greater than the rolling element diameter times "
            f"cos(contact_angle), which is {gamma * pitch!r} m, got {pitch!r} m"
        )
    sign = -1.0 if choice("race", race, ("inner", "outer")) == "inner" else 1.0
    return 0.5 * diameter * (1.0 + sign * gamma)


def angle_of(contact_angle: float) -> float:
    """Return a contact angle [rad] after checking that it is in [0, pi/2]."""
    angle = finite("contact_angle", contact_angle)
    if not 0.0 <= angle <= 0.5 * math.pi:
        raise ValueError(f"contact_angle must be in [0, pi/2] rad, got {contact_angle!r}")
    return angle


def _warn_of_size(name: str, diameter: float) -> None:
    """Issue a `UnitWarning` if the diameter of a rolling element [m] is implausibly large."""
    if diameter > MAX_DIAMETER:
        warnings.warn(
            f"likely unit error: {name} is {diameter!r} m (≤ {MAX_DIAMETER:g} m expected). Use m: "
            "12 mm is 12e-3",
            UnitWarning,
            stacklevel=3,
        )


def ball_on_race(
    ball_diameter: float,
    pitch_diameter: float,
    groove_radius: float | None = None,
    *,
    conformity: float | None = None,
    contact_angle: float = 0.0,
    race: str = "inner",
) -> RaceContact:
    """Equivalent radii of a ball in the groove of a ball bearing.

    Parameters
    ----------
    ball_diameter, pitch_diameter : float
        Diameter of a ball, and diameter of the circle through the ball centres [m].
    groove_radius : float, optional
        Radius of the groove cross-section [m], more than half the ball diameter.
    conformity : float, optional
        f = groove_radius/ball_diameter, > 0.5, usually 0.51 to 0.54 [-]. Exactly one of
        `groove_radius` and `conformity` must be given. (Harris's osculation is 1/(2 f).)
    contact_angle : float, optional
        Angle between the contact normal and the radial plane [rad], 0 to pi/2.
    race : {"inner", "outer"}
        Ring of the raceway.

    Returns
    -------
    RaceContact

    Raises
    ------
    ValueError
        An argument is outside its range.

    Warns
    -----
    UnitWarning
        The ball is larger than 1 m.

    Notes
    -----
    The radii are exact for a sphere in a torus. Half-space contact theory (Hertz and this package)
    also requires a contact that is small compared with these radii. In the transverse direction the
    contact ellipse of a loaded ball is often a tenth to a third of the ball diameter; results
    near the ends of the ellipse are less accurate than at the centre.
    """
    D, pitch = positive("ball_diameter", ball_diameter), positive("pitch_diameter", pitch_diameter)
    _warn_of_size("ball_diameter", D)
    if (groove_radius is None) == (conformity is None):
        given = "none" if conformity is None else "both"
        raise ValueError(f"exactly one of groove_radius and conformity must be given, got {given}")
    if groove_radius is None:
        f = positive("conformity", conformity)
    else:
        f = positive("groove_radius", groove_radius) / D
    if f <= 0.5:
        raise ValueError(
            f"conformity = groove_radius/ball_diameter must be > 0.5, got {f!r}: the groove must "
            "be wider than the ball"
        )
    return RaceContact(
        _rolling_radius(D, pitch, angle_of(contact_angle), race), D / (2.0 - 1.0 / f)
    )


def roller_on_race(
    roller_diameter: float,
    pitch_diameter: float,
    *,
    crown_radius: float = math.inf,
    contact_angle: float = 0.0,
    race: str = "inner",
) -> RaceContact:
    """Equivalent radii of a cylindrical or tapered roller on a straight raceway.

    Parameters
    ----------
    roller_diameter, pitch_diameter : float
        Diameter of a roller, and diameter of the circle through the roller centres [m]; for tapered
        rollers, both at mid-length.
    crown_radius : float, optional
        Radius of the roller profile along its axis [m]. Default: inf, a straight profile.
    contact_angle : float, optional
        Angle between the contact normal and the radial plane [rad], 0 to pi/2.
    race : {"inner", "outer"}
        Ring of the raceway.

    Returns
    -------
    RaceContact
        Equivalent radii, with Ry = crown_radius.

    Raises
    ------
    ValueError
        An argument is outside its range.

    Warns
    -----
    UnitWarning
        The roller has a diameter above 1 m.

    Notes
    -----
    The axis of a tapered roller is not parallel to its raceways. The equivalent radius
    follows from Harris's formula with mean diameters, an approximation for small taper angles. At
    the ends of a straight roller of finite length, the pressure is higher than in a line contact.
    """
    D = positive("roller_diameter", roller_diameter)
    _warn_of_size("roller_diameter", D)
    pitch = positive("pitch_diameter", pitch_diameter)
    Ry = positive("crown_radius", crown_radius, allow_inf=True)
    return RaceContact(_rolling_radius(D, pitch, angle_of(contact_angle), race), Ry)
