# SPDX-License-Identifier: GPL-3.0-or-later
"""Thermal softening: factor on the yield stress as a function of the temperature rise."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ._util.checks import FloatArray, finite, finite_array, positive

__all__ = ["JohnsonCook"]


@dataclass(frozen=True)
class JohnsonCook:
    """Johnson-Cook factor 1 - ((T - reference)/(melting - reference))^m on the yield stress.

    T is the ambient temperature plus the temperature rise [K]. Below `reference` the factor is 1.
    G. R. Johnson, W. H. Cook, Proc. 7th Int. Symp. on Ballistics (1983) 541-547.

    Parameters
    ----------
    melting : float
        Melting temperature [K], at which the formula gives 0.
    m : float
        Exponent, > 0 [-].
    reference : float, optional
        Temperature up to which there is no softening [K]. Default: 293.15.
    ambient : float, optional
        Temperature of the unheated bodies [K]. Default: 293.15.
    floor : float, optional
        Minimum factor [-], in (0, 1], which replaces smaller values, also above the melting
        temperature. Default: 0.01.

    Raises
    ------
    ValueError, TypeError
        An argument is outside its range or not a number.
    """

    melting: float
    m: float
    reference: float = 293.15
    ambient: float = 293.15
    floor: float = 0.01

    def __post_init__(self) -> None:
        for name in ("melting", "m", "reference", "ambient", "floor"):
            object.__setattr__(self, name, finite(name, getattr(self, name)))
        positive("m", self.m)
        if not self.melting > self.reference:
            raise ValueError(
                f"melting must be > reference = {self.reference!r} K, got {self.melting!r} K"
            )
        if not 0.0 < self.floor <= 1.0:
            raise ValueError(f"floor must be in (0, 1], got {self.floor!r}")

    def __call__(self, rise: ArrayLike) -> FloatArray:
        """Return the factor on the yield stress [-], shape of `rise`.

        rise: temperature rises [K].
        """
        T = self.ambient + finite_array("rise", rise)
        homologous = np.clip((T - self.reference) / (self.melting - self.reference), 0.0, 1.0)
        return np.maximum(1.0 - homologous**self.m, self.floor)
