# SPDX-License-Identifier: GPL-3.0-or-later
"""Gaps of indenters: flat punch, cone, and the pyramids of Berkovich and Vickers."""

from __future__ import annotations

import math

import numpy as np

from .._util.checks import FloatArray, finite, non_negative, number, positive
from ..surfaces import SurfaceGrid, require_surface

BERKOVICH_HALF_ANGLE = math.radians(65.27)
"""Angle between the axis and each of the three faces of a Berkovich indenter [rad]."""
VICKERS_HALF_ANGLE = math.radians(68.0)
"""Angle between the axis and each of the four faces of a Vickers indenter [rad]."""
_MIN_SLOPE, _MAX_SLOPE = 1e-6, 1e6


def flat_punch(grid: SurfaceGrid, radius: float, edge_radius: float = 0.0) -> FloatArray:
    """Gap of a flat-ended circular punch with a sharp or rounded edge.

    Parameters
    ----------
    grid : Grid
        Grid on which the gap is evaluated.
    radius : float
        Radius of the punch [m], > 0.
    edge_radius : float, optional
        Radius of the rounding of the edge [m], at most `radius`. By default the edge is sharp, and
        the pressure there is singular.

    Returns
    -------
    ndarray, shape (nx, ny)
        Gap [m]: 0 below the flat end, inf outside the punch.

    Raises
    ------
    ValueError
        An argument is outside its range.
    """
    a, rounding = positive("radius", radius), non_negative("edge_radius", edge_radius)
    if rounding > a:
        raise ValueError(f"edge_radius must be <= radius = {a!r}, got {edge_radius!r}")
    r = _distance(grid)
    gap = np.where(r <= a, 0.0, math.inf)
    if rounding > 0.0:
        beyond = np.clip(r - (a - rounding), 0.0, rounding)
        arc = beyond**2 / (rounding + np.sqrt(rounding**2 - beyond**2))
        gap = gap + arc
    return gap


def cone(grid: SurfaceGrid, half_angle: float, tip_radius: float = 0.0) -> FloatArray:
    """Gap of a cone, with a sharp tip or a spherical tip tangent to the cone.

    Parameters
    ----------
    grid : Grid
        Grid on which the gap is evaluated.
    half_angle : float
        Angle between the axis and the surface [rad], in (0, pi/2).
    tip_radius : float, optional
        Radius of the tip [m], >= 0.

    Returns
    -------
    ndarray, shape (nx, ny)
        Gap [m], 0 at the tip.

    Raises
    ------
    ValueError
        An argument is outside its range.
    """
    slope, R = _slope(half_angle), non_negative("tip_radius", tip_radius)
    r = _distance(grid)
    stretch = math.hypot(1.0, slope)
    ball = R * slope / stretch  # radius of the circle in which the tip passes into the cone
    inside = np.minimum(r, ball)
    tip = inside**2 / (R + np.sqrt(R**2 - inside**2)) if R > 0.0 else 0.0
    return np.asarray(tip + slope * np.maximum(r - ball, 0.0), dtype=np.float64)


def berkovich(
    grid: SurfaceGrid,
    tip_radius: float = 0.0,
    angle: float = 0.0,
    half_angle: float = BERKOVICH_HALF_ANGLE,
) -> FloatArray:
    """Gap of a Berkovich indenter, a pyramid with three faces.

    At the distance h from the sharp tip, the area of the cross-section is 24.5 h^2. This is also
    the area of a cone with a half angle of 70.3 degrees.

    Parameters
    ----------
    grid : Grid
        Grid on which the gap is evaluated.
    tip_radius : float, optional
        Radius to which the tip and the edges are rounded [m], >= 0.
    angle : float, optional
        Angle from the x axis to the normal of one face, seen along the axis [rad].
    half_angle : float, optional
        Angle between the axis and each face [rad], in (0, pi/2), 65.27 degrees by default.

    Returns
    -------
    ndarray, shape (nx, ny)
        Gap [m], 0 at the tip.

    Raises
    ------
    ValueError
        An argument is outside its range.
    """
    return _pyramid(grid, 3, half_angle, tip_radius, angle)


