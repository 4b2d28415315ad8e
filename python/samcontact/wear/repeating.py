# SPDX-License-Identifier: GPL-3.0-or-later
"""Repeated cycles of wear by plastic strain or by slip, with checkpoints."""

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
from ..solutions.state import State
from .checkpoint import alone, latest, write
from .coating import warn_of_worn_coating
from .problem import WearProblem, WearProgress, reliefs_of
from .results import BaseWearResult

S = TypeVar("S", bound=WearProblem)
R = TypeVar("R", bound=BaseWearResult)
Moments = tuple[State, ...]
Advance = Callable[[S, WearProgress], tuple[Moments, WearProgress]]
"""Function that solves a cycle and returns its states and the progress after the cycle."""


def repeat(
    kind: type[R],
    problem: S,
    advance: Advance[S],
    count: int,
    checkpoint: str | os.PathLike[str] | None,
    progress: bool,
) -> R:
    """Solve cycles until one removes no material, or until `count` cycles are solved.

    The first cycle is cycle 1, or the cycle after the last one in the checkpoint.
    """
    with nullcontext() if checkpoint is None else alone(checkpoint):
        standing = None if checkpoint is None else latest(checkpoint, problem)
        if standing is None:
            standing = WearProgress.start(problem)
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
    stopped = coarse = thin = False
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
            now = problem.over(moments[0].grid)
            surface = hertz_estimate.ContactSetup(now.grid, now.gap, now.bodies, relieved=True)
            coarse = coarse or resolution.warn_of_run(moments, surface, stacklevel=4)
            thin = thin or warn_of_worn_coating(after, stacklevel=4)
            standing, last = after, moments
            stopped = not any(standing.cycles[-1].volume)
            bar.update()
            bar.set_postfix(volume=f"{sum(standing.cycles[-1].volume):.3g} m3")
            # A finished computation keeps the initial state of its last cycle, to restore `last`.
            if checkpoint is not None and not stopped and len(standing.cycles) < count:
                write(checkpoint, problem, standing)
    assert last is not None
    return _result(kind, problem, advance, standing, stopped, first, last)


def _solved_first(first: Moments | None, advance: Advance[S], problem: S) -> Moments:
    return first if first is not None else advance(problem, WearProgress.start(problem))[0]


def _result(
    kind: type[R],
    problem: S,
    advance: Advance[S],
    standing: WearProgress,
    stopped: bool,
    first: Moments | None,
    last: Moments,
) -> R:
    solve_first = partial(_solved_first, first, advance, problem)
    problem = problem.over(standing.grid)
    relief1, relief2 = reliefs_of(problem, standing)
    return kind(
        grid=problem.grid,
        worn=problem.worn,
        cycles=standing.cycles,
        stopped=stopped,
        heights={body: np.stack(heights) for body, heights in standing.heights.items()},
        first_row={body: problem.rows(body)[0] for body in problem.worn},
        last=last,
        _solve_first=solve_first,
        relief1=relief1,
        relief2=relief2,
    )
