# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress in boxes of fine cells around small inclusions, and fatigue criteria for its cycles."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._util import memory
from .._util.cached_property import cached_property
from .._util.checks import BoolArray, FloatArray, require_list, require_type
from .._util.display import HtmlTable, Rows, ShortRepr, quantity
from .._util.frozen import read_only
from .._util.short_text import in_short
from .._util.tensors import von_mises
from ..bodies.heterogeneous import Heterogeneous, material_around
from ..fatigue.field import FatigueField
from ..problem.grid import Grid
from .interface import Interface, interface_of


@dataclass(frozen=True, repr=False, eq=False)
class FineBox(ShortRepr, HtmlTable):
    """Stress in a box of fine cells around small inclusions, as computed by `fine_boxes`.

    Attributes
    ----------
    body : Heterogeneous
        Matrix, and inclusions of the box at their positions in the state, in the frame of the grid
        of the state.
    numbers : tuple of int
        Indices of these inclusions in the list given to `fine_boxes`.
    x, y, z : ndarray
        Cell centres [m] in the same frame.
    share : ndarray, shape (nx, ny, nz)
        Volume fraction of the inclusions in each cell, 0 to 1.
    phase : ndarray of int, shape (nx, ny, nz)
        Index in `numbers` of the inclusion that fills the largest part of a cell; -1 in the matrix.
    given_stress : ndarray, shape (6, nx, ny, nz)
        Stress of the state, interpolated to the cells [Pa]. The state does not contain these
        inclusions.
    stress : ndarray, shape (6, nx, ny, nz)
        Stress with the inclusions [Pa].
    eigenstrain : ndarray, shape (6, nx, ny, nz)
        Equivalent eigenstrain [-], which causes the same stress in a homogeneous matrix.
    interpolation_error : float
        Largest difference between cubic and linear interpolation of the given stress, relative to
        the largest component of this stress. It is an upper bound of the interpolation error.
    pressure_change : float
        Estimate of the largest change of the contact pressure due to the inclusions [Pa]; this
        change is neglected.
    evaluations : int
        Number of stress evaluations in the iterative solution.
    """

    body: Heterogeneous
    numbers: tuple[int, ...]
    x: FloatArray
    y: FloatArray
    z: FloatArray
    share: FloatArray
    phase: NDArray[np.int32]
    given_stress: FloatArray
    stress: FloatArray
    eigenstrain: FloatArray
    interpolation_error: float
    pressure_change: float
    evaluations: int

    @cached_property
    def von_mises(self) -> FloatArray:
        """Von Mises stress [Pa], shape (nx, ny, nz)."""
        return read_only(von_mises(self.stress))

    @cached_property
    def disturbance(self) -> FloatArray:
        """Stress due to the inclusions [Pa], shape (6, nx, ny, nz)."""
        return read_only(self.stress - self.given_stress)

    @property
    def is_matrix(self) -> BoolArray:
        """Mask of the cells that contain the matrix only, shape (nx, ny, nz)."""
        return np.asarray(self.share == 0.0)

    @property
    def coordinates(self) -> dict[str, FloatArray]:
        """Cell centres [m] along each axis, by the name of the axis."""
        return {"x": self.x, "y": self.y, "z": self.z}

    @property
    def cell_volume(self) -> float:
        """Volume of a cell [m^3]."""
        return float((self.x[1] - self.x[0]) ** 3)

    def interfaces(self) -> list[Interface]:
        """Largest tractions at the interface of each inclusion of the box, see `Interface`."""
        found = []
        for n, number_ in enumerate(self.numbers):
            mine = self.phase == n
            full = mine & (self.share >= 1.0)
            inner = self.stress[:, full].mean(axis=1)
            total = self.eigenstrain[:, mine].sum(axis=1) / self.share[mine].sum()
            inclusion = self.body.inclusions[n]
            found.append(
                interface_of(number_, inclusion, inner, total, material_around(self.body, 0))
            )
        return found

    def eigenstrain_on(self, grid: Grid) -> FloatArray:
        """Eigenstrain averaged over the cells of a coarse grid, shape (6, nx, ny, layers).

        Pass the result to `Simulation.add_eigenstrain` to include the effect of the inclusions on
        the contact. Averaging preserves the volume integral of the eigenstrain, and therefore its
        effect on the surface displacement. The layers of the result extend from the surface to the
        bottom of the box. Raises ValueError if the grid has no dz or does not contain the box.
        """
        require_type("grid", grid, Grid)
        if grid.dz is None:
            raise ValueError(f"grid must have dz, the thickness of its cells, got {grid!r}")
        at = [
            np.floor(values / step + middle).astype(int)
            for values, step, middle in (
                (self.x, grid.dx, grid.nx / 2),
                (self.y, grid.dy, grid.ny / 2),
                (self.z, grid.dz, 0.0),
            )
        ]
        layers = int(at[2].max()) + 1
        for indices, count, name in zip(at[:2], (grid.nx, grid.ny), "xy", strict=True):
            if indices.min() < 0 or indices.max() >= count:
                raise ValueError(
                    f"grid must contain the box along {name}, got a box from cell {indices.min()} "
                    f"to cell {indices.max()} for a grid with cells 0 to {count - 1}"
                )
        memory.require_for_grid("an eigenstrain", grid, 48.0 * grid.nx * grid.ny * layers)
        coarse = np.zeros((6, grid.nx, grid.ny, layers))
        part = self.cell_volume / (grid.dx * grid.dy * grid.dz)
        where: tuple[Any, ...] = (slice(None), *np.ix_(*at))
        np.add.at(coarse, where, part * self.eigenstrain)
        return coarse

    def _rows(self) -> Rows:
        largest = float(self.von_mises[self.is_matrix].max())
        return [
            ("inclusions", ", ".join(map(str, self.numbers))),
            ("cells", " x ".join(map(str, self.share.shape))),
            ("cell size", quantity(float(self.x[1] - self.x[0]), "m")),
            ("maximum von Mises stress of the matrix", quantity(largest, "Pa")),
            ("bound of the interpolation error", f"{100 * self.interpolation_error:.2g} %"),
            ("neglected change of the pressure", quantity(self.pressure_change, "Pa")),
        ]


