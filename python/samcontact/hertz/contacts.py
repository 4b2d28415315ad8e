# SPDX-License-Identifier: GPL-3.0-or-later
"""Size, pressure and approach of point, elliptic and line contact."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import brentq
from scipy.special import ellipkm1, elliprd

from .._checks import (
    FloatArray,
    exactly_one,
    finite_array,
    non_negative,
    poisson_ratio,
    positive,
    real_array,
)
from .._repr import Shown
from .axis import line_axis, line_max_von_mises, point_axis, point_max_von_mises
from .field import field


class Body(Protocol):
    """What `effective_modulus` reads of a material: Young's modulus [Pa] and Poisson's ratio."""

    @property
    def E(self) -> float: ...
    @property
    def nu(self) -> float: ...


def effective_modulus(body1: Body, body2: Body) -> float:
    """Contact modulus of a pair, 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2.

    Parameters
    ----------
    body1, body2 : Material
        Anything with ``E`` [Pa] (inf for a rigid body) and ``nu`` [-].

    Returns
    -------
    float
        E* [Pa] (Johnson 1985, section 4.2).

    Raises
    ------
    ValueError
        A modulus is not positive, or both bodies are rigid.
    """
    compliance = 0.0
    for name, body in (("body1", body1), ("body2", body2)):
        modulus = positive(f"{name}.E", body.E, allow_inf=True)
        if not math.isinf(modulus):
            compliance += (1.0 - poisson_ratio(f"{name}.nu", body.nu) ** 2) / modulus
    if compliance == 0.0:
        raise ValueError("body1 and body2 are both rigid: at least one must be deformable")
    return 1.0 / compliance


def _semi_ellipsoid(p0: float, *ratios: FloatArray) -> FloatArray:
    """p0 sqrt(1 - sum ratio^2), zero outside."""
    inside = 1.0 - sum(np.square(ratio) for ratio in ratios)
    return np.asarray(p0 * np.sqrt(np.maximum(inside, 0.0)), dtype=np.float64)


def _points(**coordinates: ArrayLike) -> list[FloatArray]:
    """Checked coordinates, each of its own shape."""
    return [finite_array(name, given, np.shape(given)) for name, given in coordinates.items()]


def _depth_ratio(z: ArrayLike, length: float) -> FloatArray:
    depth = real_array("z", z)
    if not np.all(np.isfinite(depth)) or np.any(depth < 0.0):
        raise ValueError("z must be finite and >= 0 (depth into the body)")
    return depth / length


@dataclass(frozen=True)
class PointContact(Shown):
    """Hertz contact of a sphere and a half-space (Johnson 1985, section 4.2).

    Attributes
    ----------
    R : float
        Equivalent radius, 1/R = 1/R1 + 1/R2 [m].
    E_star : float
        Contact modulus [Pa].
    load : float
        Normal load [N].
    a : float
        Contact radius [m].
    p0 : float
        Maximum pressure [Pa].
    approach : float
        Rigid-body approach [m].
    """

    R: float
    E_star: float
    load: float
    a: float
    p0: float
    approach: float

    def pressure(self, x: ArrayLike, y: ArrayLike = 0.0) -> FloatArray:
        """Pressure [Pa] at x, y [m] (broadcast), zero outside the contact; (4.24)."""
        across, along = _points(x=x, y=y)
        return _semi_ellipsoid(self.p0, across / self.a, along / self.a)

    def gap(self, x: ArrayLike, y: ArrayLike = 0.0) -> FloatArray:
        """Gap under load [m] at x, y [m] (broadcast), zero inside the contact; (3.42)."""
        r = np.maximum(np.hypot(*_points(x=x, y=y)) / self.a, 1.0)
        # approach - displacement - r^2/2R with every length in contact radii
        outside = (2.0 - r**2) * np.arcsin(1.0 / r) + np.sqrt(r**2 - 1.0)
        scale = self.a**2 / self.R
        return np.asarray(scale * (0.5 * r**2 - 1.0 + outside / math.pi), dtype=np.float64)

    def axis_stress(self, z: ArrayLike, nu: float) -> tuple[FloatArray, FloatArray]:
        """Elastic stresses under the centre, Johnson (3.45).

        Parameters
        ----------
        z : array_like
            Depths [m], >= 0.
        nu : float
            Poisson's ratio of the loaded body, in [0, 0.5].

        Returns
        -------
        sigma_rr, sigma_zz : ndarray
            Radial (= circumferential) and axial stress [Pa], of the shape of `z`.
        """
        s = _depth_ratio(z, self.a)
        radial, axial = point_axis(s, poisson_ratio("nu", nu))
        return self.p0 * radial, self.p0 * axial

    def stress(
        self, x: ArrayLike, y: ArrayLike, z: ArrayLike, nu: float, friction: float = 0.0
    ) -> FloatArray:
        """Elastic stress anywhere in a half-space under this pressure, at rest or sliding.

        Parameters
        ----------
        x, y, z : array_like
            Points [m], broadcast; z is the depth, >= 0.
        nu : float
            Poisson's ratio of the loaded body, in [0, 0.5].
        friction : float, optional
            Coefficient mu >= 0: the shear mu p acts on the body along +x [-].

        Returns
        -------
        ndarray, shape (6, ...)
            xx, yy, zz, yz, xz, xy [Pa], tension positive; at z = 0 the limit from below.

        Raises
        ------
        ValueError
            An argument is outside its range.

        Notes
        -----
        Closed form, as that of Hamilton (1983), doi:10.1243/PIME_PROC_1983_197_076_02; derived
        from the potentials of Boussinesq and Cerruti (Johnson 1985, section 3.2). The error is
        rounding, about 1e-15 p0 near the contact and r/a times that at the distance r. The
        pressure is that of Hertz: the shear's share in the normal displacement, zero for bodies
        of equal elastic constants, is left out.
        """
        s = _depth_ratio(z, self.a)
        across, along = _points(x=x, y=y)
        points = np.broadcast_arrays(across / self.a, along / self.a, s)
        nu, friction = poisson_ratio("nu", nu), non_negative("friction", friction)
        return self.p0 * field(points[0], points[1], points[2], nu, friction)

    def max_von_mises(self, nu: float) -> tuple[float, float]:
        """Largest von Mises stress on the axis [Pa] and its depth [m]."""
        ratio, depth = point_max_von_mises(nu)
        return ratio * self.p0, depth * self.a


def point(
    R: float,
    E_star: float,
    load: float | None = None,
    approach: float | None = None,
    p0: float | None = None,
) -> PointContact:
    """Hertz point contact from exactly one of load, approach or maximum pressure.

    Parameters
    ----------
    R : float
        Equivalent radius [m].
    E_star : float
        Contact modulus [Pa], see `effective_modulus`.
    load, approach, p0 : float, optional
        Normal load [N], rigid-body approach [m], maximum pressure [Pa]; give one.

    Returns
    -------
    PointContact
        Johnson (1985), (4.22)-(4.24).

    Raises
    ------
    ValueError
        An argument is not finite and positive, or not exactly one of the three is given.
    """
    R, E_star = positive("R", R), positive("E_star", E_star)
    given = exactly_one(load=load, approach=approach, p0=p0)
    if given == "load":
        a = (0.75 * positive("load", load) * R / E_star) ** (1.0 / 3.0)
    elif given == "approach":
        a = math.sqrt(R * positive("approach", approach))
    else:
        a = 0.5 * math.pi * R * positive("p0", p0) / E_star
    force = 4.0 * E_star * a**3 / (3.0 * R)
    return PointContact(
        R=R,
        E_star=E_star,
        load=float(load) if load is not None else force,
        a=a,
        p0=float(p0) if p0 is not None else 2.0 * E_star * a / (math.pi * R),
        approach=float(approach) if approach is not None else a * a / R,
    )


@dataclass(frozen=True)
class EllipticContact(Shown):
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
        """Pressure [Pa] at x, y [m] (broadcast), zero outside the contact."""
        across, along = _points(x=x, y=y)
        return _semi_ellipsoid(self.p0, across / self.a_x, along / self.a_y)


_LARGEST_RATIO = 1e100  # of radii; the squares of what follows from it are numbers


def _axis_ratio(radius_ratio: float) -> float:
    """Ratio (>= 1) of the semi-axes of a contact whose radii have the ratio >= 1.

    lambda = (E k^2 - K) / (K - E) is 0/0 for a circle. Carlson's R_D (DLMF 19.25.1) gives
    the same as R_D(0, 1, k^-2) / R_D(0, k^-2, 1), without any cancellation.
    """
    target = math.log(radius_ratio)
    if target == 0.0:
        return 1.0

    def residual(log_k: float) -> float:
        m1 = math.exp(-2.0 * log_k)
        return float(math.log(elliprd(0.0, 1.0, m1) / elliprd(0.0, m1, 1.0)) - target)

    # 1 <= k <= lambda; the margin absorbs rounding where both ends meet
    root = brentq(residual, -1e-12, target + 1e-12, xtol=1e-15, rtol=8.9e-16)
    return math.exp(max(root, 0.0))


def elliptic(
    Rx: float,
    Ry: float,
    E_star: float,
    load: float | None = None,
    approach: float | None = None,
    p0: float | None = None,
) -> EllipticContact:
    """Hertz elliptic contact, exact, from exactly one of load, approach or maximum pressure.

    Parameters
    ----------
    Rx, Ry : float
        Equivalent principal radii in the planes y = 0 and x = 0 [m]; either may be larger.
    E_star : float
        Contact modulus [Pa].
    load, approach, p0 : float, optional
        Normal load [N], rigid-body approach [m], maximum pressure [Pa]; give one.

    Returns
    -------
    EllipticContact
        Johnson (1985), (3.60)-(3.62) with complete elliptic integrals.

    Raises
    ------
    ValueError
        An argument is not finite and positive (an infinite radius is a line contact, see
        `line`), or not exactly one of the three is given.
    """
    Rx, Ry, E_star = positive("Rx", Rx), positive("Ry", Ry), positive("E_star", E_star)
    given = exactly_one(load=load, approach=approach, p0=p0)
    long_radius = max(Rx, Ry)
    radius_ratio = long_radius / min(Rx, Ry)
    if not radius_ratio <= _LARGEST_RATIO:
        raise ValueError(
            f"Rx and Ry must differ by a factor of at most {_LARGEST_RATIO:g}, got {Rx!r} and "
            f"{Ry!r}: a straight line of contact is that of `line`"
        )
    ratio = _axis_ratio(radius_ratio)
    m1 = ratio**-2
    shape, K = float(elliprd(0.0, m1, 1.0)), float(ellipkm1(m1))

    # long semi-axis from 1/(2 R_long) = p0 b R_D / (3 a^2 E*), approach = p0 b K / E*
    if given == "load":
        a = (positive("load", load) * long_radius * shape / (math.pi * E_star)) ** (1.0 / 3.0)
    elif given == "approach":
        a = math.sqrt(2.0 * long_radius * positive("approach", approach) * shape / (3.0 * K))
    else:
        a = 2.0 * long_radius * positive("p0", p0) * shape / (3.0 * ratio * E_star)
    b = a / ratio
    peak = 3.0 * ratio * E_star * a / (2.0 * long_radius * shape)
    if not (b > 0.0 and 0.0 < peak < math.inf):
        raise ValueError(f"{given} gives a contact beyond the range of numbers: a = {a!r} m")
    a_x, a_y = (b, a) if Ry >= Rx else (a, b)
    return EllipticContact(
        Rx=Rx,
        Ry=Ry,
        E_star=E_star,
        load=float(load) if load is not None else 2.0 / 3.0 * math.pi * a * b * peak,
        a_x=a_x,
        a_y=a_y,
        k=a_y / a_x,
        p0=float(p0) if p0 is not None else peak,
        approach=float(approach) if approach is not None else peak * b * K / E_star,
    )


@dataclass(frozen=True)
class LineContact(Shown):
    """Hertz contact of a cylinder (axis y) and a half-space in plane strain (section 4.2(c)).

    Attributes
    ----------
    R : float
        Equivalent radius [m].
    E_star : float
        Contact modulus [Pa].
    load_per_length : float
        Normal load per unit length [N/m].
    b : float
        Half-width of the contact [m].
    p0 : float
        Maximum pressure [Pa].
    """

    R: float
    E_star: float
    load_per_length: float
    b: float
    p0: float

    def pressure(self, x: ArrayLike) -> FloatArray:
        """Pressure [Pa] at x [m], zero outside the contact; (4.44)."""
        return _semi_ellipsoid(self.p0, _points(x=x)[0] / self.b)

    def axis_stress(self, z: ArrayLike, nu: float) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Elastic stresses sigma_xx, sigma_yy, sigma_zz [Pa] at depths z [m]; (4.46)."""
        s = _depth_ratio(z, self.b)
        sxx, syy, szz = line_axis(s, poisson_ratio("nu", nu))
        return self.p0 * sxx, self.p0 * syy, self.p0 * szz

    def max_von_mises(self, nu: float) -> tuple[float, float]:
        """Largest von Mises stress on the axis [Pa] and its depth [m]."""
        ratio, depth = line_max_von_mises(nu)
        return ratio * self.p0, depth * self.b


