# SPDX-License-Identifier: GPL-3.0-or-later
"""Rough contacts of `plastic_zones` on grids so large that one box hardly fits into memory."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from .harness import Meter, Task, work_of
from .plastic_zones import make_reference, run, solve

__all__ = ["make_reference", "press_and_unload", "solve", "tasks"]

NAME = "plastic_zones_large"
TITLE = "Large plastic zones of rough surfaces"
PERCENT = 5  # contact fraction under full load [%]
INCREMENTS = 4


def tasks(quick: bool, folder: Path) -> list[Task]:
    sizes = (96, 128) if quick else (1024, 2048)
    stored = str(folder / f"{NAME}-{sizes[0]}.npz")
    given = {"n": sizes[0], "percent": PERCENT, "file": stored, "parts": [1 / INCREMENTS]}
    found = [
        Task(NAME, "first increment", "one box", "make_reference", given, "one box"),
        Task(NAME, "first increment", "subdomains", "solve", given, "one box"),
    ]
    case = f"{INCREMENTS} increments and unloading"
    return found + [Task(NAME, case, "subdomains", "press_and_unload", {"n": n}) for n in sizes]


def press_and_unload(meter: Meter, n: int) -> dict[str, Any]:
    parts = [(k + 1) / INCREMENTS for k in range(INCREMENTS)]
    simulation, states = run(meter, n, PERCENT, "auto", [*parts, 0.0])
    peak, unloaded = states[-2:]
    return {
        "cells": n * n * len(unloaded.depths),
        "across": n,
        "contact_fraction": float((peak.pressure > 0).mean()),
        "plastic_cells": unloaded.plastic_cells(),
        "largest_strain": unloaded.max_equivalent_plastic_strain(),
        **work_of(simulation),
    }
