# SPDX-License-Identifier: GPL-3.0-or-later
"""Inclusions of worn bodies: they come closer to the surface, and are worn away."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._util.checks import FloatArray
from .._util.display import quantity
from ..bodies.heterogeneous import Heterogeneous
from ..bodies.inclusion import Inclusion
from ..bodies.layered import Body
from ..bodies.layers import Layered

if TYPE_CHECKING:
    from ..problem.grid import Grid


def require_worn_inclusions(*bodies: Body) -> None:
    """Raise ValueError for a body whose inclusions are not supported in wear."""
    for number, body in enumerate(bodies, 1):
        if not isinstance(body, Heterogeneous):
            continue
        if isinstance(body.matrix, Layered):
            raise ValueError(
                f"for wear, body{number} must not have both layers and inclusions, got {body!r}: "
                "wear moves the inclusions closer to the surface, but not the interfaces of layers"
            )
        if body.is_plastic:
            raise ValueError(
                f"for wear, body{number} must be elastic, because it has inclusions, got {body!r}: "
                "the plastic strain of cells with inclusions cannot be moved up to the worn surface"
            )
        if body.measured is not None:
            raise ValueError(
                f"for wear, body{number} must not have voxels, got {body!r}: the worn depth varies "
                "across the voxels; use inclusions"
            )


def raised(body: Body, number: int, worn: FloatArray, grid: Grid) -> Body:
    """Return a body whose inclusions lie below the worn surface.

    Each inclusion moves up by the mean worn depth above it, see `mean_depth`. Inclusions that would
    lie entirely above the surface are removed.

    Parameters
    ----------
    body : Body
        Body before wear.
    number : {1, 2}
        Number of the body, for messages.
    worn : ndarray, shape (nx, ny)
        Worn depth in each cell of the grid [m].
    grid : Grid

    Raises
    ------
    ValueError
        Wear has reached a void. The surface would have a hole, but the half-space solution would
        carry load there.
    """
    if not isinstance(body, Heterogeneous) or not worn.any():
        return body
    kept: list[Inclusion] = []
    for n, one in enumerate(body.inclusions):
        x, y, z = one.center
        depth = z - mean_depth(one, worn, grid)
        if one.is_void and depth - one.extent[2] <= 0.0:
            raise ValueError(
                f"body{number}.inclusions[{n}] must stay below the worn surface, but wear has "
                f"reached this void {quantity(z - one.extent[2], 'm')} below the initial "
                "surface: open pores are not modelled; use fewer cycles or repeats, or omit the "
                "void"
            )
        if depth + one.extent[2] > 0.0:
            kept.append(Inclusion((x, y, depth), one.radii, one.axes, one.material, one.misfit))
    return Heterogeneous(body.matrix, kept) if kept else body.matrix


def mean_depth(inclusion: Inclusion, worn: FloatArray, grid: Grid) -> float:
    """Mean worn depth above an inclusion [m].

    Columns of cells are weighted by the height of the inclusion in them.
    """
    x, y, _ = inclusion.center
    along_x, along_y, _ = inclusion.extent
    r2 = ((grid.x - x) / along_x)[:, None] ** 2 + ((grid.y - y) / along_y) ** 2
    height = np.sqrt(np.maximum(1.0 - r2, 0.0))
    if not height.any():
        height = np.zeros_like(r2)
        height[np.unravel_index(r2.argmin(), r2.shape)] = 1.0
    return float((height * worn).sum() / height.sum())
