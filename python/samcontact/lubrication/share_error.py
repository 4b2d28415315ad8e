# SPDX-License-Identifier: GPL-3.0-or-later
"""Error due to the grid of a small load share of the boundary layer, by other flow schemes."""

from __future__ import annotations

import math
import warnings
from dataclasses import replace
from typing import Any

from .._util.errors import ResolutionWarning
from .film_solution import FilmSolution
from .nested import FilmTask, LevelSolver, state_of

SHARES = 1e-3, 0.1
"""Range of load shares whose error is estimated.

Smaller shares matter little, and larger shares depend less on the grid."""
MAX_ERROR = 0.1
"""Limit for a warning: relative error of a load share."""
SHARPER = 2.0, 4.0
"""Film thicknesses, divided by that of the layer, between which a scheme changes its order.

This scheme has the first order in thinner films, the third order in thicker films, and
overestimates the share."""
WITHOUT_SHARPER = 2.0
"""Factor on the estimated error if the scheme that overestimates the share fails."""
_TOL = 1e-5


def share_of(found: Any) -> float:
    """Return the share of the load that the boundary layer bears in a solution [-]."""
    layer = float(found["boundary_pressure"].sum())
    return layer / (layer + float(found["fluid_pressure"].sum()))


def share_error(solver: LevelSolver, found: Any, layer: tuple[float, float]) -> float | None:
    """Return the estimated error of the share of the layer due to the grid [-].

    The error is the largest difference between this share and the shares by two other schemes. With
    large cells, the scheme of order 1 gives too thick a film and too small a share; the scheme that
    uses order 3 also in thinner films (see `SHARPER`) has the opposite error. The result is
    infinite if neither scheme converges, and None if the share is outside `SHARES`.
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
    """Return the error of a share after shear and heat changed both in the same proportion."""
    return None if error is None else error * share_of(after) / share_of(before)


def warn_of_share(solution: FilmSolution, task: FilmTask) -> None:
    """Warn if the load share of the boundary layer is small and has a large error."""
    error, share = solution.share_error, solution.boundary_share
    if error is None or error <= MAX_ERROR * share:
        return
    known = f"an estimated error of {error:.2g}" if math.isfinite(error) else "an unknown error"
    warnings.warn(
        f"the boundary layer bears the share {share:.2g} of the load, with {known} due to the grid "
        f"(order = {task.order}): use smaller cells, or regard the share as a rough estimate",
        ResolutionWarning,
        stacklevel=3,
    )
