# SPDX-License-Identifier: GPL-3.0-or-later
"""Adhesive and viscoelastic contacts, films and inclusions that several benchmarks solve."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import samcontact as sc

from . import viscous
from .harness import Meter
from .steel import ELASTIC

RELAXATION_TERMS = 8


class Path(NamedTuple):
    """Simulation, not yet created, and the steps of its path."""

    made: Callable[[], sc.Simulation]
    steps: list[dict[str, Any]]

    def follow(self) -> list[sc.State]:
        """Create the simulation and take all steps."""
        simulation = self.made()
        return [simulation.step(**step) for step in self.steps]


def adhesive(meter: Meter, n: int) -> list[sc.ContactSolution]:
    """Press a rigid ball on a soft body that attracts it, and retract it, in four steps."""
    grid = sc.Grid(n, n, 320e-9 / n, 320e-9 / n)
    soft = sc.Material.elastic(1e9, 0.3)
    law = sc.Adhesion.exponential(0.05, range=4e-9)
    gap = sc.surfaces.paraboloid(grid, 1e-6)

    def cycle() -> list[sc.ContactSolution]:
        solver = sc.ContactSolver(grid, sc.Material.rigid(), soft, adhesion=law)
        found: list[sc.ContactSolution] = []
        for approach in (0.0, 2e-9, 0.0, -2e-9):
            start = found[-1].pressure if found else None
            found.append(solver.solve(gap, approach=approach, initial_pressure=start))
        return found

    return meter(cycle)


def film(meter: Meter, n: int) -> sc.lubrication.FilmSolution:
    """Solve a steady film of a ball at 0.5 GPa."""
    R, load = 0.01, 20.0
    steel = sc.Material.elastic(207e9, 0.3)
    oil = sc.Lubricant.roelands(viscosity=0.04, pressure_viscosity=22e-9)
    a = sc.hertz.point(R, sc.hertz.effective_modulus(steel, steel), load=load).a
    grid = sc.Grid(n, n, 4.5 * a / n, 4.5 * a / n)
    x, y = grid.x[:, None] - 0.75 * a, grid.y[None, :]
    gap = 0.5 * (x**2 + y**2) / R
    return meter(
        lambda: sc.lubrication.steady(
            grid, steel, steel, gap, load=load, speed=(1.0, 1.0), lubricant=oil
        )
    )


def included(n: int) -> Path:
    """Press a ball on steel with a stiff sphere below its centre, of n cells radius."""
    radius = 24e-6
    d = radius / n
    grid = sc.Grid(13 * n, 13 * n, d, d, dz=d)
    alumina = sc.Material.elastic(E=390e9, nu=0.25)
    oxide = sc.Inclusion.sphere(center=(0.0, 0.0, 60e-6), radius=radius, material=alumina)
    body = sc.Heterogeneous(ELASTIC, [oxide])
    gap = sc.surfaces.paraboloid(grid, 3e-3)
    return Path(
        lambda: sc.Simulation(grid, ELASTIC, body, gap),
        [{"load": part * 60.0} for part in (0.5, 1.0)],
    )


def viscoelastic(n: int) -> Path:
    """Press a rigid ball on a viscoelastic body with eight terms, in eleven increments."""
    body = viscous.relaxing(RELAXATION_TERMS)
    load = viscous.contact(viscous.CASES[0], n, body)[1] * viscous.RELAXED[RELAXATION_TERMS]
    return Path(
        lambda: viscous.contact(viscous.CASES[0], n, body)[0],
        [{"load": load * (0.35 + 0.05 * k), "duration": viscous.STEP} for k in range(11)],
    )
