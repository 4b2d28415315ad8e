# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies with properties that vary with depth: one coating, five layers, a yield profile.

Layers differ so little from the substrate that all bodies deform equally. The bodies are solved in
turn. Times are processor times; the first increment, which computes tables, is timed separately.
"""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import numpy as np

import samcontact as sc

from .harness import Meter, Task

NAME = "layers"
TITLE = "Yield-stress profiles and layers"
STEEL = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
RADIUS = 10e-3  # m
LOADS = (900.0, 904.0, 908.0, 912.0)  # N; the first increment computes tables
TURNS = 3
BODIES = ("homogeneous", "yield-stress profile", "one coating", "five layers")


def tasks(quick: bool, folder: Path) -> list[Task]:
    return [Task(NAME, "ball on steel", "all bodies", "press", {"n": n})
            for n in ((12,) if quick else (12, 24, 48))]  # fmt: skip


def body_of(name: str, cell: float) -> sc.Material | sc.Layered:
    """Return the body with this name; layers are as thick as a cell, whose size is `cell` [m]."""
    if name == "yield-stress profile":
        return STEEL.with_yield_profile([0.0, 2 * cell, 20 * cell], [1.02, 1.01, 1.0])
    if name == "homogeneous":
        return STEEL
    count = 1 if name == "one coating" else 5
    layers = [(sc.Material.elastic(STEEL.E * (1 + 1e-4 * n), STEEL.nu), cell)
              for n in range(count, 0, -1)]  # fmt: skip
    return sc.Layered(tuple(layers), STEEL)


def measured_increments(body: sc.Material | sc.Layered, grid: sc.Grid) -> dict[str, float]:
    """Return processor times of the first increment and of a later iteration, and the memory."""
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    began = time.process_time()
    simulation = sc.Simulation(grid, sc.Material.rigid(), body, gap, tol=1e-6)
    simulation.step(load=LOADS[0])
    first = time.process_time() - began
    before = simulation.counters["plastic_iterations"]
    began = time.process_time()
    for load in LOADS[1:]:
        simulation.step(load=load)
    count = simulation.counters["plastic_iterations"] - before
    return {
        "first": first,
        "iteration": (time.process_time() - began) / count,
        "iterations": count,
        "bytes": simulation.counters["volume_bytes"],
    }


def press(meter: Meter, n: int) -> dict[str, Any]:
    """Load all bodies on a grid with `n` cells per Hertz radius at the last load."""
    a = sc.hertz.point(RADIUS, sc.hertz.effective_modulus(sc.Material.rigid(), STEEL),
                       load=LOADS[-1]).a  # fmt: skip
    cell = a / n
    across = 2 * int(1.3 * n) + 1
    grid = sc.Grid(across, across, cell, cell, dz=cell)
    found: dict[str, list[dict[str, float]]] = {name: [] for name in BODIES}

    def turns() -> None:
        for _ in range(TURNS if n < 40 else 1):
            for name in BODIES:
                found[name].append(measured_increments(body_of(name, cell), grid))

    meter(turns)
    best = {
        name: {key: min(row[key] for row in rows) for key in rows[0]}
        for name, rows in found.items()
    }
    base = best["homogeneous"]
    columns: dict[str, Any] = {
        "cells": grid.nx * grid.ny,
        "across": n,
        "ms_per_iteration": 1e3 * base["iteration"],
        "volume_applications": base["iterations"],
    }
    for name in BODIES[1:]:
        for key, label in (("iteration", "iteration"), ("first", "first increment"),
                           ("bytes", "memory")):  # fmt: skip
            columns[f"{label}, {name}"] = best[name][key] / base[key]
    return {**columns, "errors": {}}


def notes(rows: list[dict[str, Any]]) -> list[str]:
    """Return lines with the maximum ratios of times and memory to the homogeneous body."""
    lines = []
    for name in BODIES[1:]:
        stated = [
            f"{label} {np.max([row[f'{label}, {name}'] for row in rows]):.2f}"
            for label in ("iteration", "first increment", "memory")
        ]
        lines.append(f"- {name}, maximum ratio to the homogeneous body: {', '.join(stated)}.")
    return ["\n".join(lines)]
