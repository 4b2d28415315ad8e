# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure near the end of a roller, by samcontact and by finite elements."""

from __future__ import annotations

import json
import warnings
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import reference
import samcontact as sc

from .study import table

RADIUS, LENGTH, LOAD = 8e-3, 12e-3, 5e3
CELL_X, CELL_Y, ROWS_BEYOND = 16e-6, 20e-6, 1
STEEL = sc.Material.elastic(210e9, 0.3)
DISTANCES = (0.05e-3, 0.1e-3, 0.2e-3, 0.4e-3, 1e-3)
DATA = Path(reference.__file__).parent / "roller_end"
ENDS = {"flush": "both bodies end", "overhang": "one body ends"}
METHODS = {"exact": '"exact"', "factor": '"factor"', "": "half-space"}


def elements() -> dict[str, list[float]]:
    """Return the ratios of pressure by finite elements at the distances, for both kinds of end."""
    known = json.loads((DATA / "block.json").read_text())
    found = {end: np.interp(DISTANCES, known["y"], known[end]).tolist() for end in ENDS}
    return found


def meshed_roller() -> list[float]:
    """Return the ratios by CalculiX on the meshed roller, both bodies ending; NaN below a node."""
    known = json.loads((DATA / "calculix.json").read_text())
    found = np.interp(DISTANCES, known["y"], known["pressure_over_hertz"])
    return [r if d >= 2 * known["y"][1] else np.nan for d, r in zip(DISTANCES, found, strict=True)]


def hertz_pressure(load: float = LOAD) -> float:
    """Return the maximum pressure by Hertz for a line [Pa]."""
    modulus = sc.hertz.effective_modulus(STEEL, STEEL)
    return sc.hertz.line(RADIUS, modulus, load_per_length=load / LENGTH).p0


def ratios(
    end: str, method: str, cell_y: float = CELL_Y, length: float = LENGTH
) -> NDArray[np.float64]:
    """Return the pressure on the centre line over the maximum by Hertz, at the distances.

    method: that of the free faces; "" means half-spaces. length: of the roller, under the same load
    per length.
    """
    rows = round(length / cell_y)
    grid = sc.Grid(38, rows + 2 * ROWS_BEYOND, CELL_X, cell_y)
    faces = STEEL
    if method:
        faces = STEEL.with_free_faces(low=-length / 2, high=length / 2, method=method)
    bodies = (faces, faces if end == "flush" else STEEL)
    inside = np.abs(grid.y) < length / 2
    gap = np.where(inside, grid.x[:, None] ** 2 / (2 * RADIUS), np.inf)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", sc.SingularPressureWarning)
        found = sc.ContactSolver(grid, *bodies).solve(gap, load=LOAD * length / LENGTH)
    centre = found.pressure[grid.nx // 2 - 1 : grid.nx // 2 + 1, inside].mean(axis=0)
    ratio = np.interp(DISTANCES, grid.y[inside] + length / 2, centre) / hertz_pressure()
    return np.asarray(ratio)


def stated_pressures() -> str:
    """Return the table of pressures near the end by all methods."""
    known = elements()
    rows = []
    for end, words in ENDS.items():
        rows.append([words, "finite elements, blocks", *(f"{r:.3f}" for r in known[end])])
        if end == "flush":
            meshed = ("" if np.isnan(r) else f"{r:.3f}" for r in meshed_roller())
            rows.append([words, "CalculiX, meshed roller", *meshed])
        for method, name in METHODS.items():
            rows.append([words, name, *(f"{r:.3f}" for r in ratios(end, method))])
    heading = [f"{1e3 * d:g} mm" for d in DISTANCES]
    return table(["ends", "method", *heading], rows)
