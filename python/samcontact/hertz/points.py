# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of coordinates and contact dimensions, and the Hertz pressure."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, finite_array, real_array


def require_range(given: str, **sizes: float) -> None:
    """Raise ValueError unless all dimensions of a contact are finite and > 0."""
    for name, size in sizes.items():
        if not 0.0 < size < math.inf:
            raise ValueError(
                f"{given} must give finite contact dimensions > 0, got {name} = {size!r}"
            )


def semi_ellipsoid(p0: float, *ratios: FloatArray) -> FloatArray:
    """Return the Hertz pressure p0 sqrt(1 - sum of ratio^2), zero outside the contact.

    ratios: coordinates divided by the semi-axes.
    """
    inside = 1.0 - sum(np.square(ratio) for ratio in ratios)
    return np.asarray(p0 * np.sqrt(np.maximum(inside, 0.0)), dtype=np.float64)


def coordinates(**given: ArrayLike) -> list[FloatArray]:
    """Return each coordinate as an array, after checking that all numbers are finite."""
    return [finite_array(name, values) for name, values in given.items()]


def depth_ratio(z: ArrayLike, length: float) -> FloatArray:
    depth = real_array("z", z)
    if not np.all(np.isfinite(depth)) or np.any(depth < 0.0):
        raise ValueError("z must be finite and >= 0 (depth into the body)")
    return depth / length
