# SPDX-License-Identifier: GPL-3.0-or-later
"""Small inclusions in boxes of fine cells, under the stress of a state without them."""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from .._util import memory
from .._util.checks import FloatArray, choice, number, require_list, require_type
from .._util.errors import ElasticStrainWarning, ResolutionWarning
from .._util.frozen import read_only
from .._util.short_text import in_short
from ..bodies.heterogeneous import Heterogeneous
from ..bodies.inclusion import Inclusion
from ..bodies.inclusion_cells import InclusionCells
from ..bodies.inclusion_resolution import ADVISED_CELLS, MIN_CELLS
from ..bodies.layered import matrix_of
from ..bodies.material import Material
from ..problem.grid import Grid
from ..solutions.state import State
from .fine_box import FineBox
from .fine_solution import Moduli, solve
from .stress_at_points import StressAtPoints
from .surroundings import MAX_WITHIN

_APART = (
    3.0  # distance of centres over the sum of the largest radii beyond which two do not interact
)
_MIN_TOL, _MAX_TOL = 1e-6, 1e-2
_BYTES_PER_CELL = 1500.0


def fine_boxes(
    state: State,
    inclusions: Sequence[Inclusion],
    body: int = 2,
    cells_per_radius: float = 8.0,
    within: float = 2.0,
    tol: float = 1e-4,
) -> list[FineBox]:
    """Compute the stress around inclusions that are too small for the cells of a state.

    The inclusions are solved in boxes of fine cells, under the stress of the state, which does not
    contain them. The effect of the inclusions on the contact and on the plastic flow of the state
    is neglected; it decreases as (radius/depth)^3. Two inclusions whose centres are closer than
    three times the sum of their radii are solved together, in one box. The effect of the free
    surface is included. The cost is proportional to the number of inclusions.

    Parameters
    ----------
    state : State
        State of a simulation. The body may be elastic-plastic and contain larger inclusions.
    inclusions : sequence of Inclusion
        Elastic inclusions and voids, with their positions at the start of the simulation; they move
        with the body.
    body : {1, 2}, optional
        Body that contains the inclusions. It must be neither rigid nor layered, and have no free
        faces. Default: 2.
    cells_per_radius : float, optional
        Number of cells per radius of the smallest inclusion in each box, from 2 to 64; a warning is
        issued below 4. Default: 8.
    within : float, optional
        Minimum distance from the centre of each inclusion to the sides of its box, in radii of the
        inclusion, above 1 and at most 10. Default: 2.
    tol : float, optional
        Tolerance of the eigenstrain, relative to its norm, in [1e-6, 1e-2]; at least 1e-3 is used
        if a modulus of an inclusion differs from that of the matrix by a factor above 20. Default:
        1e-4.

    Returns
    -------
    list of FineBox
        One box for each group of inclusions that are solved together.

    Raises
    ------
    ValueError
        An inclusion can yield, or its box extends beyond the grid or contains an inclusion of the
        body. The body is not supported, or has moved by a distance that is not a whole number of
        cells. An argument is outside its range.
    TypeError
        An argument has the wrong type.
    ConvergenceError
        The eigenstrain did not converge.
    MemoryError
        A box does not fit into memory.

    Warns
    -----
    ResolutionWarning
        There are fewer than 4 cells per radius.
    ElasticStrainWarning
        The stress in the matrix exceeds its yield stress, but boxes are computed as elastic.
    """
    require_type("state", state, State)
    which = choice("body", body, (1, 2))
    matrix = _matrix_of(state, which)
    require_list("inclusions", inclusions, Inclusion)
    if not inclusions:
        raise ValueError("inclusions must contain at least one Inclusion, got none")
    per_radius = number("cells_per_radius", cells_per_radius)
    if not MIN_CELLS <= per_radius <= 64.0:
        raise ValueError(f"cells_per_radius must be in [{MIN_CELLS:g}, 64], got {per_radius!r}")
    if per_radius < ADVISED_CELLS:
        warnings.warn(
            f"inclusions have fewer than {ADVISED_CELLS:g} cells per radius ({per_radius:g}): use "
            f"cells_per_radius = {ADVISED_CELLS:g} or more",
            ResolutionWarning,
            stacklevel=2,
        )
    extent = number("within", within)
    if not 1.0 < extent <= MAX_WITHIN:
        raise ValueError(f"within must be above 1 and at most {MAX_WITHIN:g} radii, got {extent!r}")
    limit = number("tol", tol)
    if not _MIN_TOL <= limit <= _MAX_TOL:
        raise ValueError(f"tol must be in [{_MIN_TOL:g}, {_MAX_TOL:g}], got {limit!r}")
    placed = [_at_state(n, one, state, which) for n, one in enumerate(inclusions)]
    stress = StressAtPoints(state, which)
    found = [
        _solved(stress, matrix, numbers, [placed[n] for n in numbers], per_radius, extent, limit)
        for numbers in groups(placed)
    ]
    _warn_of_yield(found, matrix)
    return found


