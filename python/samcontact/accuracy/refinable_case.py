# SPDX-License-Identifier: GPL-3.0-or-later
"""Case that can be solved on any grid with any number of increments."""

from __future__ import annotations

import itertools
import math
import time
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from .. import hertz
from .._util import memory
from .._util.cached_property import cached_property
from .._util.checks import FloatArray
from ..bodies.layered import Layered, softest
from ..restart.identity import Identity, identity
from ..simulation import error_controlled_quantities
from ..solutions.strained_cells import strained_extent
from .estimate import REFINEMENT_RATIO
from .solves import Solves

if TYPE_CHECKING:
    from ..cases import Case
    from ..simulation.simulation import Simulation
    from ..solutions.state import State

CELLS_OF_FIRST_GRID = math.sqrt(32.0)
"""Cells per semi-axis of the Hertz contact on the first grid. Each finer grid has sqrt(2) times as
many as the grid before."""
HERTZ_MARGIN = 1.35
"""Half-width of the first grid, relative to the semi-axis of the Hertz contact."""
HERTZ_MARGIN_ALONG_TRAVEL = 2.0
"""Half-width of the first grid along x for moving bodies, relative to the semi-axis. Plastic strain
carried along by a body then remains in the grid for a longer distance."""
TOL_SHARE = 0.01
"""Tolerance of the contact solver divided by the prescribed accuracy. The tolerance causes an error
of the values of about a tenth of the tolerance."""
_FRESH_START_FACTOR = 8
"""Factor on the number of increments of a segment with a `start`. The first increment leads from
the value reached before to a value beyond `start`; with more increments it is shorter."""
_MIN_CELLS_OF_DETAIL = 4.0  # cells across the smallest detail of a surface, on the first grid
_FIELDS_WITHOUT_EFFECT = {
    "title", "description", "output", "estimate_error", "accuracy", "quantities", "max_memory",
    "max_time",
}  # fmt: skip
"""Fields of a case that do not affect the values computed on a given grid."""
_ELASTIC_DEPTH = 1.2  # depth of the grid of elastic bodies, relative to the smaller semi-axis
_MIN_CELLS_IN_LAYER = 3
"""Minimum number of cells, on the first grid, in the largest common divisor of the thicknesses of
elastic-plastic layers: maxima at an interface are extrapolated from this number of cells."""
_MAX_CELL_ASPECT = 8.0
"""Maximum ratio of the cell width of the first grid to this largest common divisor."""


class GridSolution(NamedTuple):
    """Solution on one grid: case with this grid, simulation, states and the warnings issued."""

    case: Case
    simulation: Simulation
    states: list[State]
    issued: list[warnings.WarningMessage]

    @property
    def half(self) -> tuple[float, float]:
        """Half-widths along x and y [m] of the region that contains contact and plastic strain."""
        reach = [0, 0]
        for state in self.states:
            nx, ny = state.grid.surface_shape
            touched = np.nonzero(state.in_contact)
            found = [touched] if touched[0].size else []
            if state is self.states[-1]:
                extents = [strained_extent(state, body) for body in (1, 2)]
                found += [tuple(np.array(axis) for axis in e[:2]) for e in extents if e]
            for cells in found:
                for axis, n in enumerate((nx, ny)):
                    ends = int(cells[axis].min()), int(cells[axis].max())
                    reach[axis] = max(reach[axis], n - 2 * ends[0], 2 * ends[1] + 2 - n)
        grid = self.simulation.grid
        return 0.5 * reach[0] * grid.dx, 0.5 * reach[1] * grid.dy

    @property
    def elastic(self) -> list[int]:
        """Indices of the path segments without plastic flow."""
        ends = ends_of(self.case)
        parts = zip([0, *ends], ends, strict=False)
        return [
            number for number, (first, end) in enumerate(parts)
            if self.case.path[number].start is None
            and not any(state.iterations for state in self.states[first:end])
        ]  # fmt: skip

    @property
    def memory(self) -> float:
        """Memory of the solution, including the fields of its states [bytes]."""
        grid = self.simulation.grid
        layers = max((len(state.depths) for state in self.states[-1:]), default=0)
        plastic = float(self.simulation.counters["volume_bytes"])
        fields = memory.volume(grid, memory.VOLUME_FIELD_BYTES, layers)
        return (
            memory.surface(grid, memory.CONTACT_BYTES + memory.SIMULATION_BYTES) + plastic + fields
        )


