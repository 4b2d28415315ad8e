# SPDX-License-Identifier: GPL-3.0-or-later
"""samcontact: `ContactSolver` with an attraction, at given approaches."""

from __future__ import annotations

import samcontact as sc

from .problems import ELASTIC, MODULUS, RIGID, SIDE, Path, State


class Contact:
    """Each step starts from the pressure of the preceding one."""

    tolerances = (1e-6, 1e-7, 1e-8, 1e-9)

    def __init__(self, path: Path, tol: float) -> None:
        self.path = path
        cell = SIDE * path.cell
        grid = sc.Grid(path.n, path.n, cell, cell, periodic=path.periodic)
        law = sc.Adhesion.exponential(path.work * SIDE * MODULUS, path.range * SIDE)
        self.solver = sc.ContactSolver(grid, RIGID, ELASTIC, adhesion=law, tol=tol)
        self.gap = path.gap * SIDE

    def solve(self) -> list[State]:
        found: list[State] = []
        start = None
        for distance in self.path.distances:
            approach = self.path.approach(distance) * SIDE
            solution = self.solver.solve(self.gap, approach=approach, initial_pressure=start)
            start = solution.pressure
            found.append(State(solution.gap / SIDE, start / MODULUS, solution.iterations))
        return found
