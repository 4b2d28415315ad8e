# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts on cells with aspect ratios from 1:1 to 1:16, along the surface and in depth."""

from __future__ import annotations

from typing import Any

import numpy as np

import samcontact as sc

from .materials import MU, RADIUS, STEEL, YIELD, E, slip_error
from .table import COUNT, VALUE, Column, Table, trace

ASPECT_RATIOS = ("1:1", "2:1", "4:1", "8:1", "16:1", "1:16")
ACROSS = 24  # number of cells along the coarser direction
SOFT = sc.Material.linear_hardening(E, 0.3, YIELD, 0.1 * E)
EXACT = sc.hertz.point(RADIUS, sc.hertz.effective_modulus(STEEL, STEEL), p0=2.4e9)
FLAT = {
    "square, coarse": (17, 17, 10), "square, fine": (33, 33, 20),
    "dx:dy = 4:1": (15, 59, 12), "dx:dy = 16:1": (9, 145, 12), "dx:dy = 1:16": (145, 9, 12),
    "dx:dz = 4:1": (15, 15, 40), "dx:dz = 16:1": (13, 13, 128),
    "dx:dz = 1:4": (51, 51, 8), "dx:dz = 1:16": (103, 103, 4),
}  # fmt: skip
"""Numbers of cells along x, y and z, by name of the table row."""


def long_cells(row: str) -> dict[str, Any]:
    """Solve elastic contact on long cells, without friction and with partial slip."""
    x, y = map(int, row.split(":"))
    nx, ny = ACROSS * y, ACROSS * x
    grid = sc.Grid(nx, ny, 2.6 * EXACT.a / nx, 2.6 * EXACT.a / ny)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    found = sc.ContactSolver(grid, STEEL, STEEL).solve(gap, load=EXACT.load)
    expected = EXACT.pressure(grid.x[:, None], grid.y)
    pulled = sc.ContactSolver(grid, STEEL, STEEL, sc.Coulomb(MU)).solve(
        gap, load=EXACT.load, tangential_load=(0.5 * MU * EXACT.load, 0.0)
    )
    softness = 4 * (2 - STEEL.nu) * (1 + STEEL.nu) / E
    moved = 3 * MU * EXACT.load * softness / (16 * EXACT.a) * (1 - 0.5 ** (2 / 3))
    return {
        "cells": nx * ny,
        "iterations": found.iterations,
        "approach": abs(found.approach / EXACT.approach - 1),
        "pressure": float(np.abs(found.pressure - expected).sum() / expected.sum()),
        "shear": pulled.tangential_iterations,
        "shift": abs(pulled.shift[0] / moved - 1),
        "law": slip_error(pulled, MU),
    }


def dent(cells: tuple[int, int, int]) -> tuple[sc.State, np.ndarray]:
    """Return the loaded state, and an array of three results.

    The results are the maximum pressure [Pa], the imprint depth [m] and the volume integral of the
    equivalent plastic strain [m³].
    """
    nx, ny, nz = cells
    grid = sc.Grid(nx, ny, 3.2 * EXACT.a / nx, 3.2 * EXACT.a / ny, nz, 2 * EXACT.a / nz)
    simulation = sc.Simulation(grid, STEEL, SOFT, sc.surfaces.paraboloid(grid, RADIUS))
    loaded = simulation.step(load=EXACT.load)
    state = simulation.step(load=0.0)
    flow = state.equivalent_plastic_strain().sum() * grid.cell_area * grid.dz
    return loaded, np.array([loaded.pressure.max(), state.residual_displacement().max(), flow])


def flat_cells(row: str) -> dict[str, Any]:
    """Compare results on cells of the given shape with results on fine square cells."""
    state, values = dent(FLAT[row])
    pressure, depth, volume = np.abs(values / dent(FLAT["square, fine"])[1] - 1)
    return {
        "cells": int(np.prod(FLAT[row])),
        "evaluations": state.iterations,
        "contact": state.contact_iterations,
        "pressure": float(pressure),
        "print": float(depth),
        "flow": float(volume),
        "beyond": max(state.yield_violation, 0.0),
        "trace": trace(state.plastic_strain()),
    }


SURFACE = Table(
    "long_cells", "dx:dy", ASPECT_RATIOS, long_cells,
    (
        Column("cells", "cells", COUNT),
        Column("iterations", "elastic: iterations", COUNT, 40),
        Column("approach", "approach error (Hertz)", VALUE, 1e-3),
        Column("pressure", "pressure error (Hertz)", VALUE, 1e-2),
        Column("shear", "partial slip: iterations", COUNT),
        Column("shift", "displacement error (Mindlin)", VALUE, 2e-2),
        Column("law", "excess over μ p", at_most=1e-12),
    ),
    "16:1",
)  # fmt: skip
VOLUME = Table(
    "flat_cells", "cells", tuple(FLAT), flat_cells,
    (
        Column("cells", "number", COUNT),
        Column("evaluations", "evaluations", COUNT, 40),
        Column("contact", "contact iterations", COUNT),
        Column("pressure", "pressure", VALUE, 0.05),
        Column("print", "imprint depth", VALUE, 0.15),
        Column("flow", "plastic strain", VALUE, 0.15),
        Column("beyond", "yield excess", at_most=1e-6),
        Column("trace", "volume change", at_most=1e-14),
    ),
    "square, coarse",
)  # fmt: skip
