# SPDX-License-Identifier: GPL-3.0-or-later
"""Coatings 1/50 to 50 times as stiff as the body, 0.1 to 300 cells thick."""

from __future__ import annotations

import itertools
from typing import Any

import samcontact as sc

from .table import COUNT, VALUE, Column, Table, relative_difference, trace

E, RADIUS, RIGID = 210e9, 7.5e-3, sc.Material.rigid()
STEEL = sc.Material.elastic(E, 0.3)
STIFFNESS = ("1/50", "1/5", "1", "5", "50")
THICKNESS = ("0.1", "1", "10", "300")
SIZE, CELLS = 20e-6, 41
LAYERS = ("2", "6")
HARDLY = 1e-14
SEPARATOR = ", "


def ratio(stated: str) -> float:
    part, _, by = stated.partition("/")
    return float(part) / float(by or 1)


def rows(thicknesses: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(SEPARATOR.join(pair) for pair in itertools.product(STIFFNESS, thicknesses))


def solver(body: sc.Material | sc.Layered) -> sc.ContactSolver:
    return sc.ContactSolver(sc.Grid(CELLS, CELLS, SIZE, SIZE), RIGID, body, on_border="warn")


def pressed(body: sc.Material | sc.Layered) -> sc.ContactSolution:
    """Press a ball; the approach is the gap at a distance of 3/4 of the half-width of the grid."""
    half, made = 0.75 * CELLS / 2 * SIZE, solver(body)
    gap = sc.surfaces.paraboloid(made.grid, RADIUS)
    return made.solve(gap, approach=half**2 / (2 * RADIUS))


def elastic(row: str) -> dict[str, Any]:
    """Compare an elastic coating with uncoated bodies and with two layers of half thickness."""
    stiffness, cells = row.split(SEPARATOR)
    coating, thickness = sc.Material.elastic(ratio(stiffness) * E, 0.3), float(cells) * SIZE
    # Equal materials would be merged into one layer, so these differ slightly.
    almost = sc.Material.elastic(coating.E * (1 + HARDLY), 0.3)
    coated = sc.Layered([(coating, thickness)], STEEL)
    halves = sc.Layered([(coating, thickness / 2), (almost, thickness / 2)], STEEL)
    found, bare = pressed(coated), pressed(STEEL)

    def moved(body: sc.Material | sc.Layered) -> Any:
        return solver(body).displacement(found.pressure)

    same = sc.Layered([(almost, thickness)], STEEL) if stiffness == "1" else None
    whole = moved(coated)
    return {
        "iterations": found.iterations,
        "halves": relative_difference(moved(halves), whole),
        "error": found.error,
        "substrate": relative_difference(found.pressure, bare.pressure),
        "coating": relative_difference(found.pressure, pressed(coating).pressure),
        "same": relative_difference(moved(same), moved(STEEL)) if same else None,
    }


def yielding(row: str) -> dict[str, Any]:
    """Solve an elastic-plastic coating and substrate; each yields at 1/200 of Young's modulus."""
    stiffness, cells = row.split(SEPARATOR)

    def law(modulus: float) -> sc.Material:
        return sc.Material.linear_hardening(modulus, 0.3, modulus / 200, modulus / 20)

    size, coated = 20e-6, law(ratio(stiffness) * E)
    grid = sc.Grid(21, 21, size, size, 14, size)
    body = sc.Layered([(coated, int(cells) * size)], law(E))
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    simulation = sc.Simulation(grid, RIGID, body, gap, on_border="warn")
    approach = (7 * size) ** 2 / (2 * RADIUS)
    states = [simulation.step(approach=part * approach) for part in (0.5, 1.0)]
    last = simulation.step(load=0.0)
    strain = last.plastic_strain()
    return {
        "evaluations": sum(state.iterations for state in states),
        "contact": sum(state.contact_iterations for state in states),
        "parts": max(state.substeps for state in states),
        "strain": last.max_equivalent_plastic_strain(),
        "beyond": max(0.0, *(state.yield_violation for state in states)),
        "trace": trace(strain),
        "residual": max(state.plastic_strain_residual for state in states),
    }


ELASTIC = Table(
    "coatings", "E of coating / E of substrate, thickness / dx", rows(THICKNESS), elastic,
    (
        Column("iterations", "iterations", COUNT, 40),
        Column("error", "error", at_most=1e-8),
        Column("halves", "difference from two equal layers", at_most=1e-11),
        Column("same", "difference from no coating", at_most=1e-12),
        Column("substrate", "difference from the substrate alone", VALUE),
        Column("coating", "difference from a body of coating material", VALUE),
    ),
    "50, 10",
)  # fmt: skip
YIELDING = Table(
    "yielding_coatings", "E of coating / E of substrate, thickness / dz", rows(LAYERS), yielding,
    (
        Column("evaluations", "evaluations", COUNT, 100),
        Column("contact", "contact iterations", COUNT),
        Column("parts", "substeps per increment", COUNT, 1),
        Column("strain", "plastic strain", VALUE),
        Column("residual", "residual", at_most=1e-6),
        Column("beyond", "yield excess", at_most=1e-6),
        Column("trace", "volume change", at_most=1e-14),
    ),
    "5, 2",
)  # fmt: skip
