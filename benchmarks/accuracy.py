# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.accuracy: stated errors against true ones, as a page of the docs.

Contacts with a closed form, and others whose truth is a run that is much finer.
"""

from __future__ import annotations

import argparse
import csv
import itertools
import json
import os
import sys
import time
import warnings
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

import samcontact as sc
from samcontact.accuracy import Refinable
from samcontact.cases import Case as SectionsOfCase

from .accuracy_cases import CASES, Case, closed_form
from .harness import ROOT
from .resolution import markdown

PAGE = ROOT / "docs" / "accuracy.md"
ASKED = (0.05, 0.01, 0.002)
TRUTH = Path(__file__).with_name("accuracy.csv")
FINEST, LONGEST = 35.0, 25.0  # s for the truth, and for a run that is judged
INCREMENTS = (4, 8, 16, 32, 64)  # of a segment, for the truth
QUICK = ("balls, 1500 N", "semi-axes 1:4", "T1, 600 N")
LONG = {"max_von_mises": "von Mises", "max_equivalent_plastic_strain": "strain",
        "max_residual_von_mises": "residual", "max_pressure": "pressure",
        "contact_area": "area", "print_depth": "print"}  # fmt: skip
TEXT = """<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by: python -m benchmarks.accuracy --docs -->
# What stated errors are worth

