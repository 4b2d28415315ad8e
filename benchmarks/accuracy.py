# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.accuracy: stated errors against true ones, as a page of the docs.

Contacts with a closed form, and others whose truth is a run that is much finer.
"""

from __future__ import annotations

import argparse
import csv
import itertools
import os
import sys
import time
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple
from unittest import mock

import numpy as np
from numpy.typing import NDArray

import samcontact as sc
from reference import fem
from samcontact.accuracy import Refinable
from samcontact.cases import Case as SectionsOfCase

from .accuracy_cases import CASES, Case, closed_form
from .harness import ROOT
from .resolution import markdown

PAGE = ROOT / "docs" / "accuracy.md"
ASKED = (0.05, 0.01, 0.002)
TRUTH = Path(__file__).with_name("accuracy.csv")
MEASURED = Path(__file__).with_name("accuracy_measured.csv")
FINEST, LONGEST = 35.0, 25.0  # s of a processor for the truth, and for a run that is judged
INCREMENTS = (4, 8, 16, 32)  # of a segment, for the truth
INCREMENTS_ON = 3  # the grid of these
FINER_INCREMENTS = {
    "F2, 5000 N": (3, (8, 16, 32, 64)),
    "given approach": (3, (16, 32, 64)),
    "V1, rigid tip": (6, (4, 8, 16)),
}
"""Where what more increments than four change is large, or depends on the grid: on which, and how
many. Of the rigid tip the residual stress at the rim: it falls by 5 % on grid 3, by 1 % on 6."""
LATER = ("V1, diamond tip", "2d, rigid on perfectly plastic", "F2, friction 0.25",
         "R2, two passes", "rolling along the short axis, 1:2",
         "rolling along the long axis, 2:1")  # fmt: skip
QUICK = ("balls, 1500 N", "semi-axes 1:4", "T1, 600 N")
LONG = {"max_von_mises": "von Mises", "max_equivalent_plastic_strain": "strain",
        "max_residual_von_mises": "residual", "max_pressure": "pressure",
        "contact_area": "area", "print_depth": "print"}  # fmt: skip
SCENE_2D = "2d, rigid on perfectly plastic"
GOOD = {"approach": 0.002, "max_pressure": 0.005, "max_von_mises": 0.01,
        "max_equivalent_plastic_strain": 0.01, "max_residual_von_mises": 0.02,
        "print_depth": 0.02}  # fmt: skip
"""What finite elements can be relied on for, from their page; and of 2d."""
GOOD_OF_2D = 0.04
TEXT = """<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by: python -m benchmarks.accuracy --docs -->
# What stated errors are worth

