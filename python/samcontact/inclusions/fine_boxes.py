# SPDX-License-Identifier: GPL-3.0-or-later
"""Small inclusions in boxes of finer cells, under the stress of a state without them."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._util import memory
from .._util.cached_property import cached_property
from .._util.checks import BoolArray, FloatArray, choice, number, require_list, require_type
from .._util.display import HtmlTable, Rows, ShortRepr, quantity
from .._util.errors import ElasticStrainWarning, ResolutionWarning
from .._util.frozen import read_only
from .._util.short_text import in_short
from .._util.tensors import von_mises
from ..bodies.heterogeneous import Heterogeneous
from ..bodies.inclusion import Inclusion
from ..bodies.inclusion_cells import InclusionCells
from ..bodies.inclusion_resolution import ADVISED_CELLS, MIN_CELLS
from ..bodies.material import Material
from ..fatigue.field import FatigueField
from ..problem.grid import Grid
from ..solutions.state import State
from .fine_solution import Moduli, solve
from .interface import Interface, interface_of
from .stress_at_points import StressAtPoints
from .surroundings import MAX_WITHIN

_APART = (
    3.0  # distance of centres over the sum of the largest radii beyond which two do not interact
)
_MIN_TOL, _MAX_TOL = 1e-6, 1e-2
_BYTES_PER_CELL = 1500.0


@dataclass(frozen=True, repr=False, eq=False)
class FineBox(ShortRepr, HtmlTable):
    """Stress around small inclusions on fine cells, from `fine_boxes`.

    Attributes
    ----------
    body : Heterogeneous
        Matrix and inclusions of the box, at the position of the state in the frame of its grid.
    numbers : tuple of int
        Numbers of these inclusions in the given list.
    x, y, z : ndarray
        Cell centres [m] in the frame of the grid.
    share : ndarray, shape (nx, ny, nz)
        Share of each cell that the inclusions fill, 0 to 1.
    phase : ndarray of int, shape (nx, ny, nz)
        Index in `numbers` of the inclusion that fills most of a cell; -1 in the matrix.
    given_stress : ndarray, shape (6, nx, ny, nz)
        Stress of the state, without these inclusions, interpolated to the cells [Pa].
    stress : ndarray, shape (6, nx, ny, nz)
        Stress with the inclusions [Pa].
    eigenstrain : ndarray, shape (6, nx, ny, nz)
        Strain that the homogeneous matrix needs to have this stress [-].
    interpolation_error : float
        Largest difference between cubic and linear interpolation of the given stress, relative to
        its largest component: an upper bound of the error of the interpolation.
    pressure_change : float
        Estimate of the largest change of the contact pressure due to the inclusions [Pa], which is
        neglected.
    evaluations : int
        Number of evaluations of the stress in the solution.
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
        """Cells that contain the matrix only, shape (nx, ny, nz)."""
        return np.asarray(self.share == 0.0)

    @property
    def coordinates(self) -> dict[str, FloatArray]:
        """Cell centres by the name of their axis [m]."""
        return {"x": self.x, "y": self.y, "z": self.z}

    @property
    def cell_volume(self) -> float:
        """Volume of a cell [m^3]."""
        return float((self.x[1] - self.x[0]) ** 3)

    def interfaces(self) -> list[Interface]:
        """Largest tractions at the interface of each inclusion, see `interfaces`."""
        found = []
        for n, number_ in enumerate(self.numbers):
            mine = self.phase == n
            full = mine & (self.share >= 1.0)
            inner = self.stress[:, full].mean(axis=1)
            total = self.eigenstrain[:, mine].sum(axis=1) / self.share[mine].sum()
            inclusion = self.body.inclusions[n]
            found.append(interface_of(number_, inclusion, inner, total, self.body.matrix))
        return found

    def eigenstrain_on(self, grid: Grid, layers: int) -> FloatArray:
        """Eigenstrain as means over the cells of a coarse grid, shape (6, nx, ny, layers).

        With `Simulation.add_eigenstrain` it returns the effect of the inclusions to the contact:
        their moment, and so their displacement of the surface, is kept.
        """
        require_type("grid", grid, Grid)
        if grid.dz is None:
            raise ValueError(f"grid must have dz, got {grid!r}")
        coarse = np.zeros((6, grid.nx, grid.ny, layers))
        at = [
            np.floor(values / step + middle).astype(int)
            for values, step, middle in (
                (self.x, grid.dx, grid.nx / 2),
                (self.y, grid.dy, grid.ny / 2),
                (self.z, grid.dz, 0.0),
            )
        ]
        for indices, count, name in zip(at, coarse.shape[1:], "xyz", strict=True):
            if indices.min() < 0 or indices.max() >= count:
                raise ValueError(
                    f"grid must contain the box along {name}, got cells {indices.min()} to "
                    f"{indices.max()} of {count}"
                )
        part = self.cell_volume / (grid.dx * grid.dy * grid.dz)
        np.add.at(coarse, (slice(None), *np.ix_(*at)), part * self.eigenstrain)
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


