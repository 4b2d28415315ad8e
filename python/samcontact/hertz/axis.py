# SPDX-License-Identifier: GPL-3.0-or-later
"""Stresses on the axis of Hertz contacts, divided by the maximum pressure p0.

Depths are divided by the contact radius a, the half-width b or the semi-axis a_x. nu is Poisson's
ratio.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from .._util.bounded_minimum import bounded_minimum
from .._util.checks import FloatArray, poisson_ratio
from .._util.lazy_scipy import scipy


def _maximum(function: Callable[[float], float], upper: float) -> tuple[float, float]:
    """Return the maximum of a function of depth on [0, upper], and the depth of the maximum."""
    place, lowest = bounded_minimum(lambda s: -function(s), 0.0, upper, tolerance=1e-10)
    at_surface = function(0.0)
    if at_surface >= -lowest:
        return at_surface, 0.0
    return float(-lowest), float(place)


def _von_mises(sxx: FloatArray, syy: FloatArray, szz: FloatArray) -> float:
    """Return the von Mises stress of three principal stresses."""
    squares = (sxx - syy) ** 2 + (syy - szz) ** 2 + (szz - sxx) ** 2
    return math.sqrt(0.5 * float(squares))


def point_axis(s: FloatArray, nu: float) -> tuple[FloatArray, FloatArray]:
    """Return sigma_rr/p0 and sigma_zz/p0 on the axis of a point contact, at the depth s = z/a."""
    axial = -1.0 / (1.0 + s**2)
    # cancellation grows like eps s^2; two terms of the series are exact from 1e3 on
    far = np.maximum(s, 1.0) ** -2
    bracket = np.where(s > 1e3, far / 3.0 - far**2 / 5.0, 1.0 - s * np.arctan2(1.0, s))
    radial = -(1.0 + nu) * bracket - 0.5 * axial
    return np.asarray(radial, dtype=np.float64), np.asarray(axial, dtype=np.float64)


def point_max_von_mises(nu: float) -> tuple[float, float]:
    """Maximum of the von Mises stress / p0 on the axis of a point contact, and its depth z/a."""
    nu = poisson_ratio("nu", nu)

    def von_mises(s: float) -> float:
        radial, axial = point_axis(np.float64(s), nu)
        return float(abs(axial - radial))

    return _maximum(von_mises, 2.0)


def line_axis(s: FloatArray, nu: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return sigma_xx/p0, sigma_yy/p0 and sigma_zz/p0 on the axis of a line contact, at s = z/b."""
    root = np.sqrt(1.0 + s**2)
    # (1 + 2 s^2)/root - 2 s = (root - s)^2 / root, and root - s = 1/(root + s): no cancellation
    sxx = -1.0 / (root * (root + s) ** 2)
    szz = -1.0 / root
    return sxx, nu * (sxx + szz), szz


def line_max_von_mises(nu: float) -> tuple[float, float]:
    """Maximum of the von Mises stress / p0 on the axis of a line contact, and its depth z/b."""
    nu = poisson_ratio("nu", nu)

    return _maximum(lambda s: _von_mises(*line_axis(np.float64(s), nu)), 2.0)


def elliptic_axis(s: FloatArray, k: float, nu: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return sigma_xx/p0, sigma_yy/p0 and sigma_zz/p0 on the axis of an elliptic contact.

    s: depth z/a_x. k: ratio of the semi-axes a_y/a_x.

    The stresses follow from the potentials of the pressure (Johnson 1985, sections 3.2 and 3.5).
    The integrals of Sackfield and Hills (1983) are evaluated in Carlson's form, which avoids
    cancellation for nearly circular and for very slender ellipses.
    """
    s = np.asarray(s, dtype=np.float64)
    A, B = np.hypot(1.0, s), np.hypot(k, s)
    across = 2.0 / 3.0 * s * scipy.special.elliprd(B**2, s**2, A**2)
    along = 2.0 / 3.0 * s * scipy.special.elliprd(A**2, s**2, B**2)
    even, rest = 2.0 * nu / (A * B), (1.0 - 2.0 * nu) / (A + B)
    sxx = across + nu * along - even - rest / A
    syy = along + nu * across - even - rest / B
    return k * sxx, k * syy, -k / (A * B)


def elliptic_max_von_mises(k: float, nu: float) -> tuple[float, float]:
    """Return the maximum von Mises stress / p0 on the axis of an elliptic contact, and its depth.

    The depth is divided by the shorter semi-axis. k: ratio of the semi-axes.
    """
    nu, k = poisson_ratio("nu", nu), max(k, 1.0 / k)
    return _maximum(lambda s: _von_mises(*elliptic_axis(np.float64(s), k, nu)), 2.0)
