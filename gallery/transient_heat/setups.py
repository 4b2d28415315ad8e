# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulations of a tool that heats a flat, at rest and in motion."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

import samcontact as sc

from ..bodies import ELASTIC, square, tolerance
from ..heat.setups import E_STAR, STEEL, UNYIELDING, at_surface
from ..profiles import largest, von_mises

RADIUS, LOAD, FACTOR = 3.75e-3, 1500.0, 0.12
SPEED, TIME = 0.95, 23e-3
HERTZ = sc.hertz.point(R=RADIUS, E_star=E_STAR, load=LOAD)
assert STEEL.thermal is not None
CONDUCTIVITY, _, DIFFUSIVITY = STEEL.thermal
KINDS = {
    "no heat": sc.Heat(0.0),
    "(i)": sc.Heat(FACTOR, time=TIME),
    "(ii)": sc.Heat(FACTOR),
    "(iii)": sc.Heat(FACTOR, velocity=(-SPEED, 0.0), time=TIME),
}
NAMES = {
    "(i)": "(i) at rest, 23 ms",
    "(ii)": "(ii) at rest, steady",
    "(iii)": "(iii) moving, 23 ms",
}
EXTENT = {"no heat": (2.2, 2.4), "(i)": (3.1, 1.8), "(ii)": (3.1, 1.8), "(iii)": (2.4, 2.5)}
"""Half-width and depth over a of the grid of the elastic-plastic flat."""


@dataclass
class Elastic:
    x: np.ndarray
    z: np.ndarray
    pressure: np.ndarray
    """Pressure in the plane y = 0; the following fields are also in this plane."""
    flash: np.ndarray
    temperature: np.ndarray
    von_mises: np.ndarray
    largest: tuple[float, float, float]
    """Maximum von Mises stress, and its x and z."""

    @property
    def hottest(self) -> tuple[float, float]:
        """Maximum temperature rise [K], and its x position [m]."""
        k = int(self.flash.argmax())
        return float(self.flash[k]), float(self.x[k])


@dataclass
class Plastic:
    x: np.ndarray
    z: np.ndarray
    von_mises: np.ndarray
    largest: tuple[float, float, float]
    gamma: float
    pressure: float
    residual: float
    """Maximum residual stress, at mid-depth of a layer or, on the axis, at the surface."""


@dataclass
class Results:
    elastic: dict[str, Elastic]
    plastic: dict[str, Plastic]
    steady: Elastic
    """Results of case (iii) in its steady state."""
    times: np.ndarray
    rises: np.ndarray
    """Maximum temperature rise of a source at rest at these times [K]."""
    pressures: np.ndarray
    """Maximum pressure at these times [Pa]."""
    mesh: dict[str, str]


def solver(cells: int, heat: sc.Heat) -> tuple[sc.ContactSolver, np.ndarray]:
    """Return the contact solver of an elastic flat, and the contact pressure [Pa]."""
    grid = square(HERTZ.a, cells, 1.8)
    found = sc.ContactSolver(grid, ELASTIC, UNYIELDING, heat=heat)
    return found, found.solve(sc.surfaces.paraboloid(grid, RADIUS), load=LOAD).pressure


def elastic_case(cells: int, depths: int, heat: sc.Heat) -> Elastic:
    contact, pressure = solver(cells, heat)
    x, m = contact.grid.x, contact.grid.ny // 2
    z = np.linspace(0.0, 1.2, depths) * HERTZ.a
    stress = von_mises(contact.stress(pressure, z)[:, :, m])
    rise = contact.temperature(pressure, z)[:, m]
    return Elastic(x, z, pressure[:, m], rise[:, 0], rise, stress, largest(stress, x, z))


def plastic_case(kind: str, cells: int, per_cell: int, tol: float) -> Plastic:
    width, depth = EXTENT[kind]
    grid = square(HERTZ.a, cells, width, depth, per_cell)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    simulation = sc.Simulation(grid, ELASTIC, STEEL, gap, tol=tol, heat=KINDS[kind])
    for load in np.linspace(0.0, LOAD, 11)[1:]:
        state = simulation.step(load=float(load))
    unloaded = simulation.step(load=0.0)
    m = grid.nx // 2
    stress, residual = state.von_mises()[:, m], unloaded.von_mises()
    return Plastic(
        grid.x, grid.z, stress, largest(stress, grid.x, grid.z),
        float(state.max_equivalent_plastic_strain()), float(state.pressure.max()),
        max(float(residual.max()), at_surface(residual[m, m])),
    )  # fmt: skip


def compute(quick: bool) -> Results:
    cells, depths = (12, 21) if quick else (32, 61)
    elastic = {kind: elastic_case(cells, depths, heat) for kind, heat in KINDS.items()}
    steady = elastic_case(cells, 2, sc.Heat(FACTOR, velocity=(-SPEED, 0.0)))
    plastic_cells, per_cell = (6, 2) if quick else (10, 2)
    plastic = {
        kind: plastic_case(kind, plastic_cells, per_cell, tolerance(quick)) for kind in KINDS
    }
    times = np.geomspace(1e-4, 1e4, 9 if quick else 25)
    rises, pressures = [], []
    for time in times:
        contact, pressure = solver(cells, sc.Heat(FACTOR, time=float(time)))
        rises.append(float(contact.temperature(pressure).max()))
        pressures.append(float(pressure.max()))
    return Results(
        elastic, plastic, steady, times, np.array(rises), np.array(pressures),
        {
            "elastic": f"a/{cells}",
            "plastic": f"a/{plastic_cells}, layers a/{plastic_cells * per_cell}",
        },
    )  # fmt: skip
