# SPDX-License-Identifier: GPL-3.0-or-later
"""Dents, furrows and bumps on the surface of a body, which move with the body.

Positions are measured on the body; 0 is the initial position of the contact.
"""

from __future__ import annotations

import numpy as np

from ._util.checks import FloatArray, choice, finite, positive
from .problem.moving_topography import Relief, rows_within
from .surfaces import SurfaceGrid, require_surface

__all__ = ["furrow", "spherical"]


def _cap(r: FloatArray, depth: float, width: str, radius: float) -> FloatArray:
    """Return heights of a circular arc of the given depth for -radius < r < radius; 0 outside."""
    d, a = finite("depth", depth), positive(width, radius)
    if d == 0.0 or abs(d) > a:
        raise ValueError(f"depth must be nonzero, of magnitude <= {width} = {a!r}, got {d!r}")
    if a / abs(d) > 1e12:
        raise ValueError(f"depth must be of magnitude >= 1e-12 {width} = {1e-12 * a!r}, got {d!r}")
    R2 = (0.5 * (a**2 + d**2) / abs(d)) ** 2
    inside = np.maximum(a**2 - r**2, 0.0)
    # sqrt(R^2 - r^2) - sqrt(R^2 - a^2) without cancellation
    arc = inside / (np.sqrt(R2 - a**2 + inside) + np.sqrt(max(R2 - a**2, 0.0)) + (inside == 0))
    return np.asarray(-np.sign(d) * arc, dtype=np.float64)


def spherical(
    grid: SurfaceGrid, depth: float, radius: float, x: float = 0.0, y: float = 0.0
) -> Relief:
    """Dent in the shape of a spherical cap.

    Parameters
    ----------
    grid : Grid
        Grid of the simulation.
    depth : float
        Depth at the centre [m], nonzero, of magnitude <= `radius`; negative for a bump.
    radius : float
        Radius of the rim, where the dent meets the flat surface [m], > 0.
    x, y : float, optional
        Centre on the body [m].

    Returns
    -------
    Relief
        Surface topography, for the argument `relief1` or `relief2` of a `Simulation`.

    Raises
    ------
    ValueError
        An argument is outside its range.
    """
    require_surface(grid)
    centre, across = finite("x", x), np.asarray(grid.y)[None, :] - finite("y", y)
    along, first = rows_within(grid, centre, positive("radius", radius))
    r = np.hypot(along[:, None] - centre, across)
    return Relief(_cap(r, depth, "radius", radius), first)


def furrow(
    grid: SurfaceGrid, depth: float, half_width: float, along: str = "y", position: float = 0.0
) -> Relief:
    """Straight furrow of infinite length with a circular-arc section.

    Parameters
    ----------
    grid : Grid
        Grid of the simulation.
    depth : float
        Depth in the middle [m], nonzero, of magnitude <= `half_width`; negative for a ridge.
    half_width : float
        Half-width at the level of the flat surface [m], > 0.
    along : {"y", "x"}
        Direction of the furrow: "y" is transverse and "x" parallel to the motion of the contact.
    position : float, optional
        Position of the middle on the body [m]: along x for a furrow along y, and vice versa.

    Returns
    -------
    Relief
        Surface topography, for the argument `relief1` or `relief2` of a `Simulation`.

    Raises
    ------
    ValueError
        An argument is outside its range.
    """
    require_surface(grid)
    middle = finite("position", position)
    if choice("along", along, ("y", "x")) == "x":
        across = np.asarray(grid.y)[None, :] - middle
        return Relief(_cap(across, depth, "half_width", half_width), periodic=True)
    x, first = rows_within(grid, middle, positive("half_width", half_width))
    profile = _cap(x - middle, depth, "half_width", half_width)
    return Relief(np.repeat(profile[:, None], grid.ny, axis=1), first)
