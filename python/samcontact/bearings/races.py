# SPDX-License-Identifier: GPL-3.0-or-later
"""Equivalent radii of rolling elements on races."""

from __future__ import annotations

import math
from dataclasses import dataclass

from .._util.checks import choice, finite, positive


@dataclass(frozen=True)
class RaceContact:
    """Equivalent radii of a rolling element on a race.

    Use them as ``hertz.elliptic(c.Rx, c.Ry, E_star, load)`` and
    ``surfaces.paraboloid(grid, c.Rx, c.Ry)``; a roller without a crown has Ry = inf and belongs to
    ``hertz.line(c.Rx, E_star, load_per_length)``.

    Attributes
    ----------
    Rx, Ry : float
        Equivalent radii along and across the rolling direction [m]; Ry may be inf.
    """

    Rx: float
    Ry: float

    @property
    def curvature_sum(self) -> float:
        """Sum of the four principal curvatures, 1/Rx + 1/Ry [1/m]."""
        return 1.0 / self.Rx + 1.0 / self.Ry

    @property
    def curvature_difference(self) -> float:
        """F(rho) = (1/Rx - 1/Ry)/(1/Rx + 1/Ry), 0 of a circular and 1 of a line contact [-]."""
        return (1.0 / self.Rx - 1.0 / self.Ry) / self.curvature_sum


def _rolling_radius(diameter: float, pitch: float, contact_angle: float, race: str) -> float:
    """Equivalent radius in the rolling direction: D (1 - gamma)/2 inside, D (1 + gamma)/2 outside.

    The race is a surface of revolution; its normal curvature across the meridian is
    cos(alpha) over the radius of the parallel (Meusnier), exactly.
    """
    gamma = diameter * math.cos(contact_angle) / pitch
    if gamma >= 1.0:
        raise ValueError(
            "pitch_diameter must be > the diameter of the rolling element times the cosine of the "
            f"contact angle, {gamma * pitch!r}, got {pitch!r}"
        )
    sign = -1.0 if choice("race", race, ("inner", "outer")) == "inner" else 1.0
    return 0.5 * diameter * (1.0 + sign * gamma)


def angle_of(contact_angle: float) -> float:
    """A contact angle [rad], checked."""
    angle = finite("contact_angle", contact_angle)
    if not 0.0 <= angle <= 0.5 * math.pi:
        raise ValueError(f"contact_angle must be in [0, pi/2] rad, got {contact_angle!r}")
    return angle


def ball_on_race(
    ball_diameter: float,
    pitch_diameter: float,
    groove_radius: float | None = None,
    *,
    conformity: float | None = None,
    contact_angle: float = 0.0,
    race: str = "inner",
) -> RaceContact:
    """Radii of a ball in the groove of a ball bearing.

    Parameters
    ----------
    ball_diameter, pitch_diameter : float
        Of a ball, and of the circle of the ball centres [m].
    groove_radius : float, optional
        Of the cross-section of the groove [m], more than half the ball's diameter; or
    conformity : float, optional
        f = groove_radius/ball_diameter, > 0.5, usually 0.51 to 0.54 [-]. Give one of the two. (The
        osculation of Harris is 1/(2 f).)
    contact_angle : float, optional
        Between the contact normal and the radial plane [rad], 0 to pi/2.
    race : {"inner", "outer"}
        Which ring.

    Returns
    -------
    RaceContact

    Raises
    ------
    ValueError
        An argument is outside its range.

    Notes
    -----
    The radii are exact for a sphere in a torus. Contact theory on half-spaces, Hertz's and this
    package's, also wants a contact small against them: in the transverse direction the contact
    ellipse of a loaded ball is often a tenth to a third of the ball's diameter, and its ends are
    less accurate than its middle.
    """
    D, pitch = positive("ball_diameter", ball_diameter), positive("pitch_diameter", pitch_diameter)
    if (groove_radius is None) == (conformity is None):
        raise ValueError("give exactly one of groove_radius, conformity")
    if groove_radius is None:
        f = positive("conformity", conformity)
    else:
        f = positive("groove_radius", groove_radius) / D
    if f <= 0.5:
        raise ValueError(
            "the groove must be wider than the ball: groove_radius/ball_diameter must be > 0.5, "
            f"got {f!r}"
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
    """Radii of a cylindrical or tapered roller on a race that is straight across.

    Parameters
    ----------
    roller_diameter, pitch_diameter : float
        Of a roller, and of the circle of the roller centres [m]; of tapered rollers in the middle
        of their length.
    crown_radius : float, optional
        Of the profile of the roller along its axis [m]; inf (the default) is straight.
    contact_angle : float, optional
        Between the contact normal and the radial plane [rad], 0 to pi/2.
    race : {"inner", "outer"}
        Which ring.

    Returns
    -------
    RaceContact
        Ry = crown_radius.

    Raises
    ------
    ValueError
        An argument is outside its range.

    Notes
    -----
    For tapered rollers, whose axis and races have angles of their own, the radius is that of the
    formula of Harris with the mean diameters, an approximation for small taper angles. A straight
    roller of finite length has higher pressure at its ends than a line contact.
    """
    D = positive("roller_diameter", roller_diameter)
    pitch = positive("pitch_diameter", pitch_diameter)
    Ry = positive("crown_radius", crown_radius, allow_inf=True)
    return RaceContact(_rolling_radius(D, pitch, angle_of(contact_angle), race), Ry)
