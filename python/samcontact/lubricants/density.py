# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws of the relative density of a lubricant: density divided by that at zero pressure."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, finite_array, non_negative, positive
from .._util.display import ShortRepr
from .._util.lazy_scipy import scipy
from .._util.short_text import in_short

__all__ = ["DensityLaw", "DowsonHigginson", "Incompressible", "TabulatedDensity", "Tait"]


class DensityLaw(ABC):
    """Density as a function of pressure, relative to the density at zero pressure."""

    def ratio(self, p: ArrayLike) -> FloatArray:
        """Return the relative density [-] at pressures p >= 0 [Pa], in the shape of p."""
        return self._ratio(pressures(p))

    def slope(self, p: ArrayLike) -> FloatArray:
        """Return d(relative density)/dp [1/Pa] at pressures p >= 0 [Pa], in the shape of p."""
        return self._slope(pressures(p))

    @abstractmethod
    def _ratio(self, p: FloatArray) -> FloatArray: ...

    @abstractmethod
    def _slope(self, p: FloatArray) -> FloatArray: ...


def pressures(p: ArrayLike) -> FloatArray:
    """Return pressures as an array; raise ValueError for negative pressures."""
    found = finite_array("p", p)
    if found.size and found.min() < 0.0:
        raise ValueError(f"p must be >= 0 Pa everywhere, got {found.min():.4g}")
    return found


@dataclass(frozen=True)
class Incompressible(DensityLaw):
    """Constant density."""

    def _ratio(self, p: FloatArray) -> FloatArray:
        return np.ones_like(p)

    def _slope(self, p: FloatArray) -> FloatArray:
        return np.zeros_like(p)


@dataclass(frozen=True)
class DowsonHigginson(DensityLaw):
    """Relative density 1 + a p/(1 + b p) of mineral oils (Dowson & Higginson 1966, section 6.2).

    Attributes
    ----------
    a, b : float
        Constants, >= 0 [1/Pa].
    """

    a: float = 0.6e-9
    b: float = 1.7e-9

    def __post_init__(self) -> None:
        for name in ("a", "b"):
            object.__setattr__(self, name, non_negative(name, getattr(self, name)))

    def _ratio(self, p: FloatArray) -> FloatArray:
        return 1.0 + self.a * p / (1.0 + self.b * p)

    def _slope(self, p: FloatArray) -> FloatArray:
        return self.a / (1.0 + self.b * p) ** 2


@dataclass(frozen=True)
class Tait(DensityLaw):
    """Tait's equation of state: V/V0 = 1 - ln[1 + (1 + K') p/K]/(1 + K').

    V0 is the volume V at zero pressure. Source: Dymond & Malhotra (1988, doi:10.1007/BF01133262).

    Attributes
    ----------
    bulk_modulus : float
        Bulk modulus K at zero pressure [Pa].
    modulus_slope : float
        Derivative K' of the bulk modulus with respect to the pressure, > 0 [-].
    """

    bulk_modulus: float
    modulus_slope: float

    def __post_init__(self) -> None:
        for name in ("bulk_modulus", "modulus_slope"):
            object.__setattr__(self, name, positive(name, getattr(self, name)))

    def _volume(self, p: FloatArray) -> FloatArray:
        n = 1.0 + self.modulus_slope
        volume: FloatArray = 1.0 - np.log1p(n * p / self.bulk_modulus) / n
        if volume.size and volume.min() <= 0.0:
            raise ValueError(
                f"p must be so low that the volume by Tait's law is > 0, got {np.max(p):.4g} Pa: "
                "check p, bulk_modulus and modulus_slope"
            )
        return volume

    def _ratio(self, p: FloatArray) -> FloatArray:
        return 1.0 / self._volume(p)

    def _slope(self, p: FloatArray) -> FloatArray:
        n = 1.0 + self.modulus_slope
        return 1.0 / (self._volume(p) ** 2 * (self.bulk_modulus + n * p))


@dataclass(frozen=True, repr=False)
class TabulatedDensity(ShortRepr, DensityLaw):
    """Monotonic cubic interpolation of the density; constant beyond the last pressure.

    Attributes
    ----------
    p : tuple of float
        Pressures [Pa], increasing, the first 0.
    rho : tuple of float
        Densities in any unit, since only their ratios are used; > 0, not decreasing.
    """

    p: ArrayLike
    rho: ArrayLike

    def __post_init__(self) -> None:
        p = finite_array("p", self.p)
        rho = finite_array("rho", self.rho, p.shape)
        if not rho.min(initial=1.0) > 0.0 or (np.diff(rho) < 0.0).any():
            raise ValueError("rho must be > 0 everywhere and must not decrease with pressure")
        object.__setattr__(self, "p", tuple(p.tolist()))
        object.__setattr__(self, "rho", tuple(rho.tolist()))

    @property
    def _curve(self) -> scipy.interpolate.PchipInterpolator:
        rho = np.asarray(self.rho)
        return scipy.interpolate.PchipInterpolator(self.p, rho / rho[0])

    def _ratio(self, p: FloatArray) -> FloatArray:
        ratio: FloatArray = self._curve(np.minimum(p, np.asarray(self.p)[-1]))
        return ratio

    def _slope(self, p: FloatArray) -> FloatArray:
        last = np.asarray(self.p)[-1]
        return np.where(p <= last, self._curve.derivative()(np.minimum(p, last)), 0.0)


def density_law(density: DensityLaw | str | None) -> DensityLaw:
    """Return the density law for an argument: a law, "dowson-higginson", or None (constant)."""
    if density is None:
        return Incompressible()
    if isinstance(density, DensityLaw):
        return density
    if isinstance(density, str) and density == "dowson-higginson":
        return DowsonHigginson()
    raise ValueError(
        'density must be "dowson-higginson", None (incompressible) or a law of '
        f"samcontact.lubricants such as Tait(bulk_modulus, modulus_slope), got {in_short(density)}"
    )
