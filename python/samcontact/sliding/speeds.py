# SPDX-License-Identifier: GPL-3.0-or-later
"""Steady sliding at several velocities under one load."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from typing import Any

from numpy.typing import ArrayLike

from .._util.checks import boolean, finite_array, require_type
from .._util.errors import attach
from .._util.progress import progress_bar
from ..bodies.layered import Body
from ..contact.moving import speed_of
from ..problem.grid import Grid
from ..problem.settings import ContactSettings
from ..solutions.moving_solution import SlidingSolution
from .checkpoint import Kept, kept_in
from .curve import FrictionCurve
from .steady import steady


def over_speed(
    grid: Grid,
    body1: Body,
    body2: Body,
    gap: ArrayLike | Callable[[Grid], ArrayLike],
    *,
    load: float,
    velocities: Sequence[float],
    tol: float = ContactSettings.tol,
    on_border: str = ContactSettings.on_border,
    max_iterations: int = ContactSettings.max_iterations,
    checkpoint: str | os.PathLike[str] | None = None,
    progress: bool = False,
) -> FrictionCurve:
    """Solve steady sliding at several velocities under one load.

    The solution at each velocity starts from the solution at the previous velocity.
    `plotting.friction_curve` plots the result.

    Parameters
    ----------
    grid : Grid
    body1, body2 : Material
        Upper and lower body; the gap is fixed to body 1.
    gap : array_like, shape (nx, ny), or callable
        Initial separation [m], or a function of a grid that returns this array.
    load : float
        Normal load [N], >= 0.
    velocities : sequence of float
        Velocities of body 1 relative to body 2 along x [m/s].
    tol, on_border, max_iterations
        As in `ContactSolver`.
    checkpoint : path, optional
        Folder in which each solution is stored in a file. Repeating the call resumes from this
        folder, with bit-identical results.
    progress : bool, optional
        Whether to show the progress.

    Returns
    -------
    FrictionCurve

    Raises
    ------
    ValueError, TypeError, ConvergenceError
        As for `steady`. If a velocity after the first one fails, the attribute `result` of the
        error is the friction curve of the velocities before. CheckpointError if `checkpoint`
        contains files of another run. A velocity with a damaged file is solved again.
    """
    require_type("grid", grid, Grid)
    boolean("progress", progress)
    given = finite_array("velocities", velocities)
    if given.ndim != 1 or given.size == 0:
        raise ValueError(f"velocities must be a list of numbers [m/s], got shape {given.shape}")
    speeds = [speed_of("velocities", v) for v in given.tolist()]
    settings: dict[str, Any] = {
        "tol": tol,
        "on_border": on_border,
        "max_iterations": max_iterations,
    }
    problem: dict[str, Any] = {"body1": body1, "body2": body2, "gap": gap, "load": load}

    def solve(velocity: float, last: SlidingSolution | None) -> SlidingSolution:
        start = last if last is not None and last.grid == grid else None
        return steady(grid, **problem, velocity=velocity, start=start, **settings)

    with kept_in(checkpoint, grid, **problem, velocities=speeds, **settings) as kept:
        return FrictionCurve(tuple(_solutions(speeds, solve, kept, progress)), tol)


def _solutions(
    speeds: Sequence[float],
    solve: Callable[[float, SlidingSolution | None], SlidingSolution],
    kept: Kept | None,
    progress: bool,
) -> list[SlidingSolution]:
    solutions: list[SlidingSolution] = []
    with progress_bar(len(speeds), "velocity", shown=progress) as bar:
        for index, v in enumerate(speeds):
            found = None if kept is None else kept.solution(index)
            if found is None:
                try:
                    found = solve(v, solutions[-1] if solutions else None)
                except Exception as error:
                    if solutions:
                        attach(error, result=FrictionCurve(tuple(solutions)))
                    raise
                if kept is not None:
                    kept.add(index, found)
            solutions.append(found)
            bar.update()
            bar.set_postfix(friction=f"{found.friction:.3g}")
    return solutions
