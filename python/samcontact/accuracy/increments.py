# SPDX-License-Identifier: GPL-3.0-or-later
"""What more increments would change, from runs on grids that are as coarse as can tell it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from .._util.checks import FloatArray
from .estimate import by_grid, irregular, of_doublings
from .scene import Run

Runs = Mapping[tuple[int, int], Run]
"""By grid and increments."""
COARSEST = 1
"""The grid on which all numbers of increments are tried."""


class Doubling(NamedTuple):
    """Twice so many increments, and the finest grid on which both are known."""

    increments: int
    grid: int


class Correction(NamedTuple):
    """What more increments would add to values of the finest grid, with its errors."""

    values: FloatArray
    errors: FloatArray
    """On the grids that it was found on."""
    doublings: list[Doubling]
    """Which it is made of."""
    by_grid: list[FloatArray]
    """What a finer grid may change in each of them."""
    irregular: FloatArray
    """What is not of first order."""


def tried(runs: Runs) -> list[Run]:
    """Those of the coarsest grid, from the fewest increments on."""
    found = [run for (grid, _), run in runs.items() if grid == COARSEST]
    return sorted(found, key=lambda run: run.increments)


def correction(runs: Runs, used: int, finest: FloatArray) -> Correction:
    """Of values of the finest grid in the used number of increments."""
    made = []
    for run in tried(runs)[:-1]:
        n = run.increments
        made.append(Doubling(n, max(g for g, m in runs if m == 2 * n and (g, n) in runs)))
    steps = np.array([runs[g, 2 * n].values - runs[g, n].values for n, g in made])
    first = [n for n, _ in made].index(used)
    more, twice = of_doublings(steps, first), of_doublings(steps, first + 1)
    sizes = np.abs(steps[first:])
    sizes[-1] *= 2.0  # all that follow are together as large
    shares = [by_grid(runs[g, used].values, finest) for _, g in made[first:]]
    return Correction(
        values=more.values,
        errors=more.errors,
        doublings=made[first:],
        by_grid=[share * size for share, size in zip(shares, sizes, strict=True)],
        irregular=irregular(more.values, twice.values),
    )
