# SPDX-License-Identifier: GPL-3.0-or-later
"""Pull-off of a ball from the crater that it has pressed, and the cost of adhesion in plastic flow.

A rigid ball is pressed without adhesion into a perfectly plastic flat, and pulled off the crater,
which remains elastic (Maugis & Pollock 1984). The crater conforms to the ball, so that the pull-off
force is that of a larger ball, 3/2 pi w R_eff in the limit of a short range.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline

import samcontact as sc

from .study import table

RADIUS, E, NU, YIELD = 1e-3, 100e9, 0.3, 500e6
MODULUS = E / (1 - NU**2)
YIELD_LOAD = math.pi**3 * RADIUS**2 * (1.6 * YIELD) ** 3 / (6 * MODULUS**2)
RIGID, FLAT = sc.Material.rigid(), sc.Material.perfect_plastic(E, NU, YIELD)
LOADS, WORKS = (0.5, 5.0, 20.0, 60.0), (5.0, 20.0)
STEPS = 40  # of a retraction


@dataclass(frozen=True)
class Crater:
    """Gap between a ball and the crater that it has pressed."""

    grid: sc.Grid
    gap: np.ndarray  # [m]
    hertz: float  # radius of contact of an elastic flat, slightly enlarged [m]
    contact: float  # radius of contact under load [m]

    @property
    def distance(self) -> np.ndarray:
        """Distance of the cells from the axis [m]."""
        return np.hypot(self.grid.x[:, None], self.grid.y[None])

    @property
    def radius(self) -> float:
        """Effective radius of ball and crater in the inner half of the contact [m]."""
        inner = self.distance < 0.5 * self.contact
        return float(0.5 / np.polyfit(self.distance[inner] ** 2, self.gap[inner], 1)[0])

    @property
    def profile(self) -> CubicSpline:
        """Gap over the distance from the axis: spline through the means of rings [m]."""
        dx = self.grid.dx
        rings = (self.distance / dx).astype(int).ravel()
        count = np.bincount(rings)
        r = np.bincount(rings, self.distance.ravel()) / count
        gap = np.bincount(rings, self.gap.ravel()) / count
        last = int(1.4 * self.hertz / dx)
        return CubicSpline(np.r_[-r[2::-1], r[:last]], np.r_[gap[2::-1], gap[:last]])

    def refined(self, factor: int) -> Crater:
        """Return the axisymmetric crater on a grid of cells that are smaller by a factor."""
        cells, size = self.grid.nx * factor, self.grid.dx / factor
        grid = sc.Grid(cells, cells, size, size)
        r = np.hypot(grid.x[:, None], grid.y[None])
        inner = np.minimum(r, 1.3 * self.hertz)  # the ball is a paraboloid beyond the crater
        gap = self.profile(inner) + (r**2 - inner**2) / (2 * RADIUS)
        return Crater(grid, gap, self.hertz, self.contact)


def pressed(ratio: float, cells: int = 72, *, tol: float = 1e-5) -> Crater:
    """Return the crater after a load of `ratio` times that of first yield."""
    load = ratio * YIELD_LOAD
    hertz = (0.75 * load * RADIUS / MODULUS) ** (1 / 3)
    size = 2.9 * hertz * (1.35 if ratio > 10 else 1.1)
    dx = size / cells
    grid = sc.Grid(cells, cells, dx, dx, nz=int(1.6 * size / 2.9 / (1.3 * dx)), dz=1.3 * dx)
    ball = sc.surfaces.paraboloid(grid, RADIUS)
    simulation = sc.Simulation(grid, RIGID, FLAT, ball, tol=tol)
    for share in np.linspace(0.25, 1.0, 6) if ratio > 1 else (1.0,):
        state = simulation.step(load=share * load)
    contact = math.sqrt(np.count_nonzero(state.pressure) * grid.cell_area / math.pi)
    gap = simulation.step(load=0.0).gap
    return Crater(grid, gap - gap.min(), size / 2.9, contact)


def pull_off(crater: Crater, w: float, steps: int = STEPS) -> float:
    """Return the pull-off force of a ball from an elastic crater [N]."""
    body = sc.Material.elastic(E, NU)
    solver = sc.ContactSolver(crater.grid, RIGID, body, adhesion=sc.Adhesion.jkr(w))
    radius = max(crater.radius, RADIUS)
    length = 1.5 * (9 * math.pi**2 * w**2 * radius / (16 * MODULUS**2)) ** (1 / 3)
    solution, largest = None, 0.0
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for approach in np.linspace(0.3 * length, -1.6 * length, steps):
            start = None if solution is None else solution.pressure
            solution = solver.solve(crater.gap, approach=approach, initial_pressure=start)
            largest = max(largest, -solution.load)
            if not solution.in_contact.any() or -solution.load < 0.9 * largest:
                break
    return largest


def jkr_of(crater: Crater, w: float) -> float:
    """Return the pull-off force of the profile of a crater with attraction of short range [N]."""
    radii = np.linspace(0.05, 1.35, 260) * crater.hertz
    return sc.adhesion.jkr_profile(crater.profile.derivative(), radii, w, MODULUS).pull_off


def craters(ratios: Sequence[float] = LOADS, works: Sequence[float] = WORKS) -> str:
    """Return the table of pull-off forces from craters."""
    rows = []
    for ratio in ratios:
        crater = pressed(ratio)
        relative = RADIUS / crater.radius
        for w in works:
            unit, exact = math.pi * w * RADIUS, jkr_of(crater, w)
            force, finer = pull_off(crater, w), pull_off(crater.refined(2), w, 2 * STEPS)
            rows.append(
                [
                    f"{ratio:g}", f"{w:g} J/m²", f"{1 / relative:.2f}", f"{force / unit:.2f}",
                    f"{force / unit * relative:.2f}",
                    f"{100 * (force / exact - 1):.1f} %", f"{100 * (finer / exact - 1):.1f} %",
                ]
            )  # fmt: skip
    head = ["load/W_y", "w", "R_eff/R", "F/(π w R)", "F/(π w R_eff)",
            "F above JKR of the crater", "with half the cell size"]  # fmt: skip
    return table(head, rows)


@dataclass(frozen=True)
class Cost:
    """Iterations of a loading path."""

    plastic: int
    contact: int


def cost_of(w: float | None, control: str, increments: int = 7) -> Cost:
    """Return the iterations of a ball pressed into steel with power-law hardening, by V1.

    w: work of adhesion [J/m^2], None: no adhesion. control: "approach" or "load".
    """
    cells, size, depth = 29, 20e-6 / 29, 12
    grid = sc.Grid(cells, cells, size, size, nz=depth, dz=0.75 * size)
    steel = sc.Material.swift(210e9, 0.3, 1240e6, 30, 0.085)
    more = {} if w is None else {"adhesion": sc.Adhesion.jkr(w)}
    ball = sc.surfaces.paraboloid(grid, 105e-6)
    simulation = sc.Simulation(grid, RIGID, steel, ball, tol=1e-6, on_border="warn", **more)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for share in np.linspace(0.25, 1.0, increments):
            given = 0.6e-6 * share if control == "approach" else 1.27 * share**1.2
            simulation.step(**{control: given})
    found = simulation.counters
    return Cost(found["plastic_iterations"], found["contact_iterations"])


def adhesion_cost(works: Sequence[float] = (5.0, 30.0)) -> str:
    """Return the table of iterations with adhesion relative to those without."""
    rows = []
    for control in ("approach", "load"):
        without = cost_of(None, control)
        rows += [
            [
                control, f"{w:g} J/m²", f"{found.plastic / without.plastic:.2f}",
                f"{found.contact / without.contact:.2f}",
            ]
            for w in works
            for found in [cost_of(w, control)]
        ]  # fmt: skip
    return table(["prescribed", "w", "plastic iterations", "contact iterations"], rows)
