# SPDX-License-Identifier: GPL-3.0-or-later
"""samcontact with default settings except the tolerance."""

from __future__ import annotations

import numpy as np

import samcontact as sc

from . import problems
from .running import Outcome

# The package imports classes at their first use; the other codes are imported before a measurement.
IMPORTED = (sc.ContactSolver, sc.PartialSlipSolution, sc.Simulation)

RIGID = sc.Material.rigid()
ELASTIC = sc.Material.elastic(problems.E, problems.NU)


def version() -> str:
    return sc.__version__


class Contact:
    """Elastic contact; the contact may reach the grid edge, as in the other codes."""

    tolerances = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10)

    def __init__(self, problem: problems.Elastic, tol: float) -> None:
        self.problem = problem
        self.solver = sc.ContactSolver(problem.grid, RIGID, ELASTIC, tol=tol, on_border="warn")

    def solve(self) -> Outcome:
        found = self.solver.solve(self.problem.gap, load=self.problem.load)
        counts = {
            "iterations": found.iterations,
            "applications": found.operator_applications,
            "work": found.work,
        }
        return Outcome(found.pressure, counts, approach=found.approach)


class Slip:
    """Partial slip of two identical bodies, each twice as stiff as the elastic body of the problem.

    Pressure and shear are then uncoupled, as in ASPHER."""

    tolerances = (1e-1, 1e-2, 1e-4, 1e-6, 1e-8)

    def __init__(self, problem: problems.Slipping, tol: float) -> None:
        self.problem = problem
        half = sc.Material.elastic(2 * problems.E, problems.NU)
        law = sc.Coulomb(problems.FRICTION)
        self.solver = sc.ContactSolver(problem.grid, half, half, law, tol=tol)

    def solve(self) -> Outcome:
        problem, drive = self.problem, {}
        if problem.force is not None:
            drive["tangential_load"] = (problem.force, 0.0)
        if problem.shift is not None:
            drive["shift"] = (problem.shift, 0.0)
        found = self.solver.solve(problem.gap, load=problem.load, **drive)
        assert isinstance(found, sc.PartialSlipSolution)
        counts = {
            "iterations": found.tangential_iterations,
            "applications": found.tangential_applications,
        }
        return Outcome(found.pressure, counts, shear=found.shear)


class Plasticity:
    """Elastic-plastic contact with equal load increments."""

    tolerances = (1e-2, 1e-3, 1e-4, 1e-6)

    def __init__(self, problem: problems.Plastic, tol: float) -> None:
        hardening, modulus = problems.HARDENING, problems.E
        tangent = modulus * hardening / (modulus + hardening)
        self.problem = problem
        self.body = sc.Material.linear_hardening(
            modulus, problems.NU, problems.YIELD_STRESS, tangent
        )
        self.tol = tol

    def solve(self) -> Outcome:
        problem = self.problem
        simulation = sc.Simulation(problem.grid, RIGID, self.body, problem.gap, tol=self.tol)
        for k in range(1, problems.INCREMENTS + 1):
            state = simulation.step(load=problem.load * k / problems.INCREMENTS)
        counters = simulation.counters
        counts = {
            "iterations": counters["plastic_iterations"],
            "contact_iterations": counters["contact_iterations"],
        }
        strain = state.equivalent_plastic_strain()
        return Outcome(state.pressure, counts, plastic_strain=strain)


class Stress:
    """Stress at given depths due to a given pressure."""

    tolerances = (0.0,)

    def __init__(self, problem: problems.Plastic, pressure: np.ndarray, z: np.ndarray) -> None:
        self.solver = sc.ContactSolver(problem.grid, RIGID, ELASTIC)
        self.pressure, self.z = pressure, z

    def solve(self) -> Outcome:
        return Outcome(self.pressure, {}, stress=self.solver.stress(self.pressure, self.z))