`samcontact.to_accuracy`, or `accuracy` in a case file, gives values with errors
([how](theory.md#accuracy)). Here {cases} contacts are asked for to 5, 1 and 0.2 %, and the stated
errors compared with the true ones. The truth is Hertz for pressure, approach and area of elastic
paraboloids; else that to which the finest grids of about {finest:.0f} s extrapolate with
order 2, and 64 increments with orders 1 and 2. For the rolling ball that is hardly better than
what is judged. No run may take more than {longest:.0f} s: "not reached" are those that would;
they still state their errors. The constants of the estimate were chosen with these same contacts.

{summary}

A value is covered when its true error is below the stated one. Times are those of all grids of a
run, in one thread on a machine that had other work; cells are those of the finest surface.

{costs}

## Each quantity

True and stated errors relative to the largest value of the run [%].

{tables}
"""


Values = NDArray[np.float64]


class Judged(NamedTuple):
    """A quantity of a case, at an accuracy."""

    case: str
    asked: float
    quantity: str
    stated: float
    true: float
    seconds: float
    cells: int
    reached: bool


def finest(case: Case, seconds: float = FINEST) -> dict[str, float]:
    """The best values that can be had in some time, with one order for all; closed forms of some.

    Four increments a segment on all grids, corrected by many more on a coarse one.
    """
    scene = Refinable(SectionsOfCase.model_validate({"title": "truth", "accuracy": 0.1, **case}))
    used, most = (INCREMENTS[0], INCREMENTS[-1]) if scene.has_history else (1, 1)
    start = time.perf_counter()
    runs = [scene.run(0, used)]
    scene.settle(runs[0])
    while time.perf_counter() - start + 4 * runs[-1].seconds < seconds or len(runs) < 4:
        runs[-1].states = []
        runs.append(scene.run(len(runs), used))
    coarse = [scene.run(1, n).values for n in INCREMENTS if n <= most]
    return extrapolated(scene.names, scene.parts, [run.values for run in runs], coarse) | {
        name: value for name, value in closed_form(case).items() if name in scene.names
    }


def extrapolated(
    names: list[str], parts: list[int], grids: list[Values], coarse: list[Values]
) -> dict[str, float]:
    """With order 2 of the cells, and orders 1 and 2 of the increments."""
    change = (grids[-1] - grids[-3]) / 3
    # a thin layer at the surface that no grid shows yet is no largest value
    values = grids[-1] + np.where(np.abs(change) < 0.05 * np.abs(grids[-1]), change, 0.0)
    if len(coarse) > 1:
        first = [2 * fine - wide for wide, fine in itertools.pairwise(coarse)]
        values = values + (4 * first[-1] - first[-2]) / 3 - coarse[0]
    ends = np.cumsum(parts)
    largest = [
        float(np.abs(values[:, end - n : end]).max()) for n, end in zip(parts, ends, strict=True)
    ]
    return dict(zip(names, largest, strict=True))


def judged(name: str, truth: dict[str, float], asked: float) -> list[Judged]:
    """The quantities of a case; those that are nothing are left out."""
    start = time.perf_counter()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = sc.to_accuracy(CASES[name], asked, max_time=LONGEST)
    seconds = time.perf_counter() - start
    cells = found.grid.nx * found.grid.ny
    return [
        Judged(name, asked, quantity, found.errors[quantity] / abs(exact),
               _beyond_rounding(found.values[quantity] / exact - 1), seconds, cells, found.reached)
        for quantity, exact in truth.items() if exact != 0 and quantity in found.values
    ]  # fmt: skip


def stored() -> dict[str, dict[str, float]]:
    """The truth by case and quantity."""
    found: dict[str, dict[str, float]] = {}
    with TRUTH.open(encoding="utf-8", newline="") as file:
        for case, quantity, value in csv.reader(file):
            found.setdefault(case, {})[quantity] = float(value)
    return found


def store(names: tuple[str, ...]) -> None:
    with TRUTH.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        for name in names:
            print(name, flush=True)
            writer.writerows((name, *item) for item in finest(CASES[name]).items())


def _beyond_rounding(difference: float) -> float:
    """Of what is given, which has no error."""
    return abs(difference) if abs(difference) > 1e-9 else 0.0


def measured(names: tuple[str, ...], kept: Path | None = None) -> list[Judged]:
    """Of these cases; what is kept in a file is not measured again."""
    done: list[Any] = []
    if kept is not None and kept.exists():
        done = json.loads(kept.read_text(encoding="utf-8"))
    rows = [Judged(*row) for row in done]
    truth = stored()
    for name in names:
        if any(row.case == name for row in rows):
            continue
        for asked in ASKED:
            mine = judged(name, truth[name], asked)
            rows += mine
            worst = max((row.true / max(row.stated, 1e-300) for row in mine), default=0.0)
            told = f"{mine[0].seconds:.2f} s, worst true/stated {worst:.2f}"
            print(f"{name}, {asked}: {told}", flush=True)
        if kept is not None:
            kept.write_text(json.dumps(rows), encoding="utf-8")
    return rows


def summary(rows: list[Judged]) -> str:
    head = ("asked [%]", "values", "covered [%]", "worst true over stated",
            "median stated over true", "reached")  # fmt: skip
    lines = []
    for asked in ASKED:
        mine = [row for row in rows if row.asked == asked]
        ratio = np.array([row.true / max(row.stated, 1e-16) for row in mine])
        median = 1 / np.median(ratio[ratio > 0])
        reached = {row.case: row.reached for row in mine}
        lines.append((f"{100 * asked:g}", str(len(mine)), f"{100 * np.mean(ratio <= 1):.1f}",
                      f"{ratio.max():.2f}", f"{median:.1f}",
                      f"{sum(reached.values())} of {len(reached)} cases"))  # fmt: skip
    return markdown(head, lines)


def costs(rows: list[Judged]) -> str:
    """Time and cells of the finest surface."""
    head = "case", *(f"to {100 * asked:g} %" for asked in ASKED)
    lines = []
    for name in dict.fromkeys(row.case for row in rows):
        texts = []
        for asked in ASKED:
            mine = [row for row in rows if (row.case, row.asked) == (name, asked)]
            side = round(mine[0].cells ** 0.5)
            beyond = "" if mine[0].reached else ", not reached"
            texts.append(f"{mine[0].seconds:.2g} s, about {side}² cells{beyond}")
        lines.append((name, *texts))
    return markdown(head, lines)


def table(rows: list[Judged], name: str) -> str:
    """True and stated errors of a case, a column for each quantity."""
    mine = [row for row in rows if row.case == name]
    quantities = list(dict.fromkeys(row.quantity for row in mine))
    head = "asked", *(_short(quantity) for quantity in quantities)
    lines = []
    for asked in ASKED:
        found = {row.quantity: row for row in mine if row.asked == asked}
        texts = [f"{100 * found[q].true:.2g} / {100 * found[q].stated:.2g}" for q in quantities]
        lines.append((f"{100 * asked:g}", *texts))
    return f"**{name}** (true / stated)\n\n{markdown(head, lines)}"


def _short(quantity: str) -> str:
    kind, _, body = quantity.partition("_body")
    return " ".join([LONG.get(kind, kind), *([body] if body else [])])


def page(rows: list[Judged]) -> str:
    names = list(dict.fromkeys(row.case for row in rows))
    return TEXT.format(
        cases=len(names), finest=FINEST, longest=LONGEST,
        summary=summary(rows), costs=costs(rows),
        tables="\n\n".join(table(rows, name) for name in names),
    )  # fmt: skip


def main(given: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.accuracy")
    parser.add_argument("--quick", action="store_true", help="three cases only")
    parser.add_argument("--docs", action="store_true", help=f"write {PAGE.relative_to(ROOT)}")
    parser.add_argument("--truth", action="store_true", help=f"write {TRUTH.relative_to(ROOT)}")
    parser.add_argument("--keep", type=Path, help="file of what is measured, to go on from")
    chosen = parser.parse_args(given)
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    if chosen.truth:
        store(tuple(CASES))
    rows = measured(QUICK if chosen.quick else tuple(CASES), chosen.keep)
    if chosen.docs:
        PAGE.write_text(page(rows), encoding="utf-8")
    else:
        print(page(rows))
    return 0


if __name__ == "__main__":
    sys.exit(main())
