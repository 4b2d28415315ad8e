# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields of heterogeneous bodies."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from .._util.checks import FloatArray, choice
from ..bodies.heterogeneous import Heterogeneous

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from ..problem.grid import Grid
    from ..problem.setup import SimulationSetup


class PhaseStrains(NamedTuple):
    """Plastic strain of both phases of a body with inclusions, see `State.phase_strains`."""

    matrix: FloatArray
    """Plastic strain of the matrix [-], shape (6, nx, ny, nz)."""
    inclusion: FloatArray
    """Plastic strain of the inclusions [-], shape (6, nx, ny, nz)."""
    inclusion_equivalent: FloatArray
    """Accumulated equivalent plastic strain of the inclusions [-], shape (nx, ny, nz)."""


class InclusionState:
    """Base class of `State` with the fields of inclusions, at the current position of the body."""

    if TYPE_CHECKING:
        setup: SimulationSetup
        grid: Grid
        _core: Any

        @property
        def layers(self) -> int: ...
        def _field(
            self, name: str, body: int, compute: Callable[[], FloatArray] | None = None
        ) -> FloatArray: ...

    def share(self, body: int = 2) -> FloatArray:
        """Volume fraction of inclusions in each cell [-], from 0 to 1, shape (nx, ny, nz)."""
        return self._field("share", body, lambda: self._of_cells("share", 0.0, body))

    def phase(self, body: int = 2) -> NDArray[Any]:
        """Index of the inclusion that fills most of each cell, shape (nx, ny, nz).

        Index 0 is the first of the `inclusions` of the `Heterogeneous` body; -1 is the matrix.
        """
        return self._field("phase", body, lambda: self._of_cells("phase", -1, body))

    def disturbance(self, body: int = 2) -> FloatArray:
        """Stress due to plastic strain and inclusions [Pa], shape (6, nx, ny, nz).

        It is the total stress minus the stress that tractions, heat and initial stress cause in a
        homogeneous body of the matrix material. Without load it is the residual stress. Under load
        it also contains the effect of the different stiffness of inclusions, which vanishes on
        unloading.
        """
        return self._field("disturbance", body)

    def phase_strains(self, body: int = 2) -> PhaseStrains:
        """Plastic strain of the matrix and of the inclusions.

        The two differ only in cells that are partly filled by an inclusion and in which each phase
        yields by its own law; there, `equivalent_plastic_strain` is that of the matrix. In all
        other cells, matrix and inclusions have the plastic strain of the cell.
        """
        names = "matrix_plastic_strain", "inclusion_plastic_strain", "inclusion_equivalent_strain"
        return PhaseStrains(*(self._field(name, body) for name in names))

    def _of_cells(self, name: str, outside: float, body: int) -> FloatArray:
        index = choice("body", body, (1, 2)) - 1
        own = self.setup.bodies[index]
        shape = (*self.grid.surface_shape, self.layers)
        if not isinstance(own, Heterogeneous):
            return np.full(shape, outside)
        cells, first = own.cells_on(self.grid, check=False), self._core.first_cell[index]
        if "x" in self.grid.periodic:
            whole = cells.over_grid(getattr(cells, name), shape, outside)
            return np.roll(whole, -first, axis=0)
        moved = replace(cells, first=(cells.first[0] - first, *cells.first[1:]))
        return moved.over_grid(getattr(cells, name), shape, outside)