def fine_boxes(
    state: State,
    inclusions: Sequence[Inclusion],
    body: int = 2,
    cells_per_radius: float = 8.0,
    within: float = 2.0,
    tol: float = 1e-4,
) -> list[FineBox]:
    """Solve inclusions that are small compared with the cells of a state, each in a fine box.

    The stress of the state, which does not contain these inclusions, acts on them. Their effect on
    the contact and on the plastic flow of the state is neglected: it decreases with the cube of
    their radius over their depth. Inclusions closer than three times the sum of their radii are
    solved together. The free surface is taken into account. The cost is proportional to the number
    of inclusions.

    Parameters
    ----------
    state : State
        State of a simulation. Its body may be elastic-plastic and contain larger inclusions.
    inclusions : sequence of Inclusion
        Elastic inclusions and voids, with their positions at the start of the simulation; they move
        with the body.
    body : {1, 2}, optional
        Body that contains them; not rigid and not layered. Default: 2.
    cells_per_radius : float, optional
        Cells per smallest radius of a box, at least 2; a warning is issued below 4. Default: 8.
    within : float, optional
        Extent of a box around each inclusion, in radii, above 1 and at most 10. Default: 2.
    tol : float, optional
        Tolerance of the eigenstrain, relative to its norm, in [1e-6, 1e-2]; at least 1e-3 is used
        if moduli differ by a factor above 20. Default: 1e-4.

    Returns
    -------
    list of FineBox
        One for each group of inclusions.

    Raises
    ------
    ValueError
        An inclusion yields, lies outside of the grid or in another inclusion; the body is layered,
        rigid, or does not lie on the cells of the grid; an argument is outside its range.
    TypeError
        An argument has the wrong type.
    ConvergenceError
        The eigenstrain did not converge.
    MemoryError
        A box does not fit into the memory.

    Warns
    -----
    ResolutionWarning
        There are fewer than 4 cells per radius.
    ElasticStrainWarning
        The stress of the matrix exceeds its yield stress: the box is elastic.
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
        raise ValueError(f"within must be above 1 and at most {MAX_WITHIN:g}, got {extent!r}")
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


def fine_field(
    boxes: Sequence[FineBox], criterion: Callable[[FloatArray], FatigueField]
) -> FatigueField:
    """Fatigue criterion over a cycle of fine boxes of the same inclusions.

    Parameters
    ----------
    boxes : sequence of FineBox
        One box for each state of the cycle, e.g. of the positions of a rolling pass.
    criterion : callable
        Function of the stress, shape (n, 6, nx, ny, nz), that returns a field, e.g. ``lambda s:
        sc.fatigue.dang_van(s, slope=0.3)``.

    Returns
    -------
    FatigueField
        With the coordinates of the last box: use it with `peaks`, `butterflies` or `matrix_field`
        and the `body` of this box.

    Raises
    ------
    ValueError
        The boxes are not those of the same inclusions, or there are none.
    TypeError
        An argument has the wrong type.
    """
    require_list("boxes", boxes, FineBox)
    if not boxes:
        raise ValueError("boxes must contain at least one FineBox, got none")
    last = boxes[-1]
    for n, box in enumerate(boxes):
        if box.numbers != last.numbers or box.share.shape != last.share.shape:
            raise ValueError(
                f"boxes must contain the same inclusions on equal cells, got {box.numbers} in "
                f"boxes[{n}] and {last.numbers} in the last one"
            )
    field = criterion(np.stack([box.stress for box in boxes]))
    require_type("the result of criterion", field, FatigueField)
    return replace(field, coordinates=last.coordinates)


def groups(inclusions: Sequence[Inclusion]) -> list[list[int]]:
    """Numbers of inclusions that are so close that they are solved together."""
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
    """Return the material of the body of a state, or of its matrix."""
    described = state.setup.bodies[which - 1]
    if not isinstance(described, Material | Heterogeneous):
        raise ValueError(
            f"body{which} must be a Material or a Heterogeneous body for fine boxes, got "
            f"{in_short(described)}: the stress that a layer reflects to its inclusions is not "
            "included"
        )
    matrix = described.matrix if isinstance(described, Heterogeneous) else described
    if matrix.is_rigid:
        raise ValueError(f"body{which} must not be rigid: it has no stress")
    if matrix.free_faces is not None:
        raise ValueError(f"body{which} must not have free_faces: fine boxes do not include them")
    if abs(state.offset(which)) > 0.0:
        raise ValueError(
            f"fields of body{which} must lie on the cells of the grid, got an offset of "
            f"{state.offset(which):.3g} m: move the body by whole cells"
        )
    return matrix


def _at_state(n: int, inclusion: Inclusion, state: State, which: int) -> Inclusion:
    """Return an inclusion at its position in a state."""
    if inclusion.material is not None and inclusion.material.is_plastic:
        raise ValueError(
            f"inclusions[{n}] must be elastic or a void, got {in_short(inclusion.material)}: fine "
            "boxes are elastic; add it to a Heterogeneous body on a fine grid"
        )
    x, y, z = inclusion.center
    moved = x - state._core.first_cell[which - 1] * state.grid.dx
    if state.grid.along_x:
        period = state.grid.nx * state.grid.dx
        moved -= period * math.floor(moved / period + 0.5)
    return Inclusion((moved, y, z), inclusion.radii, inclusion.axes, inclusion.material,
                     inclusion.misfit)  # fmt: skip


def _solved(
    stress: StressAtPoints, matrix: Material, numbers: Sequence[int],
    inclusions: Sequence[Inclusion], per_radius: float, within: float, tol: float,
) -> FineBox:  # fmt: skip
    """Solve a group of inclusions at their positions in the state."""
    centers = np.array([one.center for one in inclusions])
    reach = within * np.array([one.extent for one in inclusions])
    low, high = (centers - reach).min(axis=0), (centers + reach).max(axis=0)
    h = min(min(one.radii) for one in inclusions) / per_radius
    middle = (low + high) / 2
    nx, ny = (2 * math.ceil((high[a] - low[a]) / 2 / h) for a in (0, 1))
    above = max(0, math.floor(low[2] / h))
    nz = math.ceil(high[2] / h) - above
    memory.require(
        f"a fine box of {nx} x {ny} x {nz} cells",
        _BYTES_PER_CELL * nx * ny * nz,
        "use fewer cells per radius or a smaller within",
    )
    body = Heterogeneous(matrix, inclusions)
    local = [
        Inclusion((*(one.center[a] - middle[a] for a in (0, 1)), one.center[2]), one.radii,
                  one.axes, one.material, one.misfit)
        for one in inclusions
    ]  # fmt: skip
    plane = Grid(nx, ny, h, h, dz=h)
    cells = Heterogeneous(matrix, local).cells_on(plane, check=False)
    cells = replace(cells, first=(*cells.first[:2], cells.first[2] - above))
    x, y, z = plane.x + middle[0], plane.y + middle[1], (above + np.arange(nz) + 0.5) * h
    stress.require_matrix((low, high), numbers)
    given, error = stress.at(x, y, z)
    of_box = Grid(nx, ny, h, h, nz=nz, dz=h)._core
    where, moduli = _moduli(cells, (nx, ny, nz))
    if where[0].size:
        solution = solve(of_box, above, np.moveaxis(given, -1, 1).copy(), where, moduli,
                         matrix.E, matrix.nu, tol)  # fmt: skip
        total, evaluations = np.moveaxis(solution.stress, 1, -1), solution.evaluations
        own = solution.eigenstrain
    else:
        total, evaluations, own = given.copy(), 0, np.zeros((6, 0))
    strain = np.zeros_like(given)
    strain[:, where[1], where[2], where[0]] = own
    shape = (nx, ny, nz)
    moment = np.linalg.norm(own.sum(axis=1)) * h**3
    depth = float(centers[:, 2].min())
    change = matrix.E / (1 - matrix.nu) * float(moment) / (math.pi * depth**3)
    share, phase = cells.over_grid(cells.share, shape), cells.over_grid(cells.phase, shape, -1)
    fields = [read_only(np.ascontiguousarray(f)) for f in (x, y, z, share, phase, given, total,
                                                           strain)]  # fmt: skip
    return FineBox(body, tuple(numbers), *fields, error, change, evaluations)


def _moduli(cells: InclusionCells, shape: tuple[int, int, int]) -> tuple[Any, Moduli]:
    """Indices k, i and j of the cells that differ from the matrix, and their constants."""
    differs = np.moveaxis(cells.over_grid(cells.is_deformed, shape, False), -1, 0)
    where = np.nonzero(differs)

    def of(field: FloatArray, outside: float) -> FloatArray:
        return np.asarray(np.moveaxis(cells.over_grid(field, shape, outside), -1, 0)[where])

    misfit = np.stack([of(part, 0.0) for part in cells.misfit])
    return where, Moduli(of(cells.bulk, 1.0), of(cells.shear, 1.0), misfit)


def _warn_of_yield(boxes: Sequence[FineBox], matrix: Material) -> None:
    """Warn if the matrix would yield in elastic boxes."""
    if not matrix.is_plastic:
        return
    excess = [(box.von_mises[box.is_matrix].max() / matrix.yield_stress(0.0), box) for box in boxes]
    worst, box = max(excess, key=lambda pair: pair[0])
    if worst > 1.0:
        warnings.warn(
            f"the matrix would yield near {sum(ratio > 1 for ratio, _ in excess)} of {len(boxes)} "
            f"groups of inclusions: its largest von Mises stress is {worst:.3g} times the yield "
            f"stress (inclusions {box.numbers}), but fine boxes are elastic; add these inclusions "
            "to a Heterogeneous body on a fine grid",
            ElasticStrainWarning,
            stacklevel=3,
        )
