# SPDX-License-Identifier: GPL-3.0-or-later
"""Mixed lubrication: films with a boundary layer, from the dry contact upwards in speed."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from .._util.checks import FloatArray
from ..problem.grid import Grid
from .film_solution import FilmLevel
from .nested import DryContact, FilmTask, LevelSolver, dry_contact, state_of, table_of

FILM_OF_DRY = 0.015
"""Film that a formula predicts at the first speed, in thicknesses of the boundary layer."""
MAX_RATIO, MIN_RATIO = 3.0, 1.02
"""Largest and smallest factor between successive speeds."""
FEW_ITERATIONS = 12
"""Newton iterations below which the factor grows."""
GROWTH = 1.3
_FLUID_OF_DRY = 1e-3  # share of the dry pressure that the fluid bears at the start
_TOL_ON_THE_WAY = 1e-5


@dataclass
class Step:
    """Solution at a speed relative to that of the task."""

    factor: float
    found: Any


class MixedFilm:
    """Films of a task at increasing speeds, each from the solution at the last one."""

    def __init__(self, task: FilmTask, grid: Grid) -> None:
        self._task = task
        self.gap = task.gap_on(grid, grid)
        self.dry: DryContact = dry_contact(task, grid, self.gap)
        self.layer = task.layer(self.dry.peak)
        self._solver = LevelSolver(task, grid, self.gap, table_of(task.lubricant, self.dry.peak))
        # the predicted film is nearly proportional to speed^(2/3)
        self._first = (FILM_OF_DRY * self.layer[0] / self.dry.film) ** 1.5
        self._ratio = MAX_RATIO
        self._last: Step | None = None

    def _start(self) -> dict[str, Any]:
        if self._last is not None:
            return state_of(self._last.found)
        pressure: FloatArray = self.dry.pressure
        return {
            "fluid_pressure": _FLUID_OF_DRY * pressure,
            "boundary_pressure": pressure,
            "void_fraction": np.zeros_like(pressure),
            "approach": self.dry.approach - 2.0 * self.layer[0],
        }

    def task_at(self, factor: float) -> FilmTask:
        """Return the task at a speed relative to its own."""
        velocities, spin = factor * self._task.velocities, factor * self._task.spin
        return replace(self._task, velocities=velocities, spin=spin)

    def level(self, found: Any) -> FilmLevel:
        """Return what is stated about the grid of a solution."""
        return self._solver.level(found)

    def _solved_at(self, factor: float, tol: float) -> Any:
        self._solver.task = replace(self.task_at(factor), tol=tol)
        return self._solver.solve(self._start(), self.layer, self._task.order)

    def at(self, factor: float) -> Any:
        """Return the solution at a speed relative to that of the task.

        The factors of successive calls must not decrease. The solution has not converged if even
        the smallest step fails.
        """
        while True:
            last = 0.0 if self._last is None else self._last.factor
            trial = min(self._first, factor) if self._last is None else last * self._ratio
            trial = factor if trial > factor / math.sqrt(MIN_RATIO) else trial
            tol = self._task.tol if trial == factor else max(self._task.tol, _TOL_ON_THE_WAY)
            found = self._solved_at(trial, tol)
            if found["converged"]:
                self._last = Step(trial, found)
                if found["iterations"] < FEW_ITERATIONS:
                    self._ratio = min(self._ratio**GROWTH, MAX_RATIO)
                if trial == factor:
                    return found
            elif self._last is None:
                self._first *= 10.0
                if self._first > factor:
                    return found
            else:
                self._ratio = math.sqrt(self._ratio)
                if self._ratio < MIN_RATIO:
                    return found
