# SPDX-License-Identifier: GPL-3.0-or-later
"""Cost and error of the fast residual stress due to its periodicity, by image tolerance.

The plastic strain is smooth, (1 - r^2)^4. The stress differs from the
stress in a box eight times as wide only because of periodic images.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import samcontact as sc

from .harness import Meter, Task, largest_error
from .operators import load_arrays, stress

NAME = "images"
TITLE = "Periodic images of the fast residual stress"
SERIES = ("case",)
BOXES = {  # nx, ny, nz, layer thickness over cell size
    "48 x 48 x 32": (48, 48, 32, 1.0),
    "48 x 24 x 32": (48, 24, 32, 1.0),
    "48 x 48 x 80": (48, 48, 80, 1.0),
    "80 x 16 x 20": (80, 16, 20, 1.0),
    "48 x 48 x 20, thin layers": (48, 48, 20, 0.3),
}
TOLERANCES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)
REFERENCE_WIDTH_FACTOR = 8
BASE = "image_tol 1e-03"


def tasks(quick: bool, folder: Path) -> list[Task]:
    found = []
    for box in list(BOXES)[:1] if quick else BOXES:
        stored = str(folder / f"{NAME}-{box.replace(' ', '')}.npz")
        arguments: dict[str, Any] = {"box": box, "file": stored}
        found.append(Task(NAME, box, "reference", "make_reference", arguments, hidden=True))
        for tol in TOLERANCES:
            method = f"image_tol {tol:.0e}"
            found.append(Task(NAME, box, method, "apply", {**arguments, "method": method}, BASE))
    return found


def blob(box: str) -> tuple[sc.Grid, np.ndarray]:
    nx, ny, nz, dz = BOXES[box]
    grid = sc.Grid(nx, ny, 1.0, 1.0, nz, dz)
    x, y = grid.x[:, None, None] / grid.x[-1], grid.y[None, :, None] / grid.y[-1]
    r2 = x**2 + y**2 + (2 * grid.z / (nz * dz) - 1) ** 2
    components = np.random.default_rng(0).standard_normal(6)
    return grid, 1e-3 * components[:, None, None, None] * np.maximum(1 - r2, 0.0) ** 4


def make_reference(meter: Meter, box: str, file: str) -> dict[str, Any]:
    grid, strain = blob(box)
    n = REFERENCE_WIDTH_FACTOR * max(grid.nx, grid.ny)
    wide = sc.Grid(n, n, 1.0, 1.0, grid.nz, grid.dz)
    i, j = (n - grid.nx) // 2, (n - grid.ny) // 2
    here = np.s_[:, i : i + grid.nx, j : j + grid.ny]
    embedded = np.zeros((6, *wide.volume_shape))
    embedded[here] = strain
    field = meter(lambda: stress(wide, embedded, "fast", 1e-6))
    np.savez(file, stress=field[here])
    return {}


def apply(meter: Meter, box: str, file: str, method: str) -> dict[str, Any]:
    """Measure the set-up of the operator and one application."""
    grid, strain = blob(box)
    field = meter(lambda: stress(grid, strain, "fast", float(method.split()[1])))
    cells = grid.nx * grid.ny * grid.nz
    errors = {"stress, largest": largest_error(field, load_arrays(file)["stress"])}
    return {"cells": cells, "volume_applications": 1, "errors": errors}


def notes(rows: list[dict[str, Any]]) -> list[str]:
    """Return a sentence with the maximum error for each image tolerance."""
    worst: dict[float, float] = {}
    for row in rows:
        bound = float(row["method"].removeprefix("image_tol "))
        worst[bound] = max(worst.get(bound, 0.0), row["error: stress, largest"])
    stated = [f"{error:.1e} for image_tol {bound:.0e}" for bound, error in worst.items()]
    return [f"Maximum error in all boxes: {', '.join(stated)}."]
