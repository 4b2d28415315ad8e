# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of both codes against their own limits, and tables of them."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..study import table

Runs = dict[str, dict[str, Any]]
"""What was found, by the size of a mesh."""
Quantities = dict[str, tuple[str, float]]
"""Headings and factors of units of what is compared."""
Points = list[tuple[float, float]]
"""Errors and times [s]."""


def both(found: dict[str, Runs]) -> dict[str, Runs]:
    """Runs of the two codes alone."""
    return {code: found[code] for code in ("CalculiX", "samcontact")}


def limit(runs: Runs, quantity: str) -> float:
    """Where the two finest meshes lead with order two."""
    (coarse, a), (fine, b) = sorted((int(size), run[quantity]) for size, run in runs.items())[-2:]
    ratio = (fine / coarse) ** 2
    return float((ratio * b - a) / (ratio - 1))


def error_of(runs: Runs, size: str, quantities: Quantities) -> float:
    """The largest relative error of a mesh."""
    return error_against({q: limit(runs, q) for q in quantities}, runs[size], quantities)


def error_against(truth: dict[str, float], run: dict[str, Any], quantities: Quantities) -> float:
    """The largest relative error of a run whose limit is known."""
    return max(abs(run[q] / truth[q] - 1) for q in quantities)


def points(runs: Runs, quantities: Quantities) -> Points:
    """Largest errors and times of all meshes."""
    return [(error_of(runs, size, quantities), run["seconds"]) for size, run in runs.items()]


def points_against(truth: dict[str, float], runs: Runs, quantities: Quantities) -> Points:
    """The same of runs whose limit is known."""
    return [(error_against(truth, run, quantities), run["seconds"]) for run in runs.values()]


def time_at(known: Points, error: float) -> float | None:
    """Time at an error between those that are known, in logarithms; None outside."""
    errors, times = np.log(sorted(known)).T
    if not errors[0] <= np.log(error) <= errors[-1]:
        return None
    return float(np.exp(np.interp(np.log(error), errors, times)))


def ratios(theirs: Runs, quantities: Quantities, ours: dict[str, Points]) -> str:
    """What finite elements take times what the others do, at the errors of their meshes."""
    lines = []
    for error, seconds in points(theirs, quantities):
        for than, known in ours.items():
            at = time_at(known, error)
            if at is not None:
                lines.append(
                    f"At an error of {100 * error:.2g} % finite elements take "
                    f"{seconds / at:.0f} times as long as {than}."
                )
    return "\n".join(lines)


def apart(runs: dict[str, Runs], quantities: Quantities) -> str:
    """Between which values the limits of two codes differ."""
    one, other = runs.values()
    found = [100 * abs(limit(one, q) / limit(other, q) - 1) for q in quantities]
    return f"{min(found):.2g} to {max(found):.2g} %"


def time_rows(runs: dict[str, Runs], quantities: Quantities) -> list[list[str]]:
    """Code, size, mesh, largest error and time."""
    rows = []
    for code, found in runs.items():
        for size, run in found.items():
            unit = "elements" if "elements" in run else "cells"
            error = error_of(found, size, quantities)
            rows.append([code, size, *time_cells(f"{run[unit]:.0f} {unit}", error, run)])
    return rows


def time_cells(mesh: str, error: float, run: dict[str, Any]) -> list[str]:
    """Mesh, largest error and time of a run."""
    return [mesh, f"{100 * error:.2g}", f"{run['seconds']:.3g}"]


def times(sizes: str, rows: list[list[str]]) -> str:
    """The table of errors and times; sizes: what those of meshes are."""
    return table(["code", sizes, "mesh", "largest error [%]", "time [s]"], rows)


def numbers(sizes: str, runs: dict[str, Runs], quantities: Quantities) -> str:
    """The table of what was found, and of the limits."""
    rows = []
    for code, found in runs.items():
        limits = {q: limit(found, q) for q in quantities}
        for size, run in [*found.items(), ("limit", limits)]:
            values = [f"{scale * run[q]:.5g}" for q, (_, scale) in quantities.items()]
            rows.append([code, size, *values])
    return table(["code", sizes, *(heading for heading, _ in quantities.values())], rows)
