# SPDX-License-Identifier: GPL-3.0-or-later
"""Adhesive contact in closed form: spheres, axisymmetric profiles and waves."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ._util.checks import FloatArray, finite_array, positive
from ._util.display import ShortRepr
from ._util.lazy_scipy import scipy
from ._util.short_text import in_short

__all__ = [
    "Jkr", "Maugis", "ProfileContact", "WaveContact", "dmt", "jkr", "jkr_profile", "maugis",
    "tabor", "wave",
]  # fmt: skip

_POINTS = 200
"""Number of points of the Gauss-Legendre quadratures of a profile."""


def tabor(R: float, w: float, E_star: float, range: float) -> float:
    """Return the Tabor number (R w^2/(E*^2 z^3))^(1/3) [-].

    R: radius [m]; w: work of adhesion [J/m^2]; E_star: contact modulus [Pa]; range: length z of the
    attraction [m], i.e. w divided by the largest attraction. Tabor (1977,
    doi:10.1016/0021-9797(77)90366-6). Raises ValueError for values that are not > 0.

    For Tabor numbers above about 5, the theory of Johnson, Kendall and Roberts (`jkr`) applies;
    below about 0.1, the theory of Derjaguin, Muller and Toporov (`dmt`) applies (adhesion map of
    Johnson & Greenwood 1997, doi:10.1006/jcis.1997.4984). Between these limits, use `maugis`. At
    the limits, the pull-off force of `maugis` differs from `jkr` by 0.4 % and from `dmt` by 3 %.
    """
    given = {"R": R, "w": w, "E_star": E_star, "range": range}
    R, w, E_star, range = (positive(name, value) for name, value in given.items())
    return float(np.cbrt(R * (w / E_star) ** 2 / range**3))


def dmt(R: float, w: float) -> float:
    """Return the pull-off force 2 pi w R [N] of a stiff sphere with long-range attraction.

    R: radius [m]; w: work of adhesion [J/m^2]. Derjaguin, Muller & Toporov (1975,
    doi:10.1016/0021-9797(75)90018-1). Raises ValueError for values that are not > 0.
    """
    return 2.0 * np.pi * positive("w", w) * positive("R", R)


@dataclass(frozen=True)
class Jkr:
    """Contact of a sphere with adhesion of short range, as returned by `jkr`.

    Attributes
    ----------
    R : float
        Radius [m].
    w : float
        Work of adhesion [J/m^2].
    E_star : float
        Contact modulus [Pa].
    """

    R: float
    w: float
    E_star: float

    @property
    def pull_off(self) -> float:
        """Pull-off force 3/2 pi w R [N], independent of the elastic constants."""
        return 1.5 * np.pi * self.w * self.R

    @property
    def radius_at_pull_off(self) -> float:
        """Contact radius at the pull-off force [m]."""
        return float(np.cbrt(9 * np.pi * self.w * self.R**2 / (8 * self.E_star)))

    def load(self, radius: ArrayLike) -> FloatArray:
        """Return the load [N] at contact radii [m], same shape; tension is negative."""
        a = _radii(radius)
        loads: FloatArray = 4 * self.E_star * a**3 / (3 * self.R) - np.sqrt(
            8 * np.pi * self.w * self.E_star * a**3
        )
        return loads

    def approach(self, radius: ArrayLike) -> FloatArray:
        """Return the approach [m] at contact radii [m], same shape."""
        a = _radii(radius)
        found: FloatArray = a**2 / self.R - np.sqrt(2 * np.pi * self.w * a / self.E_star)
        return found

    def radius(self, load: ArrayLike) -> FloatArray:
        """Return the stable contact radius [m] at loads [N], same shape.

        Raises ValueError for a tensile load that exceeds the pull-off force.
        """
        loads, most = finite_array("load", load), self.pull_off
        if np.any(loads < -most * (1 + 1e-12)):
            raise ValueError(
                f"load must be at least -{most:.6g} N, because the pull-off force is {most:.6g} N, "
                f"got {loads.min():.6g}"
            )
        root = np.sqrt(np.maximum(4 * most * (loads + most), 0.0))
        found: FloatArray = np.cbrt(0.75 * self.R / self.E_star * (loads + 2 * most + root))
        return found


def jkr(R: float, w: float, E_star: float) -> Jkr:
    """Return the contact of a sphere with adhesion of short range.

    R: radius [m]; w: work of adhesion [J/m^2]; E_star: contact modulus [Pa]. Johnson, Kendall &
    Roberts (1971, doi:10.1098/rspa.1971.0141). Raises ValueError for values that are not > 0.
    """
    return Jkr(positive("R", R), positive("w", w), positive("E_star", E_star))


@dataclass(frozen=True)
class Maugis:
    """Contact of a sphere with constant attraction up to a limiting gap, as returned by `maugis`.

    Attributes
    ----------
    R : float
        Radius [m].
    w : float
        Work of adhesion [J/m^2].
    E_star : float
        Contact modulus [Pa].
    stress : float
        Attraction [Pa], which acts up to the gap w/stress.
    """

    R: float
    w: float
    E_star: float
    stress: float

    @property
    def transition_parameter(self) -> float:
        """Parameter lambda = 2 stress (R/(pi w K^2))^(1/3) [-], with K = 4 E*/3."""
        return float(2 * self.stress * np.cbrt(self.R / (np.pi * self.w * self._stiffness**2)))

    @property
    def _stiffness(self) -> float:
        return 4 * self.E_star / 3

    def _solved(self, radius: ArrayLike) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return load [N], approach [m] and outer radius [m] of the attraction."""
        flat = _radii(radius)
        scale = np.cbrt(np.pi * self.w * self.R**2 / self._stiffness)
        rows = np.array([self._of_one(a / scale) for a in flat.ravel()]).reshape(-1, 3)
        load, approach, ratio = (column.reshape(flat.shape) for column in rows.T)
        force = np.pi * self.w * self.R
        length = np.cbrt(force**2 / self.R / self._stiffness**2)
        return force * load, length * approach, flat * ratio

    def _of_one(self, a: float) -> tuple[float, float, float]:
        """Return dimensionless load and approach, and outer radius/contact radius."""
        of = self.transition_parameter

        def parts(m: float) -> tuple[float, float]:
            return float(np.sqrt(m * m - 1)), float(np.arccos(1 / m))

        def work(m: float) -> float:
            root, angle = parts(m)
            first = 0.5 * of * a**2 * (root + (m * m - 2) * angle)
            return first + 4 / 3 * of**2 * a * (root * angle - m + 1) - 1

        m = float(scipy.optimize.brentq(work, 1.0, 1e8, xtol=1e-15))
        root, angle = parts(m)
        return a**3 - of * a**2 * (root + m * m * angle), a**2 - 4 / 3 * a * of * root, m

    def load(self, radius: ArrayLike) -> FloatArray:
        """Return the load [N] at contact radii [m], same shape; tension is negative."""
        return self._solved(radius)[0]

    def approach(self, radius: ArrayLike) -> FloatArray:
        """Return the approach [m] at contact radii [m], same shape."""
        return self._solved(radius)[1]

    def outer_radius(self, radius: ArrayLike) -> FloatArray:
        """Return the outer radius [m] of the attraction at contact radii [m], same shape."""
        return self._solved(radius)[2]

    @property
    def pull_off(self) -> float:
        """Pull-off force [N], between 3/2 pi w R and 2 pi w R."""
        found = scipy.optimize.minimize_scalar(
            lambda a: self._of_one(a)[0], bounds=(1e-3, 3.0), method="bounded",
            options={"xatol": 1e-10},
        )  # fmt: skip
        return float(-found.fun * np.pi * self.w * self.R)


