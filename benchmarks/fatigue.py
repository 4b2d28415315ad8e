# SPDX-License-Identifier: GPL-3.0-or-later
"""Cost of fatigue criteria for a pass of 60 states over a body."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import samcontact as sc

from .harness import Meter, Task
from .steel import STEEL

NAME = "fatigue"
TITLE = "Fatigue, a pass of 60 states"
STATES = 60
RADIUS, HALF_LENGTH = 10e-3, 200e-6
CRITERIA: dict[str, dict[str, Any]] = {
    "stress of the states": {},
    "dang_van": {"slope": 0.3},
    "crossland": {"slope": 0.3},
    "findley": {"k": 0.3},
    "fatemi_socie": {"k": 0.5},
    "orthogonal_shear": {},
}


def tasks(quick: bool, folder: Path) -> list[Task]:
    sizes = (24,) if quick else (48, 128)
    return [
        Task(NAME, "rolling ball", name, "judge", {"cells": n, "method": name}, "dang_van")
        for n in sizes
        for name in CRITERIA
    ]


def judge(meter: Meter, cells: int, method: str) -> dict[str, Any]:
    """Measure a criterion on `cells` x `cells` x `cells`/2 cells that are common to all states."""
    d = 4 * HALF_LENGTH / cells
    grid = sc.Grid(cells + STATES, cells, d, d, nz=cells // 2, dz=d)
    elastic = sc.Material.elastic(STEEL.E, STEEL.nu)
    hertz = sc.hertz.point(RADIUS, elastic.E / (2 * (1 - elastic.nu**2)), p0=2.0e9)
    # an elastic-plastic body 2 would move the grid along; an elastic one does not
    hard = sc.Material.perfect_plastic(elastic.E, elastic.nu, 100 * hertz.p0)
    simulation = sc.Simulation(grid, elastic, hard, sc.surfaces.paraboloid(grid, RADIUS))
    steps: list[dict[str, Any]] = [{"load": hertz.load}]
    steps += [{"load": hertz.load, "advance": (-d, -d)}] * (STATES - 1)
    states = simulation.run(steps, progress=False)
    cycle = sc.fatigue.cycle(states, 2)
    if method == "stress of the states":
        meter(lambda: sc.fatigue.orthogonal_shear(cycle))
    else:
        sc.fatigue.orthogonal_shear(cycle)  # omits the stress from the measurement
        meter(lambda: getattr(sc.fatigue, method)(cycle, **CRITERIA[method]))
    points = cycle.points_shape[0] * cycle.points_shape[1] * cycle.points_shape[2]
    return {"cells": points, "across": cells, "errors": {}}
