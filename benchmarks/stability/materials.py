# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts with Poisson's ratios from 0 to 0.499, and with tangent moduli from 0 to 0.9 E."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import samcontact as sc

from .table import COUNT, VALUE, Column, Table, relative_difference, trace

E, RADIUS, YIELD, MU = 210e9, 7.5e-3, 1e9, 0.3
STEEL = sc.Material.elastic(E, 0.3)
RATIOS = ("0", "0.1", "0.3", "0.45", "0.49", "0.499")
SHARES = ("0", "1e-6", "1e-3", "0.01", "0.1", "0.3", "0.5", "0.7", "0.9")


def contact(body: sc.Material, cells: int, p0: float) -> tuple[sc.hertz.PointContact, sc.Grid]:
    """Return the Hertz contact of two identical bodies, and a grid that contains the contact."""
    exact = sc.hertz.point(RADIUS, sc.hertz.effective_modulus(body, body), p0=p0)
    size = 3.2 * exact.a / cells
    return exact, sc.Grid(cells, cells, size, size)


def flow(
    lower: sc.Material,
    upper: sc.Material,
    friction: float = 0.0,
    part: float = 0.7,
    **settings: Any,
) -> tuple[sc.Simulation, sc.State]:
    """Load an elastic-plastic body by a ball in one increment; return simulation and state."""
    exact, flat = contact(STEEL, 15, 2.4e9)
    grid = sc.Grid(15, 15, flat.dx, flat.dy, 10, 0.2 * exact.a)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    simulation = sc.Simulation(grid, upper, lower, gap, friction, on_border="warn", **settings)
    return simulation, simulation.step(load=part * exact.load)


def poisson(row: str) -> dict[str, Any]:
    """Solve elastic, elastic-plastic and partial slip contacts with one Poisson's ratio.

    In partial slip, the tangential force is half of its maximum; the ball slips on a body of equal
    material, and on a rigid body.
    """
    nu = float(row)
    body = sc.Material.elastic(E, nu)
    exact, grid = contact(body, 33, 2.4e9)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    found = sc.ContactSolver(grid, body, body).solve(gap, load=exact.load)
    _, state = flow(sc.Material.linear_hardening(E, nu, YIELD, 0.05 * E), STEEL)
    pull = {"load": exact.load, "tangential_load": (0.5 * MU * exact.load, 0.0)}
    slipped = sc.ContactSolver(grid, body, body, sc.Coulomb(MU)).solve(gap, **pull)
    softness = 2 * (2 - nu) * (1 + nu) / E  # sum of (2 - nu)/G of both bodies
    moved = 3 * MU * exact.load * softness * 2 / (16 * exact.a) * (1 - 0.5 ** (2 / 3))
    dissimilar = sc.ContactSolver(grid, sc.Material.rigid(), body, sc.Coulomb(MU)).solve(
        gap, **pull
    )
    return {
        "iterations": found.iterations,
        "approach": abs(found.approach / exact.approach - 1),
        "p0": abs(found.pressure.max() / exact.p0 - 1),
        "evaluations": state.iterations,
        "beyond": max(state.yield_violation, 0.0),
        "trace": trace(state.plastic_strain()),
        "shear": slipped.tangential_iterations,
        "shift": abs(slipped.shift[0] / moved - 1),
        "dissimilar": dissimilar.tangential_iterations,
        "law": slip_error(dissimilar, MU),
    }


def slip_error(found: Any, mu: float) -> float:
    """Return the maximum excess of the shear over mu times the repulsion, relative to the shear."""
    excess = np.hypot(*found.shear) - mu * found.repulsion if math.isfinite(mu) else 0.0
    outside_shear = np.hypot(*found.shear)[found.repulsion == 0]
    worst = max(float(np.max(excess)), float(outside_shear.max(initial=0.0)), 0.0)
    return worst / float(np.hypot(*found.shear).max()) if worst else 0.0


def hardened(row: str) -> dict[str, Any]:
    """Load bodies of one tangent modulus: isotropic, kinematic, and isotropic under friction."""
    share = float(row)
    perfect = sc.Material.perfect_plastic(E, 0.3, YIELD)
    isotropic = sc.Material.linear_hardening(E, 0.3, YIELD, share * E) if share else perfect
    kinematic = perfect.with_kinematic_hardening(E * share / (1 - share)) if share else perfect
    found = {}
    for name, law, friction in (
        ("isotropic", isotropic, 0.0), ("kinematic", kinematic, 0.0), ("sliding", isotropic, 0.5),
    ):  # fmt: skip
        simulation, state = flow(law, STEEL, friction, tol=1e-7)
        found |= {name: state.iterations, f"{name} beyond": max(state.yield_violation, 0.0)}
        found["trace"] = max(found.get("trace", 0.0), trace(state.plastic_strain()))
        load = state.pressure.sum() * simulation.grid.cell_area
        found["load"] = max(found.get("load", 0.0), abs(load / state.load - 1))
        strain = state.plastic_strain()
        again = relative_difference(simulation.step(load=0.0).plastic_strain(), strain)
        found["unloaded"] = max(found.get("unloaded", 0.0), again)
    return found


POISSON = Table(
    "poisson", "ν", RATIOS, poisson,
    (
        Column("iterations", "elastic: iterations", COUNT, 30),
        Column("approach", "approach error (Hertz)", VALUE, 2e-3),
        Column("p0", "pressure error (Hertz)", VALUE, 5e-3),
        Column("evaluations", "elastic-plastic: evaluations", COUNT, 40),
        Column("beyond", "yield excess", at_most=1e-6),
        Column("trace", "volume change", at_most=1e-14),
        Column("shear", "partial slip: iterations", COUNT),
        Column("shift", "displacement error (Mindlin)", VALUE),
        Column("dissimilar", "on a rigid body: iterations", COUNT),
        Column("law", "excess over μ p", at_most=1e-12),
    ),
    "0.499",
)  # fmt: skip
HARDENING = Table(
    "hardening", "tangent modulus / E", SHARES, hardened,
    (
        Column("isotropic", "isotropic: evaluations", COUNT, 60),
        Column("isotropic beyond", "yield excess", at_most=1e-6),
        Column("kinematic", "kinematic: evaluations", COUNT, 60),
        Column("kinematic beyond", "yield excess", at_most=1e-6),
        Column("sliding", "isotropic, μ = 0.5: evaluations", COUNT, 60),
        Column("sliding beyond", "yield excess", at_most=1e-6),
        Column("trace", "volume change", at_most=1e-14),
        Column("load", "load error", at_most=1e-12),
        Column("unloaded", "strain due to unloading", VALUE),
    ),
    "0.9",
)  # fmt: skip