def maugis(R: float, w: float, E_star: float, stress: float) -> Maugis:
    """Return the contact of a sphere with a constant attraction of finite range.

    R: radius [m]; w: work of adhesion [J/m^2]; E_star: contact modulus [Pa]; stress: attraction
    [Pa] up to the gap w/stress. Maugis (1992, doi:10.1016/0021-9797(92)90285-T). Raises ValueError
    for values that are not > 0.
    """
    given = {"R": R, "w": w, "E_star": E_star, "stress": stress}
    return Maugis(*(positive(name, value) for name, value in given.items()))


@dataclass(frozen=True, repr=False, eq=False)  # arrays have no truth value
class ProfileContact(ShortRepr):
    """Axisymmetric contact with adhesion of short range at given radii: result of `jkr_profile`.

    Attributes
    ----------
    radius, load, approach : ndarray
        Contact radius [m], load [N] and approach [m]; same shape. Equilibrium is not always stable.
    """

    radius: FloatArray
    load: FloatArray
    approach: FloatArray

    @property
    def pull_off(self) -> float:
        """Largest tension among the given radii [N]."""
        return float(max(-self.load.min(), 0.0))


def jkr_profile(
    slope: Callable[[FloatArray], ArrayLike], radius: ArrayLike, w: float, E_star: float
) -> ProfileContact:
    """Return the contact of an axisymmetric profile with adhesion of short range.

    The contact area must be a full circle: either the slope is positive everywhere, or the pressure
    flattens the waves of the profile (Guduru 2007, doi:10.1016/j.jmps.2006.09.003).

    Parameters
    ----------
    slope : callable
        Slope f'(r) [-] of the profile at an array of radii [m], same shape.
    radius : array_like
        Contact radii [m], > 0.
    w : float
        Work of adhesion [J/m^2].
    E_star : float
        Contact modulus [Pa].

    Returns
    -------
    ProfileContact

    Raises
    ------
    ValueError
        Values that are not > 0.
    """
    if not callable(slope):
        raise TypeError(f"slope must be a function of the radius, got {in_short(slope)}")
    radii = _radii(radius)
    w, E_star = positive("w", w), positive("E_star", E_star)
    nodes, weights = np.polynomial.legendre.leggauss(_POINTS)
    angle, share = 0.25 * np.pi * (nodes + 1), 0.25 * np.pi * weights

    def shape(x: FloatArray) -> FloatArray:
        """Return x times the integral of f'(r)/sqrt(x^2 - r^2) over r from 0 to x.

        The integral is computed over the angle t, with r = x sin t.
        """
        at = x[..., None] * np.sin(angle)
        slopes = finite_array("slope", slope(at), at.shape)
        found: FloatArray = x * (slopes @ share)
        return found

    approach = shape(radii) - np.sqrt(2 * np.pi * radii * w / E_star)
    inside = 0.5 * radii[..., None] * (nodes + 1)
    load = E_star * radii * ((approach[..., None] - shape(inside)) @ weights)
    return ProfileContact(radii, load, approach)


