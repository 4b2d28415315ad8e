# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws of the viscosity of a lubricant versus pressure at one temperature."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, finite_array, non_negative, positive
from .._util.display import ShortRepr
from .._util.lazy_scipy import scipy
from .density import Tait

ROELANDS_LOGARITHM = 9.67
"""Constant of Roelands' law: -ln(viscosity in Pa s) at its pole, where this is 6.31e-5 Pa s."""
ROELANDS_PRESSURE = 1.98e8
"""Constant p0 of Roelands' law [Pa]: all isotherms meet in a pole at p = -p0 (Roelands 1966)."""


class ViscosityLaw(ABC):
    """Viscosity as a function of pressure, relative to the viscosity at zero pressure."""

    @property
    @abstractmethod
    def pressure_viscosity(self) -> float:
        """Slope d(ln viscosity)/dp at zero pressure [1/Pa]."""

    @abstractmethod
    def logarithm(self, p: FloatArray) -> FloatArray:
        """Return ln(viscosity/viscosity at zero pressure) at pressures >= 0 [Pa]."""

    @property
    def max_pressure(self) -> float:
        """Largest pressure for which the law is defined [Pa]."""
        return math.inf


@dataclass(frozen=True)
class Barus(ViscosityLaw):
    """Exponential law exp(alpha p), too steep above about 0.5 GPa (Barus 1893).

    Attributes
    ----------
    alpha : float
        Pressure-viscosity coefficient, >= 0 [1/Pa].
    """

    alpha: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "alpha", non_negative("alpha", self.alpha))

    @property
    def pressure_viscosity(self) -> float:
        """Slope d(ln viscosity)/dp at zero pressure [1/Pa]."""
        return self.alpha

    def logarithm(self, p: FloatArray) -> FloatArray:
        """Return alpha p."""
        return self.alpha * p


@dataclass(frozen=True)
class Roelands(ViscosityLaw):
    """Law of Roelands (1966): ln(viscosity ratio) = scale [(1 + p/pressure)^z - 1].

    Attributes
    ----------
    scale : float
        ln(viscosity at zero pressure [Pa s]) + 9.67 [-].
    pressure : float
        Constant p0 of the law [Pa].
    z : float
        Exponent [-].
    """

    scale: float
    pressure: float
    z: float

    def __post_init__(self) -> None:
        for name in ("scale", "pressure", "z"):
            object.__setattr__(self, name, positive(name, getattr(self, name)))

    @property
    def pressure_viscosity(self) -> float:
        """Slope d(ln viscosity)/dp at zero pressure [1/Pa]."""
        return self.scale * self.z / self.pressure

    def logarithm(self, p: FloatArray) -> FloatArray:
        """Return ln(viscosity/viscosity at zero pressure) at pressures [Pa]."""
        return self.scale * np.expm1(self.z * np.log1p(p / self.pressure))


@dataclass(frozen=True)
class Doolittle(ViscosityLaw):
    """Law of free volume: ln(viscosity ratio) = B R0 (1/(V/V0 - R0) - 1/(1 - R0)).

    V/V0 is the volume by an equation of state, relative to that at zero pressure. Source: Doolittle
    (1951, doi:10.1063/1.1699894).

    Attributes
    ----------
    B : float
        Doolittle's constant [-].
    R0 : float
        Occupied volume as a share of the volume at zero pressure, in (0, 1) [-].
    volume : Tait
        Equation of state: volume versus pressure.
    """

    B: float
    R0: float
    volume: Tait

    def __post_init__(self) -> None:
        for name in ("B", "R0"):
            object.__setattr__(self, name, positive(name, getattr(self, name)))
        if not self.R0 < 1.0:
            raise ValueError(
                f"R0 must be in (0, 1), got {self.R0!r}: it is the occupied share of the volume at "
                "zero pressure"
            )

    @property
    def pressure_viscosity(self) -> float:
        """Slope d(ln viscosity)/dp at zero pressure [1/Pa]."""
        return self.B * self.R0 / ((1.0 - self.R0) ** 2 * self.volume.bulk_modulus)

    def logarithm(self, p: FloatArray) -> FloatArray:
        """Return ln(viscosity/viscosity at zero pressure); infinite where no volume is free."""
        free = 1.0 / self.volume.ratio(p) - self.R0
        with np.errstate(divide="ignore"):
            inverse = np.where(free > 0.0, 1.0 / np.maximum(free, 0.0), np.inf)
        return self.B * self.R0 * (inverse - 1.0 / (1.0 - self.R0))


