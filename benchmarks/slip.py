# SPDX-License-Identifier: GPL-3.0-or-later
"""Partial slip: work of pressure and shear solutions, and errors relative to closed forms.

The closed forms are by Cattaneo and Mindlin. Rolling with creepage, steady and incremental, is
included.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np

import samcontact as sc

from .elastic_smooth import work
from .harness import Meter, Task, relative_error

NAME = "slip"
TITLE = "Partial slip"
NOTES_NEED_TIMES = True  # not stored on its page
SERIES = ("case", "method")
MU = 0.3
METHODS = {"pressure alone": None, "tol 1e-4": 1e-4, "tol 1e-6": 1e-6, "tol 1e-8": 1e-8}
BASE = "pressure alone"
AXES = (
    ("time_s", "memory_MB", "shear_work"),
    ("error: tangential displacement", "error: stick radius"),
)
RADIUS = 0.4  # contact radius on a grid of 1 m x 1 m
NU = 0.3
WHEEL_ON_RAIL = 287, 323  # cells of the finest of CONTACT's wheel-on-rail examples
WIDE_RADIUS = 0.4175  # as many contact cells as in that example
STEPS = 56
ENTRY = "tangential load, then rolling"
# s; times published in 2016, on one core
CONTACT_STATES = {"tangential displacement": 22.6, "rolling": 2210.0}


def tasks(quick: bool, folder: Path) -> list[Task]:
    sizes = (64, 128) if quick else (64, 128, 256, 512)
    pulled = [
        Task(NAME, f"Q = {q:g} mu P", method, "solve", {"n": n, "share": q, "method": method}, BASE)
        for n in sizes
        for q in (0.1, 0.5, 0.9)
        for method in METHODS
    ]
    different_bodies = [
        Task(
            NAME,
            f"dissimilar materials, increment {k} of 8",
            "tol 1e-8",
            "press_dissimilar",
            {"n": n, "last": k},
        )
        for n in sizes[:2]
        for k in (1, 8)
    ]
    rolling = [
        Task(NAME, "rolling", method, "roll", {"n": n, "tol": METHODS[method]})
        for n in sizes
        for method in ("tol 1e-4", "tol 1e-8")
    ]
    large = (72, 81) if quick else WHEEL_ON_RAIL
    variants = {"tangential displacement": "shift", "rolling": "roll_wide"}
    wide = [
        Task(NAME, f"{large[0]} x {large[1]}, {name}", "tol 1e-7", function, {"n": list(large)})
        for name, function in variants.items()
    ]
    steps = {"steps": 14 if quick else STEPS}
    return [
        *pulled,
        *different_bodies,
        *rolling,
        *wide,
        Task(NAME, ENTRY, "tol 1e-8", "roll_on", steps),
    ]


def solve(meter: Meter, n: int, share: float, method: str) -> dict[str, Any]:
    """Press a ball and load it tangentially; the time includes the solutions of both loads."""
    grid, body, gap, load = ball(n, n, RADIUS)
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
    moved = 3 * MU * load * softness() / (16 * RADIUS) * (1 - (1 - share) ** (2 / 3))
    stick = math.sqrt(pulled.sticking.sum() * grid.cell_area / math.pi) / RADIUS
    errors = {
        "tangential displacement": relative_error(pulled.shift[0], moved),
        "stick radius": relative_error(stick, (1 - share) ** (1 / 3)),
    }
    return {"cells": n * n, "across": n, "errors": errors, **work(pulled), **shear_work(pulled)}


def press_dissimilar(meter: Meter, n: int, last: int) -> dict[str, Any]:
    """Press a rigid ball on a body (nu = 0) with friction, to contact radii in equal steps."""
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


def ball(nx: int, ny: int, radius: float) -> tuple[sc.Grid, sc.Material, Any, float]:
    """Return grid (1 m x 1 m), body, gap and load of a ball; E* = 1 Pa, contact radius given."""
    grid = sc.Grid(nx, ny, 1 / nx, 1 / ny)
    body = sc.Material.elastic(2 * (1 - NU * NU), NU)
    return grid, body, sc.surfaces.paraboloid(grid, 1.0), 4 / 3 * radius**3


def rolled(grid: sc.Grid, body: sc.Material, gap: Any, load: float, tol: float) -> Any:
    """Solve steady rolling at a third of the creepage of full sliding, along x and y, with spin."""
    full = MU * abs(load) ** (1 / 3)
    return sc.rolling.steady(
        grid, body, body, gap, load=load, friction=sc.Coulomb(MU), tol=tol,
        creepage=(0.3 * full, 0.2 * full), spin=0.2 * full,
    )  # fmt: skip


def roll(meter: Meter, n: int, tol: float) -> dict[str, Any]:
    """Solve steady rolling of a ball; the time includes pressure and shear, from zero tractions."""
    problem = ball(n, n, RADIUS)
    return {"cells": n * n, "across": n, **shown(meter(lambda: rolled(*problem, tol)))}


def roll_wide(meter: Meter, n: list[int]) -> dict[str, Any]:
    problem = ball(*n, WIDE_RADIUS)
    return {"cells": n[0] * n[1], "across": n[0], **shown(meter(lambda: rolled(*problem, 1e-7)))}


def shift(meter: Meter, n: list[int]) -> dict[str, Any]:
    """Solve a contact under load and tangential displacement; more than half of the area slips."""
    grid, body, gap, load = ball(*n, WIDE_RADIUS)
    most = 3 * MU * load * softness() / (16 * WIDE_RADIUS)
    found = meter(
        lambda: sc.ContactSolver(grid, body, body, sc.Coulomb(MU), tol=1e-7).solve(
            gap, load=load, shift=(0.43 * most, 0.0)
        )
    )
    force = MU * load * (1 - (1 - 0.43) ** 1.5)
    columns = shown(found) | {"errors": {"force": relative_error(found.tangential_load[0], force)}}
    return {"cells": n[0] * n[1], "across": n[0], **columns}


def roll_on(meter: Meter, steps: int) -> dict[str, Any]:
    """Roll from Cattaneo's to Carter's state (a CONTACT example), one cell per step."""
    grid = sc.Grid(33, 33, 0.25, 0.25)
    gap = sc.surfaces.paraboloid(grid, 1 / (2 * 0.002963))
    body, law, load = sc.Material.elastic(2 * 1.28, 0.28), sc.Coulomb(0.4013), 0.4705
    force = {"load": load, "tangential_load": (-0.657 * 0.4013 * load, 0.0)}
    solver = sc.ContactSolver(grid, body, body, law)
    first = solver.solve(gap, **force)

    def roll_steps() -> list[sc.PartialSlipSolution]:
        found = [first]
        for _ in range(steps):
            found.append(solver.solve(gap, **force, previous=found[-1], advance=(-0.25, -0.25)))
        return found

    found = meter(roll_steps)
    creepage = (found[-1].shift - found[-2].shift)[0] / 0.25
    # rolling is towards -x here, so the force has the opposite sign
    steady = sc.rolling.steady(
        grid, body, body, gap, friction=law, load=load, tangential_load=(0.657 * 0.4013 * load, 0)
    )
    applications = [one.tangential_applications for one in found]
    return {
        "cells": 33 * 33,
        "across": 33,
        "errors": {"creepage": relative_error(abs(creepage), abs(steady.creepage[0]))},
        "shear_applications": sum(applications),
        "shear_work": sum(one.tangential_work for one in found),
        "max_applications_per_step": max(applications[1:]),
    }


def shown(found: sc.PartialSlipSolution | sc.RollingSolution) -> dict[str, Any]:
    """Return the table columns of a solution with shear."""
    return {"errors": {}, **work(found), **shear_work(found)}


def softness() -> float:
    """Return the sum of (2 - nu)/G of two bodies with E* = 1 Pa [1/Pa]."""
    return 2 * (2 - NU) / (1 - NU)


def notes(rows: list[dict[str, Any]]) -> list[str]:
    """Return sentences that summarise the rows of the table."""
    lines = []
    for n in sorted({row["across"] for row in rows if row["case"].startswith("Q = ")}):
        at = [row for row in rows if row["across"] == n and row["case"].startswith("Q = ")]
        of = {method: [row for row in at if row["method"] == method] for method in METHODS}
        most = {m: max(row["shear_work"] for row in of[m]) for m in ("tol 1e-4", "tol 1e-8")}
        exact = max(row["shear_applications"] for m in most for row in of[m])
        lines.append(
            f"Q = 0.1 to 0.9 mu P, {n:.0f} cells across: the whole shear solution, with coarser "
            "grids and preconditioner, takes at most as many transforms as "
            f"{most['tol 1e-4']:.0f} exact evaluations of the displacement (tolerance 1e-4) or "
            f"{most['tol 1e-8']:.0f} (tolerance 1e-8). At most {exact:.0f} exact evaluations are "
            "actually made."
        )
    for row in rows:
        size, _, name = row["case"].partition(", ")
        if size == " x ".join(map(str, WHEEL_ON_RAIL)) and "time_s" in row:
            stated = CONTACT_STATES[name]
            lines.append(
                f"{size} cells, {row['cells_in_contact']:.0f} in contact, {name}: "
                f"{row['time_s']:.2g} s; CONTACT: {stated:g} s, published in 2016 for a wheel on a "
                "rail with 50 796 cells in contact."
            )
    return ["\n".join(f"- {line}" for line in lines)] if lines else []


def shear_work(found: sc.PartialSlipSolution | sc.RollingSolution) -> dict[str, Any]:
    return {
        "work": found.work,
        "shear_iterations": found.tangential_iterations,
        "shear_applications": found.tangential_applications,
        "shear_work": found.tangential_work,
        "sticking_cells": int(np.count_nonzero(found.sticking)),
    }
