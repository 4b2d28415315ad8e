# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured microstructures: material labels or filled fractions of voxels, e.g. from tomography."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._util.checks import FloatArray, finite_array, number, positive, real_array
from .._util.display import lengths
from .._util.short_text import in_short
from .filled_shares import overlaps
from .inclusion import Vector, checked_phase
from .material import Material

Ends = list[tuple[int, int]]


class VoxelBlock:
    """Block of voxels in a body, which states the material or the filled fraction of each voxel.

    Attributes
    ----------
    materials : tuple of Material or None
        Materials of the labels 1, 2, ...; None for a void.
    labels : ndarray, shape (n, m, l)
        Label of each voxel, 0 in the matrix; or, with a single material, the fraction of each voxel
        that this material fills.
    size : tuple of float
        Edge lengths of a voxel [m].
    origin : tuple of float
        Coordinates of the corner of the block at which x, y and z are smallest [m].
    """

    materials: tuple[Material | None, ...]
    labels: NDArray[Any]
    size: Vector
    origin: Vector

    def __init__(
        self, materials: Any, labels: ArrayLike, dx: float | Sequence[float], origin: ArrayLike
    ) -> None:
        if isinstance(materials, Material) or materials is None:
            materials = [materials]
        if not isinstance(materials, (list, tuple)) or not materials:
            raise TypeError(
                f"materials must be a list of Material, with None for voids, got "
                f"{in_short(materials)}"
            )
        self.materials = tuple(
            checked_phase(f"materials[{n}]", one) for n, one in enumerate(materials)
        )
        if real_array("dx", dx).ndim == 0:
            dx = (number("dx", dx),) * 3
        x, y, z = (positive("dx", size) for size in finite_array("dx", dx, (3,)))
        self.size = (x, y, z)
        x, y, z = (float(value) for value in finite_array("origin", origin, (3,)))
        self.origin = (x, y, z)
        self.labels = _checked_labels(labels, len(self.materials))
        self._require_material_at_surface()

    def _require_material_at_surface(self) -> None:
        """Raise ValueError if voids are at the surface, or the whole block is above the surface."""
        layers = self.labels.shape[2]
        bottom = self.origin[2] + self.size[2] * (1 + np.arange(layers))
        if bottom[-1] <= 0.0:
            raise ValueError(
                f"origin must be so deep that the block of voxels reaches below the surface, got "
                f"{self.origin!r}: z is positive into the body"
            )
        top = int(np.argmax(bottom > 0.0))
        if self.origin[2] + self.size[2] * top > 0.0:
            return
        for index, material in enumerate(self.materials):
            if material is None and self._share(index)[:, :, top].any():
                raise ValueError(
                    f"labels must not have voids at the surface, got voids in labels[:, :, {top}]: "
                    "model them as dents in the surface, as part of the gap"
                )

    @property
    def depths(self) -> tuple[float, float]:
        """Depths of the top and the bottom of the block [m]; 0 for a top above the surface."""
        top = self.origin[2]
        return max(top, 0.0), top + self.size[2] * self.labels.shape[2]

    @property
    def mid_depth(self) -> float:
        """Mean depth of the part of the block that is below the surface [m]."""
        return 0.5 * sum(self.depths)

    def _share(self, index: int) -> FloatArray:
        """Fraction of each voxel that the material with this index fills."""
        if self.labels.dtype.kind == "f":
            return self.labels
        return np.asarray(self.labels == index + 1, dtype=np.float64)

    def ends(self, axes: Sequence[tuple[float, float]]) -> Ends:
        """Indices of the first cell of the block and of the cell after its last, along each axis.

        axes: lower edge of the grid and length of a cell along each axis [m].
        """
        found = []
        for (low, step), origin, size, count in zip(
            axes, self.origin, self.size, self.labels.shape, strict=True
        ):
            first, last = (origin - low) / step, (origin + size * count - low) / step
            found.append((int(np.floor(first + 1e-9)), int(np.ceil(last - 1e-9))))
        found[2] = (max(found[2][0], 0), found[2][1])
        return found

    def shares_on(
        self, axes: Sequence[tuple[float, float]]
    ) -> Iterator[tuple[int, Ends, FloatArray]]:
        """Iterate over the materials that occur in the block.

        Each item contains the number of the material, the range of cells along each axis, and the
        fraction of each of these cells that the material fills. The fractions are exact, because
        the overlap of a cell and a voxel is a cuboid.
        """
        ends = self.ends(axes)
        weights = [
            overlaps(origin + size * np.arange(count + 1), low + step * first, step, last - first)
            for (low, step), origin, size, count, (first, last) in zip(
                axes, self.origin, self.size, self.labels.shape, ends, strict=True
            )
        ]
        for index in range(len(self.materials)):
            share = self._share(index)
            if not share.any():
                continue
            for axis, weight in enumerate(weights):
                share = np.moveaxis(np.tensordot(weight, share, (1, axis)), 0, axis)
            yield index, ends, np.minimum(share, 1.0)

    def _identity(self) -> tuple[Any, ...]:
        digest = hashlib.sha256(np.ascontiguousarray(self.labels).tobytes()).hexdigest()
        shape = (self.labels.shape, self.labels.dtype.str)
        return (self.materials, self.size, self.origin, shape, digest)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, VoxelBlock):
            return NotImplemented
        return self._identity() == other._identity()

    def __hash__(self) -> int:
        return hash(self._identity())

    def __repr__(self) -> str:
        return (
            f"VoxelBlock({list(self.materials)!r}, {in_short(self.labels)}, {self.size!r}, "
            f"{self.origin!r})"
        )

    def in_short(self) -> str:
        """One-line description of the block, for tables."""
        counts = " × ".join(map(str, self.labels.shape))
        return f"{counts} of {lengths(*self.size)}, {len(self.materials)} material(s)"


def _checked_labels(labels: ArrayLike, count: int) -> NDArray[Any]:
    """Check the labels or filled fractions of voxels, and return a read-only copy."""
    if not isinstance(labels, np.ndarray):
        real_array("labels", labels)
    given = np.asarray(labels)
    if given.ndim != 3 or not given.size:
        raise ValueError(
            f"labels must be a three-dimensional array that is not empty, got shape {given.shape}"
        )
    if given.dtype.kind == "b":
        given = given.astype(np.int32)
    if given.dtype.kind == "f":
        if count != 1:
            raise ValueError(
                f"with {count} materials, labels must be integers, got {given.dtype}: filled "
                "fractions of the voxels are possible with a single material only"
            )
        shares = finite_array("labels", given).copy()
        if shares.min() < 0.0 or shares.max() > 1.0:
            raise ValueError(
                "labels must be integers, or the filled fraction of each voxel, from 0 to 1, got "
                f"{shares.min():g} to {shares.max():g}"
            )
        given = shares
    elif given.dtype.kind not in "iu":
        raise TypeError(
            f"labels must be integers, or the filled fraction of each voxel, got {given.dtype}"
        )
    elif given.min() < 0 or given.max() > count:
        raise ValueError(
            f"labels must be from 0 (matrix) to {count}, the number of materials, got "
            f"{given.min()} to {given.max()}"
        )
    else:
        given = given.astype(np.int32)
    if not given.any():
        raise ValueError("labels must contain at least one value other than 0 (matrix), got only 0")
    given.flags.writeable = False
    return given
