# SPDX-License-Identifier: GPL-3.0-or-later
"""Increments of viscoelastic bodies over those of elastic bodies with equal contacts.

Both kinds are solved in turn in one process. Times are processor times of the increments after the
first three, which build operators; the load of the viscoelastic body is smaller, so that the
last contact is of similar size.
"""

from __future__ import annotations

import math
import tempfile
import time
from pathlib import Path
from typing import Any

import h5py
import numpy as np

import samcontact as sc

from .harness import Meter, Task
from .roughness import heights, wave_amplitudes

NAME = "viscous"
TITLE = "Viscoelastic increments"
SIDE, RADIUS, CONTACT_RADIUS = 1e-3, 10e-3, 0.35e-3  # m
RUBBER = sc.Material.elastic(10e6, 0.45)
RELAXING_SHARE, STEP = 0.8, 0.05  # of the modulus that relaxes; duration of an increment [s]
RELAXED = {2: 0.496, 8: 0.414}  # load for the contact area of the elastic ball
RMS, WAVES, MU = 1e-6, 16, 0.3
TURNS, WARM, MEASURED = 3, 3, 8
CASES = ("ball", "periodic rough surface", "balls with partial slip")


def tasks(quick: bool, folder: Path) -> list[Task]:
    sizes = (64,) if quick else (128, 256)
    return [
        Task(NAME, case, f"{terms} terms", "press", {"case": case, "n": n, "terms": terms})
        for case in CASES
        for n in sizes
        for terms in (2, 8)
    ]


def relaxing(terms: int) -> sc.Material:
    """Return the material with equal shares over two decades of relaxation times."""
    times = np.logspace(-2, 0, terms)
    return RUBBER.with_relaxation(times=times.tolist(), shares=[RELAXING_SHARE / terms] * terms)


def modulus() -> float:
    return RUBBER.E / (1 - RUBBER.nu**2)


def contact(case: str, n: int, body: sc.Material) -> tuple[sc.Simulation, float]:
    """Return a simulation, and the load of an elastic body."""
    if case == CASES[1]:
        grid = sc.Grid(n, n, SIDE / n, SIDE / n, periodic="xy")
        k = np.arange(-WAVES, WAVES + 1)[:, None] + np.arange(WAVES + 1)[None, :]
        waves = wave_amplitudes(WAVES, 0.8, seed=1) * np.exp(-1j * np.pi / n * k)
        gap = -heights(n, waves, RMS)
        return sc.Simulation(grid, sc.Material.rigid(), body, gap), 0.004 * modulus() * SIDE**2
    grid = sc.Grid(n, n, SIDE / n, SIDE / n)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    load = 4 / 3 * modulus() * CONTACT_RADIUS**3 / RADIUS
    if case == CASES[0]:
        return sc.Simulation(grid, sc.Material.rigid(), body, gap), load
    return sc.Simulation(grid, body, body, gap, friction=sc.Coulomb(MU)), load / 2


def loaded(case: str, n: int, body: sc.Material) -> tuple[float, int, sc.Simulation]:
    """Return the processor time of the increments after the first, and their iterations."""
    simulation, load = contact(case, n, body)
    timed = {}
    if body.relaxation_terms is not None:
        load *= RELAXED[len(body.relaxation_terms[0])]
        timed = {"duration": STEP}
    for k in range(WARM + MEASURED):
        if k == WARM:
            before = simulation.counters["contact_iterations"]
            began = time.process_time()
        step: dict[str, Any] = {"load": load * (0.35 + 0.05 * k), **timed}
        if case == CASES[2]:
            step["tangential_load"] = (0.5 * MU * step["load"], 0.0)
        simulation.step(**step)
    spent = time.process_time() - began
    return spent, simulation.counters["contact_iterations"] - before, simulation


def remembered_fields(simulation: sc.Simulation) -> float:
    """Return the size of the memory of body 2 in fields of the whole surface."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "state.h5"
        simulation.save(file)
        with h5py.File(file) as stored:
            values = math.prod(stored["state/traction_memory2/values"].shape)
    return float(values / (simulation.grid.nx * simulation.grid.ny))


def press(meter: Meter, case: str, n: int, terms: int) -> dict[str, Any]:
    """Press an elastic and a viscoelastic body in turn."""
    found: dict[str, list[tuple[float, int, sc.Simulation]]] = {"elastic": [], "viscous": []}

    def turns() -> None:
        for _ in range(TURNS):
            found["elastic"].append(loaded(case, n, RUBBER))
            found["viscous"].append(loaded(case, n, relaxing(terms)))

    meter(turns)
    best = {name: min(row[0] for row in rows) for name, rows in found.items()}
    (_, of_elastic, elastic), (_, of_viscous, viscous) = (rows[-1] for rows in found.values())
    return {
        "cells": n * n,
        "across": n,
        "increment over elastic": best["viscous"] / best["elastic"],
        "iterations over elastic": of_viscous / of_elastic,
        "remembered fields": remembered_fields(viscous),
        "contact_fraction": float(np.mean(viscous.state.pressure > 0)),
        "contact_fraction, elastic": float(np.mean(elastic.state.pressure > 0)),
        "errors": {},
    }


def notes(rows: list[dict[str, Any]]) -> list[str]:
    """Return lines with the largest ratio of each case, and of the memory to its bound."""
    lines = []
    for case in CASES:
        of = [row for row in rows if row["case"] == case]
        if not of:
            continue
        ratio = max(row["increment over elastic"] for row in of)
        fields = max(row["remembered fields"] for row in of)
        lines.append(
            f"- {case}: at most {ratio:.2f} times the elastic increment, and {fields:.1f} "
            "remembered fields of the whole surface for each body."
        )
    return ["\n".join(lines)]
