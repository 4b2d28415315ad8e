# SPDX-License-Identifier: GPL-3.0-or-later
"""Empirical models of an elastic, perfectly plastic sphere pressed against a rigid flat.

The models are fits to finite element solutions of frictionless contact, for comparison with
computed contacts. At small interference, both models equal Hertz theory. They differ from each
other by up to 5 % in load and 7 % in area.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from . import critical
from ._util.checks import FloatArray, real_array
from ._util.display import ShortRepr
from .critical import CriticalSphere

__all__ = ["Flattening", "jackson_green", "kogut_etsion"]

KOGUT_ETSION_LIMIT = 110.0
"""Maximum interference of the fit, relative to the critical interference."""


@dataclass(frozen=True, repr=False)
class Flattening(ShortRepr):
    """Load and area of a flattened sphere; arrays have the shape of the interference.

    Attributes
    ----------
    load : float or ndarray
        Normal load [N].
    area : float or ndarray
        Contact area [m^2].
    mean_pressure : float or ndarray
        Load divided by contact area [Pa]; 0 without contact.
    critical : CriticalSphere
        Critical interference, load and area at the onset of yield in this model.
    interference_ratio, load_ratio, area_ratio : float or ndarray
        Interference, load and area, each relative to its value at the onset of yield [-].
    """

    load: float | FloatArray
    area: float | FloatArray
    mean_pressure: float | FloatArray
    critical: CriticalSphere
    interference_ratio: float | FloatArray
    load_ratio: float | FloatArray
    area_ratio: float | FloatArray


def kogut_etsion(
    interference: ArrayLike, R: float, E_star: float, nu: float, yield_stress: float
) -> Flattening:
    """Model of Kogut and Etsion (2002), up to 110 times the critical interference.

    Parameters
    ----------
    interference : array_like, any shape
        Rigid-body approach [m], >= 0.
    R : float
        Equivalent radius [m].
    E_star : float
        Contact modulus of the pair [Pa].
    nu : float
        Poisson's ratio of the body that yields, in [0, 0.5] [-].
    yield_stress : float
        Uniaxial yield stress of the body that yields [Pa].

    Returns
    -------
    Flattening
        Hertz theory up to the critical interference of `critical.kogut_etsion`; above it, two power
        laws, one up to 6 times the critical interference and one beyond. As published, both
        laws are discontinuous: the load jumps by 3 % at the critical interference and by 1.7 % at 6
        times this value, the area by -7 % and 2.9 %. Kogut and Etsion, J. Appl. Mech. 69 (2002)
        657-662, doi:10.1115/1.1490373.

    Raises
    ------
    ValueError
        An argument is outside its range, or the interference exceeds 110 times its critical value.
    """
    onset = critical.kogut_etsion(R, E_star, nu, yield_stress)
    w = _interference(interference)
    ratio = w / onset.interference
    above = ratio > KOGUT_ETSION_LIMIT * (1.0 + 1e-12)
    if above.any():
        raise ValueError(
            f"interference must be <= {KOGUT_ETSION_LIMIT * onset.interference!r} "
            f"({KOGUT_ETSION_LIMIT:g} times the critical value), got {float(w[above].flat[0])!r}"
        )
    stages = [ratio <= 1.0, ratio <= 6.0]
    load = np.select(stages, [ratio**1.5, 1.03 * ratio**1.425], 1.40 * ratio**1.263)
    area = np.select(stages, [ratio, 0.93 * ratio**1.136], 0.94 * ratio**1.146)
    return _flattening(onset, ratio, load, area)


def jackson_green(
    interference: ArrayLike, R: float, E_star: float, nu: float, yield_stress: float
) -> Flattening:
    """Model of Jackson and Green (2005), with a hardness that decreases with the contact radius.

    Parameters
    ----------
    interference, R, E_star, nu, yield_stress
        As for `kogut_etsion`, but `interference` has no upper limit. The fitted finite element
        results extend to a contact radius of about 0.4 R.

    Returns
    -------
    Flattening
        Hertz theory up to 1.9 times the critical interference of `critical.jackson_green`, where
        the load jumps by less than 1 %. Jackson and Green, J. Tribol. 127 (2005) 343-354,
        doi:10.1115/1.1866166.

    Raises
    ------
    ValueError
        An argument is outside its range.
    """
    onset = critical.jackson_green(R, E_star, nu, yield_stress)
    if yield_stress > E_star:
        raise ValueError(
            f"yield_stress must be <= E_star = {E_star!r}, got {yield_stress!r}: use Pa for both"
        )
    ratio = _interference(interference) / onset.interference
    plastic = np.maximum(ratio, 1.9)
    B = 0.14 * math.exp(23.0 * yield_stress / E_star)
    area = plastic * (plastic / 1.9) ** B
    radius = onset.a * np.sqrt(area)
    hardness = 2.84 * -np.expm1(-0.82 * (radius / R) ** -0.7)  # divided by yield stress
    load = np.exp(-0.25 * plastic ** (5 / 12)) * plastic**1.5
    load += 4.0 * hardness / onset.C * -np.expm1(-(plastic ** (5 / 9)) / 25.0) * plastic
    elastic = ratio < 1.9
    return _flattening(
        onset, ratio, np.where(elastic, ratio**1.5, load), np.where(elastic, ratio, area)
    )


def _interference(value: ArrayLike) -> FloatArray:
    array = real_array("interference", value)
    bad = ~(np.isfinite(array) & (array >= 0.0))
    if bad.any():
        raise ValueError(f"interference must be finite and >= 0, got {float(array[bad].flat[0])!r}")
    return array


def _flattening(
    onset: CriticalSphere, ratio: FloatArray, load_ratio: FloatArray, area_ratio: FloatArray
) -> Flattening:
    load = onset.load * load_ratio
    area = math.pi * onset.a**2 * area_ratio
    mean = np.divide(load, area, out=np.zeros_like(load), where=area > 0.0)

    def plain(values: FloatArray) -> float | FloatArray:
        return float(values) if values.ndim == 0 else values

    return Flattening(
        load=plain(load),
        area=plain(area),
        mean_pressure=plain(mean),
        critical=onset,
        interference_ratio=plain(ratio),
        load_ratio=plain(load_ratio),
        area_ratio=plain(area_ratio),
    )