def fine_field(
    boxes: Sequence[FineBox], criterion: Callable[[FloatArray], FatigueField]
) -> FatigueField:
    """Fatigue criterion for the stress cycle around small inclusions.

    Parameters
    ----------
    boxes : sequence of FineBox
        Boxes around the same inclusions, one for each state of the cycle, e.g. for each position of
        a rolling pass.
    criterion : callable
        Function of a stress history (array of shape (n, 6, nx, ny, nz) for n boxes) that returns
        the field of a fatigue criterion, e.g. ``lambda s: sc.fatigue.dang_van(s, slope=0.3)``.

    Returns
    -------
    FatigueField
        Field with the coordinates of the last box. Use it in `peaks`, `butterflies` or
        `matrix_field`, together with the attribute `body` of this box.

    Raises
    ------
    ValueError
        The boxes contain different inclusions or different numbers of cells, or there is no box.
    TypeError
        An argument has the wrong type.
    """
    require_list("boxes", boxes, FineBox)
    if not callable(criterion):
        raise TypeError(
            f"criterion must be a function of a stress history, got {in_short(criterion)}"
        )
    if not boxes:
        raise ValueError("boxes must contain at least one FineBox, got none")
    last = boxes[-1]
    for n, box in enumerate(boxes):
        if box.numbers != last.numbers or box.share.shape != last.share.shape:
            raise ValueError(
                f"boxes must contain the same inclusions on equal numbers of cells, got inclusions "
                f"{box.numbers} on {box.share.shape} cells in boxes[{n}], and inclusions "
                f"{last.numbers} on {last.share.shape} cells in the last box"
            )
    field = criterion(np.stack([box.stress for box in boxes]))
    require_type("the result of criterion", field, FatigueField)
    return replace(field, coordinates=last.coordinates)
