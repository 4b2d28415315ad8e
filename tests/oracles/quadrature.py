# SPDX-License-Identifier: GPL-3.0-or-later
"""Gauss-Legendre quadrature on a rectangle, refined towards a field point close to its plane.

A panel is accepted when its longest side is at most its distance from the field point. The
integrands used here are analytic except at that point, so the nearest singularity of a panel of
half length h is 2 h away from its interval: Bernstein ellipse of at least 2 + sqrt(5) = 4.24, and
16 nodes leave 4.24**-32 = 1e-20 times the algebraic factors of the pole.
"""

from __future__ import annotations

import numpy as np

NODES, WEIGHTS = np.polynomial.legendre.leggauss(16)
# Limits z -> 0 above a loaded rectangle or cuboid are taken at this height times its smallest side.
# The error is the height over the distance to the nearest edge; much smaller, z - zc loses it.
LIMIT_HEIGHT = 1e-14


def panels(u0: float, u1: float, v0: float, v1: float, height: float) -> np.ndarray:
    """Panels (n, 4) = u0, u1, v0, v1 covering a rectangle, coordinates minus the field point's.

    These keep full relative precision where the panels are smallest, so heights of 1e-14 of the
    rectangle work.
    """
    if height == 0.0 and u0 <= 0.0 <= u1 and v0 <= 0.0 <= v1:
        raise ValueError("the field point lies on the rectangle: the integral is singular")
    todo = np.array([[u0, u1, v0, v1]], dtype=float)
    done = []
    while todo.size:
        lo_u, hi_u, lo_v, hi_v = todo.T
        du = np.maximum(np.maximum(lo_u, -hi_u), 0.0)
        dv = np.maximum(np.maximum(lo_v, -hi_v), 0.0)
        distance = np.sqrt(du**2 + dv**2 + height**2)
        side_u, side_v = hi_u - lo_u, hi_v - lo_v
        fine = np.maximum(side_u, side_v) <= distance
        done.append(todo[fine])
        in_u, in_v = ~fine & (side_u >= side_v), ~fine & (side_u < side_v)
        pieces = []
        for mask, k in ((in_u, 0), (in_v, 2)):
            left, right = todo[mask].copy(), todo[mask].copy()
            left[:, k + 1] = right[:, k] = 0.5 * (left[:, k] + left[:, k + 1])
            pieces += [left, right]
        todo = np.concatenate(pieces)
    return np.concatenate(done)


def points(
    u0: float, u1: float, v0: float, v1: float, height: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Nodes u, v and weights, flat; the field point is at the origin, `height` off the plane."""
    cells = panels(u0, u1, v0, v1, height)
    half_u, half_v = 0.5 * (cells[:, 1] - cells[:, 0]), 0.5 * (cells[:, 3] - cells[:, 2])
    u = (0.5 * (cells[:, 0] + cells[:, 1]))[:, None] + half_u[:, None] * NODES
    v = (0.5 * (cells[:, 2] + cells[:, 3]))[:, None] + half_v[:, None] * NODES
    weight = (half_u * half_v)[:, None, None] * WEIGHTS[:, None] * WEIGHTS
    uu = np.broadcast_to(u[:, :, None], weight.shape)
    vv = np.broadcast_to(v[:, None, :], weight.shape)
    return uu.ravel(), vv.ravel(), weight.ravel()


def gauss(low: float, high: float, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Gauss-Legendre nodes and weights on [low, high]."""
    node, weight = np.polynomial.legendre.leggauss(count)
    return 0.5 * (low + high) + 0.5 * (high - low) * node, 0.5 * (high - low) * weight
