# SPDX-License-Identifier: GPL-3.0-or-later
"""Sliding contacts of a rigid and of an elastic ball."""

from __future__ import annotations

import warnings
from dataclasses import dataclass

import numpy as np

import samcontact as sc

from ..bodies import ELASTIC, MICRO_STRAIN, RIGID, STEEL_M50, square, tolerance
from ..profiles import largest, von_mises

RADIUS = 10e-3
MICRO_YIELD = float(STEEL_M50.yield_stress(MICRO_STRAIN))
F1_LOAD, F2_LOAD = 800.0, 5000.0
F1_FRICTION = (0.0, 0.2, 0.4)
SHOWN = (0.0, 0.1, 0.2, 0.3, 0.4, 0.5)
MORE = (0.15, 0.25, 0.31, 0.32, 0.33, 0.35, 0.45)
MORE_QUICK = (0.15, 0.25, 0.35)
LAYERS = 1.85  # depth of the volume grid over a
HERTZ_DEPTH = 0.48


@dataclass
class Elastic:
    x: np.ndarray
    pressure: np.ndarray
    z: np.ndarray
    von_mises: np.ndarray
    """Von Mises stress at x = y = 0."""
    largest_at: tuple[float, float]
    """x, z of the largest von Mises stress in the plane y = 0."""


@dataclass
class Plastic:
    """Results for one friction coefficient: at each load, at the largest load, and unloaded."""

    x: np.ndarray
    z: np.ndarray
    pressure: np.ndarray
    von_mises: np.ndarray
    gamma: np.ndarray
    residual: np.ndarray
    hydrostatic: np.ndarray
    """Profiles on x = y = 0; residual von Mises and hydrostatic stress are after unloading."""
    loads: np.ndarray
    gamma_max: np.ndarray
    """Maximum plastic strain at each load."""
    gamma_at: tuple[float, float]
    """x, z of the largest plastic strain."""
    von_mises_at: tuple[float, float, float]
    """Largest von Mises stress under load, and its x and z."""
    largest_by_depth: np.ndarray
    """Largest von Mises stress in each layer."""
    surface_plane: np.ndarray
    """Residual von Mises stress in the plane y = 0."""


@dataclass
class Results:
    rigid: sc.hertz.PointContact
    elastic: dict[float, Elastic]
    plastic: dict[float, Plastic]
    ball: sc.hertz.PointContact
    sliding: dict[float, Plastic]
    by_load: dict[float, np.ndarray]
    """Residual hydrostatic stress on the axis for µ = 0, per load."""
    layers: list[tuple[float, float]]
    """Depth of the first layer over a, and maximum plastic strain, for µ = 0.5."""
    mesh: dict[str, str]


def hertz(body1: sc.Material, load: float) -> sc.hertz.PointContact:
    return sc.hertz.point(R=RADIUS, E_star=sc.hertz.effective_modulus(body1, STEEL_M50), load=load)


def elastic_case(contact: sc.hertz.PointContact, friction: float, cells: int) -> Elastic:
    grid = square(contact.a, cells, 1.4)
    solver = sc.ContactSolver(grid, RIGID, ELASTIC, friction)
    pressure = solver.solve(sc.surfaces.paraboloid(grid, RADIUS), load=contact.load).pressure
    z = np.linspace(0.0, 2.0, 41) * contact.a
    middle = grid.nx // 2
    stress = von_mises(solver.stress(pressure, z)[:, :, middle])
    at = largest(stress, grid.x, z)[1:]
    return Elastic(grid.x, pressure[:, middle], z, stress[middle], at)


def plastic_case(
    body1: sc.Material,
    grid: sc.Grid,
    friction: float,
    load: float,
    increments: int,
    tol: float,
) -> Plastic:
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    simulation = sc.Simulation(grid, body1, STEEL_M50, gap, friction, tol=tol)
    loads, gamma_max = load * np.arange(1, increments + 1) / increments, []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # strains above 5 % are intended here
        for value in loads:
            state = simulation.step(load=float(value))
            gamma_max.append(float(state.equivalent_plastic_strain().max()))
        unloaded = simulation.step(load=0.0)
    i = j = grid.nx // 2
    gamma, stress, residual = (
        state.equivalent_plastic_strain(),
        state.von_mises(),
        unloaded.von_mises(),
    )
    at = np.unravel_index(int(gamma.argmax()), gamma.shape)
    top = np.unravel_index(int(stress.argmax()), stress.shape)
    return Plastic(
        x=grid.x,
        z=grid.z,
        pressure=state.pressure[:, j].copy(),
        von_mises=stress[i, j].copy(),
        gamma=gamma[i, j].copy(),
        residual=residual[i, j].copy(),
        hydrostatic=unloaded.hydrostatic()[i, j].copy(),
        loads=loads,
        gamma_max=np.array(gamma_max),
        gamma_at=(float(grid.x[at[0]]), float(grid.z[at[2]])),
        von_mises_at=(float(stress.max()), float(grid.x[top[0]]), float(grid.z[top[2]])),
        largest_by_depth=stress.max(axis=(0, 1)),
        surface_plane=residual[:, j].copy(),
    )


def residual_by_load(grid: sc.Grid, increments: int) -> dict[float, np.ndarray]:
    """Return the residual hydrostatic stress on the axis after 1000, 2000, ... 5000 N, µ = 0."""
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    simulation = sc.Simulation(grid, ELASTIC, STEEL_M50, gap)
    middle, found = grid.nx // 2, {}
    for k in range(1, increments + 1):
        load = F2_LOAD * k / increments
        simulation.step(load=load)
        if load % 1000.0 == 0.0:  # unloading is elastic and may precede further loading
            found[load] = simulation.step(load=0.0).hydrostatic()[middle, middle].copy()
    return found


def compute(quick: bool) -> Results:
    rigid, ball = hertz(RIGID, F1_LOAD), hertz(ELASTIC, F2_LOAD)
    cells, per_cell, increments = (10, 2, 5) if quick else (16, 4, 20)
    tol = tolerance(quick)
    small_cells, small_layers = (16, 1) if quick else (24, 2)
    small = square(rigid.a, small_cells, 1.4, 1.6, small_layers)
    elastic = {mu: elastic_case(rigid, mu, small_cells) for mu in F1_FRICTION}
    plastic = {mu: plastic_case(RIGID, small, mu, F1_LOAD, increments, tol) for mu in F1_FRICTION}
    grid = square(ball.a, cells, 2.0, LAYERS, per_cell)
    sliding = {
        mu: plastic_case(ELASTIC, grid, mu, F2_LOAD, increments, tol)
        for mu in sorted(SHOWN + (MORE_QUICK if quick else MORE))
    }
    by_load = residual_by_load(grid, increments)
    layers = []
    for count in (1, 2) if quick else (1, 2, 4, 8):
        thin = square(ball.a, 12, 2.0, LAYERS, count)
        found = plastic_case(ELASTIC, thin, 0.5, F2_LOAD, 5 if quick else 10, tol)
        layers.append((float(thin.z[0]) / ball.a, float(found.gamma_max[-1])))
    return Results(
        rigid,
        elastic,
        plastic,
        ball,
        sliding,
        by_load,
        layers,
        {
            "elastic": f"a/{small_cells}",
            "rigid ball": f"a/{small_cells}, layers a/{small_cells * small_layers}",
            "elastic ball": f"a/{cells}, layers a/{cells * per_cell}",
        },
    )
