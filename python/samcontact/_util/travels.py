# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances that both bodies travel through the contact: along x only, or along x and y."""

from __future__ import annotations

from typing import Any

import numpy as np

from .checks import FloatArray, finite_array, real_array
from .short_text import in_short

Advance = Any
"""Pair of floats (along x), or pair of pairs (x, y), for bodies 1 and 2 [m]."""
AT_REST = 0.0, 0.0
"""Value of `advance` for bodies that do not move, the default of an increment."""


def both_axes(advance: Advance) -> FloatArray:
    """Return `advance` as displacements [body][axis] of bodies 1 and 2 along x and y [m]."""
    given = real_array("advance", advance)
    if given.shape not in ((2,), (2, 2)):
        raise ValueError(
            "advance must be a pair (body 1, body 2) of displacements along x, or of pairs (x, y), "
            f"got {in_short(advance)}"
        )
    found = finite_array("advance", given)
    return found if found.ndim == 2 else np.stack([found, np.zeros(2)], axis=1)


def along_x(advance: Advance, what: str) -> tuple[float, float]:
    """Return the displacements along x [m]; raise ValueError for motion along y.

    what: end of the message, e.g. "in a cycle of wear".
    """
    given = both_axes(advance)
    if given[:, 1].any():
        raise ValueError(f"advance along y must be 0 {what}, got {in_short(advance)}")
    return float(given[0, 0]), float(given[1, 0])


def plain(travels: FloatArray) -> tuple[Any, Any]:
    """Return displacements [body][axis] as `advance`: one number per body if all are along x."""
    first, second = travels.tolist()
    if not travels[:, 1].any():
        return first[0], second[0]
    return tuple(first), tuple(second)
