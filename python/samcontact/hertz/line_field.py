# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress / p0 at any point below a line contact in plane strain; lengths are divided by b.

E. McEwen, *Stresses in elastic cylinders in contact along a generatrix*, Phil. Mag. 40 (1949) 454;
Johnson (1985), equation (4.49).
"""

from __future__ import annotations

import numpy as np

from .._util.checks import FloatArray


def line_field(x: FloatArray, z: FloatArray, nu: float) -> FloatArray:
    """Return the stress / p0, components xx, yy, zz, yz, xz, xy, shape (6, ...).

    x, z: coordinates divided by the half-width b, in arrays of equal shape; z >= 0.
    """
    # m + i n is the root of 1 - (x - i z)^2; on the surface the limit from below
    squared = (1.0 - x**2 + z**2) + 2j * x * z
    root = np.sqrt(squared)
    m, n = root.real, np.where(z > 0, root.imag, np.sign(x) * np.abs(root.imag))
    size = np.abs(squared)  # m^2 + n^2
    share = np.divide(z**2 + n**2, size, out=np.zeros_like(size), where=size > 0)
    xx, zz = 2.0 * z - m * (1.0 + share), -m * (1.0 - share)
    xz = -n * np.divide(m**2 - z**2, size, out=np.zeros_like(size), where=size > 0)
    none = np.zeros_like(xx)
    return np.stack([xx, nu * (xx + zz), zz, none, xz, none])
