# SPDX-License-Identifier: GPL-3.0-or-later
"""Shear stress of a film versus shear rate: shear thinning and limiting shear stress."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from .._util.checks import FloatArray, non_negative, positive

MAX_ARGUMENT, SMALL_ARGUMENT = 300.0, 1e-2
"""Largest ratio of stress to Eyring stress, and ratio below which a series replaces the law."""
MAX_STEPS = 60
"""Maximum number of Newton steps in the inversion of Carreau's law."""
LIMIT_EXPONENT = 6.0
"""Exponent m with which the shear stress approaches its limit; see `limited`."""


class ShearThinning(ABC):
    """Shear stress as a function of the Newtonian shear stress (viscosity times shear rate)."""

    @abstractmethod
    def stress(self, newtonian: FloatArray) -> FloatArray:
        """Return the shear stress [Pa] for Newtonian shear stresses >= 0 [Pa]."""

    @abstractmethod
    def fluidity(self, stress: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return the ratio f of Newtonian to true shear stress [-], and f'/stress [1/Pa^2].

        stress: true shear stresses >= 0 [Pa]; f' is the derivative of f with respect to them.
        """

    @property
    @abstractmethod
    def scale(self) -> float:
        """Shear stress at which thinning begins [Pa]."""


@dataclass(frozen=True)
class Newtonian(ShearThinning):
    """Viscosity that does not depend on the shear rate."""

    def stress(self, newtonian: FloatArray) -> FloatArray:
        """Return the Newtonian shear stress."""
        return newtonian

    def fluidity(self, stress: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return f = 1 and f'/stress = 0."""
        return np.ones_like(stress), np.zeros_like(stress)

    @property
    def scale(self) -> float:
        """Infinite, because there is no shear thinning."""
        return math.inf


@dataclass(frozen=True)
class Eyring(ShearThinning):
    """Eyring's law: the shear stress is tau_0 asinh(tau_N/tau_0).

    tau_N is the Newtonian shear stress. Source: Eyring (1936, doi:10.1063/1.1749836).

    Attributes
    ----------
    eyring_stress : float
        Eyring stress tau_0 [Pa]; 2 to 10 MPa for mineral oils.
    """

    eyring_stress: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "eyring_stress", positive("eyring_stress", self.eyring_stress))

    def stress(self, newtonian: FloatArray) -> FloatArray:
        """Return the shear stress [Pa] for Newtonian shear stresses [Pa]."""
        return self.eyring_stress * np.arcsinh(newtonian / self.eyring_stress)

    def fluidity(self, stress: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return f = sinh(x)/x with x = stress/tau_0, and f'/stress [1/Pa^2]."""
        x = np.minimum(stress / self.eyring_stress, MAX_ARGUMENT)
        near = x < SMALL_ARGUMENT
        safe = np.where(near, 1.0, x)
        sine, cosine = np.sinh(safe), np.cosh(safe)
        ratio = np.where(near, 1.0 + x**2 / 6.0 + x**4 / 120.0, sine / safe)
        slope = np.where(near, 1.0 / 3.0 + x**2 / 30.0, (safe * cosine - sine) / safe**3)
        return ratio, slope / self.eyring_stress**2

    @property
    def scale(self) -> float:
        """Eyring stress [Pa]."""
        return self.eyring_stress


@dataclass(frozen=True)
class Carreau(ShearThinning):
    """Carreau's law: the shear stress is tau_N [1 + (tau_N/G)^2]^((n - 1)/2).

    tau_N is the Newtonian shear stress. Source: Carreau (1972, doi:10.1122/1.549276).

    Attributes
    ----------
    critical_stress : float
        Shear stress G at which the viscosity begins to decrease [Pa].
    n : float
        Exponent, in [0, 1] [-]. At high rates, the shear stress is proportional to the n-th power
        of the shear rate.
    """

    critical_stress: float
    n: float

    def __post_init__(self) -> None:
        checked = positive("critical_stress", self.critical_stress)
        object.__setattr__(self, "critical_stress", checked)
        object.__setattr__(self, "n", non_negative("n", self.n))
        if self.n > 1.0:
            raise ValueError(f"n must be in [0, 1], got {self.n!r}: 1 is a Newtonian fluid")

    def stress(self, newtonian: FloatArray) -> FloatArray:
        """Return the shear stress [Pa] for Newtonian shear stresses [Pa]."""
        relative = np.hypot(1.0, newtonian / self.critical_stress)
        return newtonian * relative ** (self.n - 1.0)

    def fluidity(self, stress: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return the ratio f of Newtonian to true shear stress [-], and f'/stress [1/Pa^2]."""
        x = np.maximum(np.asarray(stress) / self.critical_stress, 1e-150)
        if self.n == 0.0:
            x = np.minimum(x, 1.0 - 1e-12)  # stresses stay below G
        target = np.log(x)
        at = target.copy()  # logarithm of tau_N/G; from below, Newton's method is monotonic
        for _ in range(MAX_STEPS):
            square = np.exp(np.minimum(2.0 * at, 2.0 * MAX_ARGUMENT))
            slope = 1.0 - (1.0 - self.n) * square / (1.0 + square)
            step = (target - at + 0.5 * (1.0 - self.n) * np.log1p(square)) / slope
            at = at + step
            if not step.size or np.abs(step).max() < 1e-14:
                break
        square = np.exp(np.minimum(2.0 * at, 2.0 * MAX_ARGUMENT))
        slope = 1.0 - (1.0 - self.n) * square / (1.0 + square)
        ratio = np.exp(at - target)
        change = (1.0 - self.n) * ratio**3 / ((1.0 + square) * slope)
        return ratio, change / self.critical_stress**2

    @property
    def scale(self) -> float:
        """Critical stress [Pa]."""
        return self.critical_stress


def limited(stress: FloatArray, limit: FloatArray) -> FloatArray:
    """Return the smooth minimum (tau^-m + limit^-m)^(-1/m) of a stress and its limit [Pa]."""
    low, high = np.minimum(stress, limit), np.maximum(stress, limit)
    with np.errstate(invalid="ignore", divide="ignore"):
        ratio = np.where(high > 0.0, low / high, 0.0)
    return low * (1.0 + ratio**LIMIT_EXPONENT) ** (-1.0 / LIMIT_EXPONENT)


def thinned(
    law: ShearThinning, coefficient: float | None, newtonian: FloatArray, p: FloatArray
) -> FloatArray:
    """Return the shear stress [Pa] by a law of thinning and a limiting shear stress.

    newtonian: Newtonian shear stresses [Pa]; coefficient: ratio of the limiting shear stress to the
    pressure [-], or None (no limit); p: pressures [Pa].
    """
    stress = law.stress(newtonian)
    return stress if coefficient is None else limited(stress, coefficient * p)
