# SPDX-License-Identifier: GPL-3.0-or-later
"""Hertz elliptic contact: size, pressure and approach."""

from __future__ import annotations

import math
from dataclasses import dataclass

from numpy.typing import ArrayLike

from .._util.checks import FloatArray, exactly_one, poisson_ratio, positive, together
from .._util.display import HtmlTable
from .._util.lazy_scipy import scipy
from .axis import elliptic_axis, elliptic_max_von_mises
from .points import depth_ratio, require_range, semi_ellipsoid


@dataclass(frozen=True)
class EllipticContact(HtmlTable):
    """Hertz contact with an elliptic contact area (Johnson 1985, sections 3.5 and 4.2).

    Attributes
    ----------
    Rx, Ry : float
        Equivalent principal radii in the planes y = 0 and x = 0 [m].
    E_star : float
        Contact modulus [Pa].
    load : float
        Normal load [N].
    a_x, a_y : float
        Semi-axes of the contact along x and y [m].
    k : float
        Ellipticity a_y / a_x [-].
    p0 : float
        Maximum pressure [Pa].
    approach : float
        Rigid-body approach [m].
    """

    Rx: float
    Ry: float
    E_star: float
    load: float
    a_x: float
    a_y: float
    k: float
    p0: float
    approach: float

    def pressure(self, x: ArrayLike, y: ArrayLike = 0.0) -> FloatArray:
        """Pressure [Pa] at the points x, y [m] (broadcast); zero outside the contact."""
        across, along = together(x=x, y=y)
        return semi_ellipsoid(self.p0, across / self.a_x, along / self.a_y)

    def axis_stress(self, z: ArrayLike, nu: float) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Elastic stresses on the axis below the centre; they are principal stresses.

        Parameters
        ----------
        z : array_like
            Depths [m], >= 0.
        nu : float
            Poisson's ratio of the loaded body, in [0, 0.5].

        Returns
        -------
        sigma_xx, sigma_yy, sigma_zz : ndarray
            Normal stresses along x, y and z [Pa], in the shape of `z`.

        Raises
        ------
        ValueError
            An argument is outside its range.

        Notes
        -----
        The closed form is equivalent to the solution of Sackfield and Hills (1983), Journal of
        Strain Analysis 18, 101. Rounding errors are about 1e-15 of the axial stress.
        """
        s = depth_ratio(z, self.a_x)
        sxx, syy, szz = elliptic_axis(s, self.k, poisson_ratio("nu", nu))
        return self.p0 * sxx, self.p0 * syy, self.p0 * szz

    def max_von_mises(self, nu: float) -> tuple[float, float]:
        """Maximum von Mises stress on the axis [Pa] and its depth [m]."""
        ratio, depth = elliptic_max_von_mises(self.k, nu)
        return ratio * self.p0, depth * min(self.a_x, self.a_y)


_MAX_RADIUS_RATIO = 1e100  # of the larger to the smaller radius; avoids overflow of squares


def _axis_ratio(radius_ratio: float) -> float:
    """Return the ratio k of the semi-axes (>= 1) for a ratio of the equivalent radii (>= 1).

    The ratio of the radii is (E k^2 - K) / (K - E) with the complete elliptic integrals K and E, a
    ratio that is 0/0 for a circle. Carlson's R_D (DLMF 19.25.1) gives the equivalent form R_D(0, 1,
    k^-2) / R_D(0, k^-2, 1), without cancellation.
    """
    target = math.log(radius_ratio)
    if target == 0.0:
        return 1.0

    def residual(log_k: float) -> float:
        m1 = math.exp(-2.0 * log_k)
        long, short = (scipy.special.elliprd(0.0, *sides) for sides in ((1.0, m1), (m1, 1.0)))
        return float(math.log(long / short) - target)

    # 1 <= k <= lambda; the margin absorbs rounding where both ends meet
    root = scipy.optimize.brentq(residual, -1e-12, target + 1e-12, xtol=1e-15, rtol=8.9e-16)
    return math.exp(max(root, 0.0))


def elliptic(
    Rx: float,
    Ry: float,
    E_star: float,
    load: float | None = None,
    approach: float | None = None,
    p0: float | None = None,
) -> EllipticContact:
    """Exact Hertz elliptic contact for a given load, approach or maximum pressure.

    Parameters
    ----------
    Rx, Ry : float
        Equivalent principal radii in the planes y = 0 and x = 0 [m]; either may be larger.
    E_star : float
        Contact modulus [Pa].
    load, approach, p0 : float, optional
        Normal load [N], rigid-body approach [m] or maximum pressure [Pa]. Exactly one is required.

    Returns
    -------
    EllipticContact
        Contact after Johnson (1985), equations (3.60) to (3.62), with complete elliptic integrals.

    Raises
    ------
    ValueError
        An argument is not finite and positive (for an infinite radius see `line`); load, approach
        and p0 are all missing, or several are given; or the contact dimensions overflow.
    """
    Rx, Ry, E_star = positive("Rx", Rx), positive("Ry", Ry), positive("E_star", E_star)
    given = exactly_one(load=load, approach=approach, p0=p0)
    long_radius = max(Rx, Ry)
    radius_ratio = long_radius / min(Rx, Ry)
    if not radius_ratio <= _MAX_RADIUS_RATIO:
        raise ValueError(
            f"Rx and Ry must differ by a factor of at most {_MAX_RADIUS_RATIO:g}, got {Rx!r} and "
            f"{Ry!r}: use `line` for a line contact"
        )
    ratio = _axis_ratio(radius_ratio)
    m1 = ratio**-2
    shape, K = float(scipy.special.elliprd(0.0, m1, 1.0)), float(scipy.special.ellipkm1(m1))

    # long semi-axis from 1/(2 R_long) = p0 b R_D / (3 a^2 E*), approach = p0 b K / E*
    if given == "load":
        a = (positive("load", load) * long_radius * shape / (math.pi * E_star)) ** (1.0 / 3.0)
    elif given == "approach":
        a = math.sqrt(2.0 * long_radius * positive("approach", approach) * shape / (3.0 * K))
    else:
        a = 2.0 * long_radius * positive("p0", p0) * shape / (3.0 * ratio * E_star)
    b = a / ratio
    peak = 3.0 * ratio * E_star * a / (2.0 * long_radius * shape)
    a_x, a_y = (b, a) if Ry >= Rx else (a, b)
    sizes = {
        "a_x": a_x,
        "a_y": a_y,
        "load": 2.0 / 3.0 * math.pi * a * b * peak if load is None else float(load),
        "p0": peak if p0 is None else float(p0),
        "approach": peak * b * K / E_star if approach is None else float(approach),
    }
    require_range(given, **sizes)
    return EllipticContact(Rx=Rx, Ry=Ry, E_star=E_star, k=a_y / a_x, **sizes)
