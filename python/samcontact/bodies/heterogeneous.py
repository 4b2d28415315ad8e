# SPDX-License-Identifier: GPL-3.0-or-later
"""Heterogeneous bodies: a matrix with inclusions, voids or a measured microstructure."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from numpy.typing import ArrayLike

from .._util.checks import FloatArray, boolean, require_list, require_type
from .._util.display import HtmlTable, Rows
from .display import material_in_short
from .inclusion import Inclusion
from .inclusion_cells import InclusionCells, VolumeGrid, require_volume
from .inclusion_layers import require_within_layers
from .inclusion_resolution import cells_per_radius, check_resolution
from .layers import Layered
from .material import Material
from .matrix_properties import LikeMatrix
from .microstructure import checked_box, random_inclusions
from .mixed_inclusions import mixed_cells
from .voxels import VoxelBlock

_MAX_SHOWN = 4  # inclusions in a repr


def _checked_matrix(matrix: Any) -> Material | Layered:
    if isinstance(matrix, Layered):
        return matrix
    require_type("matrix", matrix, Material)
    if matrix.is_rigid:
        raise ValueError("matrix must not be rigid: inclusions in a rigid body have no effect")
    if matrix.free_faces is not None:
        raise ValueError(
            f"matrix must not have free_faces, got {matrix.free_faces!r}: inclusions near free "
            "faces are not supported"
        )
    return matrix  # type: ignore[no-any-return]


def _matrix_in_short(matrix: Material | Layered) -> str:
    if isinstance(matrix, Layered):
        return f"{len(matrix.layers)} layer(s) on {material_in_short(matrix.substrate)}"
    return material_in_short(matrix)


@dataclass(frozen=True, repr=False, init=False)
class Heterogeneous(LikeMatrix, HtmlTable):
    """Matrix with inclusions and voids: a heterogeneous body, used like a `Material`.

    Parameters
    ----------
    matrix : Material or Layered
        Body outside of the inclusions. Each inclusion must lie within one of its layers or within
        its substrate.
    inclusions : sequence of Inclusion
        Inclusions and voids, in the frame of the grid. Where two of them overlap, the later one
        replaces the earlier one.
    measured : VoxelBlock, optional
        Measured microstructure, see `voxels`. Where an inclusion overlaps its voxels, the inclusion
        replaces them.

    Raises
    ------
    ValueError
        There is neither an inclusion nor a voxel, the matrix is rigid or has free faces, or an
        inclusion or the block of voxels crosses an interface between layers.
    TypeError
        An argument is not a body or not a list of inclusions.

    Notes
    -----
    The inclusions are perfectly bonded to the matrix. In a cell that an inclusion fills only
    partly, the moduli of inclusion and matrix are mixed: in parallel (Voigt) if the inclusion is
    softer, in series (Reuss) if it is stiffer. This choice is made for the bulk modulus and the
    shear modulus separately.

    The grid needs at least 2 cells per radius. With at least 4 cells, pressures and displacements
    are accurate. With at least 8 cells, the maximum stress near an inclusion is accurate as well.
    """

    matrix: Material | Layered
    inclusions: tuple[Inclusion, ...]
    measured: VoxelBlock | None
    law: ClassVar[str] = "heterogeneous"

    def __init__(
        self,
        matrix: Material | Layered,
        inclusions: Sequence[Inclusion] = (),
        measured: VoxelBlock | None = None,
    ) -> None:
        object.__setattr__(self, "matrix", _checked_matrix(matrix))
        if isinstance(inclusions, Inclusion):
            inclusions = [inclusions]
        require_list("inclusions", inclusions, Inclusion)
        object.__setattr__(self, "inclusions", tuple(inclusions))
        if measured is not None:
            require_type("measured", measured, VoxelBlock)
        object.__setattr__(self, "measured", measured)
        if not self.inclusions and measured is None:
            raise ValueError(
                "inclusions must contain at least one Inclusion unless measured is given, got "
                "none: for a body without inclusions use its Material or Layered"
            )
        if isinstance(self.matrix, Layered):
            require_within_layers(self.matrix.interfaces, self.inclusions, measured)

    @classmethod
    def random(
        cls,
        matrix: Material | Layered,
        material: Material | None,
        fraction: float,
        radius: float | tuple[float, float],
        box: ArrayLike,
        seed: int,
        gap: float = 0.1,
        cover: float = 0.0,
        *,
        misfit: ArrayLike = 0.0,
        radius_limits: tuple[float, float] | None = None,
        cluster: tuple[float, float] | None = None,
    ) -> Heterogeneous:
        """Matrix with non-overlapping spheres at random positions.

        The number of spheres has a Poisson distribution, their radii are lognormal, and they are
        placed by random sequential addition, the largest first. Equal arguments give equal bodies.
        All centres lie in the box; spheres with centres outside, which would extend into the box,
        are missing. Therefore choose a box that extends beyond the region of interest by the
        largest radius on each side.

        Parameters
        ----------
        matrix : Material or Layered
            Body outside of the spheres. No sphere may cross an interface between layers: choose
            the box accordingly.
        material : Material or None
            Material of the spheres; None for voids.
        fraction : float
            Expected volume fraction of the spheres in the box, > 0 and at most 0.3. `volume_in`
            returns the total volume of the spheres that were drawn.
        radius : float or pair of float
            Median radius [m], or a pair of the median radius [m] and the standard deviation of
            ln(radius) [-]. With a single number, all radii are equal.
        box : array_like, shape (3, 2)
            Lower and upper limits of the box that contains all centres, along x, y and z [m].
        seed : int
            Seed of the random numbers, >= 0.
        gap : float, optional
            Minimum distance between the surfaces of two spheres, relative to the mean of their
            radii. Default: 0.1.
        cover : float, optional
            Minimum thickness of the matrix between a sphere and the surface [m]. Default: 0.
        misfit : float or array_like, optional
            Misfit strain of the spheres, see `Inclusion.sphere`. Default: 0.
        radius_limits : pair of float, optional
            Minimum and maximum radius [m]. A radius drawn outside these limits is set to the nearer
            limit. Default: no limits.
        cluster : pair of float, optional
            Mean number of spheres per cluster, and standard deviation of each coordinate of the
            spheres about the centre of their cluster [m]. Default: no clusters.

        Returns
        -------
        Heterogeneous

        Raises
        ------
        ValueError
            A value is outside its range, no sphere is drawn, or no free position is found for a
            sphere.
        TypeError
            An argument is not a number or not a material.
        """
        return cls(
            matrix,
            random_inclusions(
                material, fraction, radius, box, seed, gap, cover,
                misfit=misfit, radius_limits=radius_limits, cluster=cluster,
            ),
        )  # fmt: skip

    @classmethod
    def voxels(
        cls,
        matrix: Material | Layered,
        materials: Material | Sequence[Material | None],
        labels: ArrayLike,
        dx: float | tuple[float, float, float],
        origin: ArrayLike,
    ) -> Heterogeneous:
        """Matrix with a measured microstructure, e.g. from tomography or EBSD.

        The fraction of a grid cell that each material fills follows exactly from the overlap of the
        cell with the voxels. The voxels may have any size and position relative to the cells.

        Parameters
        ----------
        matrix : Material or Layered
            Body outside of the block of voxels, and at the voxels with label 0. The block must lie
            within one layer or within the substrate.
        materials : sequence of Material or None
            Materials of the voxels with labels 1, 2, ...; None for voids.
        labels : array_like of int or float, shape (n, m, l)
            Label of each voxel; the axes of the array are x, y and z. With a single material,
            floating-point numbers from 0 to 1 are allowed instead, which state the volume fraction
            of each voxel that this material fills.
        dx : float or tuple of float
            Edge length of a voxel [m], or its lengths along x, y and z.
        origin : array_like, shape (3,)
            Coordinates x, y and z [m], in the frame of the grid, of the corner of the block at
            which x, y and z are smallest. The part of the block above the surface is cut off.

        Returns
        -------
        Heterogeneous

        Raises
        ------
        ValueError
            A label has no material, all labels are 0, there are voids at the surface, or a value is
            outside its range.
        TypeError
            An argument is not a material or not an array of numbers.
        """
        return cls(matrix, (), VoxelBlock(materials, labels, dx, origin))

    @property
    def phases(self) -> tuple[Material | None, ...]:
        """Materials of all inclusions, then of the voxel labels 1, 2, ...; None for a void."""
        of_voxels = () if self.measured is None else self.measured.materials
        return (*(inclusion.material for inclusion in self.inclusions), *of_voxels)

    @property
    def is_plastic(self) -> bool:
        """Whether the matrix or an inclusion can yield."""
        materials = (self.matrix, *self.phases)
        return any(material is not None and material.is_plastic for material in materials)

    @property
    def min_yield_stress(self) -> float:
        """Minimum initial yield stress of the matrix and all inclusions [Pa].

        It is infinite if all of them are elastic.
        """
        materials = (self.matrix, *self.phases)
        return min(m.min_yield_stress for m in materials if m is not None)

    def cells_on(self, grid: VolumeGrid, *, check: bool = True) -> InclusionCells:
        """Filled fraction, moduli and misfit strain of the grid cells around the inclusions.

        The moduli are divided by those of the matrix.

        Parameters
        ----------
        grid : Grid
            Grid with dz. Inclusions may extend beyond its sides.
        check : bool, optional
            Whether to check the number of cells per radius. Default: True.

        Returns
        -------
        InclusionCells
            Cells of the smallest box that contains all inclusions and voxels.

        Raises
        ------
        ValueError
            The grid has no dz, or fewer than 2 cells per radius of an inclusion. All inclusions lie
            outside the grid, an inclusion is wider than the period of the grid, or the block of
            voxels crosses the end of a period. A later inclusion covers an earlier one completely.
        MemoryError
            The box does not fit into memory.

        Warns
        -----
        ResolutionWarning
            The grid has fewer than 4 cells per radius of an inclusion.
        """
        require_volume(grid)
        if boolean("check", check):
            check_resolution(grid, self.inclusions)
        key = (grid.nx, grid.ny, grid.nz, grid.dx, grid.dy, grid.dz, grid.periodic)
        known: dict[Any, InclusionCells] = self.__dict__.setdefault("_known", {})
        if key not in known:
            around = [material_around(self, number) for number in range(len(self.phases))]
            found = mixed_cells(grid, around, self.inclusions, self.measured)
            known.clear()  # the cells of one grid are enough
            known[key] = found
        return known[key]

    def fraction_on(self, grid: VolumeGrid) -> FloatArray:
        """Volume fraction of the inclusions in each cell of a grid [-].

        Parameters
        ----------
        grid : Grid
            Grid with dz.

        Returns
        -------
        ndarray, shape (nx, ny, nz)
            Fractions from 0 to 1. On a grid without nz, the layers extend down to the deepest
            inclusion.

        Raises
        ------
        ValueError, MemoryError
            As `cells_on`.
        """
        cells = self.cells_on(grid)
        layers = grid.nz or cells.first[2] + cells.share.shape[2]
        return cells.over_grid(cells.share, (grid.nx, grid.ny, layers))

    def cells_per_radius(self, grid: VolumeGrid) -> float:
        """Smallest radius of all inclusions divided by the largest edge length of a cell [-].

        Infinite for a body that has only voxels.
        """
        require_volume(grid)
        return cells_per_radius(grid, self.inclusions)

    def volume_in(self, box: ArrayLike) -> float:
        """Total volume of the inclusions whose centres lie in a box [m^3]; voxels are not counted.

        box: lower and upper limits along x, y and z [m], shape (3, 2). Raises ValueError if a lower
        limit is not below its upper limit.
        """
        low, high = checked_box("box", box).T
        inside = (
            one.volume
            for one in self.inclusions
            if (low <= one.center).all() and (one.center <= high).all()
        )
        return math.fsum(inside)

    def _rows(self) -> Rows:
        shown = [("law", self.law), ("matrix", _matrix_in_short(self.matrix))]
        if self.inclusions:
            shown.append(("inclusions", str(len(self.inclusions))))
        if self.measured is not None:
            shown.append(("voxels", self.measured.in_short()))
        return shown

    def __getstate__(self) -> dict[str, Any]:
        return {name: getattr(self, name) for name in ("matrix", "inclusions", "measured")}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)

    def __repr__(self) -> str:
        voxels = "" if self.measured is None else f", {self.measured!r}"
        few = len(self.inclusions) <= _MAX_SHOWN
        shown = repr(list(self.inclusions)) if few else f"<{len(self.inclusions)} inclusions>"
        return f"Heterogeneous({self.matrix!r}, {shown}{voxels})"


def material_around(body: Heterogeneous, number: int) -> Material:
    """Material of the matrix around one phase: an inclusion, or the voxels with one label.

    number: index of the phase in `Heterogeneous.phases`.
    """
    if not isinstance(body.matrix, Layered):
        return body.matrix
    if number < len(body.inclusions):
        return body.matrix.material_at(max(body.inclusions[number].center[2], 0.0))
    assert body.measured is not None
    return body.matrix.material_at(body.measured.mid_depth)
