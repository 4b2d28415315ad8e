# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.accuracy_cost: cost of a prescribed accuracy and of manual grids."""

from __future__ import annotations

import time
from functools import cache
from typing import NamedTuple

import numpy as np

import samcontact as sc
from samcontact.accuracy.refinable_case import RefinableCase
from samcontact.cases import Case as SectionsOfCase

from .accuracy_cases import CASES
from .study import Record, Study, table
from .truth import known

ACCURACIES = (0.05, 0.01, 0.002)
NAMES = ("balls, 1500 N", "T1, 600 N", "T1, 1500 N", "T1, 4000 N", "V2, both elastic-plastic",
         "2a, rigid on M50", "F2, friction 0.2")  # fmt: skip
LEVELS = range(7)
INCREMENTS = (2, 4, 8, 16, 32, 64)
MAX_SECONDS = 5.0  # s, time limit of a manual grid
TEXT = """<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by: OMP_NUM_THREADS=1 python -m benchmarks.accuracy_cost --docs -->
# Cost of a prescribed accuracy

This page compares the computing time of `samcontact.to_accuracy` with the time on the best manually
chosen grid of equal error. `samcontact.to_accuracy` solves a case on several grids and with several
numbers of increments. A user who knew the required grid and number of increments in advance would
solve the case only once.

For comparison, each grid that `to_accuracy` uses is solved separately, with {increments} increments
of loading and one increment of elastic unloading, with the default tolerance of case files and
with the extent of the first grid. Numbers of increments that would take more than about
{longest:.0f} s are omitted. The "best manual grid" is the fastest combination of grid and number of
increments whose error does not exceed the error of `to_accuracy`. The error is the maximum error of
all quantities, relative to the reference values of the page [reliability of the estimated
errors](accuracy.md), which also lists the cases. Times are processor times with one thread.

{table}

In {count} of {rows} rows a manual grid is as accurate as `to_accuracy`. In these rows the median
ratio of times (`to_accuracy` / manual grid) is {median:.2g}. In the other rows no manual grid is as
accurate, because `to_accuracy` extrapolates its values from several grids, and a single grid does
not permit this. These rows show the most accurate manual grid instead.
"""


class Solved(NamedTuple):
    """Maximum relative error of a solution, its processor time [s] and its grid."""

    error: float
    seconds: float
    what: str


def error_of(values: dict[str, float], truth: dict[str, float]) -> float:
    """Return the maximum relative error of all quantities."""
    return max(abs(values[name] / exact - 1) for name, exact in truth.items() if exact != 0)


@cache
def by_hand(name: str, levels: range = LEVELS) -> list[Solved]:
    """Solve a case on manually chosen grids with given numbers of increments."""
    case = SectionsOfCase.model_validate({"title": "by hand", "accuracy": 0.1, **CASES[name]})
    refinable, truth = RefinableCase(case), known()[name]
    refinable.settle(refinable.run(0, INCREMENTS[0]))
    found = []
    for level in levels:
        seconds = 0.0
        for count in INCREMENTS if refinable.has_history else (1,):
            if 2 * seconds > MAX_SECONDS:
                break
            start = time.process_time()
            run = refinable.run(level, count)
            seconds = time.process_time() - start
            ends = np.cumsum(refinable.parts)
            values = {
                key: float(np.abs(run.values[:, end - parts : end]).max())
                for key, parts, end in zip(refinable.names, refinable.parts, ends, strict=True)
            }
            exact = {key: value for key, value in truth.items() if key in values}
            what = f"{run.cells[0]} x {run.cells[1]} cells"
            what += f", {count} increments" if refinable.has_history else ""
            found.append(Solved(error_of(values, exact), seconds, what))
    return found


def chosen(name: str, accuracy: float) -> Solved:
    start = time.process_time()
    found = sc.to_accuracy(CASES[name], accuracy)
    seconds = time.process_time() - start
    truth = {key: exact for key, exact in known()[name].items() if key in found.values}
    return Solved(error_of(found.values, truth), seconds, f"{found.grid.nx} x {found.grid.ny}")


def points(quick: bool) -> list[Record]:
    found = [{"of": name, "accuracy": accuracy} for name in NAMES for accuracy in ACCURACIES]
    return found[:1] if quick else found


def run(of: str, accuracy: float) -> Record:
    hand, mine = by_hand(of), chosen(of, accuracy)
    as_exact = [one for one in hand if one.error <= mine.error]
    best = min(as_exact, key=lambda one: one.seconds, default=min(hand, key=lambda one: one.error))
    return {"mine": mine._asdict(), "best": best._asdict(), "as_exact": bool(as_exact)}


def page(records: list[Record]) -> str:
    head = ("case", "prescribed [%]", "error [%]", "time [s]", "best manual grid",
            "its error [%]", "its time [s]", "ratio of times")  # fmt: skip
    lines, ratios = [], []
    for record in records:
        mine, best = Solved(**record["mine"]), Solved(**record["best"])
        ratio = mine.seconds / best.seconds
        if record["as_exact"]:
            ratios.append(ratio)
        what = best.what if record["as_exact"] else f"none; most accurate: {best.what}"
        lines.append((record["of"], f"{100 * record['accuracy']:g}", f"{100 * mine.error:.2g}",
                      f"{mine.seconds:.2g}", what, f"{100 * best.error:.2g}",
                      f"{best.seconds:.2g}",
                      f"{ratio:.2g}" if record["as_exact"] else ""))  # fmt: skip
    return TEXT.format(
        increments=f"{INCREMENTS[0]} to {INCREMENTS[-1]}", longest=MAX_SECONDS,
        table=table(head, lines), median=float(np.median(ratios)),
        count=len(ratios), rows=len(records),
    )  # fmt: skip


STUDY = Study(
    "accuracy_cost", "Cost of a prescribed accuracy against manual grids.", points, run, page
)

if __name__ == "__main__":
    STUDY.main()
