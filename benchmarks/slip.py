# SPDX-License-Identifier: GPL-3.0-or-later
"""Stick and slip: work of the shear beside that of the pressure, against Cattaneo and Mindlin."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np

import samcontact as sc

from .elastic_smooth import work
from .harness import Meter, Task, relative_error

NAME = "slip"
TITLE = "Stick and slip"
SERIES = ("case", "method")
MU = 0.3
METHODS = {"pressure alone": None, "tol 1e-4": 1e-4, "tol 1e-6": 1e-6, "tol 1e-8": 1e-8}
BASE = "pressure alone"
RADIUS = 0.4  # of the contact, on 1 m x 1 m
NU = 0.3


def tasks(quick: bool, folder: Path) -> list[Task]:
    sizes = (64, 128) if quick else (64, 128, 256, 512)
    return [
        Task(NAME, f"Q = {q:g} mu P", method, "solve", {"n": n, "share": q, "method": method}, BASE)
        for n in sizes
        for q in (0.1, 0.5, 0.9)
        for method in METHODS
    ] + [
        Task(NAME, f"unlike, {k} of 8", "tol 1e-8", "press_unlike", {"n": n, "last": k})
        for n in sizes[:2]
        for k in (1, 8)
    ]


def solve(meter: Meter, n: int, share: float, method: str) -> dict[str, Any]:
    """A ball pressed and pulled: the time is that of both, from nothing."""
    grid = sc.Grid(n, n, 1 / n, 1 / n)
    body = sc.Material.elastic(2 * (1 - NU * NU), NU)
    gap = sc.surfaces.paraboloid(grid, 1.0)
    load = 4 / 3 * RADIUS**3
    tol = METHODS[method]
    if tol is None:
        found = meter(lambda: sc.ContactSolver(grid, body, body).solve(gap, load=load))
        return {"cells": n * n, "across": n, "errors": {}, "work": found.work, **work(found)}
    force = (share * MU * load, 0.0)
    pulled = meter(
        lambda: sc.ContactSolver(grid, body, body, sc.Coulomb(MU), tol=tol).solve(
            gap, load=load, tangential_load=force
        )
    )
    softness = 2 * (2 - NU) / (1 - NU)  # sum of (2 - nu)/G
    shift = 3 * MU * load * softness / (16 * RADIUS) * (1 - (1 - share) ** (2 / 3))
    stick = math.sqrt(pulled.sticking.sum() * grid.cell_area / math.pi) / RADIUS
    errors = {
        "shift": relative_error(pulled.shift[0], shift),
        "stick radius": relative_error(stick, (1 - share) ** (1 / 3)),
    }
    return {"cells": n * n, "across": n, "errors": errors, **work(pulled), **shear_work(pulled)}


def press_unlike(meter: Meter, n: int, last: int) -> dict[str, Any]:
    """A rigid ball on a body with nu = 0, mu = 0.3, the contact radius growing in equal steps."""
    grid = sc.Grid(n, n, 1 / n, 1 / n)
    solver = sc.ContactSolver(
        grid, sc.Material.rigid(), sc.Material.elastic(1.0, 0.0), sc.Coulomb(MU)
    )
    gap, found = sc.surfaces.paraboloid(grid, 1.0), None
    for k in range(1, last):
        found = solver.solve(gap, load=4 / 3 * (RADIUS * k / 8) ** 3, previous=found)
    load = 4 / 3 * (RADIUS * last / 8) ** 3
    found = meter(lambda: solver.solve(gap, load=load, previous=found))
    columns = {"sweeps": found.sweeps, **work(found), **shear_work(found)}
    return {"cells": n * n, "across": n, "errors": {}, **columns}


def shear_work(found: sc.StickSlipSolution) -> dict[str, Any]:
    return {
        "work": found.work,
        "shear_iterations": found.tangential_iterations,
        "shear_applications": found.tangential_applications,
        "shear_work": found.tangential_work,
        "sticking_cells": int(np.count_nonzero(found.sticking)),
    }
