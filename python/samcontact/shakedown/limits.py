# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed-form shakedown limits of the Hertz pressure in rolling and sliding contacts."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from .._util.checks import FloatArray, choice, non_negative, poisson_ratio, positive
from .._util.display import HtmlTable, Rows
from .._util.frozen import read_only
from .._util.lazy_scipy import scipy
from ..fatigue import crossland
from ..hertz.field import field
from ..hertz.plane_field import plane_field

_DEPTHS = np.concatenate([[0.0, 1e-3, 0.01], np.linspace(0.05, 1.2, 24)])
_PATH_POSITIONS = np.concatenate(
    [
        [-1e4],
        -np.cosh(np.linspace(3.5, 0.0, 100)),
        -np.cos(np.linspace(0.0, math.pi, 601)[1:-1]),
        np.cosh(np.linspace(0.0, 3.5, 100)),
        [1e4],
    ]
)
"""Positions of a material point relative to the contact, in half-widths; denser at the contact
edges."""
_MAX_FRICTION = 10.0
EXACT, UPPER, LOWER = "exact", "upper", "lower"


@dataclass(frozen=True)
class ShakedownLimit(HtmlTable):
    """Limit of the maximum Hertz pressure, and the depth that determines this limit.

    Attributes
    ----------
    ratio : float
        Limit of the maximum Hertz pressure p0, divided by the shear yield stress k [-]. k is the
        uniaxial yield stress divided by 2 (Tresca) or by the square root of 3 (von Mises).
    depth : float
        Depth at which yielding begins if the load exceeds the limit, relative to the half-width or
        radius of the contact along the rolling direction [-]; 0 at the surface.
    kind : str
        "exact"; "upper": there is no elastic shakedown above this bound; or "lower": there is
        always elastic shakedown below this bound.
    """

    ratio: float
    depth: float
    kind: str

    def _rows(self) -> Rows:
        where = "surface" if self.depth == 0.0 else f"{self.depth:.4g} half-widths deep"
        bounds = {"exact": "p0/k", "upper": "p0/k (upper bound)", "lower": "p0/k (lower bound)"}
        name = bounds[self.kind]
        return [(name, f"{self.ratio:.5g}"), ("where", where)]


def _coefficient(friction: float) -> float:
    value = non_negative("friction", friction)
    if value > _MAX_FRICTION:
        raise ValueError(
            f"friction must be a coefficient in [0, {_MAX_FRICTION:g}], got {friction!r}: do not "
            "use percent"
        )
    return value


def _worst_depth(strength: Callable[[float], float]) -> tuple[float, float]:
    """Return the maximum over all depths of the required ratio k/p0, and the depth of the maximum.

    strength: function that returns the required k/p0 at a depth. k is the shear yield stress, p0
    the maximum Hertz pressure.
    """
    required_k = [strength(depth) for depth in _DEPTHS]
    worst = int(np.argmax(required_k))
    if worst == 0:
        return required_k[0], 0.0
    bounds = (_DEPTHS[worst - 1], _DEPTHS[min(worst + 1, len(_DEPTHS) - 1)])
    found = scipy.optimize.minimize_scalar(
        lambda depth: -strength(depth),
        bounds=bounds,
        method="bounded",
        options={"xatol": 1e-7},
    )
    return max((-float(found.fun), float(found.x)), (required_k[worst], float(_DEPTHS[worst])))


def _deviator(stress: FloatArray) -> FloatArray:
    """Return stress deviators in the plane y = 0 as vectors of length sqrt(J2), shape (n, 3)."""
    xx, yy, zz, _, xz, _ = stress
    across = (yy - 0.5 * (xx + zz)) / math.sqrt(3.0)
    return np.stack([0.5 * (xx - zz), across, xz], axis=-1)


def _smallest_ball(deviator: FloatArray) -> float:
    """Return the radius of the smallest ball that encloses all points from `_deviator`."""
    shears = np.zeros((len(deviator), 6, 1))
    shears[:, 3:, 0] = deviator  # the sum of their squares is J2
    return float(crossland(shears, slope=0.0).max_value)


