# SPDX-License-Identifier: GPL-3.0-or-later
"""Error of a small share of the boundary layer due to the grid, by other schemes of the flow."""

from __future__ import annotations

import math
import warnings
from dataclasses import replace
from typing import Any

from .._util.errors import ResolutionWarning
from .film_solution import FilmSolution
from .nested import FilmTask, LevelSolver, state_of

SHARES = 1e-3, 0.1
"""Range of shares whose error is found: smaller ones matter little, larger ones depend less on the
grid."""
MAX_ERROR = 0.1
"""Relative error of such a share above which a warning is issued."""
SHARPER = 2.0, 4.0
"""Films, in thicknesses of the layer, between which the scheme that overestimates the share changes
from first to third order."""
WITHOUT_SHARPER = 2.0
"""Factor of the difference of one scheme if that which overestimates the share fails."""
_TOL = 1e-5


def share_of(found: Any) -> float:
    """Return the share of the load that the boundary layer bears in a solution [-]."""
    layer = float(found["boundary_pressure"].sum())
    return layer / (layer + float(found["fluid_pressure"].sum()))


def share_error(solver: LevelSolver, found: Any, layer: tuple[float, float]) -> float | None:
    """Return the estimated error of the share of the layer due to the grid [-].

    It is the largest difference to the shares of two other schemes. Large cells make the film of
    order 1 too thick, and its share too small; order 3 down to thinner films has the opposite
    error. Infinite if neither converges, None outside the range of `SHARES`.
    """
    share = share_of(found)
    if not found["converged"] or not SHARES[0] <= share < SHARES[1]:
        return None
    task = solver.task
    solver.task = replace(task, tol=max(task.tol, _TOL))
    other = solver.solve(state_of(found), layer, 1 if task.order == 3 else 3)
    near = found if task.order == 3 or not other["converged"] else other
    sharper = solver.solve(state_of(near), layer, 3, order_change=SHARPER)
    solver.task = task
    both = [abs(share_of(one) - share) for one in (other, sharper) if one["converged"]]
    return max(both, default=math.inf) * (1.0 if sharper["converged"] else WITHOUT_SHARPER)


def of_sheared(error: float | None, before: Any, after: Any) -> float | None:
    """Return the error of a share that shear and heat have changed, in proportion to the share."""
    return None if error is None else error * share_of(after) / share_of(before)


def warn_of_share(solution: FilmSolution, task: FilmTask) -> None:
    """Warn of a small share of the layer with a large error."""
    error, share = solution.share_error, solution.boundary_share
    if error is None or error <= MAX_ERROR * share:
        return
    known = f"an estimated error of {error:.2g}" if math.isfinite(error) else "an unknown error"
    warnings.warn(
        f"the share of the load that the boundary layer bears, {share:.2g}, has {known} due to the "
        f"grid with order = {task.order}: use smaller cells, or take the share as an estimate",
        ResolutionWarning,
        stacklevel=3,
    )
