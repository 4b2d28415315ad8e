# SPDX-License-Identifier: GPL-3.0-or-later
"""Steady rolling of viscoelastic bodies with friction.

The displacement is that of elastic bodies of intermediate moduli plus a rest, which is taken from
the last tractions until it no longer changes.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from .. import _core
from .._util import memory
from .._util.checks import FloatArray
from ..bodies.layered import Body
from ..bodies.relaxation import long_time_share
from ..bodies.viscoelastic import instantaneous, relaxation_of, softened
from ..problem.grid import Grid
from .moving import moving_creep

_DEPTH = 8
"""Number of differences in the acceleration."""
_MAX_REPETITIONS = 200
_INNER = 0.1
"""Tolerance of a repetition relative to that of the solution."""
_LEAST = 1e-12
"""Smallest tolerance of a repetition."""


def intermediate(body: Body) -> Body:
    """Return the elastic body whose compliance is halfway between the fast and the slow one.

    The compliance of a standard linear solid at any frequency differs from it by at most (J - 1)/
    (J + 1) of it, with the creep function J after a long time.
    """
    terms = relaxation_of(body)
    if terms is None:
        return body
    return softened(body, 2 / (1 + 1 / long_time_share(terms)))


class CreepingRest:
    """Displacement of rolling viscoelastic bodies less that of their intermediate bodies."""

    def __init__(self, grid: Grid, bodies: tuple[Body, Body], speed: float) -> None:
        needed = memory.surface(grid, memory.MOVING_CONTACT_BYTES)
        memory.require_for_grid("a moving viscoelastic contact", grid, needed)
        cores = [instantaneous(body)._core for body in bodies]
        creeps = [moving_creep(body, -speed) for body in bodies]
        self._moving = _core.CreepingTractions(grid._core, *cores, *creeps)
        bases = [intermediate(body)._core for body in bodies]
        none = _core.MovingCreep([], [], False)
        self._elastic = _core.CreepingTractions(grid._core, *bases, none, none)

    def __call__(self, pressure: FloatArray, shear: FloatArray) -> tuple[FloatArray, float]:
        """Return the rest along x, y and z, shape (3, nx, ny), and the size of the whole [m]."""
        whole = self._moving.displacement(pressure, shear)
        rest: FloatArray = whole - self._elastic.displacement(pressure, shear)
        touching = whole[2][pressure > 0]
        return rest, float(np.abs(touching).max()) if touching.size else 0.0


class _Acceleration:
    """Anderson acceleration of repeated solutions."""

    def __init__(self) -> None:
        self._guesses: list[FloatArray] = []
        self._changes: list[FloatArray] = []

    def next(self, guess: FloatArray, change: FloatArray) -> FloatArray:
        """Return the next guess from the last one and the change that it causes."""
        self._guesses = [*self._guesses, guess][-_DEPTH - 1 :]
        self._changes = [*self._changes, change][-_DEPTH - 1 :]
        if len(self._guesses) == 1:
            return guess + change
        steps = np.diff([g.ravel() for g in self._guesses], axis=0)
        bends = np.diff([c.ravel() for c in self._changes], axis=0)
        weights = np.linalg.lstsq(bends.T, change.ravel(), rcond=1e-10)[0]
        correction: FloatArray = (weights @ (steps + bends)).reshape(guess.shape)
        return guess + change - correction


def roll_creeping(
    rest: CreepingRest, roll: Any, gap: FloatArray, tol: float, start: tuple[Any, Any]
) -> dict[str, Any]:
    """Repeat the solution of intermediate bodies with the rest of its own tractions.

    Parameters
    ----------
    rest : CreepingRest
    roll : callable
        Solves for a gap, pressure and shear to start from, creepages to start from (None: given
        ones), a tolerance, and a tangential displacement.
    gap : ndarray, shape (nx, ny)
        Initial gap [m].
    tol : float
        Tolerance of the solution.
    start : pair of ndarray, or of None
        Pressure and shear [Pa].

    Raises
    ------
    ConvergenceError
        No convergence.
    """
    pressure, shear = start
    lag = np.zeros((3, *gap.shape)) if shear is None else rest(pressure, shear)[0]
    motion, counts = None, dict.fromkeys(_COUNTED, 0)
    inner, error = max(_INNER * tol, _LEAST), np.inf
    acceleration = _Acceleration()
    for _ in range(_MAX_REPETITIONS):
        loose = max(inner, min(1e-3, 1e-2 * error))
        found: dict[str, Any] = roll(gap + lag[2], pressure, shear, motion, loose, lag[:2])
        for name in _COUNTED:
            counts[name] += found[name]
        pressure, shear, motion = found["pressure"], found["shear"], found["motion"]
        now, size = rest(pressure, shear)
        change = (now - lag) * (pressure > 0)
        error = float(np.abs(change).max()) / size if size > 0 else 0.0
        if error <= tol and loose <= tol:
            found.update(counts, error=max(error, found["error"]))
            return found
        lag = acceleration.next(lag, now - lag)
    raise _core.ConvergenceError(
        "the steady rolling of viscoelastic bodies did not converge: relative change "
        f"{error:.2g} after {_MAX_REPETITIONS} repetitions, tol {tol:g}: increase tol, or "
        "approach the speed and the creepage by steps of a Simulation"
    )


_COUNTED = (
    "iterations",
    "work",
    "operator_applications",
    "tangential_iterations",
    "tangential_applications",
    "tangential_work",
)
"""Counters of a solution, which are summed over the repetitions."""
