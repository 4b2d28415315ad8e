# SPDX-License-Identifier: GPL-3.0-or-later
"""Mixed lubrication: films with a boundary layer, from the dry contact upwards in speed."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..problem.grid import Grid
from .film_solution import FilmLevel
from .nested import DryContact, FilmTask, LevelSolver, dry_contact, state_of, table_of

FILM_OF_DRY = 0.06
"""Film that a formula predicts at the first speed, in thicknesses of the boundary layer."""
LAYER_RATIO, LAYER_OF_APPROACH = 2.5, 1e-3
"""Ratio of successive thicknesses of the layer at the start, and the largest one relative to the
approach of the dry contact."""
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
        self._ratio = MAX_RATIO
        self._last: Step | None = None

    def _first_factor(self, thickness: float) -> float:
        """Return the speed at which a layer bears all; the film grows with speed^(2/3)."""
        return (FILM_OF_DRY * thickness / self.dry.film) ** 1.5

    def _begin(self) -> Any:
        """Return the solution at a speed at which the layer bears all.

        A thick layer is solved first: its film differs less from that of the dry contact.
        """
        thin, pressure = self.layer
        depth = float(np.ptp(self.gap[self.dry.pressure > 0])) + abs(self.dry.approach)
        layers = [thin]
        while layers[0] * LAYER_RATIO < LAYER_OF_APPROACH * depth:
            layers.insert(0, layers[0] * LAYER_RATIO)
        state = {
            "fluid_pressure": _FLUID_OF_DRY * self.dry.pressure,
            "boundary_pressure": self.dry.pressure,
            "void_fraction": np.zeros_like(self.dry.pressure),
            "approach": self.dry.approach - 2.0 * layers[0],
        }
        found: Any = None
        for n, thickness in enumerate(layers):
            if n > 0:
                state = state_of(found)
                state["approach"] += 2.0 * (layers[n - 1] - thickness)
            factor = self._first_factor(thickness)
            self._solver.task = replace(self.task_at(factor), tol=_TOL_ON_THE_WAY)
            found = self._solver.solve(state, (thickness, pressure), self._task.order)
            if not found["converged"]:
                return found
        self._last = Step(self._first_factor(thin), found)
        return found

    def task_at(self, factor: float) -> FilmTask:
        """Return the task at a speed relative to its own."""
        velocities, spin = factor * self._task.velocities, factor * self._task.spin
        return replace(self._task, velocities=velocities, spin=spin)

    def level(self, found: Any) -> FilmLevel:
        """Return what is stated about the grid of a solution."""
        return self._solver.level(found)

    def at(self, factor: float) -> Any:
        """Return the solution at a speed relative to that of the task.

        The factors of successive calls must not decrease. The solution has not converged if even
        the smallest step fails.
        """
        if self._last is None and not (found := self._begin())["converged"]:
            return found
        while True:
            assert self._last is not None
            trial = self._last.factor * self._ratio
            # A layer that bears all at a speed bears all at any lower one.
            if trial > factor / math.sqrt(MIN_RATIO):
                trial = factor
            tol = self._task.tol if trial == factor else max(self._task.tol, _TOL_ON_THE_WAY)
            self._solver.task = replace(self.task_at(trial), tol=tol)
            found = self._solver.solve(state_of(self._last.found), self.layer, self._task.order)
            if found["converged"]:
                self._last = Step(trial, found)
                if found["iterations"] < FEW_ITERATIONS:
                    self._ratio = min(self._ratio**GROWTH, MAX_RATIO)
                if trial == factor:
                    return found
                continue
            self._ratio = math.sqrt(self._ratio)
            if self._ratio < MIN_RATIO:
                return found
