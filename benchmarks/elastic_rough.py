# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic contact of a crowned self-affine surface: error relative to the finest grid."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import samcontact as sc

from .elastic_smooth import work
from .harness import Meter, Task, relative_error, rms_error
from .roughness import block_means, heights, wave_amplitudes
from .steel import ELASTIC

NAME = "elastic_rough"
TITLE = "Elastic rough contact"
SIDE = 1e-3  # m
RMS = 1e-6  # m
MAX_PERIODS = 12  # periods over the side of the shortest wave
HURST = 0.8
CROWN = 0.02  # m: radius of curvature that keeps the contact inside the grid
LOAD = 60.0  # N: about a tenth of the surface is in contact
TOLERANCES = {"tol 1e-8": 1e-8, "tol 1e-4": 1e-4}
BASE = "tol 1e-8"


def tasks(quick: bool, folder: Path) -> list[Task]:
    sizes, finest = ((32, 64, 128), 256) if quick else ((32, 64, 128, 256, 512), 1024)
    stored = str(folder / f"{NAME}-{finest}.npz")
    reference = Task(
        NAME, "rough", BASE, "make_reference", {"n": finest, "method": BASE, "file": stored}
    )
    return [
        reference,
        *(
            Task(NAME, "rough", method, "solve", {"n": n, "method": method, "file": stored}, BASE)
            for n in sizes
            for method in TOLERANCES
        ),
    ]


def contact(meter: Meter, n: int, method: str) -> sc.ContactSolution:
    grid = sc.Grid(n, n, SIDE / n, SIDE / n)
    gap = sc.surfaces.paraboloid(grid, CROWN)
    gap -= heights(n, wave_amplitudes(MAX_PERIODS, HURST, seed=1), RMS)
    tol = TOLERANCES[method]
    return meter(lambda: sc.ContactSolver(grid, ELASTIC, ELASTIC, tol=tol).solve(gap, load=LOAD))


def make_reference(meter: Meter, n: int, method: str, file: str) -> dict[str, Any]:
    found = contact(meter, n, method)
    np.savez(file, pressure=found.pressure, approach=found.approach)
    return summary(found, n)


def summary(found: sc.ContactSolution, n: int) -> dict[str, Any]:
    area = float(np.mean(found.pressure > 0))
    return {"cells": n * n, "across": n, "contact_fraction": area, **work(found)}


def solve(meter: Meter, n: int, method: str, file: str) -> dict[str, Any]:
    found = contact(meter, n, method)
    with np.load(file) as reference:
        fine, approach = reference["pressure"], float(reference["approach"])
    errors = {
        "contact area": relative_error(np.mean(found.pressure > 0), np.mean(fine > 0)),
        "pressure, rms": rms_error(found.pressure, block_means(fine, n)),
        "approach": relative_error(found.approach, approach),
    }
    return {**summary(found, n), "errors": errors}
