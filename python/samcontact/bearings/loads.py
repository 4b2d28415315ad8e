# SPDX-License-Identifier: GPL-3.0-or-later
"""Load distribution among the rolling elements of a bearing."""

from __future__ import annotations

import math
from dataclasses import dataclass

from .._util.checks import finite, integer, non_negative, positive
from .._util.lazy_scipy import scipy
from .races import angle_of

POINT_CONTACT_EXPONENT = 1.5  # n of load ~ approach^n in point contacts


def sjovall(epsilon: float, exponent: float = POINT_CONTACT_EXPONENT) -> tuple[float, float]:
    """Sjövall's integrals J_r and J_a of the load distribution in a bearing.

    J_r is the mean of (Q/Q_max) cos psi over the circumference, J_a the mean of Q/Q_max. Q is the
    load of the element at the angle psi from the radial load. With n = `exponent`, Q(psi)/Q_max =
    (1 - (1 - cos psi)/(2 epsilon))^n, or 0 where the base of this power is negative.

    Parameters
    ----------
    epsilon : float
        Loaded fraction of the bearing diameter, > 0. With 0.5, half of the circumference is loaded;
        with 1 or more, the whole circumference.
    exponent : float
        Exponent n in load ~ approach^n: 1.5 for point contacts (default), 10/9 for line contacts.

    Returns
    -------
    J_r, J_a : float
        Radial and axial integral [-]; J_r(0.5) = 0.2288 and J_a(0.5) = 0.2782 for point contacts.

    Raises
    ------
    ValueError
        An argument is not positive.
    """
    epsilon, n = positive("epsilon", epsilon), positive("exponent", exponent)
    F, B = scipy.special.hyp2f1, scipy.special.beta
    # Euler's integral of 2F1 (DLMF 15.6.1) with sin(psi/2)^2 = epsilon u, or u on a full circle
    if epsilon > 1.0:
        z = 1.0 / epsilon
        return float(0.25 * n * z * F(1.0 - n, 1.5, 3.0, z)), float(F(-n, 0.5, 1.0, z))
    root = math.sqrt(epsilon) / math.pi
    J_a = root * B(0.5, n + 1.0) * F(0.5, 0.5, n + 1.5, epsilon)
    drop = 2.0 * epsilon * root * B(1.5, n + 1.0) * F(0.5, 1.5, n + 2.5, epsilon)
    return float(J_a - drop), float(J_a)


def stribeck_load(radial_load: float, balls: int, contact_angle: float = 0.0) -> float:
    """Maximum ball load by Stribeck's rule, 5 F_r/(Z cos(alpha)).

    The rule applies to bearings with the usual small clearance. For zero clearance, `ball_load` has
    the factor 4.37 instead of 5. Source: Harris, *Rolling Bearing Analysis*, chapter 7.

    Parameters
    ----------
    radial_load : float
        Radial load F_r [N], >= 0.
    balls : int
        Number of balls Z, >= 1.
    contact_angle : float, optional
        Contact angle [rad], < pi/2.

    Returns
    -------
    float
        Load along the contact normal [N].

    Raises
    ------
    ValueError
        An argument is outside its range.
    """
    return 5.0 * _mean_normal(radial_load, balls, contact_angle)


def ball_load(
    radial_load: float,
    balls: int,
    contact_angle: float = 0.0,
    *,
    epsilon: float = 0.5,
    exponent: float = POINT_CONTACT_EXPONENT,
) -> float:
    """Load of the most heavily loaded rolling element, F_r/(Z cos(alpha) J_r(epsilon)).

    Parameters
    ----------
    radial_load : float
        Radial load F_r [N], >= 0.
    balls : int
        Number of rolling elements Z, >= 1.
    contact_angle : float, optional
        Contact angle [rad], < pi/2.
    epsilon : float, optional
        Loaded fraction of the diameter, as in `sjovall`. The default 0.5 applies to a bearing
        without clearance; the load is then 4.37 F_r/(Z cos(alpha)) for balls and 4.08 F_r/(Z
        cos(alpha)) for rollers. Clearance reduces epsilon.
    exponent : float, optional
        Exponent n as in `sjovall`: 1.5 for balls (default), 10/9 for rollers.

    Returns
    -------
    float
        Load along the contact normal [N].

    Raises
    ------
    ValueError
        An argument is outside its range.

    Notes
    -----
    Assumptions: rigid rings, equal contact angles, and one element directly under the load.
    J_r replaces a sum over the elements; the sum differs from J_r by 1.4 % for 6 balls and by 0.2 %
    for 10 balls.
    """
    return _mean_normal(radial_load, balls, contact_angle) / sjovall(epsilon, exponent)[0]


