# SPDX-License-Identifier: GPL-3.0-or-later
"""Volume fraction that an ellipsoid fills in each cell of a grid.

The section of an ellipsoid at a depth z is an ellipse. An affine map turns the ellipse into a
circle and the cell into a parallelogram. The area common to the circle and the parallelogram has a
closed form. The filled volume of a cell is the integral of this area over z. It is computed by
Gauss quadrature between the depths at which the ellipse touches an edge or passes a corner of the
cell; the error is below 1e-7 of the cell volume.
"""

from __future__ import annotations

import numpy as np

from .._util.checks import BoolArray, FloatArray

NODES = 8
"""Number of Gauss points between successive depths at which the common area changes its shape."""
DIGITS = 12
"""Number of decimals to which filled fractions are rounded, to remove numerical noise."""
_CORNERS = np.array([[i, j, k] for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]) / 2
_AT_ONCE = 20_000  # cells whose areas are computed together, which limits the memory


def circle_and_polygon(corners: FloatArray, radius: FloatArray) -> FloatArray:
    """Area common to a circle about the origin and a polygon, for several such pairs.

    Parameters
    ----------
    corners : ndarray, shape (..., n, 2)
        Corners of each polygon, counter-clockwise.
    radius : ndarray, shape (...)
        Radius of each circle.

    Returns
    -------
    ndarray, shape (...)
        Common area. Each edge of the polygon forms a triangle with the origin. The common area is
        the sum over the edges of the signed areas common to the circle and these triangles.
    """
    p = corners[..., 0], corners[..., 1]
    q = _next(p[0]), _next(p[1])
    along = q[0] - p[0], q[1] - p[1]
    a = np.maximum(_dot(along, along), np.finfo(float).tiny)
    b = _dot(p, along)
    r2 = np.broadcast_to(radius[..., None] ** 2, a.shape)
    root = b * b - a * (_dot(p, p) - r2)
    reach = np.sqrt(np.maximum(root, 0.0))
    start, end = (np.clip(t, 0.0, 1.0) for t in ((-b - reach) / a, (-b + reach) / a))
    inside = (root > 0.0) & (end > start)
    area = np.zeros(a.shape)
    area[~inside] = _angle(*(_at(ends, ~inside) for ends in (p, q)))
    start, end = start[inside], end[inside]
    p, q, along = (_at(ends, inside) for ends in (p, q, along))
    first = p[0] + start * along[0], p[1] + start * along[1]
    last = p[0] + end * along[0], p[1] + end * along[1]
    area[inside] = _angle(p, first) + _angle(last, q)
    area *= r2 / 2
    area[inside] += _cross(first, last) / 2
    return np.asarray(area.sum(-1))


Point = tuple[FloatArray, FloatArray]
"""Coordinates x and y of points."""


def _next(x: FloatArray) -> FloatArray:
    return np.roll(x, -1, axis=-1)


def _at(points: Point, where: BoolArray) -> Point:
    return points[0][where], points[1][where]


def _dot(p: Point, q: Point) -> FloatArray:
    return np.asarray(p[0] * q[0] + p[1] * q[1])


def _cross(p: Point, q: Point) -> FloatArray:
    return np.asarray(p[0] * q[1] - p[1] * q[0])


def _angle(p: Point, q: Point) -> FloatArray:
    return np.asarray(np.arctan2(_cross(p, q), _dot(p, q)))


def shares(
    metric: FloatArray, offset: tuple[FloatArray, FloatArray, FloatArray], size: FloatArray
) -> FloatArray:
    """Volume fraction, from 0 to 1, that an ellipsoid fills in each cell of a box.

    Parameters
    ----------
    metric : ndarray, shape (3, 3)
        Matrix Q [1/m^2]; the ellipsoid contains the points p with p Q p <= 1, where p is measured
        from its centre.
    offset : three ndarrays, shapes (n,), (m,) and (l,)
        Coordinates x, y and z of the cell centres, measured from the centre of the ellipsoid [m].
    size : ndarray, shape (3,)
        Edge lengths of a cell [m].

    Returns
    -------
    ndarray, shape (n, m, l)
    """
    if (metric - np.diag(np.diag(metric))).any():
        return _of_cells(metric, offset, size)
    # Mirror images are equal to the digit, and computed once.
    (x, i), (y, j), (z, k) = (np.unique(np.abs(o), return_inverse=True) for o in offset)
    return _of_cells(metric, (x, y, z), size)[np.ix_(i, j, k)]


