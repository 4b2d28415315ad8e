# SPDX-License-Identifier: GPL-3.0-or-later
"""Adhesion of ContactEngineering: bounded contact with an exponential attraction.

The conjugate gradients of Bugnicourt et al. (2018) minimise the energy. L-BFGS-B, its other solver
with bounds, takes three times as long.
"""

from __future__ import annotations

import numpy as np
from Adhesion.Interactions import Exponential
from Adhesion.System import BoundedSmoothContactSystem
from ContactMechanics import FreeFFTElasticHalfSpace, PeriodicFFTElasticHalfSpace
from NuMPI.Optimization.CCGWithoutRestart import constrained_conjugate_gradients
from SurfaceTopography import Topography

from .problems import Path, State

MAX_ITERATIONS = 5000  # iterations


class Contact:
    """Conjugate gradients; each step starts from the solution of the preceding one."""

    tolerances = (1e-6, 1e-7, 1e-8, 1e-9)

    def __init__(self, path: Path, tol: float) -> None:
        self.path = path
        size = path.n, path.n
        kind = PeriodicFFTElasticHalfSpace if path.periodic else FreeFFTElasticHalfSpace
        self.half_space = kind(size, 1.0, (1.0, 1.0))
        if path.periodic:
            self._set_operators()
        self.system = BoundedSmoothContactSystem(
            self.half_space,
            Exponential(path.work, path.range),
            Topography(-path.gap, (1.0, 1.0)),
        )
        self.tol = tol * path.peak * path.cell**2  # of the force on a cell

    def _set_operators(self) -> None:
        spectrum = self.path.spectrum
        if spectrum.shape != self.half_space.greens_function.shape:
            spectrum = spectrum.T  # symmetric under exchange of the axes
        self.half_space.greens_function[...] = spectrum
        inverse = np.divide(1.0, spectrum, out=np.zeros_like(spectrum), where=spectrum > 0)
        self.half_space.surface_stiffness[...] = inverse

    def solve(self) -> list[State]:
        found: list[State] = []
        step = self._gap if self.path.periodic else self._displacement
        x = np.zeros(self.half_space.nb_subdomain_grid_pts)
        for distance in self.path.distances:
            approach = self.path.approach(distance)
            x, count = step(approach, x)
            found.append(State(*self._fields(x, approach), count))
        return found

    def _gap(self, approach: float, gap: np.ndarray) -> tuple[np.ndarray, int]:
        """Return the gap at its mean value, from an earlier gap."""
        start = np.maximum(self.path.gap - approach, 0.0) if not gap.any() else gap
        mean = float(self.path.gap.mean()) - approach
        fun = self.system.primal_objective(approach, gradient=True)
        return self._minimum_at_mean(fun, start * (mean / start.mean()), mean)

    def _displacement(self, approach: float, moved: np.ndarray) -> tuple[np.ndarray, int]:
        """Return the displacement, from an earlier displacement; padded."""
        n = self.path.n
        least = np.full(moved.shape, -np.inf)
        least[:n, :n] = approach - self.path.gap
        fun = self.system.objective(approach, gradient=True)
        return self._minimum(fun, np.maximum(moved, least), least, approach)

    def _minimum_at_mean(self, fun, start, mean):  # type: ignore[no-untyped-def]
        found = constrained_conjugate_gradients(
            fun, self.system.primal_hessian_product, start.ravel(), mean_val=mean,
            gtol=self.tol, maxiter=MAX_ITERATIONS,
        )  # fmt: skip
        return _checked(found, start.shape)

    def _minimum(self, fun, start, least, approach):  # type: ignore[no-untyped-def]
        found = constrained_conjugate_gradients(
            fun, self.system.hessian_product_function(approach), start.ravel(),
            bounds=least.ravel(), gtol=self.tol, maxiter=MAX_ITERATIONS,
        )  # fmt: skip
        return _checked(found, start.shape)

    def _fields(self, x: np.ndarray, approach: float) -> tuple[np.ndarray, np.ndarray]:
        """Return gap and pressure."""
        path, n = self.path, self.path.n
        moved = x + approach - path.gap if path.periodic else x
        force = np.array(self.half_space.evaluate_force(moved))[:n, :n]
        pressure = -force / path.cell**2
        gap = moved[:n, :n] + path.gap - approach
        if path.periodic:
            open_ = x > 0
            attraction = path.peak * np.exp(-gap / path.range)
            pressure = pressure - (pressure + attraction)[open_].mean()
        return gap, pressure


def _checked(found, shape):  # type: ignore[no-untyped-def]
    if not found.success:
        raise RuntimeError(f"not converged: {found.message}")
    return np.asarray(found.x).reshape(shape), int(found.nit)
