# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.accuracy: page on the errors stated by samcontact and the true errors.

The true error follows from a closed form, or from a much finer run.
"""

from __future__ import annotations

import time
from typing import NamedTuple
from unittest import mock

import numpy as np

import samcontact as sc
from reference import fem

from . import accuracy_uses
from .accuracy_cases import CASES, closed_form
from .accuracy_uses import USES
from .study import Record, Study, table
from .truth import MAX_SOLVE_SECONDS, known

ACCURACIES = (0.05, 0.01, 0.002)
MAX_SECONDS = 25.0  # limit of the processor time of a run [s]
SLOW_CASES = ("V1, diamond tip", "2d, rigid on perfectly plastic", "F2, friction 0.25",
         "R2, two passes", "rolling along the short axis, 1:2",
         "rolling along the long axis, 2:1")  # fmt: skip
QUICK_CASES = ("balls, 1500 N", "semi-axes 1:4", "T1, 600 N")
SHORT_NAMES = {"max_von_mises": "von Mises", "max_equivalent_plastic_strain": "plastic strain",
        "max_residual_von_mises": "residual von Mises", "max_pressure": "pressure",
        "contact_area": "area", "imprint_depth": "imprint depth"}  # fmt: skip
CASE_2D = "2d, rigid on perfectly plastic"
FINITE_ELEMENT_ERRORS = {"approach": 0.002, "max_pressure": 0.005, "max_von_mises": 0.01,
        "max_equivalent_plastic_strain": 0.01, "max_residual_von_mises": 0.02,
        "imprint_depth": 0.02}  # fmt: skip
"""Relative errors of the finite element results, from `reference/fem/README.md`; not for 2d."""
FINITE_ELEMENT_ERROR_2D = 0.04
TEXT = """<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by: python -m benchmarks.accuracy --docs -->
# Reliability of the estimated errors