def _both_signs(deviator: FloatArray) -> FloatArray:
    """Return a stress path together with its mirror image, in which the shear has opposite sign.

    The smallest ball that contains both paths has its centre at zero residual shear stress.
    """
    return np.concatenate([deviator, deviator * [1.0, 1.0, -1.0]])


def _tresca(deviator: FloatArray) -> float:
    """Return the smallest k/p0 at which some residual stresses xx and yy prevent Tresca yield."""
    half, across, shear = deviator[:, 0], math.sqrt(3.0) * deviator[:, 1], deviator[:, 2]

    def required_k(shift: float) -> float:
        # In-plane stresses lie within the radius of their mean, yy at `across` from it. The optimum
        # residual yy places the mean at both ends of (across - radius, across + radius).
        radius = np.hypot(half - shift, shear)
        out_of_plane = 0.25 * (np.max(across + radius) - np.min(across - radius))
        return float(max(radius.max(), out_of_plane))

    found = scipy.optimize.minimize_scalar(
        required_k, bounds=(half.min(), half.max()), method="bounded", options={"xatol": 1e-10}
    )
    return float(found.fun)


# Several limits for one friction, as in a map, share the paths at `_DEPTHS`.
@lru_cache(maxsize=2 * len(_DEPTHS))
def _line_path(depth: float, nu: float, friction: float) -> FloatArray:
    return read_only(
        _deviator(plane_field(_PATH_POSITIONS, np.full_like(_PATH_POSITIONS, depth), nu, friction))
    )


@lru_cache(maxsize=2 * len(_DEPTHS))
def _point_path(depth: float, nu: float, friction: float) -> FloatArray:
    places = np.zeros_like(_PATH_POSITIONS), np.full_like(_PATH_POSITIONS, depth)
    return read_only(_deviator(field(_PATH_POSITIONS, *places, nu, friction)))


def line(friction: float = 0.0, nu: float = 0.3, criterion: str = "tresca") -> ShakedownLimit:
    """Elastic shakedown limit of a line contact on a perfectly plastic body, by Melan's theorem.

    A body shakes down if some residual stress keeps the stress within the yield surface during the
    whole passage. Residual stress after repeated passages is uniform along the surface. Equilibrium
    then allows only the components sigma_xx and sigma_yy, which may vary with depth, so this
    limit is exact.

    Parameters
    ----------
    friction : float, optional
        Ratio of shear traction to pressure in full sliding, in [0, 10] [-].
    nu : float, optional
        Poisson's ratio, in [0, 0.5]; it affects the limit only through sigma_yy.
    criterion : {"tresca", "von_mises"}, optional
        Yield criterion.

    Returns
    -------
    ShakedownLimit
        Without friction p0/k = 4.000, at a depth of 0.5 half-widths, where the shear stress
        sigma_xz alternates. With Tresca's criterion and friction >= 0.367, p0/k = 1/friction at the
        surface.

    Raises
    ------
    ValueError
        An argument is outside its range.

    Notes
    -----
    Johnson (1985), section 9.2; Melan (1938); Johnson and Jefferis (1963). The shear traction is
    friction times pressure (full sliding).
    """
    nu, friction = poisson_ratio("nu", nu), _coefficient(friction)
    if choice("criterion", criterion, ("tresca", "von_mises")) == "tresca":
        required_k, depth = _worst_depth(lambda z: _tresca(_line_path(z, nu, friction)))
    else:
        required_k, depth = _worst_depth(
            lambda z: _smallest_ball(_both_signs(_line_path(z, nu, friction)))
        )
    return ShakedownLimit(1.0 / required_k, depth, EXACT)


