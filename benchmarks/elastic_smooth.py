# SPDX-License-Identifier: GPL-3.0-or-later
"""Hertz point contact compared with the closed form."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import samcontact as sc

from .harness import Meter, Task, relative_error, rms_error
from .steel import ELASTIC, LOAD, RADIUS, hertz

NAME = "elastic_smooth"
TITLE = "Hertz contact"
METHODS = {  # tolerance, given quantity
    "load, tol 1e-8": (1e-8, "load"),
    "load, tol 1e-4": (1e-4, "load"),
    "approach, tol 1e-8": (1e-8, "approach"),
}
BASE = "load, tol 1e-8"


def tasks(quick: bool, folder: Path) -> list[Task]:
    sizes = (32, 64, 128, 256) if quick else (32, 64, 128, 256, 512)
    return [
        Task(NAME, "Hertz", method, "solve", {"n": n, "method": method}, BASE)
        for n in sizes
        for method in METHODS
    ]


def solve(meter: Meter, n: int, method: str) -> dict[str, Any]:
    """Solve a Hertz contact on n x n cells; the contact covers four fifths of the grid width."""
    exact = hertz()
    d = 2 * exact.a / (0.8 * n)
    grid = sc.Grid(n, n, d, d)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    tol, given = METHODS[method]
    target = {given: LOAD if given == "load" else exact.approach}
    found = meter(lambda: sc.ContactSolver(grid, ELASTIC, ELASTIC, tol=tol).solve(gap, **target))
    pressure = exact.pressure(grid.x[:, None], grid.y[None, :])
    errors = {
        "largest pressure": relative_error(found.pressure.max(), exact.p0),
        "pressure, rms": rms_error(found.pressure, pressure),
    }
    if given == "load":
        errors["approach"] = relative_error(found.approach, exact.approach)
    else:
        errors["load"] = relative_error(found.load, LOAD)
    return {"cells": n * n, "across": n, "errors": errors, **work(found)}


def work(found: sc.ContactSolution) -> dict[str, Any]:
    """Return the iterations and, if the solver counts them, the operator applications."""
    columns = {"contact_iterations": found.iterations}
    if hasattr(found, "operator_applications"):
        columns["surface_applications"] = found.operator_applications
    columns["cells_in_contact"] = int(np.count_nonzero(found.pressure))
    return columns
