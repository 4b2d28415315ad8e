# SPDX-License-Identifier: GPL-3.0-or-later
"""Boussinesq and Cerruti point loads on a half-space, and loaded rectangles by quadrature of them.

z >= 0 points into the body, stress is positive in tension, components are ordered xx, yy, zz, yz,
xz, xy. Point loads: K. L. Johnson, Contact Mechanics (1985), section 3.2 (normal, eqs 3.18-3.19)
and section 3.6 (tangential, eqs 3.75-3.76), doi:10.1017/CBO9781139171731. The normal load uses 1
- z/R = r^2/(R (R + z)), so that nothing is divided by r^2.

Rectangles are centred at the origin, `rect` = (a, b) are HALF sides, (x, y) is field minus centre.
"""

from __future__ import annotations

import numpy as np

from . import quadrature


def point_normal_displacement(x, y, z, nu, E):
    """Displacement (3, ...) [m/N] of a unit normal force into the body at the origin."""
    R = np.sqrt(x * x + y * y + z * z)
    shear_modulus = E / (2.0 * (1.0 + nu))
    radial = z / R**3 - (1.0 - 2.0 * nu) / (R * (R + z))
    uz = z * z / R**3 + 2.0 * (1.0 - nu) / R
    return np.array([x * radial, y * radial, uz]) / (4.0 * np.pi * shear_modulus)


def point_tangential_displacement(x, y, z, nu, E):
    """Displacement (3, ...) [m/N] of a unit force along +x at the origin of the surface."""
    R = np.sqrt(x * x + y * y + z * z)
    shear_modulus = E / (2.0 * (1.0 + nu))
    k, T = 1.0 - 2.0 * nu, R + z
    ux = 1.0 / R + x * x / R**3 + k * (1.0 / T - x * x / (R * T**2))
    uy = x * y / R**3 - k * x * y / (R * T**2)
    uz = x * z / R**3 + k * x / (R * T)
    return np.array([ux, uy, uz]) / (4.0 * np.pi * shear_modulus)


def point_normal_stress(x, y, z, nu):
    """Stress (6, ...) [1/m^2] of a unit normal force into the body at the origin."""
    R = np.sqrt(x * x + y * y + z * z)
    k, T = 1.0 - 2.0 * nu, R + z
    common = z / R**3 - 1.0 / (R * T)
    spread = (2.0 * R + z) / (R**3 * T**2)
    sxx = k * (common + x * x * spread) - 3.0 * x * x * z / R**5
    syy = k * (common + y * y * spread) - 3.0 * y * y * z / R**5
    szz = -3.0 * z**3 / R**5
    syz = -3.0 * y * z**2 / R**5
    sxz = -3.0 * x * z**2 / R**5
    sxy = k * x * y * spread - 3.0 * x * y * z / R**5
    return np.array([sxx, syy, szz, syz, sxz, sxy]) / (2.0 * np.pi)


def point_tangential_stress(x, y, z, nu):
    """Stress (6, ...) [1/m^2] of a unit force along +x at the origin of the surface."""
    R = np.sqrt(x * x + y * y + z * z)
    k, T = 1.0 - 2.0 * nu, R + z
    spread = 1.0 / (R**3 * T**2) + 2.0 / (R**2 * T**3)
    sxx = -3.0 * x**3 / R**5 + k * (x / R**3 - 3.0 * x / (R * T**2) + x**3 * spread)
    syy = -3.0 * x * y * y / R**5 + k * (x / R**3 - x / (R * T**2) + x * y * y * spread)
    szz = -3.0 * x * z * z / R**5
    syz = -3.0 * x * y * z / R**5
    sxz = -3.0 * x * x * z / R**5
    sxy = -3.0 * x * x * y / R**5 + k * (-y / (R * T**2) + x * x * y * spread)
    return np.array([sxx, syy, szz, syz, sxz, sxy]) / (2.0 * np.pi)


def swap_xy(stress):
    """Return the components of a stress after an exchange of x and y."""
    return stress[[1, 0, 2, 4, 3, 5]]


def _integrate(function, x, y, z, rect):
    """Integral of function(field - source) over the rectangle; on it, the limit z -> 0+."""
    a, b = rect
    if z == 0.0 and abs(x) <= a and abs(y) <= b:
        z = quadrature.LIMIT_HEIGHT * min(a, b)
    u, v, weight = quadrature.points(-a - x, a - x, -b - y, b - y, z)
    return function(-u, -v, np.full_like(u, z)) @ weight


def displacement_pressure(x, y, rect, nu, E):
    """Displacement (3,) [m/Pa] at (x, y, 0) per unit pressure on the rectangle."""
    return _integrate(lambda X, Y, Z: point_normal_displacement(X, Y, Z, nu, E), x, y, 0.0, rect)


def displacement_shear_x(x, y, rect, nu, E):
    """Displacement (3,) [m/Pa] at (x, y, 0) per unit shear traction along +x on the rectangle."""
    return _integrate(
        lambda X, Y, Z: point_tangential_displacement(X, Y, Z, nu, E), x, y, 0.0, rect
    )


def displacement_shear_y(x, y, rect, nu, E):
    """Displacement (3,) [m/Pa] at (x, y, 0) per unit shear traction along +y on the rectangle."""
    return displacement_shear_x(y, x, rect[::-1], nu, E)[[1, 0, 2]]


def stress_pressure(x, y, z, rect, nu):
    """Stress (6,) at (x, y, z) per unit pressure on the rectangle."""
    return _integrate(lambda X, Y, Z: point_normal_stress(X, Y, Z, nu), x, y, z, rect)


def stress_shear_x(x, y, z, rect, nu):
    """Stress (6,) at (x, y, z) per unit shear traction along +x on the rectangle."""
    return _integrate(lambda X, Y, Z: point_tangential_stress(X, Y, Z, nu), x, y, z, rect)


def stress_shear_y(x, y, z, rect, nu):
    """Stress (6,) at (x, y, z) per unit shear traction along +y on the rectangle."""
    return swap_xy(stress_shear_x(y, x, z, rect[::-1], nu))