def groups(inclusions: Sequence[Inclusion]) -> list[list[int]]:
    """Groups of inclusions that are so close that they are solved together, as lists of indices."""
    left, found = list(range(len(inclusions))), []
    while left:
        group = [left.pop(0)]
        for member in group:
            near = [n for n in left if _are_close(inclusions[member], inclusions[n])]
            group += near
            left = [n for n in left if n not in near]
        found.append(sorted(group))
    return found


def _are_close(a: Inclusion, b: Inclusion) -> bool:
    return math.dist(a.center, b.center) < _APART * (max(a.radii) + max(b.radii))


def _matrix_of(state: State, which: int) -> Material:
    """Return the material of a body or of its matrix; raise ValueError for unsupported bodies."""
    described = state.setup.bodies[which - 1]
    matrix = matrix_of(described)
    if not isinstance(matrix, Material):
        raise ValueError(
            f"body{which} must not be layered for fine boxes, got {in_short(described)}: fine "
            "boxes do not include the effect of layers; simulate a Heterogeneous body with these "
            "inclusions on a fine grid instead"
        )
    if matrix.is_rigid:
        raise ValueError(f"body{which} must not be rigid: the stress in a rigid body is unknown")
    if matrix.free_faces is not None:
        raise ValueError(
            f"body{which} must not have free_faces: fine boxes do not include their effect"
        )
    if abs(state.offset(which)) > 0.0:
        raise ValueError(
            f"fields of body{which} must lie on the cells of the grid, got an offset of "
            f"{state.offset(which):.3g} m: move the body by a whole number of cells"
        )
    return matrix


def _at_state(n: int, inclusion: Inclusion, state: State, which: int) -> Inclusion:
    """Return an inclusion at its position in a state, after it has moved with the body."""
    if inclusion.material is not None and inclusion.material.is_plastic:
        raise ValueError(
            f"inclusions[{n}] must be elastic or a void, got {in_short(inclusion.material)}: fine "
            "boxes are computed as elastic; simulate a Heterogeneous body with this inclusion on a "
            "fine grid instead"
        )
    x = inclusion.center[0]
    moved = x - state._core.first_cell[which - 1] * state.grid.dx
    if state.grid.along_x:
        period = state.grid.nx * state.grid.dx
        moved -= period * math.floor(moved / period + 0.5)
    return _moved(inclusion, moved - x, 0.0)


