# SPDX-License-Identifier: GPL-3.0-or-later
"""Drift of the results over a thousand load cycles, after the first few cycles."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np

import samcontact as sc

from .table import COUNT, VALUE, Column, Table, relative_difference, trace

E, NU, RADIUS, YIELD = 210e9, 0.3, 7.5e-3, 1e9
ELASTIC = sc.Material.elastic(E, NU)
PERFECT = sc.Material.perfect_plastic(E, NU, YIELD)
LAWS = {
    "perfectly plastic": PERFECT,
    "linear hardening": sc.Material.linear_hardening(E, NU, YIELD, 0.1 * E),
    "kinematic": PERFECT.with_kinematic_hardening(0.11 * E),
}
CYCLES, SETTLED = 1000, 60
SIZE = 1e-6
ZONES = sc.Grid(64, 64, SIZE, SIZE, 6, SIZE)


def ball() -> tuple[sc.Grid, Any, float]:
    exact = sc.hertz.point(RADIUS, sc.hertz.effective_modulus(ELASTIC, ELASTIC), p0=2.4e9)
    size = 3.2 * exact.a / 11
    grid = sc.Grid(11, 11, size, size, 6, 1.9 * exact.a / 6)
    return grid, sc.surfaces.paraboloid(grid, RADIUS), exact.load


def asperities() -> tuple[sc.Grid, Any, float]:
    """Return four asperities of different height, each with its own plastic zone."""
    x, y, away = ZONES.x[:, None], ZONES.y, 22 * SIZE
    corners = itertools.product((-away, away), repeat=2)
    spheres = [np.hypot(x - a, y - b) ** 2 / 60e-6 + n * 1e-8 for n, (a, b) in enumerate(corners)]
    return ZONES, np.minimum.reduce(spheres), 0.04


def rough() -> tuple[sc.Grid, Any, float]:
    """Return a periodic rough surface with contact spots of few cells."""
    grid = sc.Grid(64, 64, SIZE, SIZE, 5, SIZE, periodic="xy")
    heights = sc.surfaces.rough_self_affine(
        grid, 1e-7, 0.8, wavelength_min=8 * SIZE, roll_off=16 * SIZE, seed=7
    )
    return grid, heights - heights.min(), 0.1


SETUPS = {"ball": ball, "four asperities": asperities, "rough": rough}
ROWS = tuple(f"{setup}, {law}" for setup in SETUPS for law in LAWS)


def cycled(row: str, cycles: int = CYCLES, settled: int = SETTLED) -> dict[str, Any]:
    """Load and unload repeatedly; return changes of plastic strain and imprint over the cycles."""
    setup, _, law = row.partition(", ")
    grid, gap, load = SETUPS[setup]()
    zones = "one" if setup == "ball" else "auto"
    simulation = sc.Simulation(grid, ELASTIC, LAWS[law], gap, zones=zones, on_border="warn")
    first = simulation.step(load=load).plastic_strain()
    for cycle in range(cycles):
        unloaded = simulation.step(load=0.0)
        state = simulation.step(load=load)
        if cycle == settled:
            early, bare = state.plastic_strain(), unloaded.residual_displacement()
        if cycle == cycles - 2:
            last = state.plastic_strain()
    strain = state.plastic_strain()
    return {
        "zones": len(state.zones(2)),
        "all": relative_difference(strain, first),
        "strain": relative_difference(strain, last),
        "drift": relative_difference(strain, early) / (cycles - settled),
        "print": relative_difference(unloaded.residual_displacement(), bare) / (cycles - settled),
        "trace": trace(strain),
        "load": abs(state.pressure.sum() * grid.cell_area / load - 1),
    }


TABLE = Table(
    "cycles", f"case, {CYCLES} cycles", ROWS, cycled,
    (
        Column("zones", "subdomains", COUNT),
        Column("all", "strain, all cycles", VALUE),
        Column("strain", "strain, last cycle"),
        Column("drift", f"strain, per cycle after {SETTLED}"),
        Column("print", f"imprint depth, per cycle after {SETTLED}"),
        Column("trace", "volume change", at_most=1e-13),
        Column("load", "load error", at_most=1e-12),
    ),
    "ball, linear hardening",
)  # fmt: skip
