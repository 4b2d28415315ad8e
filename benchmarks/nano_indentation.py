# SPDX-License-Identifier: GPL-3.0-or-later
"""Nano-indentation in 26 increments: time of the fast method relative to the exact method."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import samcontact as sc
from samcontact.cases import load_case

from .harness import ROOT, Meter, Task, relative_error, work_of

NAME = "nano_indentation"
TITLE = "Nano-indentation, 26 increments"
INTERFERENCE = 372e-9  # m, Boucly (2008), section 2.3.1


def tasks(quick: bool, folder: Path) -> list[Task]:
    return [
        Task(NAME, "v1", method, "solve", {"method": method}, "exact")
        for method in ("exact", "fast")
    ]


def solve(meter: Meter, method: str) -> dict[str, Any]:
    simulation, path = load_case(ROOT / "cases" / "v1_nano_indentation.toml").build()
    grid, path = simulation.grid, list(path)

    def run() -> tuple[sc.Simulation, float]:
        fresh = sc.Simulation(
            grid,
            simulation.body1,
            simulation.body2,
            simulation.initial_gap,
            residual_stress=method,
        )
        return fresh, max(fresh.step(**arguments).approach for arguments in path)

    solved, interference = meter(run)
    return {
        "cells": grid.nx * grid.ny * grid.nz,
        "increments": len(path),
        "approach_nm": 1e9 * interference,
        "errors": {"approach": relative_error(interference, INTERFERENCE)},
        **work_of(solved),
    }