`samcontact.to_accuracy`, or `accuracy` in a case file, gives values with errors
([how](theory.md#accuracy)). Here {cases} contacts are asked for to 5, 1 and 0.2 %, and the stated
errors compared with the true ones. The truth is Hertz for pressure, approach and area of elastic
paraboloids; else that to which the finest grids of about {finest:.0f} s extrapolate with order 2,
and 32 or 64 increments on a coarser grid with orders 1 and 2. For what rolls that is hardly better
than what is judged. [Finite elements](#the-truth-against-finite-elements) of three of the scenes
agree with it as well as they are known. No run may take more than {longest:.0f} s: "not reached"
are those that would; they still state their errors. The constants of the estimate were chosen
with these contacts but for {new}: {later}.

{summary}

A value is covered when its true error is below the stated one.
Times are those of all grids of a run, of one processor, of a machine that had other work. Cells are
those of the finest surface.

{costs}

## The truth against finite elements

In SI units; axisymmetric curves in `reference/fem`, whose page says what they can be relied on
for. Those of 2d go on to loads whose residual stress takes finer grids than a run here may have, so
that the contact here is one of its earlier increments.

{elements}

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


@contextmanager
def processor_time() -> Iterator[None]:
    """Time that is taken is that of one processor, whatever else the machine does."""
    with mock.patch.object(time, "perf_counter", time.process_time):
        yield


def finest(
    case: Case,
    seconds: float = FINEST,
    grid: int = INCREMENTS_ON,
    increments: tuple[int, ...] = INCREMENTS,
) -> dict[str, float]:
    """The best values that can be had in some time, with one order for all; closed forms of some.

    The fewest increments a segment on all grids, corrected by more of them on one of these.
    """
    scene = Refinable(SectionsOfCase.model_validate({"title": "truth", "accuracy": 0.1, **case}))
    counts = increments if scene.has_history else (1,)
    start = time.perf_counter()
    runs = [scene.run(0, counts[0])]
    scene.settle(runs[0])
    while time.perf_counter() - start + 4 * runs[-1].seconds < seconds or len(runs) < 4:
        runs[-1].solved = None
        runs.append(scene.run(len(runs), counts[0]))
    coarse = [scene.run(grid, n).values for n in counts]
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
        found = sc.to_accuracy(CASES[name], asked, max_time=LONGEST, progress=False)
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
    """The truth of these cases, beside that of the others."""
    truth = stored()
    for name in names:
        print(name, flush=True)
        with processor_time():
            more = FINER_INCREMENTS.get(name, (INCREMENTS_ON, INCREMENTS))
            truth[name] = finest(CASES[name], FINEST, *more)
        with TRUTH.open("w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            for case in CASES:
                writer.writerows((case, *item) for item in truth.get(case, {}).items())


def _beyond_rounding(difference: float) -> float:
    """Of what is given, which has no error."""
    return abs(difference) if abs(difference) > 1e-9 else 0.0


def measure(names: tuple[str, ...]) -> None:
    """Judge these cases, and keep the rows beside those of the others."""
    truth = stored()
    for name in names:
        rows: list[Judged] = []
        for asked in ASKED:
            with processor_time():
                mine = judged(name, truth[name], asked)
            rows += mine
            worst = max((row.true / max(row.stated, 1e-300) for row in mine), default=0.0)
            told = f"{mine[0].seconds:.2f} s, worst true/stated {worst:.2f}"
            print(f"{name}, {asked}: {told}", flush=True)
        kept = [row for row in measured() if row.case != name] + rows
        with MEASURED.open("w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            for case in CASES:
                writer.writerows(
                    (row.case, row.asked, row.quantity, f"{row.stated:.3g}", f"{row.true:.3g}",
                     f"{row.seconds:.3g}", row.cells, int(row.reached))
                    for row in kept if row.case == case
                )  # fmt: skip


def measured() -> list[Judged]:
    """The rows of all cases that were judged."""
    with MEASURED.open(encoding="utf-8", newline="") as file:
        return [
            Judged(case, float(asked), quantity, float(stated), float(true), float(seconds),
                   int(cells), reached == "1")
            for case, asked, quantity, stated, true, seconds, cells, reached in csv.reader(file)
        ]  # fmt: skip


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
    head = "case", "truth", *(f"to {100 * asked:g} %" for asked in ASKED)
    known = {name: "finer grids, as finite elements" for name in elements_of()}
    known |= {name: "Hertz" for name, case in CASES.items() if closed_form(case)}
    lines = []
    for name in dict.fromkeys(row.case for row in rows):
        texts = []
        for asked in ASKED:
            mine = [row for row in rows if (row.case, row.asked) == (name, asked)]
            side = round(mine[0].cells ** 0.5)
            beyond = "" if mine[0].reached else ", not reached"
            texts.append(f"{mine[0].seconds:.2g} s, about {side}² cells{beyond}")
        lines.append((name, known.get(name, "finer grids"), *texts))
    return markdown(head, lines)


def elements() -> str:
    """The truth of scenes of which there are finite elements, beside these."""
    head = ("case", "quantity", "finite elements", "truth here", "difference [%]",
            "finite elements are good to [%]")  # fmt: skip
    truth = stored()
    lines = []
    for name, known in elements_of().items():
        for quantity, value in known.items():
            here = truth[name][quantity]
            good = GOOD_OF_2D if name == SCENE_2D else GOOD[quantity.partition("_body")[0]]
            lines.append((name, _short(quantity), f"{value:.5g}", f"{here:.5g}",
                          f"{100 * (here / value - 1):+.2g}", f"{100 * good:.2g}"))  # fmt: skip
    return markdown(head, lines)


def elements_of() -> dict[str, dict[str, float]]:
    """What finite elements give, in SI units; of the axis, where stress and strain are largest."""
    found: dict[str, dict[str, float]] = {}
    for scene, name in (("2b1500", "T1, 1500 N"), ("2a", "2a, rigid on M50")):
        summary = fem.load(scene).summary
        loaded, unloaded = summary["loaded"], summary["unloaded"]
        found[name] = {
            "approach": summary["approach_max_m"],
            "max_pressure": summary["p_max_Pa"],
            "max_von_mises_body2": loaded["max_vm_Pa"],
            "max_equivalent_plastic_strain_body2": loaded["max_gamma_p"],
            "max_residual_von_mises_body2": unloaded["max_vm_Pa"],
            "print_depth_body2": summary["uz_center_residual_m"],
        }
    curve = fem.load("2d").load_displacement
    (at,) = np.flatnonzero(np.isclose(curve["load_N"][: curve["load_N"].argmax()],
                                      CASES[SCENE_2D]["path"][0]["load"], rtol=1e-6))  # fmt: skip
    found[SCENE_2D] = {
        "approach": float(curve["approach_m"][at]),
        "max_pressure": float(curve["p_max_Pa"][at]),
        "max_equivalent_plastic_strain_body2": float(curve["gamma_p_max"][at]),
    }
    return found


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
        new=len(LATER), later="; ".join(LATER),
        summary=summary(rows), costs=costs(rows), elements=elements(),
        tables="\n\n".join(table(rows, name) for name in names),
    )  # fmt: skip


def main(given: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.accuracy")
    parser.add_argument("cases", nargs="*", metavar="CASE", help="default: all, of which it takes "
                        "about an hour")  # fmt: skip
    parser.add_argument("--quick", action="store_true", help="three cases only")
    parser.add_argument("--truth", action="store_true", help=f"write {TRUTH.name} of these cases")
    text = f"write {PAGE.relative_to(ROOT)} from what is measured, and no more"
    parser.add_argument("--docs", action="store_true", help=text)
    chosen = parser.parse_args(given)
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    names = QUICK if chosen.quick else tuple(chosen.cases or CASES)
    if unknown := [name for name in names if name not in CASES]:
        parser.error(f"{unknown[0]!r} is none of {', '.join(CASES)}")
    if chosen.docs:
        PAGE.write_text(page(measured()), encoding="utf-8")
    elif chosen.truth:
        store(names)
    else:
        measure(names)
    return 0


if __name__ == "__main__":
    sys.exit(main())
