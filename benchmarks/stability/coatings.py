# SPDX-License-Identifier: GPL-3.0-or-later
"""Coatings from a fiftieth to fifty times as stiff as the body, of a tenth to 300 cells."""

from __future__ import annotations

import itertools
from typing import Any

import samcontact as sc

from .table import COUNT, VALUE, Column, Table, apart, trace

E, RADIUS, RIGID = 210e9, 7.5e-3, sc.Material.rigid()
STEEL = sc.Material.elastic(E, 0.3)
STIFFNESS = ("1/50", "1/5", "1", "5", "50")
THICKNESS = ("0.1", "1", "10", "300")
SIZE, CELLS = 20e-6, 41
LAYERS = ("2", "6")
SEPARATOR = ", "


def ratio(told: str) -> float:
    part, _, by = told.partition("/")
    return float(part) / float(by or 1)


def rows(thicknesses: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(SEPARATOR.join(pair) for pair in itertools.product(STIFFNESS, thicknesses))


def pressed(body: sc.Material | sc.Layered) -> sc.ContactSolution:
    """Three quarters of the grid are in contact."""
    grid = sc.Grid(CELLS, CELLS, SIZE, SIZE)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    # Of the height of the gap at three quarters of the half width: any stiffness touches there.
    reach = 0.75 * CELLS / 2 * SIZE
    return sc.ContactSolver(grid, RIGID, body, on_border="warn").solve(
        gap, approach=reach**2 / (2 * RADIUS)
    )


def elastic(row: str) -> dict[str, Any]:
    """The same coating as one layer and as two of half the thickness; beside bodies without."""
    stiffness, cells = row.split(SEPARATOR)
    coating, thickness = sc.Material.elastic(ratio(stiffness) * E, 0.3), float(cells) * SIZE
    found = pressed(sc.Layered([(coating, thickness)], STEEL))
    halves = pressed(sc.Layered([(coating, thickness / 2)] * 2, STEEL))
    return {
        "iterations": found.iterations,
        "halves": apart(halves.pressure, found.pressure),
        "error": found.error,
        "substrate": apart(found.pressure, pressed(STEEL).pressure),
        "coating": apart(found.pressure, pressed(coating).pressure),
        "same": apart(found.pressure, pressed(STEEL).pressure) if stiffness == "1" else None,
    }


def yielding(row: str) -> dict[str, Any]:
    """Coating and substrate yield at a two-hundredth of their moduli."""
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
        "beyond": max(0.0, *(state.yield_excess for state in states)),
        "trace": trace(strain),
        "residual": max(state.plastic_residual for state in states),
    }


ELASTIC = Table(
    "coatings", "E of the coating over E, thickness over dx", rows(THICKNESS), elastic,
    (
        Column("iterations", "iterations", COUNT, 40),
        Column("error", "error", at_most=1e-8),
        Column("halves", "as two equal layers", at_most=1e-12),
        Column("same", "without coating, of the same E", at_most=1e-12),
        Column("substrate", "to the substrate alone", VALUE),
        Column("coating", "to a body of the coating", VALUE),
    ),
    "50, 10",
)  # fmt: skip
YIELDING = Table(
    "yielding_coatings", "E of the coating over E, thickness over dz", rows(LAYERS), yielding,
    (
        Column("evaluations", "evaluations", COUNT, 100),
        Column("contact", "iterations of the contact", COUNT),
        Column("parts", "parts of an increment", COUNT, 1),
        Column("strain", "plastic strain", VALUE),
        Column("residual", "residual", at_most=1e-6),
        Column("beyond", "beyond yield", at_most=1e-6),
        Column("trace", "change of volume", at_most=1e-14),
    ),
    "5, 2",
)  # fmt: skip
