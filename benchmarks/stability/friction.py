# SPDX-License-Identifier: GPL-3.0-or-later
"""Friction from none to infinite, of like and unlike bodies: sliding, partial slip and rolling."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import samcontact as sc

from .materials import RADIUS, E, slip_error
from .table import COUNT, Column, Table, largest

LOAD, CELLS = 300.0, 25
BODIES = {
    "alike": (sc.Material.elastic(E, 0.3), sc.Material.elastic(E, 0.3)),
    "ν = 0 and 0.499": (sc.Material.elastic(E, 0.0), sc.Material.elastic(E, 0.499)),
    "rigid and ν = 0": (sc.Material.rigid(), sc.Material.elastic(E, 0.0)),
}
FRICTIONS = ("0", "0.1", "0.3", "1", "2", "5", "10", "∞")


def scene(bodies: str, width: float) -> tuple[tuple[sc.Material, sc.Material], sc.Grid, Any, float]:
    """Bodies, grid, gap and Hertz's radius."""
    pair = BODIES[bodies]
    radius = sc.hertz.point(RADIUS, sc.hertz.effective_modulus(*pair), load=LOAD).a
    grid = sc.Grid(CELLS, CELLS, width * radius / CELLS, width * radius / CELLS)
    return pair, grid, sc.surfaces.paraboloid(grid, RADIUS), radius


def sliding(row: str) -> dict[str, Any]:
    """Iterations, and what is left of the conditions of contact with the shear in them."""
    found: dict[str, Any] = {}
    for name in BODIES:
        pair, grid, gap, _ = scene(name, 4.0)
        solver = sc.ContactSolver(grid, *pair, float(row), max_iterations=10000)
        state = solver.solve(gap, load=LOAD)
        found |= {name: state.iterations, f"{name} work": state.work}
        scale = largest(state.gap + state.approach - gap)
        left = np.minimum(state.pressure / state.pressure.max(), state.gap / scale)
        found["left"] = max(found.get("left", 0.0), largest(left))
        load = abs(state.pressure.sum() * grid.cell_area / LOAD - 1)
        found["load"] = max(found.get("load", 0.0), load)
    return found


def slipping(row: str) -> dict[str, Any]:
    """Pressed, pulled by half of the friction, shifted until all slips, and rolled with creepage
    and spin."""
    name, _, told = row.rpartition(", ")
    mu = math.inf if told == "∞" else float(told)
    pair, grid, gap, radius = scene(name, 3.2)
    law = sc.Coulomb(mu)
    solver = sc.ContactSolver(grid, *pair, law)
    pressed = solver.solve(gap, load=LOAD)
    reach = min(mu, 1.0) * LOAD / (E * radius)  # of the order of the shift at which all slips
    pull = 0.5 * min(mu, 2.0) * LOAD
    pulled = solver.solve(gap, load=LOAD, tangential_load=(pull, 0.0), previous=pressed)
    states = [pressed, pulled]
    found = {"pressed": pressed.tangential_iterations, "pulled": pulled.tangential_iterations}
    if math.isfinite(mu):
        states.append(solver.solve(gap, load=LOAD, shift=(20 * mu * LOAD / (E * radius), 0.0),
                                   previous=pulled))  # fmt: skip
        found |= {"all": states[-1].tangential_iterations}
        found |= {"sticks": int(np.count_nonzero(states[-1].sticking))}
    states.append(sc.rolling.steady(
        grid, *pair, gap, load=LOAD, friction=law,
        creepage=(0.3 * reach / radius, 0.2 * reach / radius), spin=0.2 * reach / radius**2,
    ))  # fmt: skip
    found["rolling"] = states[-1].tangential_iterations
    found["law"] = max(slip_error(state, mu) for state in states)
    found["error"] = max(state.tangential_error for state in states)
    work = [float((state.shear * state.slip).sum()) for state in states]
    turned = [float(np.abs(state.shear * state.slip).sum()) for state in states]
    found["backward"] = max(
        max(0.0, -float((state.shear * state.slip).sum(axis=0).min())) / (total or 1.0)
        for state, total, _ in zip(states, turned, work, strict=True)
    )
    return found


SLIDING = Table(
    "sliding", "μ", FRICTIONS[:-1], sliding,
    (
        *(column for name in BODIES for column in (
            Column(name, f"{name}: iterations", COUNT),
            Column(f"{name} work", "transforms", COUNT),
        )),
        Column("left", "conditions of contact", at_most=1e-8),
        Column("load", "balance of load", at_most=1e-12),
    ),
    "2",
)  # fmt: skip
SLIPPING = Table(
    "slipping", "bodies, μ",
    tuple(f"{name}, {mu}" for name in BODIES for mu in FRICTIONS[1:]), slipping,
    (
        Column("pressed", "pressed: iterations", COUNT),
        Column("pulled", "pulled", COUNT),
        Column("all", "all slips", COUNT),
        Column("sticks", "cells that stick", COUNT, 0),
        Column("rolling", "rolling", COUNT),
        Column("error", "error of the shear"),
        Column("law", "beyond μ p", at_most=1e-12),
        Column("backward", "work of friction against the slip"),
    ),
    "rigid and ν = 0, 1",
)  # fmt: skip
