# SPDX-License-Identifier: GPL-3.0-or-later
"""Time and memory of one large plastic increment, from 10 thousand to 4 million cells.

A Hertz pressure of 6.5 GPa is prescribed in one increment; the plastic zone, 3 x 3 x 2 contact
radii, fills the volume on every grid.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

import samcontact as sc

from .harness import Meter, Task, work_of
from .steel import ELASTIC, STEEL

NAME = "scaling"
TITLE = "Growth of time and memory"
NOTES_NEED_TIMES = True  # not stored on its page
AXES = (("box_cells",), ("us_per_cell_and_application", "bytes_per_cell"))
MAX_PRESSURE = 6.5e9  # Pa
WIDTH, DEPTH = 1.6, 2.2  # half-width and depth of the volume in contact radii
EXACT_CELLS = 400_000  # needs 1 kB per cell, and more during a step
FITTED = (1e5, 5e6)  # cells


def tasks(quick: bool, folder: Path) -> list[Task]:
    sizes = (8, 12, 18) if quick else (8, 12, 18, 26, 40, 64)
    return [
        Task(NAME, "given pressure", method, "solve", {"across": n, "method": method}, "exact")
        for n in sizes
        for method in ("fast", "exact")
        if method == "fast" or np.prod(shape(n)) <= EXACT_CELLS
    ]


def shape(across: int) -> tuple[int, int, int]:
    n = 2 * int(WIDTH * across) + 1
    return n, n, int(DEPTH * across)


def solve(meter: Meter, across: int, method: str) -> dict[str, Any]:
    """Measure one plastic increment from the initial state, including set-up."""
    nx, ny, nz = shape(across)
    d = 1e-3 / across
    grid = sc.Grid(nx, ny, d, d, nz, d)
    r2 = (grid.x[:, None] ** 2 + grid.y[None, :] ** 2) / 1e-6
    pressure = MAX_PRESSURE * np.sqrt(np.maximum(1 - r2, 0))

    def run() -> tuple[sc.Simulation, sc.State]:
        simulation = sc.Simulation(grid, ELASTIC, STEEL, np.zeros((nx, ny)), residual_stress=method)
        return simulation, simulation.step(pressure=pressure)

    simulation, state = meter(run)
    flowing = np.nonzero(state.equivalent_plastic_strain())
    box = int(np.prod([np.ptp(index) + 1 for index in flowing]))
    work = work_of(simulation)
    return {
        "cells": nx * ny * nz,
        "across": across,
        "box_cells": box,
        "substeps": state.substeps,
        "us_per_cell_and_application": 1e6 * meter.time / box / work["volume_applications"],
        "bytes_per_cell": meter.memory / box,
        **work,
    }


def exponent(cells: Sequence[float], values: Sequence[float]) -> float:
    """Return the exponent n of values ~ cells^n, by a straight line through the logarithms."""
    return float(np.polyfit(np.log(cells), np.log(values), 1)[0])


def exponents(rows: list[dict[str, Any]]) -> dict[str, float]:
    """Return exponents of time per application and of memory of the fast method, within FITTED."""
    fitted = [
        row
        for row in rows
        if row["method"] == "fast" and FITTED[0] <= row.get("box_cells", 0) <= FITTED[1]
    ]
    if len(fitted) < 2:
        return {}
    cells = [row["box_cells"] for row in fitted]
    found = {}
    if all("time_s" in row for row in fitted):
        each = [row["time_s"] / row["volume_applications"] for row in fitted]
        found["time per application"] = exponent(cells, each)
    return {**found, "peak memory": exponent(cells, [row["memory_MB"] for row in fitted])}


def notes(rows: list[dict[str, Any]]) -> list[str]:
    """Return the sentences below the table."""
    return [
        f"Fast method, {FITTED[0]:.0e} to {FITTED[1]:.0e} cells: "
        f"{quantity} increases with the number of cells to the power {value:.2f}."
        for quantity, value in exponents(rows).items()
    ]
