# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of each code relative to its limit on fine meshes, and tables of errors and times."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..study import table

Runs = dict[str, dict[str, Any]]
"""Results of a code by mesh size."""
Quantities = dict[str, tuple[str, float]]
"""Heading and factor from SI to the unit in the table, for each quantity compared."""
METHODS = {
    "a grid": "samcontact with a grid chosen by the user",
    "an accuracy": "samcontact with a prescribed accuracy",
}
"""Names of the two ways to choose the grid of samcontact."""
Points = list[tuple[float, float]]
"""Pairs of relative error and processor time [s]."""


def both(found: dict[str, Runs]) -> dict[str, Runs]:
    """Return the runs of CalculiX and of samcontact, without the additional runs."""
    return {code: found[code] for code in ("CalculiX", "samcontact")}


def limit(runs: Runs, quantity: str) -> float:
    """Return the limit of a quantity, extrapolated with order two from the two finest meshes."""
    (coarse, a), (fine, b) = sorted((int(size), run[quantity]) for size, run in runs.items())[-2:]
    ratio = (fine / coarse) ** 2
    return float((ratio * b - a) / (ratio - 1))


def error_of(runs: Runs, size: str, quantities: Quantities) -> float:
    """Return the maximum relative error of the quantities on a mesh of a code."""
    return error_against({q: limit(runs, q) for q in quantities}, runs[size], quantities)


def error_against(truth: dict[str, float], run: dict[str, Any], quantities: Quantities) -> float:
    """Return the maximum relative error of the quantities of a run, given their true values."""
    return max(abs(run[q] / truth[q] - 1) for q in quantities)


def points(runs: Runs, quantities: Quantities) -> Points:
    """Return maximum error and time for each mesh of a code."""
    return [(error_of(runs, size, quantities), run["seconds"]) for size, run in runs.items()]


def points_against(truth: dict[str, float], runs: Runs, quantities: Quantities) -> Points:
    """Return maximum error and time for each run, given the true values of the quantities."""
    return [(error_against(truth, run, quantities), run["seconds"]) for run in runs.values()]


def time_at(known: Points, error: float) -> float | None:
    """Return the time [s] at an error, interpolated in logarithms; None outside the data."""
    errors, times = np.log(sorted(known)).T
    if not errors[0] <= np.log(error) <= errors[-1]:
        return None
    return float(np.exp(np.interp(np.log(error), errors, times)))


def ratios(theirs: Runs, quantities: Quantities, ours: dict[str, Points]) -> str:
    """Return a list of ratios of finite element to samcontact times, at the errors of FE meshes."""
    lines = []
    for error, seconds in points(theirs, quantities):
        for than, known in ours.items():
            at = time_at(known, error)
            if at is not None:
                lines.append(
                    f"- At an error of {100 * error:.2g} %, CalculiX takes "
                    f"{seconds / at:.0f} times as long as {METHODS[than]}."
                )
    return "\n".join(lines)


def difference_range(runs: dict[str, Runs], quantities: Quantities) -> str:
    """Return the range of the relative differences between the limits of both codes, as text."""
    one, other = runs.values()
    found = [100 * abs(limit(one, q) / limit(other, q) - 1) for q in quantities]
    return f"{min(found):.2g} to {max(found):.2g} %"


def time_rows(runs: dict[str, Runs], quantities: Quantities) -> list[list[str]]:
    """Return table rows with code, mesh size, number of cells or elements, error and time."""
    rows = []
    for code, found in runs.items():
        for size, run in found.items():
            unit = "elements" if "elements" in run else "cells"
            error = error_of(found, size, quantities)
            rows.append([code, size, *time_cells(f"{run[unit]:.0f} {unit}", error, run)])
    return rows


def time_cells(mesh: str, error: float, run: dict[str, Any]) -> list[str]:
    """Return the table entries of a run: mesh, maximum error [%] and time [s]."""
    return [mesh, f"{100 * error:.2g}", f"{run['seconds']:.3g}"]


def times(sizes: str, rows: list[list[str]]) -> str:
    """Return the table of errors and times; `sizes` is the heading of the column of mesh sizes."""
    return table(["code", sizes, "mesh", "maximum error [%]", "time [s]"], rows)


def numbers(sizes: str, runs: dict[str, Runs], quantities: Quantities) -> str:
    """Return the table of the quantities on each mesh and their limits, for each code."""
    rows = []
    for code, found in runs.items():
        limits = {q: limit(found, q) for q in quantities}
        for size, run in [*found.items(), ("limit", limits)]:
            values = [f"{scale * run[q]:.5g}" for q, (_, scale) in quantities.items()]
            rows.append([code, size, *values])
    return table(["code", sizes, *(heading for heading, _ in quantities.values())], rows)
