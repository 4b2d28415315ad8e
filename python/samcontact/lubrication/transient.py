# SPDX-License-Identifier: GPL-3.0-or-later
"""Lubricated contact whose surfaces, load or speeds change in time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, choice, finite_array, integer, positive, require_type
from .._util.display import ShortRepr
from .._util.errors import attach
from .film_solution import FilmPast, FilmSolution
from .nested import FilmTask, LevelSolver, table_of
from .steady import require_converged, solution_of, velocities_of

WEIGHTS = 1.5, 2.0, 0.5
"""Weights of the content now, one step ago and two steps ago, in a step of second order."""


@dataclass(frozen=True, repr=False, eq=False)
class FilmHistory(ShortRepr):
    """Films in time, from `transient`.

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
) -> FilmHistory:
    """March a lubricated contact in time: moving reliefs, and load or speeds that change.

    Squeeze films, impact and reversal of the motion are included. Each step is of second order in
    time (BDF2). The film before the start is assumed to be steady. If `start` belongs to a history,
    this history is continued.

    Parameters
    ----------
    start : FilmSolution
        Film at the start, from `steady` or `transient`.
    duration : float
        Duration [s], > 0.
    steps : int
        Number of time steps, >= 1. A relief should move by at most a cell in a step.
    relief1, relief2 : callable, optional
        Heights of the surfaces of bodies 1 and 2 in addition to the gap of the start [m], as a
        function of the coordinates x and y of its points at time 0. The points move with the
        velocity of the body. Waves need 32 cells each.
    load : callable, optional
        Load at a time since time 0 of the history [N]. Default: that of the start.
    speed : callable, optional
        Velocities of the surfaces at a time, as for `steady` [m/s]. Default: those of the start.
    order, tol, max_iterations
        As in `steady`.

    Returns
    -------
    FilmHistory

    Raises
    ------
    ValueError, TypeError
        Invalid arguments.
    ConvergenceError
        No convergence; its attribute `history` contains the solutions so far.
    """
    require_type("start", start, FilmSolution)
    if start.shear_thinning or start.heat is not None:
        raise ValueError(
            "start must be a film without shear thinning in the flow and without heat: transient "
            "films are isothermal; solve it with shear_thinning = False and thermal = False"
        )
    duration, steps = positive("duration", duration), integer("steps", steps, 1)
    functions = {"relief1": relief1, "relief2": relief2, "load": load, "speed": speed}
    for name, given in functions.items():
        if given is not None and not callable(given):
            raise TypeError(f"{name} must be a function, got {type(given).__name__}")
    march = _March(start, duration / steps, (relief1, relief2), load, speed)
    solutions: list[FilmSolution] = []
    settings = {
        "order": choice("order", order, (1, 2, 3)), "tol": positive("tol", tol),
        "max_iterations": integer("max_iterations", max_iterations, 1),
    }  # fmt: skip
    try:
        for _ in range(steps):
            solutions.append(march.step(settings))
    except BaseException as error:  # Ctrl-C too
        attach(error, history=FilmHistory(tuple(solutions)))
        raise
    return FilmHistory(tuple(solutions))


class _March:
    """Steps of a transient film."""

    def __init__(
        self, start: FilmSolution, step: float,
        reliefs: Sequence[Callable[[FloatArray, FloatArray], ArrayLike] | None],
        load: Callable[[float], float] | None, speed: Callable[[float], Sequence[Any]] | None,
    ) -> None:  # fmt: skip
        body1, body2 = start.bodies
        self._last, self._step, self._reliefs = start, step, reliefs
        self._load, self._speed = load, speed
        self._task = FilmTask(
            (body1, body2), start.gap, True, start.load, start.velocities, start.spin,
            start.lubricant, np.inf, start.boundary, 3, 1e-6, 20,
        )  # fmt: skip
        self._peak = float(start.pressure.max()) if start.past is None else start.past.peak
        self._layer = self._task.layer(self._peak)
        table = table_of(start.lubricant, self._peak)
        self._solver = LevelSolver(self._task, start.grid, start.gap, table)

    def _gap(self, smooth: FloatArray, ways: FloatArray) -> FloatArray:
        """Return the gap of the undeformed surfaces, reliefs at their present positions [m]."""
        grid, gap = self._last.grid, smooth
        for number, (relief, way) in enumerate(zip(self._reliefs, ways, strict=True), 1):
            if relief is not None:
                x, y = np.meshgrid(grid.x - way[0], grid.y - way[1], indexing="ij")
                gap = gap - finite_array(f"relief{number}", relief(x, y), grid.surface_shape)
        return gap

    def step(self, settings: dict[str, Any]) -> FilmSolution:
        """Return the film after one more step."""
        last = self._last
        content = last.content
        past = last.past or FilmPast(0.0, np.zeros((2, 2)), content, last.gap, self._peak)
        time = past.time + self._step
        velocities = last.velocities if self._speed is None else velocities_of(self._speed(time))
        ways = past.ways + 0.5 * self._step * (last.velocities + velocities)
        load = last.load if self._load is None else positive("load", self._load(time))
        task = replace(self._task, velocities=velocities, target=load, **settings)
        gap = self._gap(past.gap, ways)
        solver = self._solver
        solver.task, solver.gap = task, gap
        state = {
            "fluid_pressure": last.fluid_pressure, "boundary_pressure": last.boundary_pressure,
            "void_fraction": 1.0 - last.filling, "approach": last.approach,
        }  # fmt: skip
        found = solver.solve(
            state, self._layer, task.order, time=(self._step, WEIGHTS[0]),
            content=WEIGHTS[1] * content - WEIGHTS[2] * past.content,
        )  # fmt: skip
        require_converged(found, task)
        solution = solution_of(last.grid, gap, task, found, [solver.level(found)])
        self._last = replace(solution, past=FilmPast(time, ways, content, past.gap, past.peak))
        return self._last
