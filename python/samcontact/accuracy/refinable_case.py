# SPDX-License-Identifier: GPL-3.0-or-later
"""Case that can be solved on any grid with any number of increments."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .._util.checks import FloatArray
from ..bodies.layers import Layered
from ..restart.identity import Identity, identity
from .fatigue_quantities import depends_on_increments
from .grid_solution import GridSolution
from .grids import grids_of
from .solves import Solves
from .studies import study_of

if TYPE_CHECKING:
    from ..cases import Case

__all__ = ["RefinableCase"]

TOL_SHARE = 0.01
"""Tolerance of the contact solver divided by the prescribed accuracy. The relative error that a
tolerance causes is about a tenth of this tolerance."""
_FRESH_START_FACTOR = 8
"""Factor on the number of increments of a segment with a `start`. The first increment leads from
the end of the previous segment to a value beyond `start`; the factor makes this increment
shorter."""
_FIRST_INCREMENTS = 2
"""Number of increments for which `first_duration` of a segment applies. With n times as many
increments, the first duration is n times shorter."""
_FIELDS_WITHOUT_EFFECT = {
    "title", "description", "output", "estimate_error", "accuracy", "quantities", "max_memory",
    "max_time",
}  # fmt: skip
"""Fields of a case that do not affect the values computed on a given grid."""


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
    margins: FloatArray | float = 0.0
    """Errors that a comparison of grids may miss, in the shape of `values`."""
    note: str = ""
    """Result, as text, that must be the same on the two finest grids."""
    solved: GridSolution | None = None

    @property
    def name(self) -> str:
        return name_of(self.level, self.increments)


def name_of(level: int, increments: int) -> str:
    """Return the name of a run in files, from grid level and number of increments."""
    return f"grid{level:02d}_increments{increments:04d}"


class RefinableCase:
    """Case that is solved with the grids and the numbers of increments that the search chooses."""

    def __init__(self, case: Case) -> None:
        require_refinable(case)
        self.case = case
        self.bodies = case.body1.build(), case.body2.build()
        self.yields = any(body.is_plastic for body in self.bodies)
        marching = case.heat is not None and case.heat.history is not None
        self._all_increments = marching or depends_on_increments(case)
        self.relaxes = case.relaxes
        self.has_history = self.yields or case.sticks or self.relaxes or self._all_increments
        """Whether results depend on the number of increments."""
        smooth = self.relaxes and not (self.yields or case.sticks)
        self.max_increment_order = 2 if smooth else 1
        """Highest order of convergence in the number of increments."""
        layered = any(isinstance(body, Layered) for body in self.bodies)
        self.elastic_layers = layered and not self.yields
        """Whether layers are elastic. Stress is then not evaluated, as cells cross interfaces."""
        self.study = study_of(case, self.bodies)
        self.names = list(self.study.names)
        contact: Any = case.contact
        self.tol = float(contact.tol)
        """Tolerance of the contact solver, from the case or from the prescribed accuracy."""
        self.elastic: set[int] = set()
        """Indices of path segments whose results do not depend on the number of increments."""
        self.grids = grids_of(case, self.bodies)

    @property
    def run_identity(self) -> Identity:
        """Identity that stored runs must match, including the contact tolerance."""
        return identity(
            names=self.names, tol=self.tol, **self.case.model_dump(exclude=_FIELDS_WITHOUT_EFFECT)
        )

    @property
    def parts(self) -> list[int]:
        """For each quantity, the number of values whose maximum is taken, e.g. one per material."""
        return [self.study.parts(name) for name in self.names]

    @property
    def orders(self) -> FloatArray:
        """Lowest order of convergence in the cell size, for each part of all quantities."""
        return np.repeat([self.study.order(name) for name in self.names], self.parts)

    def __repr__(self) -> str:
        return f"RefinableCase({self.case!r})"

    def on(self, level: int, increments: int) -> Case:
        """Return the case with the grid of a level and a number of increments per segment."""
        grid = self.grids.on(level, free=self.yields or self.elastic_layers)
        path = []
        for number, segment in enumerate(self.case.path):
            changes: dict[str, Any] = {"increments": self._count(number, increments)}
            if segment.first_duration is not None and number not in self.elastic:
                changes["first_duration"] = segment.first_duration * _FIRST_INCREMENTS / increments
            for kind in ("roll", "slide"):
                passes = getattr(segment, kind)
                if passes is not None:
                    changes[kind] = passes.model_copy(update={"step": grid.dx})
            path.append(segment.model_copy(update=changes))
        contact = self.case.contact.model_copy(update={"tol": self.tol})
        case = self.case.on_grid(grid, path=path, contact=contact)
        heat = case.heat
        if heat is None or heat.history is None:
            return case
        # time steps of heating are at most as long as the shortest increment
        durations = (step["duration"] for step in case.steps() if step["duration"] > 0.0)
        shortest = min([heat.history[0], *durations])
        history = [shortest, heat.history[1]]
        return case.model_copy(update={"heat": heat.model_copy(update={"history": history})})

    def _count(self, number: int, increments: int) -> int:
        """Return the increments in a segment: 1 if elastic, else a multiple of `increments`."""
        if number in self.elastic:
            return 1
        return increments * (1 if self.case.path[number].start is None else _FRESH_START_FACTOR)

    def solve(
        self, level: int, increments: int, solves: Solves | None = None, *, progress: bool = False
    ) -> GridSolution:
        """Solve the case on a grid, continuing from stored increments."""
        solves = Solves(self.run_identity) if solves is None else solves
        name = name_of(level, increments)
        return self.study.solve(self.on(level, increments), name, solves, progress)

    def run(
        self, level: int, increments: int, solves: Solves | None = None, *, progress: bool = False
    ) -> GridRun:
        """Return the results of the case on a grid; stored results are not computed again."""
        name = name_of(level, increments)
        if solves is not None and name in solves.given:
            return GridRun(level, increments, **solves.given[name])
        began = time.perf_counter()
        solved = self.solve(level, increments, solves, progress=progress)
        given: dict[str, Any] = {
            "cells": solved.simulation.grid.surface_shape,
            "values": self.study.values(solved, self.names),
            "margins": self.study.margins(solved, self.names),
            "note": self.study.note(solved),
            "half": solved.half,
            "elastic": solved.elastic,
            "memory": solved.memory,
            "seconds": time.perf_counter() - began,
        }
        if solves is not None:
            solves.add(name, given)
        return GridRun(level, increments, **given, solved=solved)

    def settle(self, run: GridRun) -> None:
        """Choose elastic segments, and the extent of finer grids, from the results of a run."""
        self.grids.settle(run.level, run.half)
        if not self._all_increments:
            path = self.case.path
            self.elastic = {n for n in run.elastic if not path[n].duration}

    def accept(self, accuracy: float) -> None:
        """Relax the contact tolerance to suit a relative accuracy, unless the case sets `tol`."""
        if "tol" not in self.case.contact.model_fields_set:
            self.tol = max(self.tol, TOL_SHARE * accuracy)


def require_refinable(case: Case) -> None:
    """Raise ValueError, with a remedy, for a case whose grid errors cannot be estimated."""
    if case.wear is not None and case.wear.window is not None:
        raise ValueError(
            "accuracy cannot be prescribed with wear.window, a number of cells, because the "
            "results then depend on the grid: use wear.smoothing_length"
        )
    if case.heat is not None and case.heat.history is not None and case.moves:
        raise ValueError(
            "heat.history requires that bodies move by whole cells, so that the path depends on "
            "the grid: specify [grid] instead of accuracy"
        )
    if case.relaxes and case.moves:
        raise ValueError(
            "relaxation of a body requires that the bodies move by whole cells, so that the path "
            "depends on the grid: specify [grid] instead of accuracy, and compare with a run with "
            "half the cell size"
        )
    surface: Any = case.surface
    straight = surface.radii() is not None and not all(map(math.isfinite, surface.radii()))
    endless = surface.shape == "cylinder" or straight
    if endless and not (case.grid is not None and case.grid.periodic):
        raise ValueError(
            f"surface.shape = {surface.shape!r} gives a contact of infinite length: to prescribe "
            'accuracy, add [grid] with periodic = "y" (or "x"), along the axis of the body'
        )
