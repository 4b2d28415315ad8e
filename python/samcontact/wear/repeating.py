# SPDX-License-Identifier: GPL-3.0-or-later
"""Repetition of cycles of wear, by plastic strain or by slip, with checkpoints."""

from __future__ import annotations

import os
from collections.abc import Callable
from contextlib import nullcontext
from functools import partial
from typing import TypeVar

import numpy as np

from .._util.errors import attach
from .._util.progress import progress_bar
from ..diagnostics import hertz_estimate, resolution
from ..problem.moving_topography import Relief, heights_over
from ..solutions.state import State
from .checkpoint import WearProblem, WearProgress, alone, latest, write
from .results import BaseWearResult

S = TypeVar("S", bound=WearProblem)
R = TypeVar("R", bound=BaseWearResult)
Moments = tuple[State, ...]
Advance = Callable[[S, WearProgress], tuple[Moments, WearProgress]]
"""Function that solves a cycle, and returns its states and the initial state of the next one."""


def repeat(
    kind: type[R],
    problem: S,
    advance: Advance[S],
    count: int,
    checkpoint: str | os.PathLike[str] | None,
    progress: bool,
) -> R:
    """Repeat cycles, from the start or from a checkpoint, until a cycle removes no material."""
    with nullcontext() if checkpoint is None else alone(checkpoint):
        standing = None if checkpoint is None else latest(checkpoint, problem)
        if standing is None:
            standing = _start(problem)
        if len(standing.cycles) >= count:
            done = len(standing.cycles)
            raise ValueError(
                "cycles must be greater than the number of cycles in the "
                f"checkpoint ({done}), got {count}"
            )
        return _repeat(kind, problem, advance, standing, count, checkpoint, progress)


def _repeat(
    kind: type[R],
    problem: S,
    advance: Advance[S],
    standing: WearProgress,
    count: int,
    checkpoint: str | os.PathLike[str] | None,
    progress: bool,
) -> R:
    first = last = None
    stopped = coarse = False
    with progress_bar(count, "cycle", shown=progress, initial=len(standing.cycles)) as bar:
        while not stopped and len(standing.cycles) < count:
            try:
                moments, after = advance(problem, standing)
            except Exception as error:
                if last is not None:
                    attach(
                        error, result=_result(kind, problem, advance, standing, False, first, last)
                    )
                raise
            first = moments if not standing.cycles else first
            surface = hertz_estimate.ContactSetup(
                problem.grid, problem.gap, problem.bodies, relieved=True
            )
            coarse = coarse or resolution.warn_of_run(moments, surface, stacklevel=4)
            standing, last = after, moments
            stopped = not any(standing.cycles[-1].volume)
            bar.update()
            bar.set_postfix(volume=f"{sum(standing.cycles[-1].volume):.3g} m3")
            # A finished computation keeps the initial state of its last cycle, to restore `last`.
            if checkpoint is not None and not stopped and len(standing.cycles) < count:
                write(checkpoint, problem, standing)
    assert last is not None
    return _result(kind, problem, advance, standing, stopped, first, last)


def _start(problem: WearProblem) -> WearProgress:
    heights = {}
    for body in problem.worn:
        (first, rows), grid = problem.rows(body), problem.grid
        relief, blank = problem.reliefs[body - 1], np.zeros((rows, grid.ny))
        heights[body] = [blank if relief is None else heights_over(relief, first, rows, grid)]
    return WearProgress(heights)


def reliefs_of(problem: WearProblem, standing: WearProgress) -> list[Relief | None]:
    """Return the current surfaces of both bodies; None for a smooth surface without wear."""
    reliefs = list(problem.reliefs)
    for body in problem.worn:
        first, _ = problem.rows(body)
        heights = standing.heights[body]
        worn = np.maximum(heights[0] - heights[-1], 0.0)
        reliefs[body - 1] = Relief(heights[-1], first, worn=worn)
    return reliefs


def _solved_first(first: Moments | None, advance: Advance[S], problem: S) -> Moments:
    return first if first is not None else advance(problem, _start(problem))[0]


def _result(
    kind: type[R],
    problem: S,
    advance: Advance[S],
    standing: WearProgress,
    stopped: bool,
    first: Moments | None,
    last: Moments,
) -> R:
    relief1, relief2 = reliefs_of(problem, standing)
    return kind(
        grid=problem.grid,
        worn=problem.worn,
        cycles=standing.cycles,
        stopped=stopped,
        heights={body: np.stack(heights) for body, heights in standing.heights.items()},
        first_row={body: problem.rows(body)[0] for body in problem.worn},
        last=last,
        _solve_first=partial(_solved_first, first, advance, problem),
        relief1=relief1,
        relief2=relief2,
    )