def _of_cells(
    metric: FloatArray, offset: tuple[FloatArray, FloatArray, FloatArray], size: FloatArray
) -> FloatArray:
    """Filled fractions of the cells of a box, shape (n, m, l); arguments as for `shares`."""
    points = np.stack(np.meshgrid(*offset, indexing="ij"), -1)
    to_unit_sphere = np.linalg.cholesky(metric)  # |p L|^2 = p Q p
    distance = np.linalg.norm(points @ to_unit_sphere, axis=-1)
    half = np.linalg.norm((_CORNERS * size) @ to_unit_sphere, axis=-1).max()
    filled = np.where(distance <= 1.0 - half, 1.0, 0.0)
    cut = np.abs(distance - 1.0) < half
    places = points[cut]
    parts = [
        _of_cut_cells(metric, places[n : n + _AT_ONCE], size)
        for n in range(0, len(places), _AT_ONCE)
    ]
    filled[cut] = np.concatenate(parts) if parts else 0.0
    return filled


def _of_cut_cells(metric: FloatArray, centers: FloatArray, size: FloatArray) -> FloatArray:
    """Filled fractions of cells that the surface of the ellipsoid cuts, shape (n,).

    centers: centres of the cells [m], shape (n, 3).
    """
    plane = metric[:2, :2]
    toward = np.linalg.solve(plane, metric[:2, 2])  # the centre of the section is -toward z
    height = 1.0 / np.sqrt(metric[2, 2] - metric[:2, 2] @ toward)
    flat = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) / 2 * size[:2]
    corners = centers[:, None, :2] + flat
    low = np.maximum(centers[:, 2] - size[2] / 2, -height)
    high = np.maximum(np.minimum(centers[:, 2] + size[2] / 2, height), low)
    changes = np.clip(_changes(metric, corners), low[:, None], high[:, None])
    ends = np.sort(np.concatenate([low[:, None], changes, high[:, None]], axis=1), axis=1)
    steps = np.diff(ends, axis=1)
    cell, part = np.nonzero(steps > 1e-9 * size[2])
    first, step = ends[cell, part], steps[cell, part]
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    t = (nodes + 1) / 2
    at, slope = t * t * (3 - 2 * t), 6 * t * (1 - t)  # smooth where the area starts as a root
    z = first[:, None] + step[:, None] * at
    radius = np.sqrt(np.maximum(1.0 - (z / height) ** 2, 0.0))
    root = np.linalg.cholesky(plane)
    moved = corners[cell][:, None] + z[..., None, None] * toward
    area = circle_and_polygon(moved @ root, radius) / (root[0, 0] * root[1, 1])
    parts = (area * slope * weights / 2).sum(-1) * step
    volume = np.bincount(cell, parts, minlength=len(centers))
    return np.asarray(np.clip(np.round(volume / size.prod(), DIGITS), 0.0, 1.0))


def _changes(metric: FloatArray, corners: FloatArray) -> FloatArray:
    """Depths at which the ellipse touches an edge or passes a corner of its cell, shape (n, 16).

    corners: corners of each cell [m], shape (n, 4, 2). Depths that do not exist are replaced by 0.
    """
    x, y = corners[..., 0], corners[..., 1]
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = metric
    found = [_roots(zz, xz * x + yz * y, xx * x * x + 2 * xy * x * y + yy * y * y - 1.0)]
    for at, aa, ab, az, bb, bz in (
        (x[:, [0, 1]], xx, xy, xz, yy, yz),
        (y[:, [0, 2]], yy, xy, yz, xx, xz),
    ):  # the smallest p Q p on the plane of an edge
        c, b = aa - ab * ab / bb, az - ab * bz / bb
        found.append(_roots(zz - bz * bz / bb, b * at, c * at * at - 1.0))
    return np.concatenate(found, axis=1)


def _roots(a: float, b: FloatArray, c: FloatArray) -> FloatArray:
    """Both real roots of a z^2 + 2 b z + c, or 0 in place of complex roots."""
    root = b * b - a * c
    reach = np.sqrt(np.maximum(root, 0.0))
    both = np.concatenate([-b - reach, -b + reach], axis=1) / a
    return np.where(np.concatenate([root, root], axis=1) > 0.0, both, 0.0)


def overlaps(edges: FloatArray, first: float, step: float, count: int) -> FloatArray:
    """Return how much of each cell along an axis is covered by each of several intervals [-].

    Parameters
    ----------
    edges : ndarray, shape (n + 1,)
        Edges of the intervals [m], increasing.
    first, step : float
        Lower edge of the first cell, and length of a cell [m].
    count : int
        Number of cells.

    Returns
    -------
    ndarray, shape (count, n)
        Covered fraction of each cell; the rows are the cells, the columns the intervals.
    """
    low = first + step * np.arange(count)
    left = np.maximum(low[:, None], edges[:-1])
    right = np.minimum((low + step)[:, None], edges[1:])
    return np.asarray(np.round(np.maximum(right - left, 0.0) / step, DIGITS))


def is_cut(share: FloatArray) -> BoolArray:
    """Mask of the cells that are filled only partly."""
    return np.asarray((share > 0.0) & (share < 1.0))