def line_kinematic(friction: float = 0.0, nu: float = 0.3) -> ShakedownLimit:
    """Elastic shakedown limit of a line contact on a body with linear kinematic hardening.

    The backstress can take any value at each point. The body therefore shakes down if, at each
    point, the path of the stress deviator fits into the yield surface after a suitable shift. Above
    the limit there is plastic shakedown, and never ratcheting.

    Parameters
    ----------
    friction, nu : float, optional
        As for `line`.

    Returns
    -------
    ShakedownLimit
        Limit with von Mises' criterion.

    Raises
    ------
    ValueError
        An argument is outside its range.

    Notes
    -----
    Melan (1938); Ponter, Hearle and Johnson (1985), J. Mech. Phys. Solids 33, 339-362.
    """
    nu, friction = poisson_ratio("nu", nu), _coefficient(friction)
    required_k, depth = _worst_depth(lambda z: _smallest_ball(_line_path(z, nu, friction)))
    return ShakedownLimit(1.0 / required_k, depth, EXACT)


def point(friction: float = 0.0, nu: float = 0.3) -> ShakedownLimit:
    """Upper bound of the shakedown limit of a circular contact on a perfectly plastic body.

    Residual stress shifts the path of the stress deviator at a point but cannot shrink it, so the
    smallest ball that encloses this path gives a bound. Without friction the bound follows from the
    maximum orthogonal shear stress, 0.21389 p0. At the surface the residual shear stress sigma_xz
    must vanish, which gives p0/k <= 1/friction.

    Parameters
    ----------
    friction, nu : float, optional
        As for `line`.

    Returns
    -------
    ShakedownLimit
        Limit with von Mises' criterion at points in the plane y = 0; p0/k = 4.675 without friction.

    Raises
    ------
    ValueError
        An argument is outside its range.

    Notes
    -----
    Ponter, Hearle and Johnson (1985), J. Mech. Phys. Solids 33, 339-362. Below the surface any
    residual shear stress is admitted, even if it is not in equilibrium. With friction the true
    limit may therefore be lower.
    """
    nu, friction = poisson_ratio("nu", nu), _coefficient(friction)

    def required_k(depth: float) -> float:
        path = _point_path(depth, nu, friction)
        return _smallest_ball(path if depth > 0.0 else _both_signs(path))

    largest, depth = _worst_depth(required_k)
    return ShakedownLimit(1.0 / largest, depth, UPPER)


def point_lower_bound(friction: float = 0.0, nu: float = 0.3) -> ShakedownLimit:
    """Lower bound of the shakedown limit of a circular contact on a perfectly plastic body.

    A residual stress sigma_xx that is uniform along the rolling direction x is in equilibrium for
    any variation with y and z. By Melan's theorem a body shakes down if this residual stress keeps
    the total stress within the yield surface during the whole passage; other residual stresses may
    allow a higher pressure.

    Parameters
    ----------
    friction, nu : float, optional
        As for `line`.

    Returns
    -------
    ShakedownLimit
        Limit with von Mises' criterion at points in the plane y = 0, where the limit is lowest:
        p0/k = 3.23 without friction; for a coefficient of friction of 0.4 it is 3 % below the upper
        bound of `point`.

    Raises
    ------
    ValueError
        An argument is outside its range.
    """
    nu, friction = poisson_ratio("nu", nu), _coefficient(friction)
    along = np.array([0.5, -0.5 / math.sqrt(3.0), 0.0])  # shift of the centre due to sigma_xx

    def required_k(depth: float) -> float:
        path = _point_path(depth, nu, friction)
        reach = 2.0 * float(np.abs(path).max())
        found = scipy.optimize.minimize_scalar(
            lambda residual: float(np.linalg.norm(path + residual * along, axis=1).max()),
            bounds=(-reach, reach),
            method="bounded",
            options={"xatol": 1e-9 * reach},
        )
        return float(found.fun)

    largest, depth = _worst_depth(required_k)
    return ShakedownLimit(1.0 / largest, depth, LOWER)


