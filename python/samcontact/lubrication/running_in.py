# SPDX-License-Identifier: GPL-3.0-or-later
"""Running-in: wear of a surface by the boundary layer, under a film."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from .._util.checks import FloatArray, boolean, choice, integer, positive, require_type
from .._util.display import ShortRepr, quantity
from .._util.errors import attach
from .._util.frozen import read_only
from .._util.progress import progress_bar
from .film_solution import FilmSolution
from .mixed import MixedFilm
from .nested import FilmTask, LevelSolver, table_of
from .sheared import ShearedLevel, sheared_from
from .steady import require_converged, solution_of

MAX_STEP = 10.0
"""Largest depth that may be worn off in a step, divided by the boundary layer thickness."""


@dataclass(frozen=True, repr=False, eq=False)
class RunningIn(ShortRepr):
    """Films and wear over time, from `running_in`.

    Attributes
    ----------
    films : tuple of FilmSolution
        Film at the start and after each step.
    time : ndarray, shape (n,)
        Times since the start [s].
    depth : ndarray, shape (n, nx, ny)
        Depth of the removed material [m].
    """

    films: tuple[FilmSolution, ...]
    time: FloatArray
    depth: FloatArray

    @property
    def volume(self) -> FloatArray:
        """Worn volume [m^3], shape (n,)."""
        volume: FloatArray = self.depth.sum(axis=(1, 2)) * self.films[0].grid.cell_area
        return volume

    @property
    def boundary_share(self) -> FloatArray:
        """Shares of the load that the boundary layer carries [-], shape (n,)."""
        return np.array([film.boundary_share for film in self.films])


def running_in(
    film: FilmSolution,
    *,
    archard: float,
    duration: float,
    steps: int,
    worn: int = 2,
    tol: float = 1e-6,
    max_iterations: int = 40,
    progress: bool = False,
) -> RunningIn:
    """Simulate running-in: wear of a surface in proportion to the pressure of its boundary layer.

    The worn depth increases by ``archard`` times the pressure of the boundary layer times the
    sliding distance (Archard's law); the fluid causes no wear. The worn surface is at rest in the
    contact, like the surface of a pin on a rotating disc, so each of its points wears continuously.
    After each step, a steady film is solved on the worn gap.

    Parameters
    ----------
    film : FilmSolution
        Film at the start, from `steady` or `stribeck`, with a boundary layer and sliding.
    archard : float
        Wear coefficient divided by hardness [1/Pa], > 0.
    duration : float
        Duration [s], > 0.
    steps : int
        Number of steps of equal duration, >= 1. A step must not wear off more than 10 times the
        thickness of the boundary layer.
    worn : {1, 2}, optional
        Body that wears; its velocity must be 0.
    tol, max_iterations
        As in `steady`.
    progress : bool, optional
        Whether to show the progress.

    Returns
    -------
    RunningIn

    Raises
    ------
    ValueError, TypeError
        Invalid arguments, a film without boundary layer, a worn body that moves, no sliding, or a
        step that wears off too much.
    ConvergenceError
        No convergence; the attribute `result` contains the completed steps.
    """
    require_type("film", film, FilmSolution)
    rate, duration = positive("archard", archard), positive("duration", duration)
    steps, body = integer("steps", steps, 1), choice("worn", worn, (1, 2))
    boolean("progress", progress)
    speed = _sliding_speed(film, body)
    step = duration / steps
    course = _Course(film, positive("tol", tol), integer("max_iterations", max_iterations, 1))
    films, depths = [film], [np.zeros(film.grid.surface_shape)]

    def result() -> RunningIn:
        times = np.linspace(0.0, step * (len(films) - 1), len(films))
        return RunningIn(tuple(films), times, read_only(np.array(depths[: len(films)])))

    try:
        with progress_bar(steps, "step", shown=progress) as bar:
            for _ in range(steps):
                removed = rate * speed * step * films[-1].boundary_pressure
                _require_small(removed, film, steps)
                depths.append(depths[-1] + removed)
                films.append(course.at(depths[-1]))
                bar.update()
    except BaseException as error:  # Ctrl-C too
        attach(error, result=result())
        raise
    return result()


def _sliding_speed(film: FilmSolution, worn: int) -> float:
    """Return the sliding speed [m/s]; raise ValueError for a film that cannot wear the body."""
    if film.boundary is None:
        raise ValueError("film must have a boundary layer, got none: give `steady` a boundary")
    if film.past is not None:
        raise ValueError("film must be steady, got a film of a history: use a film from `steady`")
    if film.velocities[worn - 1].any() or film.spin:
        raise ValueError(
            f"body {worn}, which wears, must be at rest, and the film without spin, got the "
            f"velocity {film.velocities[worn - 1].tolist()} m/s and the spin {film.spin} rad/s: "
            "a moving surface spreads its wear over a track; set worn to a body at rest"
        )
    return float(np.hypot(*film.velocities[2 - worn]))


def _require_small(removed: FloatArray, film: FilmSolution, steps: int) -> None:
    """Raise ValueError if a step wears off more than `MAX_STEP` allows."""
    assert film.boundary is not None
    largest, limit = float(removed.max()), MAX_STEP * film.boundary.thickness
    if largest > limit:
        needed = int(np.ceil(steps * largest / limit))
        raise ValueError(
            f"steps must be at least {needed}, so that each step wears off at most {MAX_STEP:g} "
            f"times the thickness of the boundary layer, got {steps}, of which one wears off "
            f"{quantity(largest, 'm')}"
        )


class _Course:
    """Steady films on a gap that increases due to wear.

    Each solution starts from the preceding film. If this fails, it starts from the dry contact.
    """

    def __init__(self, film: FilmSolution, tol: float, max_iterations: int) -> None:
        assert film.boundary is not None
        body1, body2 = film.bodies
        task = FilmTask(
            (body1, body2), film.gap, True, film.load, film.velocities, film.spin, film.lubricant,
            film.supply, film.boundary, film.order, tol, max_iterations, film.shear_thinning,
            film.heat is not None,
        )  # fmt: skip
        start = MixedFilm(task, film.grid)
        # The layer keeps its constants while the largest pressure of the dry contact changes.
        self._boundary, self._layer = film.boundary, start.layer
        self._task = replace(task, boundary=replace(film.boundary, pressure=start.layer[1]))
        table = table_of(film.lubricant, start.dry.peak)
        self._solver = LevelSolver(self._task, film.grid, film.gap, table)
        self._last, self._depth, self._gap = film, np.zeros_like(film.gap), film.gap

    def at(self, depth: FloatArray) -> FilmSolution:
        """Return the film after a depth [m], shape (nx, ny), has been worn off the surface."""
        task = replace(self._task, gap=self._gap + depth)
        solver = self._solver
        solver.task, solver.gap = task, self._gap + depth
        found = self._solved(solver, self._start(depth), task)
        if not found["converged"]:
            mixed = MixedFilm(task, self._last.grid)
            found = mixed.at(1.0)
            if task.is_sheared and found["converged"]:
                found = ShearedLevel(mixed.solver_of(task)).solve(found, self._layer)
        require_converged(found, task)
        shown = replace(task, boundary=self._boundary)
        film = solution_of(self._last.grid, solver.gap, shown, found, [solver.level(found)])
        self._last, self._depth = film, depth
        return film

    def _solved(self, solver: LevelSolver, state: dict[str, Any], task: FilmTask) -> Any:
        if task.is_sheared:
            return sheared_from(solver, state, self._layer)
        return solver.solve(state, self._layer, task.order)

    def _start(self, depth: FloatArray) -> dict[str, Any]:
        """Return the state of the last film, with the approach increased by the mean wear.

        Both this mean and the mean film thickness, which it keeps unchanged, are weighted by the
        pressure of the boundary layer.
        """
        last = self._last
        layer = last.boundary_pressure
        removed = float((layer * (depth - self._depth)).sum() / layer.sum())
        return {
            "fluid_pressure": last.fluid_pressure, "boundary_pressure": layer,
            "void_fraction": 1.0 - last.filling, "approach": last.approach + removed,
        }  # fmt: skip
