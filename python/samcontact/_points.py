# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress of surface tractions at any points of a half-space, by direct sums."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from . import kernels
from ._checks import FloatArray, real_array
from .grid import Grid
from .layered import Body
from .material import Material

_BLOCK = 1 << 18
"""Pairs of a point and a cell at once: 20 MB."""


def stress_at_points(
    grid: Grid,
    tractions: tuple[FloatArray, FloatArray | None, FloatArray | None],
    nu: float,
    points: tuple[ArrayLike, ArrayLike, ArrayLike],
) -> FloatArray:
    """Stress of pressure, s_x and s_y in the cells of a grid, at points [Pa], shape (6, ...).

    Each loaded cell counts with its closed form (Love 1929; `kernels.pressure_stress` and
    `kernels.shear_stress`): what the transforms of `ContactSolver.stress` give at the centres of
    cells. Time grows with points times loaded cells, memory does not.
    """
    given = [_finite(name, values) for name, values in zip("xyz", points, strict=True)]
    try:
        x, y, z = np.broadcast_arrays(*given)
    except ValueError:
        shapes = ", ".join(str(values.shape) for values in given)
        raise ValueError(f"x, y and z must have shapes that broadcast, got {shapes}") from None
    if (z < 0).any():
        raise ValueError(f"z must be >= 0 [m], positive into the body, got {z.min():.6g}")
    flat = [np.ascontiguousarray(values, dtype=np.float64).ravel() for values in (x, y, z)]
    total: FloatArray = np.zeros((6, flat[0].size))
    for traction, along in zip(tractions, (None, "x", "y"), strict=True):
        if traction is not None and np.any(traction):
            _add(total, grid, traction, along, nu, flat)
    return total.reshape(6, *x.shape)


def _finite(name: str, values: ArrayLike) -> FloatArray:
    array = real_array(name, values)
    if not np.isfinite(array).all():
        raise ValueError(f"{name} must be finite everywhere [m]")
    return array


def _add(
    total: FloatArray,
    grid: Grid,
    traction: FloatArray,
    along: str | None,
    nu: float,
    points: list[FloatArray],
) -> None:
    """One traction, in blocks of points and cells."""
    i, j = np.nonzero(traction)
    values, halves = traction[i, j], (0.5 * grid.dx, 0.5 * grid.dy)
    cells = min(len(values), _BLOCK)
    count = max(1, _BLOCK // cells)
    for start in range(0, points[0].size, count):
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
    """Raise ValueError for what has no stress at points: the homogeneous material of others."""
    if not isinstance(material, Material):
        raise ValueError(
            f"body{body} must be homogeneous for stress at points, got one of layers: use "
            "ContactSolver.stress(pressure, z), on the cells of the grid"
        )
    if material.is_rigid:
        raise ValueError(f"body{body} is rigid: it has no stress")
    if grid.periodic:
        raise ValueError(
            f"grid must have no period for stress at points, got periodic={grid.periodic!r}: use "
            "ContactSolver.stress(pressure, z), on the cells of the grid"
        )
    if heated:
        raise ValueError(
            f"body{body} is heated, and stress at points is that of tractions alone: use "
            "ContactSolver.stress(pressure, z), which includes thermal stress"
        )
    return material