def line(
    R: float,
    E_star: float,
    load_per_length: float | None = None,
    p0: float | None = None,
) -> LineContact:
    """Hertz line contact from load per length or maximum pressure.

    The approach of a line contact depends on the datum and is not offered.

    Parameters
    ----------
    R : float
        Equivalent radius [m].
    E_star : float
        Contact modulus [Pa].
    load_per_length, p0 : float, optional
        Load per unit length [N/m], maximum pressure [Pa]; give one.

    Returns
    -------
    LineContact
        Johnson (1985), (4.43)-(4.45).

    Raises
    ------
    ValueError
        An argument is not finite and positive, or not exactly one of the two is given.
    """
    R, E_star = positive("R", R), positive("E_star", E_star)
    if exactly_one(load_per_length=load_per_length, p0=p0) == "load_per_length":
        b = math.sqrt(4.0 * positive("load_per_length", load_per_length) * R / (math.pi * E_star))
    else:
        b = 2.0 * R * positive("p0", p0) / E_star
    return LineContact(
        R=R,
        E_star=E_star,
        load_per_length=(
            float(load_per_length)
            if load_per_length is not None
            else math.pi * E_star * b * b / (4.0 * R)
        ),
        b=b,
        p0=float(p0) if p0 is not None else E_star * b / (2.0 * R),
    )
