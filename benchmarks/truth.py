# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.truth: reference values of cases, for comparison with stated errors."""

from __future__ import annotations

import itertools
import time

import numpy as np
from numpy.typing import NDArray

from samcontact.accuracy.refinable_case import RefinableCase
from samcontact.cases import Case as SectionsOfCase

from .accuracy_cases import CASES, Case, closed_form
from .study import Record, Study

MAX_SOLVE_SECONDS = 35.0  # processor time [s]
INCREMENTS = (4, 8, 16, 32)  # increments per segment
INCREMENTS_ON = 3  # number of the grid for these increments
FINER_INCREMENTS = {
    "F2, 5000 N": (3, (8, 16, 32, 64)),
    "given approach": (3, (16, 32, 64)),
    "V1, rigid tip": (6, (4, 8, 16)),
}
"""Number of a grid, and numbers of increments on this grid, for cases whose results change much
with more than four increments, or by an amount that depends on the grid. With the rigid tip, the
residual stress at the rim falls by 5 % on grid 3 and by 1 % on grid 6."""
Values = NDArray[np.float64]


def finest(
    case: Case,
    seconds: float = MAX_SOLVE_SECONDS,
    grid: int = INCREMENTS_ON,
    increments: tuple[int, ...] = INCREMENTS,
) -> dict[str, float]:
    """Return reference values of a case: closed forms if known, otherwise extrapolated.

    Values are extrapolated from increasingly fine grids, within a time limit and with the fewest
    increments. Runs with more increments on one grid give a correction.
    """
    refinable = RefinableCase(
        SectionsOfCase.model_validate({"title": "truth", "accuracy": 0.1, **case})
    )
    counts = increments if refinable.has_history else (1,)
    start = time.process_time()
    runs = [refinable.run(0, counts[0])]
    refinable.settle(runs[0])
    while time.process_time() - start + 4 * runs[-1].seconds < seconds or len(runs) < 4:
        runs[-1].solved = None
        runs.append(refinable.run(len(runs), counts[0]))
    coarse = [refinable.run(grid, n).values for n in counts]
    return extrapolated(refinable.names, refinable.parts, [run.values for run in runs], coarse) | {
        name: value for name, value in closed_form(case).items() if name in refinable.names
    }


def extrapolated(
    names: list[str], parts: list[int], grids: list[Values], coarse: list[Values]
) -> dict[str, float]:
    """Extrapolate values with order 2 in cell size, and with orders 1 and 2 in increment size."""
    change = (grids[-1] - grids[-3]) / 3
    # a maximum in a thin surface layer that no grid resolves is disregarded
    values = grids[-1] + np.where(np.abs(change) < 0.05 * np.abs(grids[-1]), change, 0.0)
    if len(coarse) > 1:
        first = [2 * fine - wide for wide, fine in itertools.pairwise(coarse)]
        values = values + (4 * first[-1] - first[-2]) / 3 - coarse[0]
    ends = np.cumsum(parts)
    largest = [
        float(np.abs(values[:, end - n : end]).max()) for n, end in zip(parts, ends, strict=True)
    ]
    return dict(zip(names, largest, strict=True))


def run(of: str) -> Record:
    more = FINER_INCREMENTS.get(of, (INCREMENTS_ON, INCREMENTS))
    return {"values": finest(CASES[of], MAX_SOLVE_SECONDS, *more)}


def points(quick: bool) -> list[Record]:
    return [{"of": name} for name in (list(CASES)[:1] if quick else CASES)]


def known() -> dict[str, dict[str, float]]:
    """Return the stored reference values by case and quantity."""
    return {record["of"]: record["values"] for record in STUDY.records()}


STUDY = Study(
    "truth", "Reference values of cases, to check stated errors.", points, run, lasting=True
)

if __name__ == "__main__":
    STUDY.main()
