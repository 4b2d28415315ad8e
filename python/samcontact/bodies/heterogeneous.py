# SPDX-License-Identifier: GPL-3.0-or-later
"""Heterogeneous bodies: a matrix with inclusions, voids or a measured microstructure."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from .._util import memory
from .._util.checks import FloatArray, require_list, require_type
from .._util.display import HtmlTable, Rows
from .display import material_in_short
from .inclusion import Inclusion
from .inclusion_cells import InclusionCells, VolumeGrid, blocks_on, box_of, require_volume
from .inclusion_resolution import cells_per_radius, check_resolution
from .material import Material
from .phase_mixing import Mixture, relative_phase

_BYTES_PER_CELL = 400.0  # of the box of all inclusions, while its cells are mixed


def _checked_matrix(matrix: Any) -> Material:
    require_type("matrix", matrix, Material)
    if matrix.is_rigid:
        raise ValueError("matrix must not be rigid: inclusions in a rigid body have no effect")
    if matrix.free_faces is not None:
        raise ValueError(
            f"matrix must not have free_faces, got {matrix.free_faces!r}: inclusions near free "
            "faces are not supported"
        )
    return matrix  # type: ignore[no-any-return]


@dataclass(frozen=True, repr=False, init=False)
class Heterogeneous(HtmlTable):
    """Matrix with inclusions and voids: a heterogeneous body, used like a `Material`.

    Parameters
    ----------
    matrix : Material
        Material of the body outside of the inclusions.
    inclusions : sequence of Inclusion
        Inclusions and voids, in the frame of the grid. Where two of them overlap, the later one
        replaces the earlier one.

    Raises
    ------
    ValueError
        There is no inclusion, or the matrix is rigid or has free faces.
    TypeError
        An argument is not a material or not a list of inclusions.

    Notes
    -----
    The inclusions are perfectly bonded to the matrix. A cell that an inclusion fills partly has
    mixed moduli: in parallel (Voigt) for an inclusion softer than the matrix, in series (Reuss) for
    a stiffer one, bulk and shear modulus each by its own ratio. The grid needs at least 2 cells per
    radius; from 4 cells on, pressures and displacements are accurate, from 8 cells on also maxima
    of the stress near an inclusion.
    """

    matrix: Material
    inclusions: tuple[Inclusion, ...]
    law: ClassVar[str] = "heterogeneous"

    def __init__(self, matrix: Material, inclusions: Sequence[Inclusion]) -> None:
        object.__setattr__(self, "matrix", _checked_matrix(matrix))
        if isinstance(inclusions, Inclusion):
            inclusions = [inclusions]
        require_list("inclusions", inclusions, Inclusion)
        object.__setattr__(self, "inclusions", tuple(inclusions))
        if not self.inclusions:
            raise ValueError(
                "inclusions must contain at least one Inclusion, got none: for a homogeneous body "
                "use its Material"
            )

    @property
    def E(self) -> float:
        """Young's modulus of the matrix [Pa]."""
        return self.matrix.E

    @property
    def nu(self) -> float:
        """Poisson's ratio of the matrix [-]."""
        return self.matrix.nu

    @property
    def parameters(self) -> Mapping[str, Any]:
        """Parameters of the matrix."""
        return self.matrix.parameters

    @property
    def thermal(self) -> tuple[float, float, float] | None:
        """Thermal constants of the matrix, see `Material.with_thermal`."""
        return self.matrix.thermal

    @property
    def softening(self) -> Callable[[FloatArray], ArrayLike] | None:
        """Softening law of the matrix."""
        return self.matrix.softening

    @property
    def kinematic(self) -> tuple[tuple[float, float], ...]:
        """Backstresses of the matrix, see `Material.with_kinematic_hardening`."""
        return self.matrix.kinematic

    @property
    def _core(self) -> Any:
        return self.matrix._core

    @property
    def is_rigid(self) -> bool:
        """Always False."""
        return False

    @property
    def phases(self) -> tuple[Material | None, ...]:
        """Material of each inclusion; None for a void."""
        return tuple(inclusion.material for inclusion in self.inclusions)

    @property
    def is_plastic(self) -> bool:
        """Whether the matrix or an inclusion can yield."""
        materials = (self.matrix, *self.phases)
        return any(material is not None and material.is_plastic for material in materials)

    @property
    def min_yield_stress(self) -> float:
        """Minimum initial yield stress of matrix and inclusions [Pa]; infinite if none yields."""
        materials = (self.matrix, *self.phases)
        return min(m.min_yield_stress for m in materials if m is not None)

    def cells_on(self, grid: VolumeGrid) -> InclusionCells:
        """Shares, relative moduli and misfit strains of the cells of a grid.

        Parameters
        ----------
        grid : Grid
            Grid with dz. Its sides do not limit the inclusions.

        Returns
        -------
        InclusionCells
            Cells of the smallest box that contains all inclusions.

        Raises
        ------
        ValueError
            The grid has no dz, or fewer than 2 cells per radius of an inclusion; inclusions are
            deeper than nz layers, all lie outside of the grid, or are wider than its period; a
            later inclusion covers an earlier one.
        MemoryError
            The box does not fit into the memory.

        Warns
        -----
        ResolutionWarning
            The grid has fewer than 4 cells per radius of an inclusion.
        """
        require_volume(grid)
        check_resolution(grid, self.inclusions)
        box = box_of(grid, self.inclusions)
        memory.require(
            f"a box of {' x '.join(map(str, box.shape))} cells around the inclusions",
            _BYTES_PER_CELL * math.prod(box.shape),
            "use larger cells or fewer inclusions",
        )
        mixture = Mixture(box.shape)
        for number, where, share in blocks_on(grid, box, self.inclusions):
            inclusion = self.inclusions[number]
            phase = relative_phase(self.matrix, inclusion.material, inclusion.misfit)
            mixture.add(number, where, share, phase)
        return _cells(box.first, mixture, self.phases)

    def fraction_on(self, grid: VolumeGrid) -> FloatArray:
        """Share of each cell of the grid that inclusions fill.

        Parameters
        ----------
        grid : Grid
            Grid with dz.

        Returns
        -------
        ndarray, shape (nx, ny, nz)
            Shares from 0 to 1; on a grid without nz, down to the deepest inclusion.

        Raises
        ------
        ValueError, MemoryError
            As `cells_on`.
        """
        cells = self.cells_on(grid)
        layers = grid.nz or cells.first[2] + cells.share.shape[2]
        return cells.over_grid(cells.share, (grid.nx, grid.ny, layers))

    def cells_per_radius(self, grid: VolumeGrid) -> float:
        """Smallest radius of all inclusions, in the largest edge length of a cell."""
        require_volume(grid)
        return cells_per_radius(grid, self.inclusions)

    def _rows(self) -> Rows:
        shown = [("law", self.law), ("matrix", material_in_short(self.matrix))]
        shown.append(("inclusions", str(len(self.inclusions))))
        return shown

    def __repr__(self) -> str:
        return f"Heterogeneous({self.matrix!r}, {list(self.inclusions)!r})"


def _cells(
    first: tuple[int, int, int], mixture: Mixture, phases: Sequence[Material | None]
) -> InclusionCells:
    """Return the mixed cells, with the distinct materials of the inclusions."""
    laws = tuple(dict.fromkeys(phases))
    of_phase = np.array([*(laws.index(material) for material in phases), -1], dtype=np.int32)
    law = of_phase[mixture.phase]  # phase -1 is the last entry
    fields = (mixture.bulk.mixed(), mixture.shear.mixed(), mixture.misfit())
    for field in (mixture.share, mixture.phase, *fields, law):
        field.flags.writeable = False
    return InclusionCells(first, laws, mixture.share, mixture.phase, *fields, law)
