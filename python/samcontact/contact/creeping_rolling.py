# SPDX-License-Identifier: GPL-3.0-or-later
"""Steady rolling of viscoelastic bodies with friction.

The displacement is that of elastic bodies with intermediate moduli plus a remainder. The contact of
the elastic bodies is solved repeatedly, each time with the remainder due to the last tractions,
until the remainder no longer changes.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from .. import _core
from .._util import memory
from .._util.checks import FloatArray
from ..bodies.layered import Body, materials_of
from ..bodies.viscoelastic import instantaneous, relaxation_of, softened, vibrating
from ..problem.contact_law import in_contact
from ..problem.grid import Grid
from .moving import moving_creep

Tractions = tuple[FloatArray | None, FloatArray | None]
"""Pressure, shape (nx, ny), and shear, shape (2, nx, ny) [Pa]."""
Motion = tuple[float, float, float]
"""Creepages along x and y [-] and spin [1/m]."""
Roll = Callable[[FloatArray, Tractions, Motion, float, FloatArray | None], dict[str, Any]]
"""Function that solves steady rolling of elastic bodies. Arguments: gap; tractions and motion to
start from; tolerance; additional tangential displacement, shape (2, nx, ny) [m]."""

_DEPTH = 8
"""Number of earlier repetitions that the acceleration uses."""
_MAX_REPETITIONS = 400
_INNER_TOL = 0.01
"""Tolerance of one repetition, divided by the tolerance of the solution."""
_TIGHTEST_TOL = 1e-12
"""Smallest tolerance of a repetition."""


def intermediate(body: Body, speed: float, grid: Grid) -> Body:
    """Return an elastic body whose compliance is the mean of a smallest and a largest compliance.

    The smallest compliance is that for instantaneous loads. The largest is that for a pressure wave
    twice as long as the grid which passes at `speed`. For shorter waves, the complex compliance of
    a standard linear solid differs from the mean by less than the mean.
    """
    if relaxation_of(body) is None:
        return body
    slow = vibrating(body, np.pi * speed / (grid.nx * grid.dx))
    share = materials_of(slow)[0].E / materials_of(body)[0].E
    return softened(body, 2 / (1 + 1 / share))


class CreepingRest:
    """Remainder: displacement of rolling viscoelastic bodies minus that of `elastic` bodies."""

    def __init__(
        self, grid: Grid, bodies: tuple[Body, Body], elastic: tuple[Body, Body], speed: float
    ) -> None:
        needed = memory.surface(grid, memory.MOVING_CONTACT_BYTES)
        memory.require_for_grid("a moving viscoelastic contact", grid, needed)
        cores = [instantaneous(body)._core for body in bodies]
        creeps = [moving_creep(body, -speed) for body in bodies]
        self._moving = _core.CreepingTractions(grid._core, *cores, *creeps)
        none = _core.MovingCreep([], [], False)
        upper, lower = (body._core for body in elastic)
        self._elastic = _core.CreepingTractions(grid._core, upper, lower, none, none)

    def __call__(self, pressure: FloatArray, shear: FloatArray) -> tuple[FloatArray, float]:
        """Return the remainder, shape (3, nx, ny), and the maximum total u_z in the contact [m]."""
        whole = self._moving.displacement(pressure, shear)
        rest: FloatArray = whole - self._elastic.displacement(pressure, shear)
        touching = whole[2][in_contact(pressure)]
        return rest, float(np.abs(touching).max()) if touching.size else 0.0


class _Acceleration:
    """Anderson acceleration of repeated solutions."""

    def __init__(self) -> None:
        self._guesses: list[FloatArray] = []
        self._changes: list[FloatArray] = []

    def next(self, guess: FloatArray, change: FloatArray) -> FloatArray:
        """Return the next guess, from the last guess and the change that one repetition makes."""
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
    rest: CreepingRest, roll: Roll, gap: FloatArray, tol: float, start: tuple[Tractions, Motion]
) -> dict[str, Any]:
    """Solve the contact of elastic bodies repeatedly, with the remainder due to the last tractions.

    Parameters
    ----------
    rest : CreepingRest
    roll : callable
        Solves the contact of the elastic bodies.
    gap : ndarray, shape (nx, ny)
        Initial gap [m].
    tol : float
        Tolerance of the solution.
    start : pair
        Tractions and creepages from which the first solution starts.

    Raises
    ------
    ConvergenceError
        The repetitions do not converge.
    """
    tractions, motion = start
    lag = np.zeros((3, *gap.shape))
    if tractions[0] is not None and tractions[1] is not None:
        lag = rest(tractions[0], tractions[1])[0]
    counts = dict.fromkeys(_COUNTED, 0)
    inner, error = max(_INNER_TOL * tol, _TIGHTEST_TOL), np.inf
    acceleration = _Acceleration()
    for _ in range(_MAX_REPETITIONS):
        loose = max(inner, min(1e-3, 1e-2 * error))
        found = roll(gap + lag[2], tractions, motion, loose, lag[:2])
        for name in _COUNTED:
            counts[name] += found[name]
        pressure, shear, motion = found["pressure"], found["shear"], found["motion"]
        tractions = pressure, shear
        now, size = rest(pressure, shear)
        change = (now - lag) * in_contact(pressure)
        error = float(np.abs(change).max()) / size if size > 0 else 0.0
        if error <= tol and loose <= tol:
            found.update(counts, error=max(error, found["error"]))
            return found
        lag = acceleration.next(lag, now - lag)
    failed = _core.ConvergenceError(
        "the steady rolling of viscoelastic bodies did not converge: relative change "
        f"{error:.2g} after {_MAX_REPETITIONS} repetitions, tol {tol:g}: increase tol, or "
        "approach the speed and the creepage by steps of a Simulation"
    )
    failed.iterations, failed.residual = counts["iterations"], error
    raise failed


_COUNTED = (
    "iterations",
    "work",
    "operator_applications",
    "tangential_iterations",
    "tangential_applications",
    "tangential_work",
)
"""Counters of a solution, which are summed over the repetitions."""
