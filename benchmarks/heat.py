# SPDX-License-Identifier: GPL-3.0-or-later
"""Cost of frictional heating: one contact with equal increments, cold and heated."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import samcontact as sc

from .elastic_smooth import work
from .harness import Meter, Task, relative_error, work_of
from .steel import ELASTIC, LOAD, RADIUS, STEEL, hertz

NAME = "heat"
TITLE = "Frictional heat"
THERMAL = {"conductivity": 50.2, "expansion": 11.7e-6, "diffusivity": 1.367e-5}
FACTOR = 0.05  # m/s
STEP = 1e-3  # s
HEAT_CASES = {
    "cold": sc.Heat(0.0),
    "at rest": sc.Heat(FACTOR),
    "moving, 0.1 m/s": sc.Heat(FACTOR, velocity=(0.1, 0.0)),
}
TRANSIENT_HEAT = sc.Heat(FACTOR, history=(STEP, 1.0))
MAX_MISES = {"cold": 2351e6, "at rest": 1926e6}  # Pa, from independent computations


def tasks(quick: bool, folder: Path) -> list[Task]:
    sizes = (65, 129) if quick else (65, 129, 257, 513)
    contact = [
        Task(NAME, "contact", method, "solve", {"n": n, "method": method}, "cold")
        for n in sizes
        for method in HEAT_CASES
    ]
    cells = (12,) if quick else (12, 20)
    plastic = [
        Task(NAME, "12 increments", method, "press", {"cells": c, "method": method}, "cold")
        for c in cells
        for method in (*HEAT_CASES, "transient")
    ]
    return contact + plastic


def solve(meter: Meter, n: int, method: str) -> dict[str, Any]:
    """Solve a contact on n x n cells; the operators are built before the measurement."""
    d = 2.6 * hertz().a / n
    grid = sc.Grid(n, n, d, d)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    solver = sc.ContactSolver(
        grid, ELASTIC, ELASTIC.with_thermal(**THERMAL), heat=HEAT_CASES[method]
    )
    found = meter(lambda: solver.solve(gap, load=LOAD))
    return {"cells": n * n, "across": n, "errors": {}, **work(found)}


def press(meter: Meter, cells: int, method: str) -> dict[str, Any]:
    """Load to 1500 N in 12 increments, with `cells` per Hertz radius; the time includes set-up."""
    d = hertz().a / cells
    n = 2 * int(1.5 * cells) + 1
    grid = sc.Grid(n, n, d, d, int(1.7 * cells), d)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    is_transient = method == "transient"
    heat = TRANSIENT_HEAT if is_transient else HEAT_CASES[method]
    extra = {"duration": STEP} if is_transient else {}

    def run() -> tuple[sc.Simulation, sc.State]:
        simulation = sc.Simulation(grid, ELASTIC, STEEL.with_thermal(**THERMAL), gap, heat=heat)
        for load in np.linspace(0.0, LOAD, 13)[1:]:
            state = simulation.step(load=load, **extra)
        return simulation, state

    simulation, state = meter(run)
    errors = {}
    if method in MAX_MISES:
        errors["von Mises"] = relative_error(state.von_mises().max(), MAX_MISES[method])
    volume = grid.nx * grid.ny * grid.nz
    return {"cells": volume, "across": cells, "errors": errors, **work_of(simulation)}
