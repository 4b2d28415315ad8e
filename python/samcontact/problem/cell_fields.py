# SPDX-License-Identifier: GPL-3.0-or-later
"""Conversion of fields to the memory layout of the compiled core."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import (
    FloatArray,
    finite_array,
    real_array,
    require_type,
    tractions,
)
from .._util.short_text import in_short
from .grid import Grid


def shear_components(
    grid: Grid, shear: ArrayLike | None
) -> tuple[FloatArray | None, FloatArray | None]:
    """Split the shear traction, shape (nx, ny) or (2, nx, ny), into arrays along x and y [Pa]."""
    require_type("grid", grid, Grid)
    if shear is None:
        return None, None
    shape = grid.surface_shape
    if real_array("shear", shear).ndim == 3:
        both = tractions("shear", shear, (2, *shape))
        return both[0], both[1]
    return tractions("shear", shear, shape), None


def depths_of(z: ArrayLike) -> FloatArray:
    """Check depths [m], given as a number or a list, and return a one-dimensional array."""
    depths = np.atleast_1d(real_array("z", z))
    if depths.ndim != 1 or not ((depths <= 1e75) & (depths >= 0)).all():
        raise ValueError(
            "z must be a one-dimensional array of depths >= 0 and <= 1e75 m, or one such depth, "
            f"got {in_short(z)}"
        )
    return depths


def depth_major(grid: Grid, name: str, tensor: ArrayLike) -> FloatArray:
    """Check a tensor field of shape (6, nx, ny, nz) and return it in the shape (6, nz, nx, ny)."""
    require_type("grid", grid, Grid)
    checked = finite_array(name, tensor, (6, *grid.volume_shape))
    return np.ascontiguousarray(np.moveaxis(checked, 3, 1))