class _Lattice(NamedTuple):
    """Fine cells of a box."""

    middle: FloatArray
    """Coordinates x and y of the centre of the box [m]."""
    plane: Grid
    """Grid of one layer of cells, with its origin at the centre of the box."""
    above: int
    """Number of layers of cells between the surface and the box."""
    layers: int

    @property
    def shape(self) -> tuple[int, int, int]:
        return self.plane.nx, self.plane.ny, self.layers

    def axes(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Cell centres along x, y and z [m]."""
        x, y = self.plane.x + self.middle[0], self.plane.y + self.middle[1]
        z = (self.above + np.arange(self.layers) + 0.5) * self.plane.dx
        return np.asarray(x), np.asarray(y), np.asarray(z, dtype=np.float64)

    def cells(self, matrix: Material, inclusions: Sequence[Inclusion]) -> InclusionCells:
        """Cells that inclusions fill, with indices counted from the first cell of the box."""
        shift = (-float(self.middle[0]), -float(self.middle[1]))
        local = Heterogeneous(matrix, [_moved(one, *shift) for one in inclusions])
        cells = local.cells_on(self.plane, check=False)
        return replace(cells, first=(*cells.first[:2], cells.first[2] - self.above))


def _moved(one: Inclusion, along_x: float, along_y: float) -> Inclusion:
    x, y, z = one.center
    place = (x + along_x, y + along_y, z)
    return Inclusion(place, one.radii, one.axes, one.material, one.misfit)


def _lattice(low: FloatArray, high: FloatArray, h: float) -> _Lattice:
    """Return cells with the edge length h [m] for a box from `low` to `high` [m]."""
    nx, ny = (2 * math.ceil((high[a] - low[a]) / 2 / h) for a in (0, 1))
    above = max(0, math.floor(low[2] / h))
    layers = math.ceil(high[2] / h) - above
    memory.require(
        f"a fine box of {nx} x {ny} x {layers} cells",
        _BYTES_PER_CELL * nx * ny * layers,
        "use fewer cells per radius or a smaller within",
    )
    return _Lattice((low[:2] + high[:2]) / 2, Grid(nx, ny, h, h, dz=h), above, layers)


def _solved(
    stress: StressAtPoints, matrix: Material, numbers: Sequence[int],
    inclusions: Sequence[Inclusion], per_radius: float, within: float, tol: float,
) -> FineBox:  # fmt: skip
    """Solve a group of inclusions at their positions in the state."""
    centers = np.array([one.center for one in inclusions])
    reach = within * np.array([one.extent for one in inclusions])
    ends = (centers - reach).min(axis=0), (centers + reach).max(axis=0)
    stress.require_matrix(ends, numbers)
    h = min(min(one.radii) for one in inclusions) / per_radius
    lattice = _lattice(*ends, h)
    cells, axes = lattice.cells(matrix, inclusions), lattice.axes()
    given, error = stress.at(*axes)
    where, moduli = _moduli(cells, lattice.shape)
    total, strain, evaluations = given.copy(), np.zeros_like(given), 0
    if where[0].size:
        box = Grid(*lattice.shape[:2], h, h, nz=lattice.layers, dz=h)._core
        of_layers = np.moveaxis(given, -1, 1).copy()
        solution = solve(box, lattice.above, of_layers, where, moduli, matrix.E, matrix.nu, tol)
        total, evaluations = np.moveaxis(solution.stress, 1, -1), solution.evaluations
        strain[:, where[1], where[2], where[0]] = solution.eigenstrain
    moment = float(np.linalg.norm(strain.sum(axis=(1, 2, 3)))) * h**3
    change = matrix.E / (1 - matrix.nu) * moment / (math.pi * float(centers[:, 2].min()) ** 3)
    share = cells.over_grid(cells.share, lattice.shape)
    phase = cells.over_grid(cells.phase, lattice.shape, -1)
    phase.flags.writeable = False
    given, total, strain = (read_only(np.ascontiguousarray(f)) for f in (given, total, strain))
    x, y, z = map(read_only, axes)
    return FineBox(
        Heterogeneous(matrix, inclusions), tuple(numbers), x, y, z, read_only(share),
        phase, given, total, strain, error, change, evaluations,
    )  # fmt: skip


def _moduli(cells: InclusionCells, shape: tuple[int, int, int]) -> tuple[Any, Moduli]:
    """Indices k, i and j of the cells that differ from the matrix, and their moduli."""
    differs = np.moveaxis(cells.over_grid(cells.is_deformed, shape, False), -1, 0)
    where = np.nonzero(differs)

    def of(field: FloatArray, outside: float) -> FloatArray:
        return np.asarray(np.moveaxis(cells.over_grid(field, shape, outside), -1, 0)[where])

    misfit = np.stack([of(part, 0.0) for part in cells.misfit])
    return where, Moduli(of(cells.bulk, 1.0), of(cells.shear, 1.0), misfit)


def _warn_of_yield(boxes: Sequence[FineBox], matrix: Material) -> None:
    """Warn if the matrix would yield in boxes that are computed as elastic."""
    if not matrix.is_plastic:
        return
    excess = [(box.von_mises[box.is_matrix].max() / matrix.yield_stress(0.0), box) for box in boxes]
    worst, box = max(excess, key=lambda pair: pair[0])
    if worst > 1.0:
        warnings.warn(
            f"the matrix would yield near {sum(ratio > 1 for ratio, _ in excess)} of {len(boxes)} "
            f"groups of inclusions, but fine boxes are computed as elastic: the von Mises stress "
            f"reaches {worst:.3g} times the yield stress near inclusions {box.numbers}; simulate a "
            "Heterogeneous body with these inclusions on a fine grid",
            ElasticStrainWarning,
            stacklevel=3,
        )
