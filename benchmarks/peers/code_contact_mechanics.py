# SPDX-License-Identifier: GPL-3.0-or-later
"""ContactMechanics: Polonsky and Keer's solver on the free half-space."""

from __future__ import annotations

from importlib.metadata import version as version_of

import numpy as np
from ContactMechanics import FreeFFTElasticHalfSpace
from ContactMechanics.Optimization.ConstrainedConjugateGradients import (
    constrained_conjugate_gradients,
)
from SurfaceTopography import Topography

from . import problems
from .running import Outcome


def version() -> str:
    return version_of("ContactMechanics")


class Contact:
    """Elastic contact.

    The tolerance applies to three quantities: penetration relative to the indentation, the offset,
    and tensile forces relative to the mean force on a cell."""

    tolerances = (1e-4, 1e-6, 1e-8, 1e-10)

    def __init__(self, problem: problems.Elastic, tol: float) -> None:
        self.problem = problem
        self.tol = tol
        size = (problem.side, problem.side)
        # The engine "serial" is faster than "fftw" here.
        self.substrate = FreeFFTElasticHalfSpace(
            problem.gap.shape, problems.E_STAR, size, fft="serial"
        )
        self.topography = Topography(-problem.gap, size)
        # Order of magnitude of the displacements: the load on a disk as wide as the grid.
        self.displacement = problem.load / (problems.E_STAR * problem.side)

    def solve(self) -> Outcome:
        problem, tol = self.problem, self.tol
        found = constrained_conjugate_gradients(
            self.substrate,
            self.topography,
            external_force=problem.load,
            pentol=tol * self.displacement,
            forcetol=10 * tol * problem.load / problem.n**2,
            thermotol=tol,
            maxiter=3000,
        )
        if not found.success:
            raise RuntimeError(f"ContactMechanics: {found.message}")
        counts = {"iterations": int(found.nit), "applications": int(found.nfev)}
        return Outcome(np.asarray(found.jac) / problem.cell**2, counts)
