# SPDX-License-Identifier: GPL-3.0-or-later
"""Small elastic-plastic rough patch under a rigid flat: error relative to the finest grid."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import samcontact as sc

from .harness import Meter, Task, relative_error, rms_error, work_of
from .roughness import block_means, heights, wave_amplitudes
from .steel import STEEL

NAME = "plastic_rough"
TITLE = "Elastic-plastic rough contact"
SIDE = 200e-6  # m
RMS = 0.4e-6  # m
MAX_PERIODS = 6  # periods over the side of the shortest wave
HURST = 0.8
CROWN = 3e-3  # m: radius of curvature that keeps the contact inside the grid
LOAD = 12.0  # N
INCREMENTS = 6
DEPTH = 0.3  # depth of the volume over the side


def tasks(quick: bool, folder: Path) -> list[Task]:
    sizes, finest = ((20, 40), 80) if quick else ((20, 40, 80), 160)
    stored = str(folder / f"{NAME}-{finest}.npz")
    reference = Task(
        NAME, "rough", "fast", "make_reference", {"n": finest, "method": "fast", "file": stored}
    )
    return [
        reference,
        *(
            Task(
                NAME, "rough", method, "solve", {"n": n, "method": method, "file": stored}, "exact"
            )
            for n in sizes
            for method in ("exact", "fast")
        ),
    ]


def run(meter: Meter, n: int, method: str) -> tuple[sc.Simulation, sc.State, sc.State]:
    d = SIDE / n
    grid = sc.Grid(n, n, d, d, int(DEPTH * n), d)
    gap = sc.surfaces.paraboloid(grid, CROWN)
    gap -= heights(n, wave_amplitudes(MAX_PERIODS, HURST, seed=3), RMS)

    def load_and_unload() -> tuple[sc.Simulation, sc.State, sc.State]:
        simulation = sc.Simulation(grid, sc.Material.rigid(), STEEL, gap, residual_stress=method)
        for k in range(1, INCREMENTS + 1):
            loaded = simulation.step(load=LOAD * k / INCREMENTS)
        return simulation, loaded, simulation.step(load=0.0)

    return meter(load_and_unload)


def summary(simulation: sc.Simulation, loaded: sc.State) -> dict[str, Any]:
    grid = simulation.grid
    return {
        "cells": grid.nx * grid.ny * grid.nz,
        "across": grid.nx,
        "contact_fraction": float(np.mean(loaded.pressure > 0)),
        "largest_plastic_strain": float(loaded.equivalent_plastic_strain().max()),
        **work_of(simulation),
    }


def make_reference(meter: Meter, n: int, method: str, file: str) -> dict[str, Any]:
    simulation, loaded, unloaded = run(meter, n, method)
    np.savez(
        file,
        pressure=loaded.pressure,
        approach=loaded.approach,
        strain=loaded.equivalent_plastic_strain().max(),
        print=unloaded.residual_displacement(),
    )
    return summary(simulation, loaded)


def solve(meter: Meter, n: int, method: str, file: str) -> dict[str, Any]:
    simulation, loaded, unloaded = run(meter, n, method)
    with np.load(file) as fine:
        errors = {
            "pressure, rms": rms_error(loaded.pressure, block_means(fine["pressure"], n)),
            "approach": relative_error(loaded.approach, fine["approach"]),
            "largest plastic strain": relative_error(
                loaded.equivalent_plastic_strain().max(), fine["strain"]
            ),
            "imprint, rms": rms_error(
                unloaded.residual_displacement(), block_means(fine["print"], n)
            ),
        }
    return {**summary(simulation, loaded), "errors": errors}
