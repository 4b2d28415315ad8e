# SPDX-License-Identifier: GPL-3.0-or-later
"""Nominal profiles of the rail 60E1 (EN 13674) and the wheel S1002 (EN 13715) in millimetres."""

import math

import numpy as np


def rail_60e1(inclination=1 / 40):
    """Points of the head, of three tangent arcs, with the foot inclined; its top is the origin."""
    y = np.linspace(-35.9, 35.9, 401)
    slope, z_start, z = 0.0, 0.0, np.zeros_like(y)
    for radius, start, end in ((300.0, 0.0, 10.228), (80.0, 10.228, 26.05), (13.0, 26.05, 35.9)):
        centre = start - radius * slope  # tangent to the arc before
        lowest = z_start + math.sqrt(radius**2 - (start - centre) ** 2)
        arc = lowest - np.sqrt(np.maximum(radius**2 - (np.abs(y) - centre) ** 2, 0.0))
        z = np.where(np.abs(y) >= start, arc, z)
        slope = (end - centre) / radius
        z_start = lowest - radius * math.sqrt(1.0 - slope**2)
    turn = math.atan(inclination)
    y, z = y * math.cos(turn) + z * math.sin(turn), z * math.cos(turn) - y * math.sin(turn)
    highest = np.argmin(z)
    return np.column_stack([y - y[highest], z - z[highest]])


def wheel_s1002():
    """Points from the flange to the outer tread, z down, the running circle as origin."""
    y = np.linspace(-30.0, 55.0, 601)
    tread = [2.646656573e-13, -5.957839843e-12, 5.309217349e-15, -1.562379023e-8, 5.844240864e-8]
    tread += [-2.810427944e-5, 1.565681624e-3, -3.358537058e-2, 0.0]
    root = [-2.252755540e-7, -4.687195829e-5, -4.169739389e-3, -2.054332446e-1, -6.051367875]
    root += [-1.065501873e2, -1.038384026e3, -4.320221063e3]
    z = np.where(y > -26.0, np.polyval(tread, y), np.polyval(root, y))
    return np.column_stack([y, np.where(y > 32.15796, 1.364323640 - 0.066666667 * y, z)])
