# SPDX-License-Identifier: GPL-3.0-or-later
"""Components and invariants of tensors."""

from __future__ import annotations

import numpy as np

from .checks import FloatArray

COMPONENTS = ("xx", "yy", "zz", "yz", "xz", "xy")


def von_mises(stress: FloatArray) -> FloatArray:
    """Return the von Mises stress [Pa] of components xx, yy, zz, yz, xz, xy, shape (6, ...)."""
    xx, yy, zz, yz, xz, xy = stress
    normal = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    return np.asarray(np.sqrt(0.5 * normal + 3.0 * (yz**2 + xz**2 + xy**2)), dtype=np.float64)
