# SPDX-License-Identifier: GPL-3.0-or-later
"""Times on one and two threads (contact, increments, subdomains) or processes (sweeps).

Times are wall-clock times, so the machine must have two free processors.
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import samcontact as sc

from . import elastic_rough, plastic_zones, slip
from .harness import ROOT, Meter, Task
from .steel import LOAD, balls

NAME = "threads"
TITLE = "Threads"
SERIES = ("case", "method")
AXES = (("cells",), ("time_ratio",))
BASE = "1 thread"
HIDDEN_COLUMNS = (
    "contact_iterations", "surface_applications", "volume_applications", "cells_in_contact", "work",
    "shear_iterations", "shear_applications", "shear_work", "sticking_cells", "contact_fraction",
    "plastic_cells",
)  # fmt: skip
"""Counts that do not depend on the number of threads; they are in the tables of other parts."""
SIZES = {
    "contact": (64, 256, 1024),
    "partial slip": (64, 256, 1024),
    "increments": (8, 24, 40),
    "plastic subdomains": (64, 256, 512),
    "sweep": (4, 16, 64),
}
ROUNDS = 3  # repetitions of all cases except sweeps, which take minutes
LARGE_SIZES = {
    "contact": 256**2,
    "partial slip": 256**2,
    "increments": 1e5,
    "plastic subdomains": 1e5,
    "sweep": 64,
}
"""Minimum number of cells (for a sweep: of cases) from which a case counts as large."""

WORKERS = ("on two threads", "on one thread")
SWEEP_WORKERS = ("in two processes", "in one process")


def tasks(quick: bool, folder: Path) -> list[Task]:
    return [
        Task(
            NAME, case, method, "solve", {"case": case, "n": n, "method": method}, BASE, own, rounds
        )
        for case, sizes in SIZES.items()
        for n in (sizes[:2] if quick else sizes)
        for threads, method in ((1, BASE), (2, "2 threads"))
        # a sweep uses two processes instead
        for own, rounds in ((1, 1) if case == "sweep" else (threads, ROUNDS),)
    ]


def solve(meter: Meter, case: str, n: int, method: str) -> dict[str, Any]:
    """Solve one case; the harness sets the number of threads."""
    if case == "contact":
        found = elastic_rough.contact(meter, n, "tol 1e-8")
        return {"cells": n * n, "across": n, "contact_iterations": found.iterations}
    if case == "partial slip":
        return {**slip.solve(meter, n, 0.5, "tol 1e-6"), "errors": {}}
    if case == "plastic subdomains":
        simulation, states = plastic_zones.run(meter, n, 5, "auto")
        return plastic_zones.summary(simulation, states[-1])
    return press(meter, n) if case == "increments" else sweep(meter, n, int(method[0]))


def press(meter: Meter, n: int) -> dict[str, Any]:
    """Load and unload two balls, with `n` cells per Hertz radius."""

    def run() -> sc.Simulation:
        simulation = balls(n)
        for part in (0.5, 1.0, 0.0):
            simulation.step(load=part * LOAD)
        return simulation

    grid = meter(run).grid
    return {"cells": grid.nx * grid.ny * grid.nz, "across": n}


def sweep(meter: Meter, cases: int, processes: int) -> dict[str, Any]:
    """Solve a case for `cases` loads; measure processes of one thread, including their start."""
    loads = [800.0 + 1600.0 * k / cases for k in range(cases)]

    def run() -> Any:
        with tempfile.TemporaryDirectory() as folder:
            return sc.sweep(
                ROOT / "cases" / "t1_two_balls.toml", {"path[0].load": loads},
                executor=processes, output=folder, progress=False,
            )  # fmt: skip

    meter(run)
    return {"cells": cases}


def efficiency(row: dict[str, Any]) -> float:
    """Return the efficiency of two threads; it is 1 if they halve the time."""
    return float(1 / (2 * row["time_ratio"]))


def notes(rows: list[dict[str, Any]]) -> list[str]:
    """Return the minimum efficiency in large cases and the maximum time ratio in small cases."""
    lines = []
    for case in SIZES:
        both = [row for row in rows if row["case"] == case and row["method"] != BASE]
        large = [efficiency(row) for row in both if row["cells"] >= LARGE_SIZES[case]]
        small = [row["time_ratio"] for row in both if row["cells"] < LARGE_SIZES[case]]
        two, one = SWEEP_WORKERS if case == "sweep" else WORKERS
        stated = []
        if large:
            stated.append(f"the efficiency is at least {min(large):.2f} in large cases")
        if small:
            most = f"{max(small):.2f} times the time {one}"
            stated.append(f"the time is at most {most} in small cases")
        lines += [f"- {case}: {two}, {', and '.join(stated)}."] if stated else []
    return ["\n".join(lines)]
