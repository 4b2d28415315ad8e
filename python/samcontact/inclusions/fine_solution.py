# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic solution of inclusions in a box of cells under a given stress.

The equations are (1) to (3) of docs/theory/inclusions.md without plastic flow. The top of the box
may be below the surface of the body.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from .. import _core
from .._util.checks import FloatArray
from .tensors import deviator, mean

_LARGE_RATIO = 20.0  # of moduli, beyond which the iteration converges slowly
_STRONG_TOL = 1e-3  # smallest tolerance then: the strain in a void is not unique
_DEPTH = 8  # number of steps that the acceleration uses
_MAX_EVALUATIONS = 200
_IMAGE_TOL = 1e-4


class Moduli(NamedTuple):
    """Moduli and misfit strain of the cells that differ from the matrix."""

    bulk: FloatArray
    """Bulk modulus divided by that of the matrix, shape (n,)."""
    shear: FloatArray
    """Shear modulus divided by that of the matrix, shape (n,)."""
    misfit: FloatArray
    """Misfit strain, shape (6, n)."""

    @property
    def are_strong(self) -> bool:
        """Whether a modulus differs from that of the matrix by a factor above 20."""
        both = np.concatenate([self.bulk, self.shear])
        return bool(both.max() > _LARGE_RATIO or both.min() < 1 / _LARGE_RATIO)


class Solution(NamedTuple):
    """Eigenstrain of n cells, shape (6, n), stress in the box [Pa], and number of evaluations."""

    eigenstrain: FloatArray
    stress: FloatArray
    evaluations: int


class _Law:
    """Update of the eigenstrain e* of all cells at constant s + p C e*.

    Here s is the stress, C the stiffness of the matrix and p a factor; see `MixedLaw` in the
    compiled core.
    """

    def __init__(self, cells: Moduli, E: float, nu: float) -> None:
        strong = cells.are_strong
        self.misfit = cells.misfit
        bulk_part = 2 * (1 - 2 * nu) / (3 * (1 - nu))
        shear_part = (7 - 5 * nu) / (15 * (1 - nu))
        self.bulk = self._kept(cells.bulk, bulk_part, E / (1 - 2 * nu), strong)
        self.shear = self._kept(cells.shear, shear_part, E / (1 + nu), strong)

    @staticmethod
    def _kept(
        ratio: FloatArray, sphere: float, stiffness: float, strong: bool
    ) -> tuple[FloatArray, FloatArray]:
        """Return p C, and the ratio [-] of the updated s to s + p C e* for a misfit of 0."""
        p = np.full_like(ratio, sphere)
        if strong:
            p = np.where(ratio < 1, 1.0, np.where(ratio > 1, 0.5 * sphere, p))
        return p * stiffness, ratio / ((1 - p) * ratio + p)

    def step(self, stress: FloatArray, eigenstrain: FloatArray) -> FloatArray:
        """Return the eigenstrain that follows from an estimate of stress and eigenstrain.

        All arrays have the shape (6, n).
        """
        found = np.zeros_like(stress)
        for part, (stiffness, share) in ((mean, self.bulk), (deviator, self.shear)):
            kept = part(stress) + stiffness * part(eigenstrain)
            found += (kept - share * (kept - stiffness * part(self.misfit))) / stiffness
        return found


class _Anderson:
    """Anderson acceleration of a fixed-point iteration."""

    def __init__(self) -> None:
        self.points: list[FloatArray] = []
        self.steps: list[FloatArray] = []

    def next(self, x: FloatArray, step: FloatArray) -> FloatArray:
        """Return the next estimate, from the last estimate x and the step of the iteration at x."""
        self.points = [*self.points, x][-_DEPTH - 1 :]
        self.steps = [*self.steps, step][-_DEPTH - 1 :]
        if len(self.points) == 1:
            return x + step
        changes = np.stack([(b - a).ravel() for a, b in pairwise(self.steps)], axis=1)
        moves = np.stack([(b - a).ravel() for a, b in pairwise(self.points)], axis=1)
        weights = np.linalg.lstsq(changes, step.ravel(), rcond=1e-10)[0]
        return np.asarray(x + step - ((moves + changes) @ weights).reshape(x.shape))


def solve(
    box: Any, above: int, given: FloatArray, where: Any, cells: Moduli, E: float, nu: float,
    tol: float,
) -> Solution:  # fmt: skip
    """Compute the eigenstrain of the inclusions in a box, and the stress in the box.

    Parameters
    ----------
    box : _core.Grid
        Cells of the box in all its layers.
    above : int
        Number of layers of cells between the surface and the box.
    given : ndarray, shape (6, nz, nx, ny)
        Stress without the inclusions [Pa].
    where : tuple of ndarray
        Indices k, i and j of the n cells that differ from the matrix.
    cells : Moduli
        Moduli and misfit strain of these cells.
    E, nu : float
        Young's modulus [Pa] and Poisson's ratio of the matrix.
    tol : float
        Tolerance of the eigenstrain, relative to its norm.
    """
    operator = _core.operators.ResidualBox(
        box, above, _core.Elastic.isotropic(E, nu), min(_IMAGE_TOL, tol)
    )
    law, accelerated = _Law(cells, E, nu), _Anderson()
    limit = max(tol, _STRONG_TOL) if cells.are_strong else tol
    of_cells = (slice(None), *where)
    strain = np.zeros_like(given)
    x = law.step(given[of_cells], np.zeros((6, len(where[0]))))
    for count in range(1, _MAX_EVALUATIONS + 1):
        strain[of_cells] = x
        stress = given + np.moveaxis(operator.stress(strain), -1, 1)
        step = law.step(stress[of_cells], x) - x
        size = np.linalg.norm(x + step)
        if np.linalg.norm(step) <= limit * size:
            return Solution(x, stress, count)
        x = accelerated.next(x, step)
    raise _core.ConvergenceError(
        f"inclusions did not converge: after {_MAX_EVALUATIONS} evaluations, the eigenstrain still "
        f"changes by {np.linalg.norm(step) / size:.2g} of its norm, more than tol = {limit:g}; "
        "increase tol, use inclusions with moduli closer to those of the matrix, or solve "
        "fewer inclusions in one box"
    )
