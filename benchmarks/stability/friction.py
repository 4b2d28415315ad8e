# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts with coefficients of friction from zero to infinity, for three pairs of materials."""

from __future__ import annotations

import contextlib
import math
from typing import Any

import numpy as np

import samcontact as sc

from .materials import RADIUS, E, slip_error
from .table import COUNT, Column, Table, largest

LOAD = 300.0
BODIES = {
    "identical": (sc.Material.elastic(E, 0.3), sc.Material.elastic(E, 0.3)),
    "ν = 0 and 0.499": (sc.Material.elastic(E, 0.0), sc.Material.elastic(E, 0.499)),
    "rigid and ν = 0": (sc.Material.rigid(), sc.Material.elastic(E, 0.0)),
}
FRICTIONS = ("0", "0.1", "0.3", "1", "2", "5", "10", "∞")


def setup(bodies: str, width: float, cells: int) -> tuple[Any, sc.Grid, Any, float]:
    """Return bodies, grid of `width` Hertz radii, gap and Hertz contact radius [m]."""
    pair = BODIES[bodies]
    radius = sc.hertz.point(RADIUS, sc.hertz.effective_modulus(*pair), load=LOAD).a
    grid = sc.Grid(cells, cells, width * radius / cells, width * radius / cells)
    return pair, grid, sc.surfaces.paraboloid(grid, RADIUS), radius


def sliding(row: str) -> dict[str, Any]:
    """Solve contacts in full sliding; return iterations, residuals and errors of the load."""
    found: dict[str, Any] = {}
    for name in BODIES:
        pair, grid, gap, _ = setup(name, 7.2, 45)
        solver = sc.ContactSolver(grid, *pair, float(row), max_iterations=10000)
        try:
            state = solver.solve(gap, load=LOAD)
        except sc.ConvergenceError:
            found |= {name: None, f"{name} work": None}
            continue
        found |= {name: state.iterations, f"{name} work": state.work}
        scale = largest(state.gap + state.approach - gap)
        left = np.minimum(state.pressure / state.pressure.max(), state.gap / scale)
        found["left"] = max(found.get("left", 0.0), largest(left))
        load = abs(state.pressure.sum() * grid.cell_area / LOAD - 1)
        found["load"] = max(found.get("load", 0.0), load)
    return found


def slipping(row: str) -> dict[str, Any]:
    """Solve contacts under half the maximum friction force, in full sliding, and in rolling.

    Rolling is with creepage and spin. Results of solutions that do not converge are missing.
    """
    name, _, stated = row.rpartition(", ")
    mu = math.inf if stated == "∞" else float(stated)
    pair, grid, gap, radius = setup(name, 3.2, 25)
    law, limit = sc.Coulomb(mu), min(mu, 2.0) * LOAD
    solver = sc.ContactSolver(grid, *pair, law)
    reach = min(mu, 1.0) * LOAD / (E * radius)  # about the shift at full sliding
    creepage = (0.3 * reach / radius, 0.2 * reach / radius)
    drives: dict[str, dict[str, Any]] = {
        "pressed": {},
        "pulled": {"tangential_load": (limit / 2, 0)},
    }
    if math.isfinite(mu):
        drives["all"] = {"shift": (20 * mu * LOAD / (E * radius), 0.0)}
    states: dict[str, Any] = {}
    previous = None
    for key, drive in drives.items():
        try:
            states[key] = previous = solver.solve(gap, load=LOAD, previous=previous, **drive)
        except sc.ConvergenceError:
            continue
    with contextlib.suppress(sc.ConvergenceError):
        states["rolling"] = sc.rolling.steady(
            grid, *pair, gap, load=LOAD, friction=law, creepage=creepage,
            spin=0.2 * reach / radius**2,
        )  # fmt: skip
    found: dict[str, Any] = {key: state.tangential_iterations for key, state in states.items()}
    if "all" in states:
        found["sticks"] = int(np.count_nonzero(states["all"].sticking))
    found["law"] = max(slip_error(state, mu) for state in states.values())
    found["error"] = max(state.tangential_error for state in states.values())
    found["backward"] = max(map(backward, states.values()))
    return found


def backward(state: Any) -> float:
    """Return the size of the largest negative friction work of a cell, relative to the total."""
    work = (state.shear * state.slip).sum(axis=0)
    return max(0.0, -float(work.min())) / (float(np.abs(work).sum()) or 1.0)


SLIDING = Table(
    "sliding", "μ", FRICTIONS[:-1], sliding,
    (
        *(column for name in BODIES for column in (
            Column(name, f"{name}: iterations", COUNT),
            Column(f"{name} work", "transforms", COUNT),
        )),
        Column("left", "contact conditions", at_most=1e-8),
        Column("load", "load error", at_most=1e-12),
    ),
    "2",
)  # fmt: skip
SLIPPING = Table(
    "slipping", "bodies, μ",
    tuple(f"{name}, {mu}" for name in BODIES for mu in FRICTIONS[1:]), slipping,
    (
        Column("pressed", "normal load: iterations", COUNT),
        Column("pulled", "tangential load", COUNT),
        Column("all", "full slip", COUNT),
        Column("sticks", "sticking cells", COUNT, 0),
        Column("rolling", "rolling", COUNT),
        Column("error", "shear error"),
        Column("law", "excess over μ p", at_most=1e-12),
        Column("backward", "work against the slip"),
    ),
    "rigid and ν = 0, 1",
)  # fmt: skip
