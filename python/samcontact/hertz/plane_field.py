# SPDX-License-Identifier: GPL-3.0-or-later
"""Dimensionless stress at any point below a sliding line contact: over p0, at x, z over b.

The stress of plane strain follows from F(zeta) = 1/pi integral of p(s)/(zeta - s) ds, zeta =
x + i z, which is zeta - sqrt(zeta^2 - 1) for a Hertz pressure (Muskhelishvili 1953; Johnson 1985,
section 2.5): a point force has F = P/(pi zeta), and its stress is (2.18) and (2.22).
"""

from __future__ import annotations

import numpy as np

from .._util.checks import FloatArray


def plane_field(x: FloatArray, z: FloatArray, nu: float, friction: float) -> FloatArray:
    """Stress xx, yy, zz, yz, xz, xy over p0, shape (6, ...), at depths z >= 0 (equal shapes)."""
    zeta = x + 1j * z
    root = np.sqrt(zeta - 1.0) * np.sqrt(zeta + 1.0)
    F = 1.0 / (zeta + root)  # zeta - root without cancellation
    # z F' tends to zero at the surface, including the rim
    slope = np.divide(-z * F, root, out=np.zeros_like(root), where=(z > 0.0) & (root != 0.0))
    xx, zz, xz = F.imag + slope.real, F.imag - slope.real, -slope.imag
    if friction != 0.0:
        shear = xx  # xz of a tangential load is xx of a normal one
        xx = xx + friction * (slope.imag - 2.0 * F.real)
        zz = zz - friction * slope.imag
        xz = xz + friction * shear
    none = np.zeros_like(xx)
    return np.stack([xx, nu * (xx + zz), zz, none, xz, none])
