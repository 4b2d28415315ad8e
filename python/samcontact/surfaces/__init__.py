# SPDX-License-Identifier: GPL-3.0-or-later
"""Initial gaps between two undeformed surfaces, shape (nx, ny), in metres.

Every function takes a grid (any object with nx, ny, dx, dy, x, y). The gap of a composite surface
is the sum of its parts: a rough ball is ``paraboloid(grid, R) + sinusoidal(grid, ...)``.
"""

from .roller import iso_drop as iso_drop
from .roller import roller
from .shapes import SurfaceGrid as SurfaceGrid
from .shapes import (
    cylinder,
    from_heights,
    paraboloid,
    rough_self_affine,
    sinusoidal,
    sphere,
)
from .shapes import interpolated as interpolated
from .shapes import require_surface as require_surface

__all__ = [
    "cylinder",
    "from_heights",
    "paraboloid",
    "roller",
    "rough_self_affine",
    "sinusoidal",
    "sphere",
]
