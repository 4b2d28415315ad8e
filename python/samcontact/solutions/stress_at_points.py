# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress due to surface tractions at arbitrary points of a half-space, by direct summation."""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import kernels
from .._util.checks import FloatArray, real_array, together
from ..bodies.layered import Body
from ..bodies.material import Material
from ..problem.grid import Grid

_BLOCK_PAIRS = 1 << 18
"""Number of pairs (point, cell) that are processed together; they require 20 MB."""
_EDGE_TOLERANCE = 1e-6
"""Distance from the edge of a cell, in cells, below which a point counts as on the edge."""
_MAX_COORDINATE = 1e75
"""Maximum coordinate [m]; with larger values, products of squared distances overflow."""

IntArray = NDArray[np.intp]
Tractions = tuple[FloatArray, FloatArray | None, FloatArray | None]


def stress_at_points(
    grid: Grid,
    tractions: Tractions,
    nu: float,
    points: tuple[ArrayLike, ArrayLike, ArrayLike],
) -> FloatArray:
    """Stress [Pa] at points due to pressure, s_x and s_y in the cells of a grid, shape (6, ...).

    The closed forms of all loaded cells are summed (Love 1929; `kernels.pressure_stress` and
    `kernels.shear_stress`). At cell centres the result equals `ContactSolver.stress`. At
    points of the surface on an edge of a loaded cell, the result is the mean of the stresses half a
    cell away on both sides of this edge. The computing time is proportional to the number of points
    times the number of loaded cells; memory is constant.
    """
    given = {name: _finite(name, values) for name, values in zip("xyz", points, strict=True)}
    x, y, z = together(**given)
    if (z < 0).any():
        raise ValueError(f"z must be >= 0 [m], positive into the body, got {z.min():.6g}")
    flat = np.stack([np.asarray(values, dtype=np.float64).ravel() for values in (x, y, z)])
    half = _half_cells(grid, tractions, flat)
    between = half.any(axis=0)
    total: FloatArray = np.zeros((6, flat[0].size))
    total[:, ~between] = _sums(grid, tractions, nu, flat[:, ~between])
    if between.any():
        for signs in itertools.product((-1.0, 1.0), repeat=2):
            step = half[:, between] * np.array([*signs, 0.0])[:, None]
            total[:, between] += 0.25 * _sums(grid, tractions, nu, flat[:, between] + step)
    return total.reshape(6, *x.shape)


def _half_cells(grid: Grid, tractions: Tractions, points: FloatArray) -> FloatArray:
    """Return half a cell size [m] for surface points on edges of loaded cells, otherwise 0.

    With uniform tractions in each cell, the stress near a jump of the traction contains the
    logarithm of the distance. The mean of the values half a cell away on both sides does not
    contain this term.
    """
    half = np.zeros_like(points)
    cells: list[tuple[IntArray, IntArray]] = []
    for n, (axis, size) in enumerate(((grid.x, grid.dx), (grid.y, grid.dy))):
        edge = (points[n] - axis[0]) / size + 0.5  # in cells from the edge of the grid
        half[n, np.abs(edge - np.rint(edge)) < _EDGE_TOLERANCE] = 0.5 * size
        behind, ahead = (
            np.clip(np.floor(edge + side), -1, len(axis)).astype(np.intp) + 1
            for side in (-_EDGE_TOLERANCE, _EDGE_TOLERANCE)
        )
        cells.append((behind, ahead))
    loaded = np.zeros((grid.nx + 2, grid.ny + 2), dtype=np.bool_)
    for traction in tractions:
        if traction is not None:
            loaded[1:-1, 1:-1] |= traction != 0
    is_loaded = np.any([loaded[i, j] for i, j in itertools.product(*cells)], axis=0)
    half[:, ~is_loaded | (points[2] >= _EDGE_TOLERANCE * min(grid.dx, grid.dy))] = 0.0
    return half


def _sums(grid: Grid, tractions: Tractions, nu: float, points: FloatArray) -> FloatArray:
    total: FloatArray = np.zeros((6, points.shape[1]))
    for traction, along in zip(tractions, (None, "x", "y"), strict=True):
        if traction is not None and np.any(traction):
            _add(total, grid, traction, along, nu, points)
    return total


def _finite(name: str, values: ArrayLike) -> FloatArray:
    array = real_array(name, values)
    if not (np.abs(array) <= _MAX_COORDINATE).all():
        raise ValueError(f"{name} must be finite, and <= {_MAX_COORDINATE:g} m, at all points")
    return array


def _add(
    total: FloatArray,
    grid: Grid,
    traction: FloatArray,
    along: str | None,
    nu: float,
    points: FloatArray,
) -> None:
    """Add the stress due to one traction component to `total`, in blocks of points and cells."""
    i, j = np.nonzero(traction)
    values, halves = traction[i, j], (0.5 * grid.dx, 0.5 * grid.dy)
    cells = min(len(values), _BLOCK_PAIRS)
    count = max(1, _BLOCK_PAIRS // cells)
    for start in range(0, points.shape[1], count):
        x, y, z = (p[start : start + count, None] for p in points)
        for first in range(0, len(values), cells):
            own = slice(first, first + cells)
            X, Y = x - grid.x[i[own]], y - grid.y[j[own]]
            if along is None:
                unit = kernels.pressure_stress(X, Y, z, *halves, nu)
            else:
                unit = kernels.shear_stress(X, Y, z, *halves, nu, along=along)
            total[:, start : start + count] += unit @ values[own]


def require_closed_forms(grid: Grid, material: Body, body: int, *, heated: bool) -> Material:
    """Return the material of a body; ValueError unless stress at arbitrary points is available."""
    if not isinstance(material, Material):
        raise ValueError(
            f"body{body} must be homogeneous for stress at arbitrary points, got layers or "
            "inclusions: use `stress`, which gives the stress below the cell centres"
        )
    if material.is_rigid:
        raise ValueError(f"body{body} is rigid and has no stress")
    if grid.periodic:
        raise ValueError(
            "grid must not be periodic for stress at arbitrary points, got "
            f"periodic={grid.periodic!r}: use `stress`, which gives it below the cell centres"
        )
    if heated:
        raise ValueError(
            f"body{body} must not be heated for stress at arbitrary points, because thermal stress "
            "is not available there: use `stress`, which includes it below the cell centres"
        )
    return material
