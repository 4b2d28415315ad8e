# SPDX-License-Identifier: GPL-3.0-or-later
"""tamaas: Polonsky and Keer's solver, with free and periodic operators, and plastic contact.

Plastic contact is solved by the volume model and the EPIC scheme of tamaas, in a periodic
domain."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable

import numpy as np
import tamaas as tm
from tamaas.nonlinear_solvers import DFSANECXXSolver

from . import problems
from .running import Outcome

tm.initialize(1)
tm.set_log_level(tm.LogLevel.error)


def version() -> str:
    return str(tm.__version__)


def iterations_logged(solve: Callable[[], float]) -> int:
    """Call the solver and count the iterations that it prints, because it returns no count."""
    kept = os.dup(2), os.dup(1)
    with tempfile.TemporaryFile() as file:
        for stream in (1, 2):
            os.dup2(file.fileno(), stream)
        tm.set_log_level(tm.LogLevel.info)
        try:
            solve()
        finally:
            tm.set_log_level(tm.LogLevel.error)
            os.dup2(kept[0], 2)
            os.dup2(kept[1], 1)
        file.seek(0)
        lines = [line.split() for line in file.read().decode().splitlines()]
    return max((int(line[0]) for line in lines if line and line[0].isdigit()), default=0)


class Contact:
    """Solver with the pressure as primal variable; two operator applications per iteration."""

    tolerances = (1e-4, 1e-6, 1e-8, 1e-10)

    def __init__(self, problem: problems.Elastic, tol: float) -> None:
        side, n = problem.side, problem.n
        self.mean = problem.load / side**2
        self.model = tm.ModelFactory.createModel(tm.model_type.basic_2d, [side, side], [n, n])
        self.model.E, self.model.nu = problems.E, problems.NU
        self.solver = tm.PolonskyKeerRey(self.model, -problem.gap, tol)
        if not problem.periodic:
            tm.ModelFactory.registerNonPeriodic(self.model, "dcfft")
            self.solver.setIntegralOperator("dcfft")
        self.solver.max_iter = 5000
        self.solver.dump_freq = 1

    def solve(self) -> Outcome:
        self.model.traction[...] = 0.0
        count = iterations_logged(lambda: self.solver.solve(self.mean))
        counts = {"iterations": count, "applications": 2 * count}
        return Outcome(np.array(self.model.traction).squeeze(), counts)


class Plasticity:
    """Plastic contact: Anderson mixing of contact and plastic flow, which DF-SANE solves in C++."""

    tolerances = (1e-2, 1e-3, 1e-4, 1e-6)

    def __init__(self, problem: problems.Plastic, tol: float) -> None:
        self.problem = problem
        n, side = problem.n, problem.side
        # The number of nodes in depth is one more than the number of layers.
        size = [problem.depth, side, side]
        kind = tm.model_type.volume_2d
        self.model = tm.ModelFactory.createModel(kind, size, [problem.layers + 1, n, n])
        self.model.E, self.model.nu = problems.E, problems.NU
        material = tm.materials.IsotropicHardening(
            self.model, problems.YIELD_STRESS, problems.HARDENING
        )
        self.residual = tm.Residual(self.model, material)
        self.flow = DFSANECXXSolver(self.residual)
        # An absolute norm of strain; strains here are of the order of 1 %.
        self.flow.tolerance = 1e-3 * tol
        self.contact = tm.PolonskyKeerRey(self.model, -problem.gap, 1e-2 * tol)
        self.solver = tm.AndersonMixing(self.contact, self.flow, tol, 5)
        self.solver.max_iter = 500

    def solve(self) -> Outcome:
        problem = self.problem
        for k in range(1, problems.INCREMENTS + 1):
            # solve() also updates the state of the material.
            self.solver.solve(problem.load * k / problems.INCREMENTS / problem.side**2)
        pressure = np.array(self.model.traction)[..., 2]
        strain = np.array(self.model["cumulated_plastic_strain"])
        strain = strain.reshape(problem.layers + 1, problem.n, problem.n)
        return Outcome(pressure, {}, plastic_strain=np.moveaxis(strain, 0, 2))


class Stress:
    """Stress by the gradient of Boussinesq's displacements and Hooke's law, one application."""

    tolerances = (0.0,)

    def __init__(self, problem: problems.Plastic, pressure: np.ndarray, z: np.ndarray) -> None:
        n, side = problem.n, problem.side
        size, kind = [problem.depth, side, side], tm.model_type.volume_2d
        self.model = tm.ModelFactory.createModel(kind, size, [z.size, n, n])
        self.model.E, self.model.nu = problems.E, problems.NU
        tm.ModelFactory.registerVolumeOperators(self.model)
        self.pressure = pressure
        self.model.traction[..., 2] = pressure

    def solve(self) -> Outcome:
        fields = [np.zeros([*self.model.shape, 6]) for _ in range(2)]
        self.model.operators["boussinesq_gradient"](self.model.traction, fields[0])
        self.model.operators["hooke"](*fields)
        full = np.asarray(tm.compute.from_voigt(fields[1]))
        # xx, yy, zz, yz, xz, xy of the tensor by rows, depth last
        stress = np.moveaxis(full[..., [0, 4, 8, 5, 2, 1]], (3, 0), (0, 3))
        return Outcome(self.pressure, {}, stress=stress)