@dataclass(frozen=True, repr=False)
class Tabulated(ShortRepr, ViscosityLaw):
    """Monotonic cubic interpolation of ln(viscosity) (Fritsch & Carlson 1980, doi:10.1137/0717021).

    Attributes
    ----------
    p : tuple of float
        Pressures [Pa], increasing, the first 0.
    eta : tuple of float
        Viscosities [Pa s], > 0, not decreasing. Beyond the last pressure, `Lubricant.tables`
        continues ln(viscosity) with its slope at the last pressure.
    """

    p: ArrayLike
    eta: ArrayLike

    def __post_init__(self) -> None:
        p = increasing_pressures(self.p)
        eta = finite_array("eta", self.eta, p.shape)
        if not eta.min() > 0.0 or (np.diff(eta) < 0.0).any():
            raise ValueError("eta must be > 0 Pa s everywhere and must not decrease with pressure")
        object.__setattr__(self, "p", tuple(p.tolist()))
        object.__setattr__(self, "eta", tuple(eta.tolist()))

    @property
    def pressure_viscosity(self) -> float:
        """Slope d(ln viscosity)/dp at zero pressure [1/Pa]."""
        return float(self._curve.derivative()(0.0))

    @property
    def max_pressure(self) -> float:
        """Last pressure of the table [Pa]."""
        return float(np.asarray(self.p)[-1])

    @property
    def _curve(self) -> scipy.interpolate.PchipInterpolator:
        return scipy.interpolate.PchipInterpolator(self.p, np.log(self.eta))

    def logarithm(self, p: FloatArray) -> FloatArray:
        """Return ln(viscosity/viscosity at zero pressure) at pressures [Pa]."""
        curve, last = self._curve, self.max_pressure
        inside = curve(np.minimum(p, last)) - curve(0.0)
        beyond: FloatArray = inside + curve.derivative()(last) * np.maximum(p - last, 0.0)
        return beyond


def increasing_pressures(p: ArrayLike) -> FloatArray:
    """Return the pressures of a table; raise ValueError unless they increase from 0."""
    pressures = finite_array("p", p)
    if pressures.ndim != 1 or pressures.size < 3:
        raise ValueError(
            f"p must be a list of at least three numbers, got an array of shape {pressures.shape}"
        )
    if pressures[0] != 0.0 or (np.diff(pressures) <= 0.0).any():
        raise ValueError("p must increase from 0 Pa, without repeated values: sort p, and add 0")
    return pressures


def roelands(viscosity: float, pressure_viscosity: float, z: float | None) -> ViscosityLaw:
    """Return Roelands' law, or the law of a constant viscosity if `pressure_viscosity` is 0."""
    if pressure_viscosity == 0.0:
        return Barus(0.0)
    scale = math.log(viscosity) + ROELANDS_LOGARITHM
    if not scale > 0.0:
        raise ValueError(
            f"viscosity must be > 6.31e-5 Pa s for Roelands' law, got {viscosity!r}: use "
            "Lubricant.barus for thinner fluids"
        )
    if z is None:
        return Roelands(scale, ROELANDS_PRESSURE, pressure_viscosity * ROELANDS_PRESSURE / scale)
    z = positive("z", z)
    return Roelands(scale, z * scale / pressure_viscosity, z)
