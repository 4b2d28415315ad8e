# SPDX-License-Identifier: GPL-3.0-or-later
"""Rough contacts that yield at many spots: plastic subdomains compared with a single box."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

import samcontact as sc

from .harness import Meter, Task, relative_error, rms_error, work_of
from .steel import STEEL

NAME = "plastic_zones"
TITLE = "Plastic zones of rough surfaces"
CELL = 1e-6  # m
SLOPE = 0.06  # rms
MIN_WAVELENGTH = 8  # cells per shortest wave
ROLL_OFF = 64  # cells
HARDNESS = 4.2e9  # Pa; approximate load over contact area
LOADING = (0.5, 1.0)  # fractions of the load
BOWL = 3.0  # height of the border over the rms roughness; keeps the contact inside
SINKS_FROM = 1024  # cells; larger surfaces sink deeper and need a higher border


def tasks(quick: bool, folder: Path) -> list[Task]:
    sizes = (96,) if quick else (128, 256, 512)
    found = []
    for n in sizes:
        for percent in (2, 5):
            stored = str(folder / f"{NAME}-{n}-{percent}.npz")
            for method, function in (("one box", "make_reference"), ("subdomains", "solve")):
                given = {"n": n, "percent": percent, "file": stored}
                found.append(
                    Task(NAME, f"{percent} % in contact", method, function, given, "one box")
                )
    return found


def gap(grid: sc.Grid) -> np.ndarray:
    """Return the gap of a rigid, self-affine rough flat, increased near the borders [m]."""
    rough = sc.surfaces.rough_self_affine(
        grid, 1e-6, 0.8, wavelength_min=MIN_WAVELENGTH * CELL, roll_off=ROLL_OFF * CELL, seed=7
    )
    slopes = np.gradient(rough, CELL)
    rough *= SLOPE / np.sqrt(np.mean(slopes[0] ** 2 + slopes[1] ** 2))
    x, y = np.meshgrid(grid.x, grid.y, indexing="ij")
    side = np.maximum(np.abs(x), np.abs(y)) / (0.5 * grid.nx * CELL)
    bowl = BOWL * max(1.0, grid.nx / SINKS_FROM) * rough.std()
    return np.asarray(rough - rough.min() + bowl * side**8)


def run(
    meter: Meter, n: int, percent: float, zones: str, parts: Sequence[float] = LOADING
) -> tuple[sc.Simulation, list[sc.State]]:
    """Solve contacts under fractions `parts` of the load for a contact area of about `percent`."""
    grid = sc.Grid(n, n, CELL, CELL, dz=CELL)
    surface, area = gap(grid), (n * CELL) ** 2

    def press() -> tuple[sc.Simulation, list[sc.State]]:
        simulation = sc.Simulation(grid, sc.Material.rigid(), STEEL, surface, tol=1e-3, zones=zones)
        full = percent / 100 * HARDNESS * area
        return simulation, [simulation.step(load=part * full) for part in parts]

    return meter(press)


def summary(simulation: sc.Simulation, state: sc.State) -> dict[str, Any]:
    grid = simulation.grid
    return {
        "cells": grid.nx * grid.ny * len(state.depths),
        "across": grid.nx,
        "contact_fraction": float(np.mean(state.pressure > 0)),
        "plastic_cells": state.plastic_cells(),
        **work_of(simulation),
    }


def numbers(state: sc.State) -> dict[str, Any]:
    return {
        "pressure": state.pressure,
        "print": state.residual_displacement(),
        "gap": state.gap.mean(),
        "strain": state.max_equivalent_plastic_strain(),
    }


def make_reference(
    meter: Meter, n: int, percent: float, file: str, parts: Sequence[float] = LOADING
) -> dict[str, Any]:
    simulation, states = run(meter, n, percent, "one", parts)
    np.savez(file, **numbers(states[-1]))
    return summary(simulation, states[-1])


def solve(
    meter: Meter, n: int, percent: float, file: str, parts: Sequence[float] = LOADING
) -> dict[str, Any]:
    simulation, states = run(meter, n, percent, "auto", parts)
    ours = numbers(states[-1])
    with np.load(file) as whole:
        errors = {
            "pressure, rms": rms_error(ours["pressure"], whole["pressure"]),
            "imprint, rms": rms_error(ours["print"], whole["print"]),
            "mean gap": relative_error(ours["gap"], whole["gap"]),
            "largest plastic strain": relative_error(ours["strain"], whole["strain"]),
        }
    return {**summary(simulation, states[-1]), "errors": errors}


def notes(rows: list[dict[str, Any]]) -> list[str]:
    """Return sentences that compare time, memory and fields of subdomains and of one box."""
    lines = []
    for across in sorted({row["across"] for row in rows}):
        at = [row for row in rows if row["across"] == across]
        one, zones = (
            [row for row in at if row["method"] == name] for name in ("one box", "subdomains")
        )
        if one and zones:
            times = [row["time_ratio"] for row in zones]
            memory = [b["memory_MB"] / a["memory_MB"] for a, b in zip(one, zones, strict=True)]
            errors = [row[key] for row in zones for key in row if key.startswith("error: ")]
            lines.append(
                f"- {across:.0f} cells across: subdomains need {min(times):.2f} to "
                f"{max(times):.2f} of the time and {min(memory):.2f} to {max(memory):.2f} "
                "of the memory of one box; the relative difference of the fields is at most "
                f"{max(errors):.1e}."
            )
    return ["\n".join(lines)] if lines else []
