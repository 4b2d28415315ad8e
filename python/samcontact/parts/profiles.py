# SPDX-License-Identifier: GPL-3.0-or-later
"""Cross-sections given by points, as smooth curves z(y)."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._util.checks import FloatArray, finite_array, non_negative
from .._util.lazy_scipy import scipy

_MIN_POINTS = 8


class Profile:
    """Cross-section of a wheel or a rail: a cubic spline z(y), interpolating or smoothing.

    name: name of the argument, for messages. points: points (y, z) [m], shape (n, 2), ordered by
    y in either direction. smoothing: root-mean-square distance of the curve from the points [m]; 0
    for a curve through the points.
    """

    def __init__(self, name: str, points: ArrayLike, smoothing: float) -> None:
        given = finite_array(name, points)
        if given.ndim != 2 or given.shape[1] != 2 or len(given) < _MIN_POINTS:
            raise ValueError(
                f"{name} must be a list of at least {_MIN_POINTS} points (y, z) [m], got shape "
                f"{given.shape}"
            )
        y, z = given.T if given[-1, 0] > given[0, 0] else given[::-1].T
        back = np.flatnonzero(np.diff(y) <= 0.0)
        if back.size:
            raise ValueError(
                f"{name} must have points ordered by y, got points whose order in y reverses at "
                f"{y[back[0]]!r} m: cut off the part of a rail below its head, or the part of a "
                "wheel above its flange"
            )
        self.name = name
        self.ends = float(y[0]), float(y[-1])
        noise = non_negative("smoothing", smoothing)
        interpolate = scipy.interpolate
        if noise > 0.0:
            self._spline = interpolate.UnivariateSpline(y, z, s=len(y) * noise**2)
        else:
            self._spline = interpolate.CubicSpline(y, z, bc_type="natural")

    def holds(self, y: FloatArray) -> NDArray[np.bool_]:
        """Whether each position y [m] lies within the range of the points."""
        return (y >= self.ends[0]) & (y <= self.ends[1])

    def at(self, y: ArrayLike, order: int = 0) -> FloatArray:
        """Return z [m], positive downwards, or its derivative of the given order with respect to y.

        Positions y outside the range of the points are replaced by the nearest end of the range.
        """
        return np.asarray(self._spline(np.clip(y, *self.ends), order), dtype=np.float64)

    def curvature(self, y: float) -> float:
        """Curvature of the section [1/m], positive if its centre lies below (larger z)."""
        slope, second = (float(self.at(y, order)) for order in (1, 2))
        return float(second / (1.0 + slope**2) ** 1.5)
