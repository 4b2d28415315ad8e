# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress / p0 at any point below a sliding line contact; lengths are divided by the half-width b.

In plane strain the stress due to a pressure p follows from the function F(zeta) = 1/pi integral of
p(s)/(zeta - s) ds with zeta = x + i z (Muskhelishvili 1953; Johnson 1985, section 2.5). For a Hertz
pressure, F = zeta - sqrt(zeta^2 - 1). For a line force P, F = P/(pi zeta), with the stress of
Johnson's equations (2.18) and (2.22).
"""

from __future__ import annotations

import numpy as np

from .._util.checks import FloatArray


def plane_field(x: FloatArray, z: FloatArray, nu: float, friction: float) -> FloatArray:
    """Return the stress / p0, components xx, yy, zz, yz, xz, xy, shape (6, ...).

    x, z: coordinates divided by the half-width b, in arrays of equal shape; z >= 0.
    """
    zeta = x + 1j * z
    root = np.sqrt(zeta - 1.0) * np.sqrt(zeta + 1.0)
    F = 1.0 / (zeta + root)  # zeta - root without cancellation
    # z F' tends to zero at the surface, including the rim
    slope = np.divide(-z * F, root, out=np.zeros_like(root), where=(z > 0.0) & (root != 0.0))
    xx, zz, xz = F.imag + slope.real, F.imag - slope.real, -slope.imag
    if friction != 0.0:
        shear = xx  # xz due to a tangential load equals xx due to a normal load
        xx = xx + friction * (slope.imag - 2.0 * F.real)
        zz = zz - friction * slope.imag
        xz = xz + friction * shear
    none = np.zeros_like(xx)
    return np.stack([xx, nu * (xx + zz), zz, none, xz, none])
