# SPDX-License-Identifier: GPL-3.0-or-later
"""Trends and undefined points of profiles; maps are handled by SurfaceTopography."""

from __future__ import annotations

import numpy as np

from .._util.checks import FloatArray


def detrended_profile(z: FloatArray, trend: str) -> FloatArray:
    """Return the heights of an equally spaced profile minus a trend, fitted to the defined points.

    trend: "height", line with minimum rms height of the residual; "slope", line with minimum rms
    slope of the residual, which then has zero mean; "curvature", parabola with minimum rms height
    of the residual.
    """
    s = np.linspace(-1.0, 1.0, len(z))
    known = np.isfinite(z)
    if trend == "slope":
        ends = np.flatnonzero(known)[[0, -1]]
        rise = (z[ends[1]] - z[ends[0]]) / (s[ends[1]] - s[ends[0]]) if ends[1] > ends[0] else 0.0
        level = z - rise * s
        return np.asarray(level - level[known].mean())
    degree = min({"height": 1, "curvature": 2}[trend], int(known.sum()) - 1)
    fitted = np.polynomial.Polynomial.fit(s[known], z[known], degree)
    return np.asarray(z - fitted(s))


def filled_profile(z: FloatArray) -> FloatArray:
    """Interpolate the undefined heights of a profile linearly."""
    known = np.flatnonzero(np.isfinite(z))
    return np.interp(np.arange(len(z)), known, z[known])