def point_kinematic(friction: float = 0.0, nu: float = 0.3) -> ShakedownLimit:
    """Elastic shakedown limit of a circular contact on a body with linear kinematic hardening.

    Parameters
    ----------
    friction, nu : float, optional
        As for `line`.

    Returns
    -------
    ShakedownLimit
        Limit with von Mises' criterion at points in the plane y = 0, where the limit is lowest.

    Raises
    ------
    ValueError
        An argument is outside its range.
    """
    nu, friction = poisson_ratio("nu", nu), _coefficient(friction)
    required_k, depth = _worst_depth(lambda z: _smallest_ball(_point_path(z, nu, friction)))
    return ShakedownLimit(1.0 / required_k, depth, EXACT)


def elliptic(k: float, friction: float = 0.0) -> ShakedownLimit:
    """Upper bound of the shakedown limit of an elliptic contact, from the orthogonal shear stress.

    The shear stress sigma_xz alternates between +tau_0 and -tau_0 as the contact passes. Neither
    residual stress nor kinematic hardening reduces the range of this stress, so tau_0 must not
    exceed the shear yield stress. In this docstring, k is the ratio of the semi-axes. Friction
    shifts both extremes of sigma_xz equally.

    Parameters
    ----------
    k : float
        Semi-axis transverse to the rolling direction divided by the semi-axis along this direction,
        > 0 [-], e.g. `k` of `hertz.elliptic` for rolling along x.
    friction : float, optional
        Ratio of shear traction to pressure, in [0, 10] [-]. The surface of a perfectly plastic body
        yields in each pass if the ratio of p0 to the shear yield stress is above 1/friction,
        because the residual shear stress vanishes at the surface.

    Returns
    -------
    ShakedownLimit
        Upper bound p0/tau_0: 4.675 for a circular contact (k = 1), 4.000 for a line contact.

    Raises
    ------
    ValueError
        An argument is outside its range.

    Notes
    -----
    Lundberg and Palmgren (1947): tau_0/p0 = sqrt(2t - 1)/(2t(t + 1)) at the depth a/((t + 1)
    sqrt(2t - 1)), with the semi-axis a along the rolling direction and 1/k^2 = (t^2 - 1)(2t - 1).
    """
    ratio, friction = positive("k", k), _coefficient(friction)
    if not ratio > 1e-50:
        raise ValueError(f"k must be > 1e-50, got {ratio!r}")
    across = ratio**-2
    # u = t - 1 avoids cancellation for long contacts
    upper = 1.0 + across ** (1.0 / 3.0)
    u = scipy.optimize.brentq(
        lambda u: u * (u + 2.0) * (2.0 * u + 1.0) - across, 0.0, upper, xtol=1e-300, rtol=1e-15
    )
    shear = math.sqrt(2.0 * u + 1.0) / (2.0 * (u + 1.0) * (u + 2.0))
    if friction > shear:
        return ShakedownLimit(1.0 / friction, 0.0, UPPER)
    return ShakedownLimit(1.0 / shear, 1.0 / ((u + 2.0) * math.sqrt(2.0 * u + 1.0)), UPPER)


def first_yield(
    friction: float = 0.0, nu: float = 0.3, criterion: str = "tresca"
) -> ShakedownLimit:
    """Elastic limit of a line contact: pressure at first yield, below the shakedown limit.

    Parameters and errors as for `line`.

    Returns
    -------
    ShakedownLimit
        Limit at which the stress (`hertz.LineContact.stress`) reaches yield at some point.
    """
    nu, friction = poisson_ratio("nu", nu), _coefficient(friction)
    tresca = choice("criterion", criterion, ("tresca", "von_mises")) == "tresca"

    def required_k(depth: float) -> float:
        half, across, shear = _line_path(depth, nu, friction).T
        radius = np.hypot(half, shear)
        if tresca:
            far_side = 0.5 * (np.abs(math.sqrt(3.0) * across) + radius)
            return float(np.maximum(radius, far_side).max())
        return float(np.hypot(radius, across).max())

    largest, depth = _worst_depth(required_k)
    return ShakedownLimit(1.0 / largest, depth, EXACT)