def vickers(
    grid: SurfaceGrid,
    tip_radius: float = 0.0,
    angle: float = 0.0,
    half_angle: float = VICKERS_HALF_ANGLE,
) -> FloatArray:
    """Gap of a Vickers indenter, a pyramid with four faces.

    At the distance h from the sharp tip, the area of the cross-section is 24.504 h^2.

    Parameters
    ----------
    grid : Grid
        Grid on which the gap is evaluated.
    tip_radius : float, optional
        Radius to which the tip and the edges are rounded [m], >= 0.
    angle : float, optional
        Angle from the x axis to the normal of one face, seen along the axis [rad].
    half_angle : float, optional
        Angle between the axis and each face [rad], in (0, pi/2), 68 degrees by default.

    Returns
    -------
    ndarray, shape (nx, ny)
        Gap [m], 0 at the tip.

    Raises
    ------
    ValueError
        An argument is outside its range.
    """
    return _pyramid(grid, 4, half_angle, tip_radius, angle)


def _slope(half_angle: float) -> float:
    """Return the slope of a surface that makes the angle `half_angle` [rad] with the axis."""
    angle = number("half_angle", half_angle)
    slope = 1.0 / math.tan(angle) if 0.0 < angle < 0.5 * math.pi else 0.0
    if not _MIN_SLOPE <= slope <= _MAX_SLOPE:
        hint = ": degrees instead of radians?" if angle > 0.5 * math.pi else ""
        raise ValueError(f"half_angle must be in (0, pi/2) rad, got {half_angle!r}{hint}")
    return slope


def _distance(grid: SurfaceGrid) -> FloatArray:
    require_surface(grid)
    return np.hypot(np.asarray(grid.x)[:, None], np.asarray(grid.y)[None, :])


def _pyramid(
    grid: SurfaceGrid, faces: int, half_angle: float, tip_radius: float, angle: float
) -> FloatArray:
    """Return the gap of a pyramid whose tip and edges are sharp or rounded.

    The rounded pyramid is the envelope of all balls with the radius `tip_radius` that fit into the
    sharp pyramid. It consists of planes, of cylinders along the edges and of a sphere at the tip,
    which meet without a kink.
    """
    slope, R = _slope(half_angle), non_negative("tip_radius", tip_radius)
    turned = finite("angle", angle)
    require_surface(grid)
    x, y = np.asarray(grid.x)[:, None], np.asarray(grid.y)[None, :]
    step = 2.0 * math.pi / faces
    normals = [turned + step * k for k in range(faces)]
    planes = [slope * (math.cos(a) * x + math.sin(a) * y) for a in normals]
    gap = np.asarray(np.maximum.reduce(planes), dtype=np.float64)
    if R == 0.0:
        return gap
    gap += R - R * math.hypot(1.0, slope)
    steepest = slope * math.cos(0.5 * step)  # slope along an edge
    stretch = math.hypot(1.0, steepest)
    # half-width of the cylinder: there, its slope across the edge equals that of the faces
    across = slope * math.sin(0.5 * step) / stretch
    half_width = R * across / math.hypot(1.0, across)
    r2 = x**2 + y**2
    on_tip = r2 < R**2
    sphere = np.sqrt(np.where(on_tip, R**2 - r2, 0.0))
    for a in normals:
        edge = a + 0.5 * step
        u = math.cos(edge) * x + math.sin(edge) * y
        v = math.cos(edge) * y - math.sin(edge) * x
        arc = np.sqrt(np.maximum(R**2 - v**2, 0.0))
        on_edge = (np.abs(v) < half_width) & (u > steepest * arc / stretch)
        gap = np.where(on_edge, R + steepest * u - stretch * arc, gap)
        on_tip = on_tip & (u <= steepest * sphere)
    return np.where(on_tip, r2 / (R + sphere), gap)
