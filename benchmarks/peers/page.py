# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of docs/peers.md from stored measurements: ratios of times at equal error."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from ..harness import ROOT
from ..study import table_of
from ..tables import between_markers, cell
from .problems import PLASTIC
from .running import MAX_CELLS, tight

PAGE = ROOT / "docs" / "peers.md"
OURS = "samcontact"
# The errors at which times are compared.
ELASTIC = ("hertz", "rough", "periodic")
MEASURE = dict.fromkeys(ELASTIC, "pressure") | dict.fromkeys(PLASTIC, "plastic strain")
MEASURE["slip"] = "shear"
TARGETS = dict.fromkeys(ELASTIC, (1e-4, 1e-6, 1e-8)) | dict.fromkeys(PLASTIC, (1e-2, 1e-3, 1e-4))
TARGETS["slip"] = (1e-1, 1e-2, 1e-4)
COUNTED_AT = dict.fromkeys(ELASTIC, 1e-6) | dict.fromkeys(PLASTIC, 1e-3)
COUNTED_AT["slip"] = 1e-2
TITLES = {
    "hertz": "Hertz contact",
    "rough": "Elastic rough contact",
    "plastic": "Elastic-plastic contact",
    "stress": "Stress under a Hertz pressure",
    "periodic": "Periodic rough contact",
    "periodic_plastic": "Periodic elastic-plastic contact",
    "slip": "Partial slip",
}
KINDS = {
    "hertz": "elastic contact",
    "rough": "elastic contact",
    "plastic": "elastic-plastic contact",
    "periodic": "periodic elastic contact",
    "periodic_plastic": "periodic elastic-plastic contact",
    "slip": "partial slip",
}
PERIODIC = ("periodic", "periodic_plastic")
FINE_PRESSURE, FINE_AREA = "pressure, finest", "contact area, finest"
TIMES = {"with_setup_s": "with set-up", "without_setup_s": "without set-up"}

Place = tuple[str, str, int]
Ladder = dict[float, list[dict[str, Any]]]
"""Successful rounds of one code on one problem, by tolerance."""


def by_place(data: dict[str, Any]) -> dict[Place, dict[str, Ladder]]:
    """Return the measurements by place (problem, case, size), and for each place by code."""
    places: dict[Place, dict[str, Ladder]] = {}
    for key, rounds in data["rows"].items():
        problem, case, n, code, tol = key.split("|")
        codes = places.setdefault((problem, case, int(n)), {})
        worked = [row for row in rounds if "failed" not in row]
        if worked and row_counts(problem, float(tol)):
            codes.setdefault(code, {})[float(tol)] = worked
    order = list(TITLES)
    return dict(sorted(places.items(), key=lambda item: (order.index(item[0][0]), item[0][1:])))


def row_counts(problem: str, tol: float) -> bool:
    """Whether a row is a measurement; references, whose error is zero, are not measurements."""
    return tol not in tight(problem).values()


def points(ladder: Ladder, measure: str, time: str) -> list[tuple[float, float]]:
    """Return error and minimum time of the rounds for each tolerance, loosest tolerance first."""
    return [
        (rounds[0]["errors"][measure], min(row[time] for row in rounds))
        for _, rounds in sorted(ladder.items(), reverse=True)
        if rounds[0]["errors"].get(measure)
    ]


def time_at(curve: list[tuple[float, float]], error: float) -> float | None:
    """Return the time to reach an error, interpolated in logarithms between two tolerances.

    If the loosest tolerance reaches the error, its time is returned; None if no tolerance does.
    """
    reached = [i for i, (found, _) in enumerate(curve) if found <= error]
    if not reached:
        return None
    i = reached[0]
    if i == 0:
        return curve[0][1]
    (high, before), (low, after) = curve[i - 1], curve[i]
    part = np.log(high / error) / np.log(high / low)
    return float(np.exp(np.log(before) + part * np.log(after / before)))


def ratio_at(
    codes: dict[str, Ladder], code: str, measure: str, time: str, error: float
) -> float | None:
    """Return the time of a code divided by the time of samcontact at equal error."""
    ours, other = (time_at(points(codes[name], measure, time), error) for name in (OURS, code))
    return other / ours if ours and other else None


