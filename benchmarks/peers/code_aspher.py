# SPDX-License-Identifier: GPL-3.0-or-later
"""ASPHER: nested grids and a spectral preconditioner; exact, mixed precision, H2-matrix."""

from __future__ import annotations

from importlib.metadata import version as version_of
from typing import Any, ClassVar

import aspher
import numpy as np

from . import problems
from .running import Outcome


def version() -> str:
    return version_of("aspher")


class Contact:
    """Contact in free space by FFT in double precision; each call reports its set-up time."""

    tolerances = (1e-4, 1e-6, 1e-8, 1e-10)
    settings: ClassVar[dict[str, Any]] = {"backend": "fft"}

    def __init__(self, problem: problems.Elastic, tol: float) -> None:
        self.problem = problem
        self.tol = tol

    def solve(self) -> Outcome:
        problem = self.problem
        found = aspher.solve_nested(
            grid_size=problem.n,
            gap=problem.gap.ravel(),
            p_nominal=problem.load / problem.side**2,
            domain_size=problem.side,
            E_star=problems.E_STAR,
            coarsest=min(64, problem.n),
            tol=self.tol,
            **self.settings,
        )
        if not found.converged:
            raise RuntimeError(f"ASPHER: {found.status}, {found.status_reason}")
        counts = {"iterations": found.iterations, "applications": found.matvec_count}
        pressure = np.asarray(found.pressure).reshape(problem.gap.shape)
        share = found.timings["build"] / found.timings["total"]
        return Outcome(pressure, counts, setup_share=share)


class Mixed(Contact):
    """Solver in single precision, with a final correction in double precision."""

    tolerances = (1e-6, 1e-8, 1e-10)
    settings: ClassVar = {"backend": "fft", "precision": "float_then_double"}


class Hierarchical(Contact):
    """H2-matrix restricted to candidates of contact; the operator is accurate to about 1e-5."""

    tolerances = (1e-5, 1e-6)
    settings: ClassVar = {"backend": "h2", "active_set": True}


class Slip:
    """`FrictionSolver` with the default preconditioner.

    The tolerance applies to the residuals of the friction conditions. A run that is reported as not
    converged has no result."""

    tolerances = (1e-1, 1e-2, 1e-3, 1e-4)

    def __init__(self, problem: problems.Slipping, tol: float) -> None:
        self.problem, self.tol = problem, tol

    def solve(self) -> Outcome:
        problem = self.problem
        solver = aspher.FrictionSolver(
            grid_size=problem.n,
            domain_size=problem.side,
            E_star=problems.E_STAR,
            nu=problems.NU,
            model=aspher.CoulombFriction(mu=problems.FRICTION),
        )
        solver.set_gap(problem.gap)
        area = problem.side**2
        drive: dict[str, Any] = {}
        if problem.force is not None:
            drive["q_bar"] = (problem.force / area, 0.0)
        if problem.shift is not None:
            drive["delta_t"] = (problem.shift, 0.0)
        found = solver.step(
            p_bar=problem.load / area,
            tol_normal=min(self.tol, 1e-6),
            tol_tangential=self.tol,
            **drive,
        )
        if not found.converged:
            raise RuntimeError(f"ASPHER: {found.status_reason}")
        shape = problem.gap.shape
        shear = np.stack([np.reshape(found.qx, shape), np.reshape(found.qy, shape)])
        pressure = np.reshape(solver.pressure, shape)
        return Outcome(pressure, {"iterations": found.tangential_iters}, shear=shear)
