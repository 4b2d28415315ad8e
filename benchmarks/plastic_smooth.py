# SPDX-License-Identifier: GPL-3.0-or-later
"""Two steel balls, loaded to 1500 N and unloaded: comparison with axisymmetric finite elements."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import samcontact as sc
from reference import fem

from .harness import Meter, Task, relative_error, work_of
from .steel import LOAD, balls

NAME = "plastic_smooth"
TITLE = "Elastic-plastic contact of two balls"


def tasks(quick: bool, folder: Path) -> list[Task]:
    sizes, increments = ((8, 12), 12) if quick else ((8, 12, 16, 24, 32), 24)
    return [
        Task(
            NAME,
            "two balls",
            method,
            "solve",
            {"across": across, "increments": increments, "method": method},
            "exact",
        )
        for across in sizes
        for method in ("exact", "fast")
    ]


def solve(meter: Meter, across: int, increments: int, method: str) -> dict[str, Any]:
    """Load two balls in equal increments, unload in one; `across`: cells per Hertz radius."""

    def run() -> tuple[sc.Simulation, sc.State, sc.State]:
        simulation = balls(across, residual_stress=method)
        for k in range(1, increments + 1):
            loaded = simulation.step(load=LOAD * k / increments)
        return simulation, loaded, simulation.step(load=0.0)

    simulation, loaded, unloaded = meter(run)
    grid = simulation.grid
    axis = (grid.nx // 2, grid.ny // 2)
    case = fem.load("2b1500")
    summary = case.summary
    r, uz = (case.surface_uz[key] for key in ("r_m", "uz_residual_m"))
    profile = unloaded.residual_displacement()[axis[0] :, axis[1]]
    print_error = np.abs(profile - np.interp(grid.x[axis[0] :], r, uz)).max() / np.abs(uz).max()
    computed = {
        "largest pressure": (loaded.pressure.max(), summary["p_max_Pa"]),
        "largest plastic strain": (
            loaded.equivalent_plastic_strain().max(),
            summary["loaded"]["max_gamma_p"],
        ),
        "residual von Mises": (
            unloaded.von_mises()[axis].max(),
            summary["unloaded"]["max_vm_Pa"],
        ),
    }
    errors = {quantity: relative_error(*pair) for quantity, pair in computed.items()}
    errors["imprint depth"] = float(print_error)
    cells = grid.nx * grid.ny * grid.nz
    return {"cells": cells, "across": across, "errors": errors, **work_of(simulation)}
