# SPDX-License-Identifier: GPL-3.0-or-later
"""Lubricated contact whose surfaces, load or speeds change in time."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import (
    FloatArray,
    boolean,
    choice,
    finite_array,
    integer,
    positive,
    require_type,
)
from .._util.display import ShortRepr
from .._util.errors import attach
from .._util.progress import progress_bar
from ..restart.identity import Identity, digest, identity
from .balance import WEIGHTS
from .checkpoint import Kept, kept_in
from .film_solution import FilmPast, FilmSolution
from .nested import FilmTask, LevelSolver, table_of
from .sheared import sheared_from
from .steady import require_converged, solution_of, velocities_of


@dataclass(frozen=True, repr=False, eq=False)
class FilmHistory(ShortRepr):
    """Films over time, from `transient`.

    Attributes
    ----------
    solutions : tuple of FilmSolution
        Solution at the end of each step.
    """

    solutions: tuple[FilmSolution, ...]

    @property
    def time(self) -> FloatArray:
        """Times since the start [s], shape (n,)."""
        return np.array([s.time for s in self.solutions])

    @property
    def film(self) -> FloatArray:
        """Film thickness [m], shape (n, nx, ny)."""
        return np.array([s.film for s in self.solutions])

    @property
    def pressure(self) -> FloatArray:
        """Pressure [Pa], shape (n, nx, ny)."""
        return np.array([s.pressure for s in self.solutions])


_Heights = Callable[[FloatArray, FloatArray], ArrayLike]


def transient(
    start: FilmSolution,
    *,
    duration: float,
    steps: int,
    relief1: Callable[[FloatArray, FloatArray], ArrayLike] | None = None,
    relief2: Callable[[FloatArray, FloatArray], ArrayLike] | None = None,
    load: Callable[[float], float] | None = None,
    speed: Callable[[float], Sequence[Any]] | None = None,
    order: int = 3,
    tol: float = 1e-6,
    max_iterations: int = 20,
    checkpoint: str | os.PathLike[str] | None = None,
    progress: bool = False,
) -> FilmHistory:
    """Solve a transient lubricated contact: moving topography, varying load or speeds.

    Squeeze films, impact and reversal of the motion are included. The time integration is of second
    order (BDF2). The film is assumed to be steady before the start. If `start` is a film from
    `transient`, its history is continued.

    Parameters
    ----------
    start : FilmSolution
        Film at the start, from `steady` (without `thermal`) or `transient`. If it was solved with
        `shear_thinning`, all steps include shear thinning.
    duration : float
        Duration [s], > 0.
    steps : int
        Number of time steps, >= 1. Moving topography should advance by at most one cell per step.
    relief1, relief2 : callable, optional
        Topography that moves with body 1 or 2: function f(x, y) that returns the height [m] of the
        points of the body that are at x and y at time 0. The heights are subtracted from the gap of
        the start. Wavy topography needs 32 cells per wavelength.
    load : callable, optional
        Function that returns the load [N] at a time since the beginning of the history [s].
        Default: the load of the start.
    speed : callable, optional
        Function that returns the velocities of the surfaces [m/s] at a time since the beginning of
        the history [s], in the form that `steady` accepts. Default: the velocities of the start.
    order, tol, max_iterations
        As in `steady`.
    checkpoint : path, optional
        Folder in which the film of each step is stored. Repeating the call resumes from this
        folder, with bit-identical results; a step whose file is damaged is solved again.
    progress : bool, optional
        Whether to show the progress.

    Returns
    -------
    FilmHistory

    Raises
    ------
    ValueError, TypeError
        Invalid arguments.
    CheckpointError
        `checkpoint` contains files of another run.
    ConvergenceError
        No convergence; its attribute `history` contains the solutions so far.
    """
    require_type("start", start, FilmSolution)
    if start.heat is not None:
        raise ValueError(
            "start must be a film without heating, got a heated film, and transient films do not "
            "include heat: solve the start with thermal = False"
        )
    duration, steps = positive("duration", duration), integer("steps", steps, 1)
    functions = {"relief1": relief1, "relief2": relief2, "load": load, "speed": speed}
    for name, given in functions.items():
        if given is not None and not callable(given):
            raise TypeError(f"{name} must be a function, got {type(given).__name__}")
    boolean("progress", progress)
    settings = {
        "order": choice("order", order, (1, 2, 3)), "tol": positive("tol", tol),
        "max_iterations": integer("max_iterations", max_iterations, 1),
    }  # fmt: skip
    course = _Course(start, duration / steps, (relief1, relief2), load, speed)
    run: Identity = {}
    if checkpoint is not None:
        what = {"start": start, "duration": duration, "steps": steps, **settings}
        run = identity(**what, course=course.described(start, steps))
    solutions: list[FilmSolution] = []
    try:
        with (
            kept_in(checkpoint, run) as kept,
            progress_bar(steps, "step", shown=progress) as bar,
        ):
            for film in _films(_March(start, course, settings), start, steps, kept):
                solutions.append(film)
                bar.update()
    except BaseException as error:  # Ctrl-C too
        attach(error, history=FilmHistory(tuple(solutions)))
        raise
    return FilmHistory(tuple(solutions))


def standing_on(film: FilmSolution, gap: FloatArray) -> FilmSolution:
    """Return a steady film as the start of a history in which part of its topography moves.

    gap: gap of the film without the moving topography [m].
    """
    peak = float(film.pressure.max())
    return replace(film, past=FilmPast(0.0, np.zeros((2, 2)), film.content, gap, peak))


def _films(
    march: _March, start: FilmSolution, steps: int, kept: Kept | None
) -> Iterator[FilmSolution]:
    """Iterate over the films of all steps, which are read from the checkpoint or solved."""
    last, like = start, replace(start, order=march.order, errors=None)
    for index in range(steps):
        found = None if kept is None else kept.film(index, like)
        if found is None:
            found = march.step(last)
            if kept is not None:
                kept.add(index, found)
        last = found
        yield found


class _Instant(NamedTuple):
    """Motion and load at the end of a step."""

    time: float
    velocities: FloatArray
    ways: FloatArray
    """Travels of the surfaces since time 0 [m], shape (2, 2)."""
    load: float
    gap: FloatArray
    """Gap of the undeformed surfaces with the moving topography at its present position [m]."""


class _Course:
    """Motion, load and moving topography over time."""

    def __init__(
        self, start: FilmSolution, step: float, reliefs: Sequence[_Heights | None],
        load: Callable[[float], float] | None, speed: Callable[[float], Sequence[Any]] | None,
    ) -> None:  # fmt: skip
        self.step, self._grid, self._reliefs = step, start.grid, reliefs
        self._load, self._speed = load, speed
        self._smooth = start.smooth_gap

    def first(self, start: FilmSolution) -> _Instant:
        """Return motion, load and gap at the time of a film."""
        past = start.past
        time, ways = (0.0, np.zeros((2, 2))) if past is None else (past.time, past.ways)
        return _Instant(time, start.velocities, ways, start.load, start.gap)

    def after(self, last: _Instant) -> _Instant:
        """Return motion, load and gap one step after an instant."""
        time = last.time + self.step
        velocities = last.velocities if self._speed is None else velocities_of(self._speed(time))
        ways = last.ways + 0.5 * self.step * (last.velocities + velocities)
        load = last.load if self._load is None else positive("load", self._load(time))
        return _Instant(time, velocities, ways, load, self._gap(ways))

    def _gap(self, ways: FloatArray) -> FloatArray:
        grid, gap = self._grid, self._smooth
        for number, (relief, way) in enumerate(zip(self._reliefs, ways, strict=True), 1):
            if relief is not None:
                x, y = np.meshgrid(grid.x - way[0], grid.y - way[1], indexing="ij")
                gap = gap - finite_array(f"relief{number}", relief(x, y), grid.surface_shape)
        return gap

    def described(self, start: FilmSolution, steps: int) -> list[str]:
        """Return texts that identify all steps of a run.

        The functions of time are evaluated, because their code may not identify them.
        """
        instant, found = self.first(start), []
        for _ in range(steps):
            instant = self.after(instant)
            found.append(digest(identity(instant=list(instant))))
        return found


class _March:
    """Solver for the steps of a transient film."""

    def __init__(self, start: FilmSolution, course: _Course, settings: dict[str, Any]) -> None:
        body1, body2 = start.bodies
        self._course, self._settings = course, settings
        self.order: int = settings["order"]
        self._task = FilmTask(
            (body1, body2), start.gap, True, start.load, start.velocities, start.spin,
            start.lubricant, start.supply, start.boundary, 3, 1e-6, 20, start.shear_thinning,
        )  # fmt: skip
        self._peak = float(start.pressure.max()) if start.past is None else start.past.peak
        self._layer = self._task.layer(self._peak)
        table = table_of(start.lubricant, self._peak)
        self._solver = LevelSolver(self._task, start.grid, start.gap, table)

    def step(self, last: FilmSolution) -> FilmSolution:
        """Return the film one step after the film `last`."""
        content = last.content
        past = last.past or FilmPast(0.0, np.zeros((2, 2)), content, last.gap, self._peak)
        now = self._course.after(self._course.first(last))
        task = replace(self._task, velocities=now.velocities, target=now.load, **self._settings)
        solver = self._solver
        solver.task, solver.gap = task, now.gap
        state = {
            "fluid_pressure": last.fluid_pressure, "boundary_pressure": last.boundary_pressure,
            "void_fraction": 1.0 - last.filling, "approach": last.approach,
        }  # fmt: skip
        more: dict[str, Any] = {
            "time": (self._course.step, WEIGHTS[0]),
            "content": WEIGHTS[1] * content - WEIGHTS[2] * past.content,
        }
        if task.thins:
            found = sheared_from(solver, state, self._layer, **more)
        else:
            found = solver.solve(state, self._layer, task.order, **more)
        require_converged(found, task)
        solution = solution_of(last.grid, now.gap, task, found, [solver.level(found)])
        past = FilmPast(now.time, now.ways, content, past.gap, past.peak)
        return replace(solution, past=past)
