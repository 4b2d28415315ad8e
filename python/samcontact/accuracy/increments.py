# SPDX-License-Identifier: GPL-3.0-or-later
"""Extrapolation of values to infinitely many increments, based on runs on coarse grids."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from .._util.checks import FloatArray
from .estimate import by_grid, extrapolate_increments, irregular
from .refinable_case import GridRun

Runs = Mapping[tuple[int, int], GridRun]
"""Runs by (grid level, number of increments); level 0 is the coarsest grid."""
TRIAL_LEVEL = 1
"""Level of the coarse grid on which the case is solved with each number of increments tried."""


class Doubling(NamedTuple):
    """Number of increments n, and the finest grid level solved with both n and 2 n increments."""

    increments: int
    grid: int


class Correction(NamedTuple):
    """Correction that extrapolates values of the finest grid to infinitely many increments."""

    values: FloatArray
    errors: FloatArray
    """Errors of the correction on the coarse grids from which it was computed."""
    doublings: list[Doubling]
    """Doublings from which the correction is computed."""
    by_grid: list[FloatArray]
    """For each doubling, possible error that results from using its change on the finest grid."""
    irregular: FloatArray
    """Part of the correction that does not follow a regular order of convergence."""


def trial_runs(runs: Runs) -> list[GridRun]:
    """Return the runs on grid `TRIAL_LEVEL`, in order of their numbers of increments."""
    found = [run for (grid, _), run in runs.items() if grid == TRIAL_LEVEL]
    return sorted(found, key=lambda run: run.increments)


def correction(runs: Runs, used: int, finest: FloatArray, max_order: int = 1) -> Correction:
    """Return the correction of values of the finest grid to infinitely many increments.

    finest: values of the finest grid. used: number of increments with which they were computed.
    max_order: highest order of convergence in the number of increments.
    """
    made = []
    for run in trial_runs(runs)[:-1]:
        n = run.increments
        made.append(Doubling(n, max(g for g, m in runs if m == 2 * n and (g, n) in runs)))
    steps = np.array([runs[g, 2 * n].values - runs[g, n].values for n, g in made])
    first = [n for n, _ in made].index(used)
    more, doubled = (extrapolate_increments(steps, n, max_order) for n in (first, first + 1))
    sizes = np.abs(steps[first:])
    sizes[-1] *= 2.0  # all further doublings together change as much as the last one
    shares = [by_grid(runs[g, used].values, finest) for _, g in made[first:]]
    return Correction(
        values=more.values,
        errors=more.errors,
        doublings=made[first:],
        by_grid=[share * size for share, size in zip(shares, sizes, strict=True)],
        irregular=irregular(more.values, doubled.values, max_order),
    )