def row_at(ladder: Ladder, measure: str, error: float) -> dict[str, Any] | None:
    """Return the run of the loosest tolerance with at most this error; None if there is none."""
    for tol in sorted(ladder, reverse=True):
        if ladder[tol][0]["errors"].get(measure, np.inf) <= error:
            return ladder[tol][0]
    return None


def table(lines: list[dict[str, Any]]) -> str:
    """Return the Markdown table of rows, given as dictionaries with equal keys."""
    return table_of([{name: "" if value is None else cell(value) for name, value in line.items()}
                     for line in lines])  # fmt: skip


def where(place: Place, codes: dict[str, Ladder]) -> str:
    """Return the name of a case in a table, with its contact fraction; "one" for a single case."""
    _, case, _ = place
    row = next(iter(codes[OURS].values()))[0]
    return f"{case}, {100 * row['contact_fraction']:.2g} %" if case else "one"


def solver_lines(problem: str, data: dict[str, Any]) -> Iterator[dict[str, Any]]:
    measure = MEASURE[problem]
    for place, codes in by_place(data).items():
        if place[0] != problem or OURS not in codes:
            continue
        for code, ladder in codes.items():
            ratios = {
                f"{name}, {error:.0e}".replace("e-0", "e-"): ratio_at(
                    codes, code, measure, time, error
                )
                for time, name in times_of(problem).items()
                for error in TARGETS[problem]
            }
            if not any(ratios.values()):
                continue  # the code, or samcontact, does not reach this error
            line: dict[str, Any] = {
                "case, area in contact": where(place, codes),
                "cells": f"{place[2]}²",
            }
            if not place[1]:
                del line["case, area in contact"]
            line.update(code=code, **ratios)
            best = row_at(ladder, measure, COUNTED_AT[problem])
            line["memory_MB"] = best and best["memory_MB"]
            line["iterations"] = best and best["counts"].get("iterations")
            line["applications"] = best and best["counts"].get("applications")
            yield line


def times_of(problem: str) -> dict[str, str]:
    """Return the kinds of time measured; with plastic flow, only the time with set-up."""
    return {"with_setup_s": "with set-up"} if problem in PLASTIC else TIMES


def converged(
    target_problem: str, data: dict[str, Any], case: str = ""
) -> Iterator[tuple[int, str, dict[str, Any]]]:
    """Iterate over the reference solutions of a problem: cells across, code and row of each."""
    for key, rounds in data["rows"].items():
        problem, of, n, code, tol = key.split("|")
        worked = rounds and "failed" not in rounds[0]
        if (
            worked
            and (problem, of) == (target_problem, case)
            and float(tol) == tight(problem).get(code)
        ):
            yield int(n), code, rounds[0]


def grid_lines(problem: str, data: dict[str, Any]) -> list[dict[str, Any]]:
    """Return table rows with grid errors of all codes, relative to samcontact's finest grid."""
    found = sorted(converged(problem, data), key=lambda one: one[:2])
    ours = [(n, row) for n, code, row in found if code == OURS]
    if not ours:
        return []
    finest, reference = max(ours, key=lambda one: one[0])
    quantities = {
        "largest_pressure": "maximum pressure",
        "largest_plastic_strain": "maximum plastic strain",
    }
    return [
        {
            "cells": f"{n}²",
            "code": code,
            **{f"{name} / finest - 1": row[q] / reference[q] - 1 for q, name in quantities.items()},
        }
        for n, code, row in found
        if n < finest
    ]


Grids = dict[str, dict[int, tuple[float, float | None]]]
"""By code and cells across: discretisation error, and minimum time to solve to a tenth of it."""


def grids_of(problem: str, case: str, data: dict[str, Any]) -> Grids:
    """Return, for each grid, the discretisation error and the time to solve to a tenth of it."""
    places, found = by_place(data), Grids()
    for n, code, row in sorted(converged(problem, data, case), key=lambda one: one[:2]):
        error = row["errors"].get(FINE_PRESSURE)
        ladder = places.get((problem, case, n), {}).get(code)
        if error and ladder:
            curve = points(ladder, MEASURE[problem], "with_setup_s")
            found.setdefault(code, {})[n] = error, time_at(curve, error / 10)
    return found