@dataclass(eq=False)
class GridRun:
    """Results of a case on one grid. `solved` may be None to save memory."""

    level: int
    increments: int
    cells: tuple[int, int]  # along x and y
    values: FloatArray  # shape (increments from `marks_of`, parts of all quantities)
    half: tuple[float, float]
    elastic: list[int]
    memory: float
    seconds: float
    solved: GridSolution | None = None

    @property
    def name(self) -> str:
        return name_of(self.level, self.increments)


def name_of(level: int, increments: int) -> str:
    """Return the name of a run in files, from grid level and number of increments."""
    return f"grid{level:02d}_increments{increments:04d}"


class RefinableCase:
    """Case that is solved on grids and with numbers of increments chosen by the search."""

    def __init__(self, case: Case) -> None:
        require_refinable(case)
        self.case = case
        self.bodies = case.body1.build(), case.body2.build()
        self.yields = any(body.is_plastic for body in self.bodies)
        marching = case.heat is not None and case.heat.history is not None
        self.has_history = self.yields or marching
        """Whether results depend on the number of increments."""
        drives = {name for step in case.steps() for name in ("load", "approach") if name in step}
        given = drives if len(drives) == 1 else set()
        layered = any(isinstance(body, Layered) for body in self.bodies)
        self.elastic_layers = layered and not self.yields
        """Whether layers are elastic. Stress is then not evaluated: cells cross interfaces."""
        names = error_controlled_quantities.names(
            self.bodies, case.output.body, volume=not self.elastic_layers
        )
        self.names = [name for name in names if name not in given]
        contact: Any = case.contact
        self.tol = float(contact.tol)
        """Tolerance of the contact solver, from the case or from the prescribed accuracy."""
        self.elastic: set[int] = set()
        """Indices of path segments without plastic flow; one increment suffices for each."""
        along_x = HERTZ_MARGIN_ALONG_TRAVEL if case.moves else HERTZ_MARGIN
        self.half = along_x * self.semi_axes[0], HERTZ_MARGIN * self.semi_axes[1]
        self._part_of_layers = self._part_of_all_layers()

    @property
    def run_identity(self) -> Identity:
        """Identity that stored runs must match, including the contact tolerance."""
        return identity(
            names=self.names, tol=self.tol, **self.case.model_dump(exclude=_FIELDS_WITHOUT_EFFECT)
        )

    @property
    def parts(self) -> list[int]:
        """For each quantity, the number of values whose maximum is taken, e.g. one per material."""
        return [error_controlled_quantities.has_parts(name, self.bodies) for name in self.names]

    @cached_property
    def semi_axes(self) -> tuple[float, float]:
        """Semi-axes [m] along x and y of the Hertz contact at maximum load, without roughness."""
        radii = self.case.surface.radii()
        assert radii is not None
        E_star = hertz.effective_modulus(*map(softest, self.bodies))
        steps = self.case.steps()
        sizes = []
        for name in ("load", "approach"):
            target = max((step.get(name, 0.0) for step in steps), default=0.0)
            if target > 0:
                given: dict[str, Any] = {name: target}
                if math.isclose(*radii, rel_tol=1e-9):
                    a = hertz.point(radii[0], E_star, **given).a
                    sizes.append((a, a))
                else:
                    found = hertz.elliptic(*radii, E_star, **given)
                    sizes.append((found.a_x, found.a_y))
        if not sizes:
            raise ValueError("path: at least one load or approach must be > 0")
        return max(sizes)

    @cached_property
    def _finer(self) -> float:
        """Factor >= 1 by which roughness, dents and furrows require more cells than the contact."""
        details: list[float] = []
        roughness: Any = self.case.surface.roughness
        if roughness is not None:
            details += [0.5 * roughness.wavelength_x, 0.5 * roughness.wavelength_y]
        for relief in (self.case.relief1, self.case.relief2):
            kind: Any = relief
            if kind is not None and kind.kind == "dent":
                details.append(2.0 * math.sqrt(2.0 * kind.radius * abs(kind.depth)))
            elif kind is not None:
                details.append(2.0 * kind.half_width)
        widest = min(self.semi_axes) / CELLS_OF_FIRST_GRID
        return max([1.0, *(_MIN_CELLS_OF_DETAIL * widest / size for size in details if size > 0)])

    def cells(self, level: int) -> float:
        """Return the number of cells along a semi-axis of the Hertz contact at a grid level."""
        return float(CELLS_OF_FIRST_GRID * self._finer * REFINEMENT_RATIO**level)

    def __repr__(self) -> str:
        return f"RefinableCase({self.case!r})"

    def on(self, level: int, increments: int) -> Case:
        """Return the case on the grid of a level; the centre of a cell lies at the grid centre."""
        from ..cases.sections import GridSection

        cells = self.cells(level)
        sizes = [a / cells for a in self.semi_axes]
        counts = [2 * math.ceil(half / d) + 1 for half, d in zip(self.half, sizes, strict=True)]
        free = self.yields or self.elastic_layers
        layers = 0 if free else math.ceil(_ELASTIC_DEPTH * cells) + 2
        grid = GridSection(
            nx=counts[0], ny=counts[1], dx=sizes[0], dy=sizes[1], nz=layers, dz=self._dz(level)
        )
        path = []
        for number, segment in enumerate(self.case.path):
            changes: dict[str, Any] = {"increments": self._count(number, increments)}
            for kind in ("roll", "slide"):
                passes = getattr(segment, kind)
                if passes is not None:
                    changes[kind] = passes.model_copy(update={"step": sizes[0]})
            path.append(segment.model_copy(update=changes))
        contact = self.case.contact.model_copy(update={"tol": self.tol})
        case = self.case.model_copy(update={"grid": grid, "path": path, "contact": contact})
        heat = case.heat
        if heat is None or heat.history is None:
            return case
        # time steps of heating are at most as long as the shortest increment
        durations = (step["duration"] for step in case.steps() if step["duration"] > 0.0)
        shortest = min([heat.history[0], *durations])
        history = [shortest, heat.history[1]]
        return case.model_copy(update={"heat": heat.model_copy(update={"history": history})})

    def _dz(self, level: int) -> float:
        """Return the cell size along z [m], a divisor of all elastic-plastic layer thicknesses."""
        if self._part_of_layers is None:
            return min(self._sizes(level))
        cells = max(_MIN_CELLS_IN_LAYER, math.ceil(self._part_of_layers / min(self._sizes(0))))
        return self._part_of_layers / round(cells * REFINEMENT_RATIO**level)

    def _part_of_all_layers(self) -> float | None:
        """Return the largest common divisor of elastic-plastic layer thicknesses [m], if any."""
        depths = [
            float(depth) for body in self.bodies if isinstance(body, Layered) and body.is_plastic
            for depth in body.interfaces
        ]  # fmt: skip
        if not depths:
            return None
        part = common_part(depths)
        min_thickness = min(self._sizes(0)) / _MAX_CELL_ASPECT
        if part is None or part < min_thickness:
            listed = ", ".join(f"{depth:.6g}" for depth in depths)
            raise ValueError(
                f"layers: the depths of the interfaces, {listed} m, must be multiples of a common "
                f"length >= {min_thickness:.2g} m, so that cells fit all layers: round the "
                "thicknesses, or specify [grid] instead of accuracy"
            )
        return part

    def _count(self, number: int, increments: int) -> int:
        """Return the number of increments of segment `number`: 1, `increments` or a multiple."""
        if number in self.elastic:
            return 1
        return increments * (1 if self.case.path[number].start is None else _FRESH_START_FACTOR)

    def solve(
        self, level: int, increments: int, solves: Solves | None = None, *, progress: bool = False
    ) -> GridSolution:
        """Solve the case on a grid, continuing from stored increments."""
        solves = Solves(self.run_identity) if solves is None else solves
        name, case = name_of(level, increments), self.on(level, increments)
        with warnings.catch_warnings(record=True) as issued:
            warnings.simplefilter("always")
            simulation, path = case.build()
            states = solves.run(name, simulation, path, progress=progress)
        return GridSolution(case, simulation, states, issued)

    def run(
        self, level: int, increments: int, solves: Solves | None = None, *, progress: bool = False
    ) -> GridRun:
        """Return the results of the case on a grid; stored results are not computed again."""
        name = name_of(level, increments)
        if solves is not None and name in solves.given:
            return GridRun(level, increments, **solves.given[name])
        began = time.perf_counter()
        solved = self.solve(level, increments, solves, progress=progress)
        values = []
        for mark in marks_of(solved.case):
            found = [
                error_controlled_quantities.parts(solved.states[mark], name) for name in self.names
            ]
            values.append([part for parts in found for part in parts])
        given: dict[str, Any] = {
            "cells": solved.simulation.grid.surface_shape,
            "values": np.array(values),
            "half": solved.half,
            "elastic": solved.elastic,
            "memory": solved.memory,
            "seconds": time.perf_counter() - began,
        }
        if solves is not None:
            solves.add(name, given)
        return GridRun(level, increments, **given, solved=solved)

    def settle(self, run: GridRun) -> None:
        """Set half-widths of later grids, and segments without plastic flow, as found in a run."""
        half = [1.08 * h + 2.0 * d for h, d in zip(run.half, self._sizes(run.level), strict=True)]
        along_x = max(half[0], self.half[0]) if self.case.moves else half[0]
        self.half = along_x, half[1]
        if self.case.heat is None or self.case.heat.history is None:
            self.elastic = set(run.elastic)

    def accept(self, accuracy: float) -> None:
        """Relax the contact tolerance to suit a relative accuracy, unless the case sets `tol`."""
        if "tol" not in self.case.contact.model_fields_set:
            self.tol = max(self.tol, TOL_SHARE * accuracy)

    def _sizes(self, level: int) -> list[float]:
        return [a / self.cells(level) for a in self.semi_axes]