@dataclass(frozen=True)
class WaveContact:
    """Line contact of a sinusoidal surface with adhesion of short range, as returned by `wave`.

    Attributes
    ----------
    length : float
        Wavelength [m].
    amplitude : float
        Amplitude of the cosine [m].
    w : float
        Work of adhesion [J/m^2].
    E_star : float
        Contact modulus [Pa].
    """

    length: float
    amplitude: float
    w: float
    E_star: float

    @property
    def flattening_pressure(self) -> float:
        """Mean pressure for complete contact without adhesion, pi E* amplitude/length [Pa]."""
        return np.pi * self.E_star * self.amplitude / self.length

    @property
    def alpha(self) -> float:
        """Adhesion parameter sqrt(2 E* w/length)/flattening_pressure [-]."""
        return float(np.sqrt(2 * self.E_star * self.w / self.length) / self.flattening_pressure)

    def mean_pressure(self, half_width: ArrayLike) -> FloatArray:
        """Return the mean pressure [Pa] at half-widths of the contact [m], same shape."""
        x = np.pi * _radii(half_width, "half_width") / self.length
        if np.any(x >= 0.5 * np.pi):
            raise ValueError(
                f"half_width must be below half the wavelength, {0.5 * self.length:.6g} m, got "
                f"{np.max(half_width):.6g}"
            )
        found: FloatArray = self.flattening_pressure * (
            np.sin(x) ** 2 - self.alpha * np.sqrt(np.tan(x))
        )
        return found

    @property
    def pull_off(self) -> float:
        """Largest mean tension [Pa]."""
        found = scipy.optimize.minimize_scalar(
            lambda x: float(self.mean_pressure(x * self.length)), bounds=(1e-9, 0.5 - 1e-9),
            method="bounded", options={"xatol": 1e-12},
        )  # fmt: skip
        return float(max(-found.fun, 0.0))


def wave(length: float, amplitude: float, w: float, E_star: float) -> WaveContact:
    """Return the line contact of a sinusoidal surface with adhesion of short range.

    length: wavelength [m]; amplitude: amplitude of the cosine [m]; w: work of adhesion [J/m^2];
    E_star: contact modulus [Pa]. Johnson (1995, doi:10.1016/0020-7683(94)00111-9). Raises
    ValueError for values that are not > 0.
    """
    given = {"length": length, "amplitude": amplitude, "w": w, "E_star": E_star}
    return WaveContact(*(positive(name, value) for name, value in given.items()))


def _radii(value: ArrayLike, name: str = "radius") -> FloatArray:
    """Return contact radii or half-widths, after checking that they are > 0."""
    found = finite_array(name, value)
    if np.any(found <= 0):
        raise ValueError(f"{name} must be > 0, got {found.min():.6g}")
    return found
