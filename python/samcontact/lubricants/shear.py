# SPDX-License-Identifier: GPL-3.0-or-later
"""Shear stress of a film over the shear rate: shear thinning and limiting shear stress."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from .._util.checks import FloatArray, non_negative, positive

LIMIT_EXPONENT = 6.0
"""Exponent with which the shear stress approaches its limit."""


class ShearThinning(ABC):
    """Shear stress as a function of the Newtonian shear stress, viscosity times shear rate."""

    @abstractmethod
    def stress(self, newtonian: FloatArray) -> FloatArray:
        """Return the shear stress [Pa] for Newtonian shear stresses >= 0 [Pa]."""


@dataclass(frozen=True)
class Newtonian(ShearThinning):
    """Viscosity that does not depend on the shear rate."""

    def stress(self, newtonian: FloatArray) -> FloatArray:
        """Return the Newtonian shear stress."""
        return newtonian


@dataclass(frozen=True)
class Eyring(ShearThinning):
    """Eyring's law tau_0 asinh(tau_N/tau_0). Eyring (1936, doi:10.1063/1.1749836).

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


@dataclass(frozen=True)
class Carreau(ShearThinning):
    """Carreau's law tau_N [1 + (tau_N/G)^2]^((n - 1)/2). Carreau (1972, doi:10.1122/1.549276).

    Attributes
    ----------
    critical_stress : float
        Shear stress G at which the viscosity begins to fall [Pa].
    n : float
        Exponent of the shear stress over the shear rate at high rates, in [0, 1] [-].
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


def limited(stress: FloatArray, limit: FloatArray) -> FloatArray:
    """Return the smooth minimum (tau^-m + limit^-m)^(-1/m) of a stress and its limit [Pa]."""
    low, high = np.minimum(stress, limit), np.maximum(stress, limit)
    with np.errstate(invalid="ignore", divide="ignore"):
        ratio = np.where(high > 0.0, low / high, 0.0)
    return low * (1.0 + ratio**LIMIT_EXPONENT) ** (-1.0 / LIMIT_EXPONENT)