def _mean_normal(radial_load: float, balls: int, contact_angle: float) -> float:
    """Load F_r/(Z cos(alpha)) [N] from radial load, number of elements and contact angle."""
    load, count = non_negative("radial_load", radial_load), integer("balls", balls, 1)
    angle = angle_of(contact_angle)
    if angle > 0.5 * math.pi - 1e-9:
        raise ValueError(
            "contact_angle must be < pi/2 rad for a radial load, got "
            f"{angle!r} rad: a thrust bearing carries no radial load"
        )
    return load / (count * math.cos(angle))


@dataclass(frozen=True)
class LoadZone:
    """Load distribution among the rolling elements of a single row.

    Attributes
    ----------
    max_load : float
        Load of the most heavily loaded element, along the contact normal [N].
    epsilon : float
        Loaded fraction of the diameter, as in `sjovall`; inf under pure thrust.
    exponent : float
        Exponent n in load ~ approach^n.
    """

    max_load: float
    epsilon: float
    exponent: float

    @property
    def half_angle(self) -> float:
        """Half-angle of the load zone [rad]."""
        return math.acos(max(-1.0, 1.0 - 2.0 * self.epsilon))

    def load(self, psi: float) -> float:
        """Load [N] at the angle psi [rad] from the direction of the radial load."""
        share = 1.0 - (1.0 - math.cos(finite("psi", psi))) / (2.0 * self.epsilon)
        return float(self.max_load * max(share, 0.0) ** self.exponent)


def load_zone(
    radial_load: float,
    axial_load: float,
    balls: int,
    contact_angle: float,
    *,
    exponent: float = POINT_CONTACT_EXPONENT,
) -> LoadZone:
    """Load zone in a row with angular contact under combined radial and axial load.

    Parameters
    ----------
    radial_load, axial_load : float
        Radial and axial loads, F_r >= 0 and F_a > 0 [N].
    balls : int
        Number of rolling elements Z, >= 1.
    contact_angle : float
        Contact angle under load [rad], between 0 and pi/2, equal for all elements.
    exponent : float, optional
        Exponent n as in `sjovall`: 1.5 for balls (default), 10/9 for rollers.

    Returns
    -------
    LoadZone

    Raises
    ------
    ValueError
        An argument is outside its range, or F_r tan(alpha) >= F_a: the axial load does not balance
        the thrust due to the radial load, and the rings would separate.

    Notes
    -----
    The equation J_r(epsilon)/J_a(epsilon) = F_r tan(alpha)/F_a (Sjövall 1933), for rings that
    remain parallel, is solved for epsilon. The maximum element load follows from the axial load.
    """
    F_r, F_a = non_negative("radial_load", radial_load), positive("axial_load", axial_load)
    count, angle = integer("balls", balls, 1), angle_of(contact_angle)
    if not 0.0 < angle < 0.5 * math.pi - 1e-9:
        raise ValueError(f"contact_angle must be between 0 and pi/2 rad, got {angle!r}")
    normal = F_a / (count * math.sin(angle))
    ratio = F_r * math.tan(angle) / F_a
    n = positive("exponent", exponent)
    if ratio >= 1.0:
        raise ValueError(
            "axial_load must be greater than radial_load tan(contact_angle), which is "
            f"{F_r * math.tan(angle)!r} N, got {F_a!r} N: otherwise the rings separate"
        )
    if ratio == 0.0:
        return LoadZone(normal, math.inf, n)

    def excess(log_epsilon: float) -> float:
        J_r, J_a = sjovall(math.exp(log_epsilon), n)
        return J_r / J_a - ratio

    # J_r/J_a decreases from 1 - O(epsilon) in a small load zone to n/(4 epsilon) in a large one
    low, high = math.log(1e-3 * (1.0 - ratio)), math.log(1e2 * n / ratio)
    epsilon = math.exp(scipy.optimize.brentq(excess, low, high, xtol=1e-13))
    return LoadZone(normal / sjovall(epsilon, n)[1], epsilon, n)
