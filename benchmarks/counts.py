# SPDX-License-Identifier: GPL-3.0-or-later
"""Operator applications per increment; cost and benefit of automatic sub-increments."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import samcontact as sc
from gallery.profiles import von_mises

from .harness import Meter, Task, largest_error, work_of
from .steel import HEAVY_LOAD, LOAD, balls

NAME = "counts"
TITLE = "Operator applications and increments"
SERIES = ("case", "control")
HEAVY_SETUP = {"load": HEAVY_LOAD, "width": 1.8, "depth": 2.4}
LOADINGS = {  # load [N], increments
    "1500 N in 20 increments": (LOAD, 20),
    "1500 N in one increment": (LOAD, 1),
    "p0 = 8 GPa in one increment": (HEAVY_LOAD, 1),
}
CYCLE = "p0 = 8 GPa and unloading"


def tasks(quick: bool, folder: Path) -> list[Task]:
    across = 8 if quick else 16
    found = [
        Task(NAME, case, "fast", "load_up", {"across": across, "path": case, "method": "fast"})
        for case in LOADINGS
    ]
    # Equal numbers of loading and unloading increments; the last is the reference.
    across, finest = (6, 50) if quick else (10, 200)
    stored = str(folder / f"{NAME}-{across}-{finest}.npz")
    base = f"{finest} increments"
    methods = {base: "make_reference", "2 increments": "cycle", "20 increments": "cycle"}
    for tol in (2e-2, 5e-3, 2e-3):
        methods[f"increment_tol {tol:g}"] = "cycle"
    for method, function in methods.items():
        arguments = {"across": across, "method": method, "file": stored}
        found.append(Task(NAME, CYCLE, method, function, arguments, base))
    return found


def columns(simulation: sc.Simulation, increments: int, substeps: int) -> dict[str, Any]:
    grid, work = simulation.grid, work_of(simulation)
    applications = work["volume_applications"]
    return {
        "cells": grid.nx * grid.ny * grid.nz,
        "increments": increments,
        "substeps": substeps,
        "applications_per_increment": applications / increments,
        "contact_iterations_per_application": work["contact_iterations"] / applications,
        **work,
    }


def load_up(meter: Meter, across: int, path: str, method: str) -> dict[str, Any]:
    load, increments = LOADINGS[path]
    settings = HEAVY_SETUP if load == HEAVY_LOAD else {}

    def run() -> tuple[sc.Simulation, int]:
        simulation = balls(across, **settings, residual_stress=method)
        substeps = 0
        for k in range(1, increments + 1):
            substeps += simulation.step(load=load * k / increments).substeps
        return simulation, substeps

    simulation, substeps = meter(run)
    return columns(simulation, increments, substeps)


def there_and_back(
    meter: Meter, across: int, method: str
) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
    """Load and unload two balls; return the fields to compare, and the columns of the table.

    method: number of increments, or a tolerance.
    """
    automatic = method.startswith("increment_tol")
    half = 1 if automatic else int(method.split()[0]) // 2
    tol = float(method.split()[1]) if automatic else None

    def run() -> tuple[sc.Simulation, sc.State, sc.State, int]:
        simulation = balls(across, **HEAVY_SETUP, increment_tol=tol, residual_stress="fast")
        substeps = 0
        for k in range(1, half + 1):
            loaded = simulation.step(load=HEAVY_LOAD * k / half)
            substeps += loaded.substeps
        for k in range(half - 1, -1, -1):
            unloaded = simulation.step(load=HEAVY_LOAD * k / half)
            substeps += unloaded.substeps
        return simulation, loaded, unloaded, substeps

    simulation, loaded, unloaded, substeps = meter(run)
    fields = {
        "pressure": loaded.pressure,
        "plastic strain": unloaded.equivalent_plastic_strain(),
        "residual von Mises": von_mises(unloaded.residual_stress()),
        "imprint": unloaded.residual_displacement(),
    }
    control = "increment_tol" if automatic else "given increments"
    return fields, {"control": control, **columns(simulation, 2 * half, substeps)}


def make_reference(meter: Meter, across: int, method: str, file: str) -> dict[str, Any]:
    fields, work = there_and_back(meter, across, method)
    np.savez(file, **fields)
    return work


def cycle(meter: Meter, across: int, method: str, file: str) -> dict[str, Any]:
    """Load and unload; compare all fields with the run with the smallest increments."""
    fields, work = there_and_back(meter, across, method)
    with np.load(file) as fine:
        errors = {name: largest_error(field, fine[name]) for name, field in fields.items()}
    return {**work, "errors": errors}