def accuracy_lines(problem: str, data: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Iterate over table rows: errors on each grid, and times at equal cells and equal error."""
    for case in dict.fromkeys(place[1] for place in by_place(data) if place[0] == problem):
        grids = grids_of(problem, case, data)
        ours = [(error, time) for error, time in grids.get(OURS, {}).values() if time]
        rows = {(n, code): row for n, code, row in converged(problem, data, case)}
        for n, code in sorted((n, code) for code, found in grids.items() for n in found):
            error, time = grids[code][n]
            same_cells = grids[OURS].get(n, (0.0, None))[1]
            same_error = time_at(ours, error) if ours and error <= ours[0][0] else None
            line: dict[str, Any] = {"case": case, "cells": f"{n}²", "code": code}
            if not case:
                del line["case"]
            line["error of pressure"] = error
            line["error of contact area"] = rows[n, code]["errors"][FINE_AREA]
            line["time, equal cells"] = time and same_cells and time / same_cells
            line["time, equal error"] = time and same_error and time / same_error
            yield line


def stress_lines(data: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Iterate over table rows for the stress, one application of an operator without tolerance."""
    for (problem, _, n), codes in by_place(data).items():
        if problem != "stress" or OURS not in codes:
            continue
        for code, ladder in codes.items():
            line = {"cells": f"{n}² x {n // 6 + 1}", "code": code}
            line["error"] = ladder[0.0][0]["errors"]["stress"]
            for time, name in TIMES.items():
                smallest, ours = (min(row[time] for row in c[0.0]) for c in (ladder, codes[OURS]))
                line[name] = smallest / ours
            line["memory_MB"] = ladder[0.0][0]["memory_MB"]
            yield line


def without_empty(lines: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Remove columns that are empty in all rows."""
    kept = [name for name in lines[0] if any(line[name] is not None for line in lines)]
    return [{name: line[name] for name in kept} for line in lines]


MAX_SETUP_BOUND_CELLS = (
    256  # cells across; below this the set-up determines the ratios of elastic contact
)


def minimum_ratios(data: dict[str, Any]) -> dict[str, float]:
    """Return the minimum ratio of times of other codes to samcontact, by kind of contact."""
    found: dict[str, list[float]] = {}
    for place, codes in by_place(data).items():
        problem = place[0]
        small = problem in ELASTIC and place[2] < MAX_SETUP_BOUND_CELLS
        if problem not in MEASURE or OURS not in codes or small:
            continue
        for code in (name for name in codes if name != OURS):
            for time in times_of(problem):
                ratio = ratio_at(codes, code, MEASURE[problem], time, COUNTED_AT[problem])
                found.setdefault(KINDS[problem], []).extend([ratio] if ratio else [])
    return {kind: min(ratios) for kind, ratios in found.items() if ratios}


def smallest_ratios(data: dict[str, Any]) -> str:
    """Return a text with the minimum ratio of each kind of contact."""
    found = minimum_ratios(data)
    return "; ".join(
        f"{kind} {float(f'{found[kind]:.2g}'):g} at an error of {COUNTED_AT[problem]:g}"
        + (f" on grids of {MAX_SETUP_BOUND_CELLS}² cells or more" if problem in ELASTIC else "")
        for kind, problem in {kind: problem for problem, kind in KINDS.items()}.items()
        if found.get(kind)
    )


def wins_of_peers(data: dict[str, Any]) -> list[str]:
    """Return texts of the cases in which another code is faster at equal error, with the ratio."""
    found: dict[str, list[str]] = {}
    for problem, measure in MEASURE.items():
        for place, codes in by_place(data).items():
            if place[0] != problem or OURS not in codes:
                continue
            for code in (name for name in codes if name != OURS):
                for time, name in times_of(problem).items():
                    ratios = [ratio_at(codes, code, measure, time, e) for e in TARGETS[problem]]
                    smallest = min((ratio for ratio in ratios if ratio), default=1.0)
                    if smallest < 1:
                        title = TITLES[problem] + (f", {place[1]}" if place[1] else "")
                        line = f"{title}, {code}, {name}"
                        found.setdefault(line, []).append(f"{place[2]}² ({smallest:.2f})")
    for stress in stress_lines(data):
        for name in TIMES.values():
            if stress[name] < 1:
                line = f"{TITLES['stress']}, {stress['code']}, {name}"
                found.setdefault(line, []).append(f"{stress['cells']} ({stress[name]:.2f})")
    for problem in PERIODIC:
        for place in accuracy_lines(problem, data):
            ratio = place["time, equal error"]
            if place["code"] != OURS and ratio and ratio < 1:
                case = f", {place['case']}" if "case" in place else ""
                line = f"{TITLES[problem]}{case}, {place['code']}, at the error of its grid"
                found.setdefault(line, []).append(f"{place['cells']} ({ratio:.2f})")
    if not found:
        return ["In these tables no other code is faster at equal error."]
    head = (
        "Each line gives the number of cells and, in brackets, the minimum ratio of the time to "
        "the time of samcontact at any error in the tables:"
    )
    return ["\n".join([head, "", *(f"- {k}: {', '.join(v)}" for k, v in found.items())])]


def failures(data: dict[str, Any]) -> list[str]:
    """Return texts of the measurements that are missing in the tables, with the reason."""
    found: dict[str, list[str]] = {}
    for key, rounds in data["rows"].items():
        problem, case, n, code, tol = key.split("|")
        if rounds and "failed" in rounds[0]:
            place = f"{TITLES[problem]}{', ' + case if case else ''}, {n}², tolerance {tol}"
            found.setdefault(f"{code}: {rounds[0]['failed']}", []).append(place)
    if not found:
        return []
    lines = [f"- {reason}: {'; '.join(places)}" for reason, places in found.items()]
    return ["\n".join(["Not measured:", "", *lines])]


def about_grids(problem: str, data: dict[str, Any]) -> list[str]:
    """Return a text on the discretisation errors of codes with different discretisations."""
    sections = []
    if problem in PLASTIC and (grid := grid_lines(problem, data)):
        sections += [
            "Tightly converged solutions, relative to samcontact on the finest grid:",
            table(grid),
        ]
    if problem in PERIODIC and (lines := list(accuracy_lines(problem, data))):
        sections += [
            f"Errors relative to samcontact on {MAX_CELLS[problem]}² cells. Times (with set-up, "
            "relative to samcontact) are for an algebraic error of a tenth of the error of the "
            "grid:",
            table(without_empty(lines)),
        ]
    clocks = {
        row.get("clock")
        for key, rounds in data["rows"].items()
        for row in rounds
        if key.split("|")[0] == problem
    }
    if "process_time" in clocks:
        sections.append("Times are processor times, measured on a machine with other load.")
    return sections


def tables_of(data: dict[str, Any]) -> str:
    """Return all tables between the markers of the page."""
    versions = ", ".join(f"{code} {version}" for code, version in data["versions"].items())
    counts = [len(rounds) for rounds in data["rows"].values() if rounds]
    sections = [f"{versions}; one thread; {min(counts)} to {max(counts)} rounds."]
    if smallest := smallest_ratios(data):
        head = "Minimum ratio of the time of any other code to the time of samcontact"
        sections.append(f"{head}: {smallest}.")
    for problem, title in TITLES.items():
        lines = list(stress_lines(data) if problem == "stress" else solver_lines(problem, data))
        if lines:
            sections += [f"### {title}", table(without_empty(lines))]
            if problem in MEASURE:
                sections.append(f"![{title}: time and error](../build/figures/peers_{problem}.png)")
        if lines:
            sections += about_grids(problem, data)
    sections += ["### Cases in which another code is faster", *wins_of_peers(data), *failures(data)]
    return "\n\n".join(sections)


def write(data: dict[str, Any]) -> None:
    """Write all tables between the markers of the page."""
    page = PAGE.read_text(encoding="utf-8")
    PAGE.write_text(between_markers(page, tables_of(data)), encoding="utf-8")
