# SPDX-License-Identifier: GPL-3.0-or-later
"""Resolution of inclusions by the cells of a grid."""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence
from typing import Protocol

from .._util.display import quantity
from .._util.errors import ResolutionWarning
from .inclusion import Inclusion

MIN_CELLS = 2.0
"""Minimum number of cells per radius; with fewer cells an inclusion loses its shape."""
ADVISED_CELLS = 4.0
"""Minimum number of cells per radius for accurate pressures and displacements."""


class CellSizes(Protocol):
    """Edge lengths of the cells of a grid [m]."""

    @property
    def dx(self) -> float: ...
    @property
    def dy(self) -> float: ...
    @property
    def dz(self) -> float | None: ...


def largest_edge(grid: CellSizes) -> float:
    """Largest edge length of a cell [m]."""
    return max(grid.dx, grid.dy, grid.dz or 0.0)


def cells_per_radius(grid: CellSizes, inclusions: Sequence[Inclusion]) -> float:
    """Ratio of the smallest radius of all inclusions to the largest edge length of a cell."""
    radii = (min(inclusion.radii) for inclusion in inclusions)
    return min(radii, default=math.inf) / largest_edge(grid)


def check_resolution(grid: CellSizes, inclusions: Sequence[Inclusion]) -> None:
    """Raise ValueError below 2 cells per radius of an inclusion, and warn below 4 cells."""
    edge = largest_edge(grid)
    coarse = [n for n, one in enumerate(inclusions) if min(one.radii) < ADVISED_CELLS * edge]
    if not coarse:
        return
    worst = min(coarse, key=lambda n: min(inclusions[n].radii))
    radius = min(inclusions[worst].radii)
    found = f"{radius / edge:.3g} cells per radius ({quantity(radius, 'm')})"
    if radius < MIN_CELLS * edge * (1 - 1e-9):
        raise ValueError(
            f"inclusions must have at least {MIN_CELLS:g} cells per radius, got {found} for "
            f"inclusions[{worst}]: use cells of at most {quantity(radius / ADVISED_CELLS, 'm')}"
        )
    if radius < ADVISED_CELLS * edge * (1 - 1e-9):
        warnings.warn(
            f"{len(coarse)} of {len(inclusions)} inclusions have fewer than {ADVISED_CELLS:g} "
            f"cells per radius; the smallest has {found}: use cells of at most "
            f"{quantity(radius / ADVISED_CELLS, 'm')}",
            ResolutionWarning,
            stacklevel=4,
        )
