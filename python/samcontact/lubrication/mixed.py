# SPDX-License-Identifier: GPL-3.0-or-later
"""Mixed lubrication: films with a boundary layer, solved from the dry contact to higher speeds."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..problem.contact_law import in_contact
from ..problem.grid import Grid
from .film_limits import require_thin_layer
from .film_solution import FilmLevel
from .nested import DryContact, FilmTask, LevelSolver, dry_contact, state_of, table_of
from .share_error import of_sheared, share_error
from .sheared import ShearedLevel

FILM_OF_DRY = 0.06
"""Film that a formula predicts at the first speed, divided by the layer thickness."""
LAYER_RATIO, MIN_LAYER_RATIO = 2.5, 1.1
"""Ratio of successive layer thicknesses at the start: first value, and minimum after failures."""
LAYER_OF_APPROACH = 2e-3
"""First layer thickness, divided by the sum of approach and gap variation of the dry contact."""
FIRST_ITERATIONS = 60
"""Newton iterations that are allowed for each layer thickness at the start."""
MAX_RATIO, MIN_RATIO = 3.0, 1.02
"""Largest and smallest factor between successive speeds."""
FEW_ITERATIONS = 12
"""Number of Newton iterations below which the factor between speeds is increased."""
GROWTH = 1.3
_FLUID_OF_DRY = 1e-3  # share of the dry pressure that the fluid bears at the start
_TOL_ON_THE_WAY = 1e-5


@dataclass
class Step:
    """Solution at `factor` times the speed of the task."""

    factor: float
    found: Any


class MixedFilm:
    """Films of a task at increasing speeds; each solution starts from the preceding one."""

    def __init__(self, task: FilmTask, grid: Grid) -> None:
        self._task = task
        self.gap = task.gap_on(grid, grid)
        self.dry: DryContact = dry_contact(task, grid, self.gap)
        require_thin_layer(task, self.dry)
        self.layer = task.layer(self.dry.peak)
        self._solver = LevelSolver(task, grid, self.gap, table_of(task.lubricant, self.dry.peak))
        self._ratio = MAX_RATIO
        self._last: Step | None = None

    def _first_factor(self, thickness: float) -> float:
        """Return speed/(speed of the task) [-] at which the boundary layer carries the whole load.

        thickness: thickness of the layer [m].
        """
        return float((FILM_OF_DRY * thickness / self.dry.film) ** 1.5)

    def _begin(self) -> Any:
        """Return the solution at the first speed, at which the layer carries the whole load.

        Contacts with thicker layers are solved first, because they are closer to the dry contact.
        """
        thin = self.layer[0]
        touching = in_contact(self.dry.pressure)
        depth = float(np.ptp(self.gap[touching])) + abs(self.dry.approach)
        thickness, ratio = max(thin, LAYER_OF_APPROACH * depth), LAYER_RATIO
        last: dict[str, Any] = {
            "fluid_pressure": _FLUID_OF_DRY * self.dry.pressure,
            "boundary_pressure": self.dry.pressure,
            "void_fraction": np.zeros_like(self.dry.pressure),
            "approach": self.dry.approach,
        }
        thickness_of_last = 0.0
        while True:
            state = last | {"approach": last["approach"] + 2.0 * (thickness_of_last - thickness)}
            found = self._first_solution(state, thickness)
            if found["converged"]:
                if thickness == thin:
                    self._last = Step(self._first_factor(thin), found)
                    return found
                last, thickness_of_last = state_of(found), thickness
            else:
                ratio = math.sqrt(ratio)
                if ratio < MIN_LAYER_RATIO or thickness_of_last == 0.0:
                    return found
            thickness = max(thin, thickness_of_last / ratio)

    def _first_solution(self, state: dict[str, Any], thickness: float) -> Any:
        """Return the solution for a layer thickness [m], at the speed of `_first_factor`."""
        task = self.task_at(self._first_factor(thickness))
        self._solver.task = replace(
            task, tol=_TOL_ON_THE_WAY, max_iterations=max(task.max_iterations, FIRST_ITERATIONS)
        )
        return self._solver.solve(state, (thickness, self.layer[1]), task.order)

    def task_at(self, factor: float) -> FilmTask:
        """Return the task with its velocities and spin multiplied by a factor."""
        velocities, spin = factor * self._task.velocities, factor * self._task.spin
        return replace(self._task, velocities=velocities, spin=spin)

    def solver_of(self, task: FilmTask) -> LevelSolver:
        """Return the solver, after giving it this task to solve."""
        self._solver.task = task
        return self._solver

    def level(self, found: Any) -> FilmLevel:
        """Return the summary of a solution on this grid."""
        return self._solver.level(found)

    def solved(self, factor: float, states_error: bool) -> tuple[Any, float | None]:
        """Return the solution with shear thinning and heating, and the error of its layer share.

        factor: as for `at`; states_error: whether to estimate the error of the share of the load
        that the boundary layer carries (else None).
        """
        found = self.at(factor)
        solver = self.solver_of(self.task_at(factor))
        error = share_error(solver, found, self.layer) if states_error else None
        if not solver.task.is_sheared or not found["converged"]:
            return found, error
        sheared = ShearedLevel(solver).solve(found, self.layer)
        return sheared, of_sheared(error, found, sheared)

    def at(self, factor: float) -> Any:
        """Return the solution without thinning and heating at `factor` times the speed of the task.

        The factors of successive calls must not decrease. If even the smallest step in speed fails,
        the returned solution has not converged.
        """
        if self._last is None and not (found := self._begin())["converged"]:
            return found
        while True:
            assert self._last is not None
            trial = self._last.factor * self._ratio
            # If the layer carries the whole load at a speed, it does so at any lower speed.
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
