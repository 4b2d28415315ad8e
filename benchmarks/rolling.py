# SPDX-License-Identifier: GPL-3.0-or-later
"""Cost of a rolling increment after a short and a long distance."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import samcontact as sc

from .harness import Meter, Task, work_of
from .steel import STEEL

NAME = "rolling"
TITLE = "Rolling, 24 increments"
CERAMIC = sc.Material.elastic(310e9, 0.29)
RADIUS, LOAD = 4.7625e-3, 1152.9  # p0 = 5.7 GPa
CONTACT_RADIUS = 310.76e-6
INCREMENTS = 24
DISTANCES = {"loading only": -1, "after 3 a": 3, "after 10 a": 10}  # in contact radii


def tasks(quick: bool, folder: Path) -> list[Task]:
    cells = (8,) if quick else (8, 12)
    return [
        Task(NAME, "p0 = 5.7 GPa", distance, "roll", {"cells": c, "method": distance}, "after 3 a")
        for c in cells
        for distance in DISTANCES
    ]


def roll(meter: Meter, cells: int, method: str) -> dict[str, Any]:
    """Measure increments of rolling by one cell each, with `cells` cells per contact radius."""
    distance = DISTANCES[method]
    d = CONTACT_RADIUS / cells
    grid = sc.Grid(5 * cells + 1, 4 * cells + 1, d, d, int(2.2 * cells), d)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    simulation = sc.Simulation(grid, CERAMIC, STEEL, gap, residual_stress="fast")
    ramp = [{"load": load} for load in np.linspace(0.0, LOAD, INCREMENTS + 1)[1:]]
    step = {"load": LOAD, "advance": (-d, -d)}
    path = ramp
    if distance >= 0:
        simulation.run([*ramp[1::2], *([step] * (distance * cells))], progress=False)
        path = [step] * INCREMENTS
    earlier = work_of(simulation)
    meter(lambda: simulation.run(path, progress=False))
    row = {name: count - earlier[name] for name, count in work_of(simulation).items()}
    volume = grid.nx * grid.ny * grid.nz
    return {"cells": volume, "across": cells, "errors": {}, **row}
