# SPDX-License-Identifier: GPL-3.0-or-later
"""Grid cells that inclusions fill completely or partly."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from .._util.checks import BoolArray, FloatArray
from .._util.display import ShortRepr, quantity
from .._util.short_text import in_short
from .filled_shares import is_cut, shares
from .inclusion import Inclusion
from .inclusion_resolution import CellSizes
from .material import Material
from .phase_mixing import Index
from .voxels import VoxelBlock

Counts = tuple[int, int, int]


class VolumeGrid(CellSizes, Protocol):
    """Grid of volume cells: the attributes of `samcontact.Grid` that are needed here."""

    @property
    def nx(self) -> int: ...
    @property
    def ny(self) -> int: ...
    @property
    def nz(self) -> int: ...
    @property
    def periodic(self) -> str: ...


@dataclass(frozen=True, repr=False)
class InclusionCells(ShortRepr):
    """Cells of a box around all inclusions of a body.

    Attributes
    ----------
    first : tuple of int
        Indices of the first cell of the box along x, y and z; negative if that cell is outside the
        grid.
    laws : tuple of Material or None
        Distinct materials of the inclusions; None for a void.
    share : ndarray, shape (n, m, l)
        Volume fraction of the inclusions in each cell, 0 to 1.
    phase : ndarray of int, shape (n, m, l)
        Index in `Heterogeneous.phases` of the inclusion that fills the largest part of the cell; -1
        in the matrix.
    bulk, shear : ndarray, shape (n, m, l)
        Bulk and shear modulus of each cell, mixed from those of matrix and inclusions and divided
        by those of the matrix; 0 in a void.
    misfit : ndarray, shape (6, n, m, l)
        Misfit strain, weighted by the mixing rule (see `phase_mixing`).
    law : ndarray of int, shape (n, m, l)
        Index in `laws` of the material of the inclusion that `phase` names; -1 in the matrix.
    expansion : ndarray, shape (n, m, l)
        Thermal expansion coefficient minus that of the matrix [1/K], weighted like the misfit
        strain.
    """

    first: Counts
    laws: tuple[Material | None, ...]
    share: FloatArray
    phase: NDArray[np.int32]
    bulk: FloatArray
    shear: FloatArray
    misfit: FloatArray
    law: NDArray[np.int32]
    expansion: FloatArray

    @property
    def is_cut(self) -> BoolArray:
        """Mask of the cells that inclusions fill only partly, shape (n, m, l)."""
        return is_cut(self.share)

    @property
    def is_deformed(self) -> BoolArray:
        """Mask of the cells whose moduli or misfit differ from the matrix, shape (n, m, l).

        The misfit includes a difference in thermal expansion; it is 0 in the matrix.
        """
        differs = (self.bulk != 1.0) | (self.shear != 1.0) | self.misfit.any(axis=0)
        return np.asarray(differs | (self.expansion != 0.0))

    def over_grid(self, field: NDArray[Any], shape: Counts, outside: float = 0.0) -> NDArray[Any]:
        """Copy a field of the box, shape (n, m, l), to a grid.

        shape: numbers of cells of the grid along its axes. Cells of the grid outside the box have
        the value `outside`.
        """
        whole = np.full(shape, outside, dtype=field.dtype)
        box, grid = zip(
            *(_common(f, n, m) for f, n, m in zip(self.first, field.shape, shape, strict=True)),
            strict=True,
        )
        whole[grid] = field[box]
        return whole


def _common(first: int, count: int, size: int) -> tuple[slice, slice]:
    """Common cells of a box and a grid along an axis: slice of the box, and slice of the grid."""
    low, high = max(first, 0), min(first + count, size)
    high = max(low, high)
    return slice(low - first, high - first), slice(low, high)


class Box(NamedTuple):
    """Box of cells: indices of its first cell, and number of cells along x, y and z."""

    first: Counts
    shape: Counts


def require_volume(grid: VolumeGrid) -> None:
    """Raise TypeError unless the object is a grid, and ValueError for a grid without dz."""
    if not all(hasattr(grid, name) for name in ("nx", "ny", "nz", "dx", "dy", "dz", "periodic")):
        raise TypeError(f"grid must be a samcontact.Grid, got {in_short(grid)}")
    if grid.dz is None:
        raise ValueError(
            f"grid must have dz, the thickness of its cells, for inclusions, got {grid!r}"
        )


def _axes(grid: VolumeGrid) -> list[tuple[float, float, int, bool]]:
    """For each axis: lower edge of the grid [m], cell length [m], number of cells, periodicity."""
    assert grid.dz is not None
    return [
        (-grid.nx / 2 * grid.dx, grid.dx, grid.nx, "x" in grid.periodic),
        (-grid.ny / 2 * grid.dy, grid.dy, grid.ny, "y" in grid.periodic),
        (0.0, grid.dz, grid.nz, False),
    ]


def _edges(grid: VolumeGrid) -> list[tuple[float, float]]:
    """Lower edge of the grid and length of a cell along each axis [m]."""
    return [(low, step) for low, step, _, _ in _axes(grid)]


def _cells_of(grid: VolumeGrid, inclusion: Inclusion) -> list[tuple[int, int]]:
    """Indices of the first cell of an inclusion and of the cell after the last, along each axis."""
    ends = []
    for (low, step), c, half in zip(_edges(grid), inclusion.center, inclusion.extent, strict=True):
        first, last = ((c + side * half - low) / step for side in (-1, 1))
        ends.append((int(np.floor(first + 1e-9)), int(np.ceil(last - 1e-9))))
    ends[2] = (max(ends[2][0], 0), ends[2][1])
    return ends


def box_of(
    grid: VolumeGrid, inclusions: Sequence[Inclusion], measured: VoxelBlock | None = None
) -> Box:
    """Smallest box that contains all inclusions and voxels.

    If an inclusion crosses the end of a period, the box extends over the whole period.
    """
    cells = [_cells_of(grid, inclusion) for inclusion in inclusions]
    names = [f"inclusions[{n}]" for n in range(len(inclusions))]
    if measured is not None:
        cells.append(measured.ends(_edges(grid)))
        names.append("the block of voxels")
    ends = np.array(cells)
    _check_place(grid, names, ends)
    if measured is not None:
        _require_in_period(grid, ends[-1])
    low, high = ends[:, :, 0].min(axis=0), ends[:, :, 1].max(axis=0)
    for axis, (_, _, count, wraps) in enumerate(_axes(grid)):
        if wraps and (low[axis] < 0 or high[axis] > count):
            low[axis], high[axis] = 0, count
    i, j, k = (int(value) for value in low)
    n, m, layers = (int(value) for value in high - low)
    return Box((i, j, k), (n, m, layers))


def _check_place(grid: VolumeGrid, names: Sequence[str], ends: NDArray[np.intp]) -> None:
    """Raise ValueError if all inclusions are outside the grid, or one is wider than a period."""
    highest = int(ends[:, 2, 0].argmin())
    if grid.nz and ends[highest, 2, 0] >= grid.nz:
        raise ValueError(
            f"at least one inclusion must reach into the {grid.nz} layers of the grid, got none; "
            f"the highest, {names[highest]}, begins in layer {ends[highest, 2, 0] + 1}: increase "
            "nz, or omit nz"
        )
    outside = np.zeros(len(names), dtype=bool)
    for axis, (name, (low, step, count, wraps)) in enumerate(
        zip("xy", _axes(grid)[:2], strict=True)
    ):
        wide = np.ptp(ends[:, axis], axis=1)
        if wraps and wide.max() > count:
            raise ValueError(
                f"{names[int(wide.argmax())]} must not be wider than the period of the grid along "
                f"{name}, {quantity(step * count, 'm')} ({count} cells), "
                f"got a width of {wide.max()} cells: enlarge the grid"
            )
        if not wraps:
            beyond = (ends[:, axis, 1] <= 0) | (ends[:, axis, 0] >= count)
            outside |= beyond
            if beyond.all():
                at = low + step * float(ends[0, axis].mean())
                raise ValueError(
                    f"at least one inclusion must lie in the grid, within {name} = ±"
                    f"{quantity(-low, 'm')}, got none; {names[0]} is at {name} = {at:.6g} "
                    "m: enlarge the grid, or move the inclusions"
                )
    if outside.all():
        raise ValueError(
            "at least one inclusion must lie in the grid, got none: enlarge the grid, or move the "
            "inclusions"
        )


def _require_in_period(grid: VolumeGrid, ends: NDArray[np.intp]) -> None:
    """Raise ValueError if the block of voxels crosses the end of a period."""
    for axis, (_, _, count, wraps) in enumerate(_axes(grid)):
        if wraps and (ends[axis, 0] < 0 or ends[axis, 1] > count):
            raise ValueError(
                f"voxels must lie within the period of the grid along {'xyz'[axis]}, cells 0 to "
                f"{count - 1}, got cells {ends[axis, 0]} to {ends[axis, 1] - 1}: move the origin "
                "of the voxels, or enlarge the grid"
            )


def voxels_on(
    grid: VolumeGrid, box: Box, measured: VoxelBlock
) -> Iterator[tuple[int, Index, FloatArray]]:
    """Iterate over the materials of the voxels.

    Each item contains the number of the material, the indices of its cells in the box, and the
    fraction of each of these cells that the material fills.
    """
    for number, ends, share in measured.shares_on(_edges(grid)):
        inside = (np.arange(*pair) - first for pair, first in zip(ends, box.first, strict=True))
        yield number, np.ix_(*inside), share


def blocks_on(
    grid: VolumeGrid, box: Box, inclusions: Sequence[Inclusion]
) -> Iterator[tuple[int, Index, FloatArray]]:
    """Iterate over the inclusions.

    Each item contains the number of the inclusion, the indices of its cells in the box, and the
    fraction of each of these cells that the inclusion fills. Raises ValueError if a later inclusion
    covers an earlier one.
    """
    axes = _axes(grid)
    middles = ((grid.nx - 1) / 2, (grid.ny - 1) / 2, -0.5)  # mirrored cells: opposite numbers
    size = np.array([step for _, step, _, _ in axes])
    _require_uncovered(inclusions)
    for number, inclusion in enumerate(inclusions):
        cells = [np.arange(*ends) for ends in _cells_of(grid, inclusion)]
        x, y, z = (
            np.asarray(step * (at - middle) - c, dtype=np.float64)
            for (_, step, _, _), at, middle, c in zip(
                axes, cells, middles, inclusion.center, strict=True
            )
        )
        inside = [
            (at - first) % count if wraps and box_count == count else at - first
            for at, first, (_, _, count, wraps), box_count in zip(
                cells, box.first, axes, box.shape, strict=True
            )
        ]
        yield number, np.ix_(*inside), shares(inclusion.metric(), (x, y, z), size)


def _require_uncovered(inclusions: Sequence[Inclusion]) -> None:
    """Raise ValueError if a later sphere contains an earlier inclusion."""
    centers = np.array([one.center for one in inclusions])
    longest = np.array([max(one.radii) for one in inclusions])
    shortest = np.array([min(one.radii) for one in inclusions])
    for n in range(len(inclusions) - 1):
        distance = np.linalg.norm(centers[n + 1 :] - centers[n], axis=1)
        covered = distance + longest[n] <= shortest[n + 1 :] * (1 + 1e-12)
        if covered.any():
            by = n + 1 + int(covered.argmax())
            raise ValueError(
                f"inclusions[{n}] must not lie within a later inclusion, got inclusions[{by}] "
                "around it: where inclusions overlap, the later one replaces the earlier one; "
                "exchange their order"
            )
