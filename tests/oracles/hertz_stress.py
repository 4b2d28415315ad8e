# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress under a Hertz pressure with proportional friction, by quadrature over the contact disc.

Pressure p = p0 sqrt(1 - r^2/a^2), traction s = f p on the body along +x. With r = a sin t the
pressure becomes cos t and the integrand is analytic; the trapezoidal rule is spectrally accurate
in the periodic angle. Unit radius and unit p0; components are ordered xx, yy, zz, yz, xz, xy.
"""

from __future__ import annotations

import numpy as np
from scipy.optimize import minimize

from . import half_space, quadrature


def von_mises(stress):
    """Von Mises stress of components (6, ...)."""
    xx, yy, zz, yz, xz, xy = stress
    normal = 0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2)
    return np.sqrt(normal + 3.0 * (yz**2 + xz**2 + xy**2))


def stress(x, y, z, friction=0.0, nu=0.3):
    """Stress (6,) / p0 at (x, y, z)/a in the loaded body, z > 0.

    Both rules converge like exp(-count * z), so 40/z nodes leave about exp(-40).
    """
    if z <= 0.0:
        raise ValueError(f"z = {z}: the quadrature needs a depth > 0")
    count = int(np.ceil(40.0 / min(z, 1.0))) + 16
    t, weight = quadrature.gauss(0.0, 0.5 * np.pi, count)
    angle = 2.0 * np.pi * np.arange(2 * count) / (2 * count)
    X = x - np.sin(t)[:, None] * np.cos(angle)
    Y = y - np.sin(t)[:, None] * np.sin(angle)
    load = np.broadcast_to((weight * np.sin(t) * np.cos(t) ** 2)[:, None], X.shape)
    load = load * (np.pi / count)
    kernel = half_space.point_normal_stress(X, Y, z, nu)
    if friction != 0.0:
        kernel = kernel + friction * half_space.point_tangential_stress(X, Y, z, nu)
    return np.einsum("sij,ij->s", kernel, load)


def max_von_mises(friction=0.0, nu=0.3):
    """Largest von Mises stress / p0 below the surface in the plane y = 0, and its x/a, z/a."""

    def negative(point):
        return -von_mises(stress(point[0], 0.0, point[1], friction, nu))

    found = minimize(
        negative, (friction, 0.48), method="Nelder-Mead", options={"xatol": 1e-7, "fatol": 1e-14}
    )
    return -found.fun, found.x[0], found.x[1]