def common_part(lengths: Sequence[float]) -> float | None:
    """Return the largest common divisor of lengths; None if below 1/64 of the first length."""
    for parts in range(1, 65):
        part = lengths[0] / parts
        counts = [length / part for length in lengths]
        if all(abs(count - round(count)) < 1e-8 * count for count in counts):
            return part
    return None


def marks_of(case: Case) -> list[int]:
    """Return indices: the last increment of each segment, and the last loaded one of passes."""
    marks: list[int] = []
    count = 0
    for segment, made in zip(case.path, case.steps_of_segments(), strict=True):
        if segment.passes is not None:
            target = getattr(segment, segment.quantity)
            under = [i for i, step in enumerate(made) if step.get(segment.quantity) == target]
            marks.append(count + under[-1])
        count += len(made)
        marks.append(count - 1)
    return marks


def ends_of(case: Case) -> list[int]:
    """Return the cumulative number of increments at the end of each segment."""
    return list(itertools.accumulate(len(steps) for steps in case.steps_of_segments()))


def require_refinable(case: Case) -> None:
    """Raise ValueError, with a remedy, for a case that is defined on one grid only."""
    remedy = "specify [grid] with the cells of the data instead of accuracy"
    if case.sticks:
        raise ValueError(
            "contact.friction: accuracy does not support partial slip: specify [grid] instead"
        )
    if case.wear is not None:
        raise ValueError("wear: accuracy does not support wear: specify [grid] instead")
    if case.grid is not None and case.grid.periodic:
        raise ValueError(
            "grid.periodic: accuracy does not support periodic grids: "
            "specify the whole of [grid] instead of accuracy"
        )
    surface: Any = case.surface
    if surface.shape == "file":
        raise ValueError(f"surface.shape = 'file' is defined at the points of its file: {remedy}")
    if surface.roughness is not None and surface.roughness.kind != "sinusoidal":
        raise ValueError(
            f"surface.roughness.kind = {surface.roughness.kind!r} depends on the cells of the "
            "grid: specify [grid] instead of accuracy"
        )
    for name in ("relief1", "relief2"):
        relief = getattr(case, name)
        if relief is not None and not relief.is_known:
            raise ValueError(f"{name}.kind = {relief.kind!r} is defined on one grid only: {remedy}")
    radii = surface.radii()
    if radii is None or not all(map(math.isfinite, radii)):
        raise ValueError(
            f"surface.shape = {surface.shape!r} gives a contact of infinite length, for which "
            'accuracy cannot be prescribed: specify [grid] with periodic = "y" (or "x") instead'
        )
