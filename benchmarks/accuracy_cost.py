# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.accuracy_cost: what an accuracy costs beside grids chosen by hand.

On one thread: OMP_NUM_THREADS must be 1. With --docs it writes a page of the documentation.
"""

from __future__ import annotations

import argparse
import json
import os
import time
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np

import samcontact as sc
from samcontact.accuracy import Refinable
from samcontact.cases import Case as SectionsOfCase

from .accuracy import stored
from .accuracy_cases import CASES
from .harness import ROOT
from .resolution import markdown

KEPT = Path(__file__).with_name("accuracy_cost.json")
PAGE = ROOT / "docs" / "accuracy_cost.md"
ASKED = (0.05, 0.01, 0.002)
NAMES = ("balls, 1500 N", "T1, 600 N", "T1, 1500 N", "T1, 4000 N", "V2, both yield",
         "2a, rigid on M50", "F2, friction 0.2")  # fmt: skip
LEVELS = range(7)
INCREMENTS = (2, 4, 8, 16, 32, 64)
LONGEST = 5.0  # s of a grid chosen by hand
TEXT = """<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by: OMP_NUM_THREADS=1 python -m benchmarks.accuracy_cost --docs -->
# What an accuracy costs

`samcontact.to_accuracy` solves a case on several grids and in several numbers of increments.
Whoever knew in advance which grid and how many increments have the same error would solve only
that one.
Here all grids of the sequence are solved so, each by itself, with {increments} increments of
loading and one of elastic unloading, the tolerance that cases have by default and the window
of the first grid, as long as that takes less than about {longest:.0f} s. The quickest of them
whose largest error is below that of `to_accuracy` is the best by hand. Errors are those of the
worst quantity, against [the truth](accuracy.md); times those of the processor, one thread.

{table}

In {count} of {rows} rows a grid of the sweep is as exact; there the median of time over that of
the best is {median:.2g}. In the others none is, since values of `to_accuracy` are extrapolated and
those of a grid are not; the one with the least error is shown.
"""


class Solved(NamedTuple):
    """Largest relative error of a way to solve a case, and what it takes."""

    error: float
    seconds: float
    what: str


class Row(NamedTuple):
    """A case to an accuracy, and the best grid by hand."""

    case: str
    asked: float
    mine: Solved
    best: Solved
    as_exact: bool


def error_of(values: dict[str, float], truth: dict[str, float]) -> float:
    """Of the worst quantity."""
    return max(abs(values[name] / exact - 1) for name, exact in truth.items() if exact != 0)


def by_hand(name: str, levels: range = LEVELS) -> list[Solved]:
    """Grids and increments, each by itself."""
    case = SectionsOfCase.model_validate({"title": "by hand", "accuracy": 0.1, **CASES[name]})
    scene, truth = Refinable(case), stored()[name]
    scene.settle(scene.run(0, INCREMENTS[0]))
    found = []
    for level in levels:
        seconds = 0.0
        for count in INCREMENTS if scene.has_history else (1,):
            if 2 * seconds > LONGEST:
                break
            start = time.process_time()
            run = scene.run(level, count)
            seconds = time.process_time() - start
            ends = np.cumsum(scene.parts)
            values = {
                key: float(np.abs(run.values[:, end - parts : end]).max())
                for key, parts, end in zip(scene.names, scene.parts, ends, strict=True)
            }
            known = {key: exact for key, exact in truth.items() if key in values}
            what = f"{run.cells[0]} x {run.cells[1]} cells"
            what += f", {count} increments" if scene.has_history else ""
            found.append(Solved(error_of(values, known), seconds, what))
    return found


def chosen(name: str, asked: float) -> Solved:
    start = time.process_time()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = sc.to_accuracy(CASES[name], asked)
    seconds = time.process_time() - start
    truth = {key: exact for key, exact in stored()[name].items() if key in found.values}
    return Solved(error_of(found.values, truth), seconds, f"{found.grid.nx} x {found.grid.ny}")


def measured(names: tuple[str, ...], asked: tuple[float, ...]) -> Iterator[Row]:
    for name in names:
        hand = by_hand(name)
        for share in asked:
            mine = chosen(name, share)
            as_exact = [one for one in hand if one.error <= mine.error]
            if as_exact:
                best = min(as_exact, key=lambda one: one.seconds)
            else:
                best = min(hand, key=lambda one: one.error)
            yield Row(name, share, mine, best, bool(as_exact))


def page(rows: list[Row]) -> str:
    head = ("case", "asked [%]", "error [%]", "time [s]", "best by hand", "its error [%]",
            "its time [s]", "ratio")  # fmt: skip
    lines, ratios = [], []
    for row in rows:
        ratio = row.mine.seconds / row.best.seconds
        if row.as_exact:
            ratios.append(ratio)
        what = row.best.what if row.as_exact else f"none; nearest: {row.best.what}"
        lines.append((row.case, f"{100 * row.asked:g}", f"{100 * row.mine.error:.2g}",
                      f"{row.mine.seconds:.2g}", what, f"{100 * row.best.error:.2g}",
                      f"{row.best.seconds:.2g}",
                      f"{ratio:.2g}" if row.as_exact else ""))  # fmt: skip
    return TEXT.format(
        increments=f"{INCREMENTS[0]} to {INCREMENTS[-1]}", longest=2 * LONGEST,
        table=markdown(head, lines), median=float(np.median(ratios)),
        count=len(ratios), rows=len(rows),
    )  # fmt: skip


def kept() -> list[Row]:
    rows = json.loads(KEPT.read_text(encoding="utf-8"))
    return [Row(case, asked, Solved(*a), Solved(*b), exact) for case, asked, a, b, exact in rows]


def main(given: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.accuracy_cost")
    parser.add_argument("--quick", action="store_true", help="one case to 5 %% only")
    parser.add_argument("--case", action="append", choices=CASES, help="only these, keep the rest")
    parser.add_argument("--docs", action="store_true", help=f"write {PAGE.relative_to(ROOT)}")
    options = parser.parse_args(given)
    if os.environ.get("OMP_NUM_THREADS") != "1":
        parser.error("times are of one thread: set OMP_NUM_THREADS=1")
    if options.quick:
        print(page(list(measured(NAMES[:1], ASKED[:1]))))
        return 0
    names = tuple(options.case or NAMES)
    rows = [row for row in kept() if row.case not in names]
    for row in measured(names, ASKED):
        print(row, flush=True)
        rows.append(row)
    if options.docs:
        KEPT.write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
        PAGE.write_text(page(rows), encoding="utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