This page shows how often the true error of a result exceeds the error estimated by samcontact (the
stated error). `samcontact.to_accuracy`, or `accuracy` in a case file, solves a contact to a
prescribed accuracy and returns results with stated errors ([how errors are
estimated](theory/accuracy.md#solution-to-an-accuracy)).

{cases} contacts are solved to accuracies of 5, 1 and 0.2 %, and the stated errors are compared with
the true errors. The true error is the difference from a reference. For pressure, approach and area
of elastic paraboloids, the reference is Hertz's solution. For all other values, the reference is
extrapolated in two ways: with order 2 in the cell size, from the finest grids that can be solved in
about {finest:.0f} s; and with orders 1 and 2 in the number of increments, from solutions on a
coarser grid with up to 32 or, for some contacts, 64 increments. For rolling contacts this reference
is hardly more accurate than the values that are compared with it. [Finite element
solutions](#comparison-of-the-reference-with-finite-elements) of three of the cases agree with the
reference to within the accuracy of the finite elements.

The time limit of a run is {longest:.0f} s. Runs that cannot reach the accuracy within this time are
marked "not reached"; their values have stated errors too. The constants of the error estimate were
calibrated with these contacts, except for the following {new}: {later}.

{summary}

A value is covered if its true error does not exceed its stated error. The fourth column is the
maximum of the ratio of true to stated error; the fifth column is the median of the inverse ratio,
stated to true error. The next table gives the time of each run, summed over all its grids, and the
number of surface cells of the finest grid. The times were measured on one processor of a machine
that also did other work.

{costs}

## Partial slip, periodic and rough surfaces, wear, shakedown, fatigue

These cases were not used to calibrate the error estimate. The reference is a closed form (Hertz;
Cattaneo and Mindlin for bodies with Poisson's ratio 0; half the von Mises stress for the amplitude
of Crossland's criterion), or a solution of the same program to an accuracy of {finer:g} %, whose
own error limits the comparison. The heights of the rough surface are given at samples, and the
errors refer to the surface that is interpolated between the samples.

{uses}

## Comparison of the reference with finite elements

All values are in SI units. The axisymmetric finite-element results are in `reference/fem`; the
README file in this folder states their accuracy. At the highest loads of case 2d, an accurate
residual stress needs finer grids than the time limit of a run permits. For case 2d, an earlier
increment of the finite-element curve is therefore compared.

{elements}

## Errors of each quantity

The tables give true and stated errors [%], relative to the maximum value in the run.

{tables}
"""


class Judged(NamedTuple):
    """True error and error stated by samcontact for one quantity at one prescribed accuracy."""

    case: str
    accuracy: float
    quantity: str
    stated: float
    true: float
    seconds: float
    cells: int
    reached: bool


def judged(name: str, truth: dict[str, float], accuracy: float) -> Record:
    """Return the stated and the true relative errors of the non-zero quantities of a case.

    The time is processor time.
    """
    start = time.process_time()
    with mock.patch.object(time, "perf_counter", time.process_time):
        case = (CASES | USES)[name]
        found = sc.to_accuracy(case, accuracy, max_time=MAX_SECONDS, progress=False)
    seconds = time.process_time() - start
    exact = {key: value for key, value in truth.items() if value != 0 and key in found.values}
    return {
        "seconds": _short(seconds),
        "cells": found.grid.nx * found.grid.ny,
        "reached": found.reached,
        "stated": {key: _short(found.errors[key] / abs(exact[key])) for key in exact},
        "true": {
            key: _short(_beyond_rounding(found.values[key] / exact[key] - 1)) for key in exact
        },
    }


def _short(value: float) -> float:
    return float(f"{value:.3g}")


def _beyond_rounding(difference: float) -> float:
    """Return the absolute difference; zero if it is a rounding error, as for prescribed values."""
    return abs(difference) if abs(difference) > 1e-9 else 0.0


def points(quick: bool) -> list[Record]:
    return [
        {"of": name, "accuracy": accuracy}
        for name in (QUICK_CASES if quick else CASES)
        for accuracy in ACCURACIES
    ] + [
        {"of": name, "accuracy": accuracy}
        for name in (() if quick else USES)
        for accuracy in accuracy_uses.ACCURACIES
    ]


def run(of: str, accuracy: float) -> Record:
    return judged(of, accuracy_uses.reference(of) if of in USES else known()[of], accuracy)


def quantities(records: list[Record]) -> list[Judged]:
    """Return the stated and true errors of all quantities in all records."""
    return [
        Judged(record["of"], record["accuracy"], quantity, record["stated"][quantity], true,
               record["seconds"], record["cells"], record["reached"])
        for record in records for quantity, true in record["true"].items()
    ]  # fmt: skip


def summary(rows: list[Judged]) -> str:
    head = ("accuracy [%]", "values", "covered [%]", "maximum true / stated",
            "median stated / true", "reached")  # fmt: skip
    lines = []
    for accuracy in ACCURACIES:
        mine = [row for row in rows if row.accuracy == accuracy]
        ratio = np.array([row.true / max(row.stated, 1e-16) for row in mine])
        median = 1 / np.median(ratio[ratio > 0])
        reached = {row.case: row.reached for row in mine}
        lines.append((f"{100 * accuracy:g}", str(len(mine)), f"{100 * np.mean(ratio <= 1):.1f}",
                      f"{ratio.max():.2f}", f"{median:.1f}",
                      f"{sum(reached.values())} of {len(reached)} cases"))  # fmt: skip
    return table(head, lines)


def costs(rows: list[Judged]) -> str:
    """Return the table of times and of numbers of surface cells on the finest grid."""
    head = "case", "reference", *(f"to {100 * accuracy:g} %" for accuracy in ACCURACIES)
    by = {name: "finer grids, and finite elements" for name in elements_of()}
    by |= {name: "Hertz" for name, case in CASES.items() if closed_form(case)}
    lines = []
    for name in dict.fromkeys(row.case for row in rows):
        texts = []
        for accuracy in ACCURACIES:
            mine = [row for row in rows if (row.case, row.accuracy) == (name, accuracy)]
            side = round(mine[0].cells ** 0.5)
            beyond = "" if mine[0].reached else ", not reached"
            texts.append(f"{mine[0].seconds:.2g} s, about {side}² cells{beyond}")
        lines.append((name, by.get(name, "finer grids"), *texts))
    return table(head, lines)


def elements() -> str:
    """Return the table of reference values and finite element values of three cases."""
    head = ("case", "quantity", "finite elements", "reference", "difference [%]",
            "accuracy of finite elements [%]")  # fmt: skip
    truth = known()
    lines = []
    for name, found in elements_of().items():
        for quantity, value in found.items():
            here = truth[name][quantity]
            good = (
                FINITE_ELEMENT_ERROR_2D
                if name == CASE_2D
                else FINITE_ELEMENT_ERRORS[quantity.partition("_body")[0]]
            )
            lines.append((name, _words(quantity), f"{value:.5g}", f"{here:.5g}",
                          f"{100 * (here / value - 1):+.2g}", f"{100 * good:.2g}"))  # fmt: skip
    return table(head, lines)


def elements_of() -> dict[str, dict[str, float]]:
    """Return the finite element values [SI units]; stress and strain are largest on the axis."""
    found: dict[str, dict[str, float]] = {}
    for key, name in (("2b1500", "T1, 1500 N"), ("2a", "2a, rigid on M50")):
        summary = fem.load(key).summary
        loaded, unloaded = summary["loaded"], summary["unloaded"]
        found[name] = {
            "approach": summary["approach_max_m"],
            "max_pressure": summary["p_max_Pa"],
            "max_von_mises_body2": loaded["max_vm_Pa"],
            "max_equivalent_plastic_strain_body2": loaded["max_gamma_p"],
            "max_residual_von_mises_body2": unloaded["max_vm_Pa"],
            "imprint_depth_body2": summary["uz_center_residual_m"],
        }
    curve = fem.load("2d").load_displacement
    (at,) = np.flatnonzero(np.isclose(curve["load_N"][: curve["load_N"].argmax()],
                                      CASES[CASE_2D]["path"][0]["load"], rtol=1e-6))  # fmt: skip
    found[CASE_2D] = {
        "approach": float(curve["approach_m"][at]),
        "max_pressure": float(curve["p_max_Pa"][at]),
        "max_equivalent_plastic_strain_body2": float(curve["gamma_p_max"][at]),
    }
    return found


def uses(rows: list[Judged]) -> str:
    """Return the table of true and stated errors of the uses beyond a single contact."""
    head = ("use", "reference", "accuracy [%]", "quantity", "true / stated error [%]",
            "surface cells, reached")  # fmt: skip
    lines = []
    for row in rows:
        known_by = "closed form" if accuracy_uses.closed_form(row.case) else "finer grids"
        reached = "yes" if row.reached else "no"
        lines.append((row.case, known_by, f"{100 * row.accuracy:g}", _words(row.quantity),
                      f"{100 * row.true:.2g} / {100 * row.stated:.2g}",
                      f"about {round(row.cells**0.5)}², {reached}"))  # fmt: skip
    return table(head, lines)


def errors(rows: list[Judged], name: str) -> str:
    """Return the table of true and stated errors of a case, with one column per quantity."""
    mine = [row for row in rows if row.case == name]
    shown = list(dict.fromkeys(row.quantity for row in mine))
    head = "accuracy [%]", *(_words(quantity) for quantity in shown)
    lines = []
    for accuracy in ACCURACIES:
        found = {row.quantity: row for row in mine if row.accuracy == accuracy}
        texts = [f"{100 * found[q].true:.2g} / {100 * found[q].stated:.2g}" for q in shown]
        lines.append((f"{100 * accuracy:g}", *texts))
    return f"**{name}** (true / stated)\n\n{table(head, lines)}"


def _words(quantity: str) -> str:
    kind, _, body = quantity.partition("_body")
    return SHORT_NAMES.get(kind, kind) + (f", body {body}" if body else "")


def page(records: list[Record]) -> str:
    rows = quantities([record for record in records if record["of"] in CASES])
    others = quantities([record for record in records if record["of"] in USES])
    names = list(dict.fromkeys(row.case for row in rows))
    return TEXT.format(
        cases=len(names), finest=MAX_SOLVE_SECONDS, longest=MAX_SECONDS,
        new=len(SLOW_CASES), later="; ".join(SLOW_CASES),
        summary=summary(rows), costs=costs(rows), elements=elements(),
        uses=uses(others), finer=100 * accuracy_uses.REFERENCE_ACCURACY,
        tables="\n\n".join(errors(rows, name) for name in names),
    )  # fmt: skip


STUDY = Study("accuracy", "Stated and true errors.", points, run, page, lasting=True)

if __name__ == "__main__":
    STUDY.main()
