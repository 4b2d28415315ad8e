# SPDX-License-Identifier: GPL-3.0-or-later
"""Cost of elastic-plastic rolling over many inclusions, and over the clean body."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np

import samcontact as sc

from .harness import Meter, Task, work_of

NAME = "inclusions"
TITLE = "Rolling over 200 inclusions, 60 increments"
STEEL = sc.Material.linear_hardening(210e9, 0.3, 1500e6, 9.5e9)
ALUMINA = sc.Material.elastic(390e9, 0.25)
CELLS, A, P0 = 12, 0.5e-3, 4e9  # cells per contact radius, contact radius [m], elastic p0 [Pa]
COUNT, INCREMENTS, SIDE = 200, 60, 6  # inclusions, positions of the ball, width of the grid in A
CLEAN_BODY, UNMIRRORED_BODY, FILLED_BODY = "clean", "clean, no mirror plane", "inclusions"


def tasks(quick: bool, folder: Path) -> list[Task]:
    increments = 6 if quick else INCREMENTS
    rounds = 1 if quick else 2
    return [
        Task(NAME, "p0 = 4 GPa", body, "roll", {"method": body, "increments": increments},
             CLEAN_BODY, rounds=rounds)
        for body in (CLEAN_BODY, UNMIRRORED_BODY, FILLED_BODY)
    ]  # fmt: skip


def inclusions(increments: int) -> list[sc.Inclusion]:
    """Return spheres of 2.05 to 2.6 cells radius below the track, which do not overlap."""
    random = np.random.default_rng(1)
    h = A / CELLS
    low = np.array([-0.5 * SIDE * A - increments * h, -2.6 * A, 0.3 * A])
    high = np.array([2.8 * A, 2.6 * A, 2.4 * A])
    spheres: list[sc.Inclusion] = []
    while len(spheres) < COUNT:
        radius, centre = h * random.uniform(2.05, 2.6), random.uniform(low, high)
        apart = (
            np.linalg.norm(centre - one.center) > 1.2 * (radius + one.radii[0]) for one in spheres
        )
        if all(apart):
            spheres.append(sc.Inclusion.sphere(tuple(centre), radius, ALUMINA))
    return spheres


def roll(meter: Meter, method: str, increments: int) -> dict[str, Any]:
    """Load a rigid ball on a body and roll it by one cell in each increment."""
    h = A / CELLS
    grid = sc.Grid(SIDE * CELLS, SIDE * CELLS, h, h, dz=h)
    radius = 2 * A * STEEL.E / (1 - STEEL.nu**2) / (np.pi * P0)
    off = 0.25 * h if method == UNMIRRORED_BODY else 0.0
    gap = (grid.x[:, None] ** 2 + (grid.y - off) ** 2) / (2 * radius)
    body = sc.Heterogeneous(STEEL, inclusions(increments)) if method == FILLED_BODY else STEEL
    load = 2 / 3 * np.pi * A**2 * P0

    def rolled() -> sc.Simulation:
        simulation = sc.Simulation(grid, sc.Material.rigid(), body, gap, tol=1e-3, on_border="warn")
        simulation.step(load=load)
        for _ in range(increments):
            simulation.step(load=load, advance=(0.0, h))
        return simulation

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", sc.ResolutionWarning)
        simulation = meter(rolled)
    meter.time = meter.cpu  # one thread: the time of other processes does not count
    return {"cells": grid.nx * grid.ny, "across": CELLS, "errors": {}, **work_of(simulation)}


def notes(rows: list[dict[str, Any]]) -> list[str]:
    """Return a line with processor time and memory over those of the clean body."""
    of = {row["method"]: row for row in rows}
    if (
        not {CLEAN_BODY, UNMIRRORED_BODY, FILLED_BODY} <= set(of)
        or "time_ratio" not in of[FILLED_BODY]
    ):
        return []
    (time, memory), (alone, memory_alone) = (
        [of[FILLED_BODY][name] / of[body][name] for name in ("time_ratio", "memory_MB")]
        for body in (CLEAN_BODY, UNMIRRORED_BODY)
    )
    return [
        f"With 200 inclusions, processor time and memory are {time:.1f} and {memory:.1f} times "
        f"those of the clean body with a mirror plane, and {alone:.1f} and {memory_alone:.1f} "
        "times those of the clean body without a mirror plane."
    ]
