# SPDX-License-Identifier: GPL-3.0-or-later
"""Dents, furrows and bumps in the surface of a body, which move with it.

Positions are those on the body, 0 where the contact stands at the start.
"""

from __future__ import annotations

import numpy as np

from ._util.checks import FloatArray, choice, finite, positive
from .scene.moving_topography import Relief, rows_within
from .surfaces import SurfaceGrid, require_surface

__all__ = ["furrow", "spherical"]


def _cap(r: FloatArray, depth: float, width: str, radius: float) -> FloatArray:
    """Heights of a circular arc of this depth between -radius and radius; 0 beyond."""
    d, a = finite("depth", depth), positive(width, radius)
    if d == 0.0 or abs(d) > a:
        raise ValueError(f"depth must not be 0, nor deeper than {width} = {a!r}, got {d!r}")
    if a / abs(d) > 1e12:
        raise ValueError(f"depth must be at least 1e-12 {width}, {1e-12 * a!r}, got {d!r}")
    R2 = (0.5 * (a**2 + d**2) / abs(d)) ** 2
    inside = np.maximum(a**2 - r**2, 0.0)
    # sqrt(R^2 - r^2) - sqrt(R^2 - a^2) without cancellation
    arc = inside / (np.sqrt(R2 - a**2 + inside) + np.sqrt(max(R2 - a**2, 0.0)) + (inside == 0))
    return np.asarray(-np.sign(d) * arc, dtype=np.float64)


def spherical(
    grid: SurfaceGrid, depth: float, radius: float, x: float = 0.0, y: float = 0.0
) -> Relief:
    """Dent with the shape of a spherical cap.

    Parameters
    ----------
    grid : Grid
        Of the simulation.
    depth : float
        At its centre [m], not 0; negative: a bump. At most the radius.
    radius : float
        Of its rim, where it meets the flat surface [m], > 0.
    x, y : float, optional
        Its centre on the body [m].

    Returns
    -------
    Relief
        For `relief1` or `relief2` of a `Simulation`.

    Raises
    ------
    ValueError
        An argument outside its range.
    """
    require_surface(grid)
    centre, across = finite("x", x), np.asarray(grid.y)[None, :] - finite("y", y)
    along, first = rows_within(grid, centre, positive("radius", radius))
    r = np.hypot(along[:, None] - centre, across)
    return Relief(_cap(r, depth, "radius", radius), first)


def furrow(
    grid: SurfaceGrid, depth: float, half_width: float, along: str = "y", position: float = 0.0
) -> Relief:
    """Straight furrow of any length whose section is a circular arc.

    Parameters
    ----------
    grid : Grid
        Of the simulation.
    depth : float
        In its middle [m], not 0; negative: a ridge. At most the half width.
    half_width : float
        Half of its width where it meets the flat surface [m], > 0.
    along : {"y", "x"}
        Its direction: across the way of the contact, or along it.
    position : float, optional
        Of its middle on the body [m]: along x of a furrow along y, and the other way round.

    Returns
    -------
    Relief
        For `relief1` or `relief2` of a `Simulation`.

    Raises
    ------
    ValueError
        An argument outside its range.
    """
    require_surface(grid)
    middle = finite("position", position)
    if choice("along", along, ("y", "x")) == "x":
        across = np.asarray(grid.y)[None, :] - middle
        return Relief(_cap(across, depth, "half_width", half_width), periodic=True)
    x, first = rows_within(grid, middle, positive("half_width", half_width))
    profile = _cap(x - middle, depth, "half_width", half_width)
    return Relief(np.repeat(profile[:, None], grid.ny, axis=1), first)
