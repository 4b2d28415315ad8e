# SPDX-License-Identifier: GPL-3.0-or-later
"""Stribeck curve: lubricated contact versus speed, from the dry contact to the full film."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, finite, finite_array
from .._util.display import ShortRepr
from .._util.errors import attach
from ..bodies.layered import Body
from ..lubricants.lubricant import Lubricant
from ..problem.grid import Grid
from .boundary import Boundary
from .film_solution import FilmSolution
from .mixed import MixedFilm
from .sheared import check_heated, with_shear
from .steady import checked_task, require_converged, solution_of


@dataclass(frozen=True, repr=False, eq=False)
class StribeckCurve(ShortRepr):
    """Films at increasing speeds, from `stribeck`.

    Attributes
    ----------
    solutions : tuple of FilmSolution
        Solution at each speed.
    dry_pressure : ndarray, shape (nx, ny)
        Pressure of the dry contact [Pa].
    """

    solutions: tuple[FilmSolution, ...]
    dry_pressure: FloatArray

    @property
    def speed(self) -> FloatArray:
        """Mean speed (u1 + u2)/2 of the surfaces for each solution [m/s], shape (n,)."""
        return np.array([float(s.velocities[:, 0].mean()) for s in self.solutions])

    @property
    def boundary_share(self) -> FloatArray:
        """Share of the load that the boundary layer carries [-], shape (n,)."""
        return np.array([s.boundary_share for s in self.solutions])

    @property
    def share_error(self) -> FloatArray:
        """Estimated errors of `boundary_share` due to the grid [-], shape (n,).

        NaN for shares above 0.1 or below 0.001; see `FilmSolution`.
        """
        errors = (s.share_error for s in self.solutions)
        return np.array([math.nan if error is None else error for error in errors])

    @property
    def central_film(self) -> FloatArray:
        """Central film thicknesses [m], shape (n,)."""
        return np.array([s.central_film for s in self.solutions])

    @property
    def minimum_film(self) -> FloatArray:
        """Minimum film thicknesses [m], shape (n,)."""
        return np.array([s.minimum_film for s in self.solutions])


def stribeck(
    grid: Grid,
    body1: Body,
    body2: Body,
    gap: ArrayLike | Callable[[Grid], ArrayLike],
    *,
    load: float,
    speeds: Sequence[float],
    slide_to_roll: float = 0.0,
    lubricant: Lubricant,
    boundary: Boundary,
    order: int = 3,
    shear_thinning: bool = False,
    thermal: bool = False,
    tol: float = 1e-6,
    max_iterations: int = 40,
) -> StribeckCurve:
    """Solve a lubricated contact at several speeds, from the dry contact upwards.

    The solution at each speed starts from the solution at the previous speed. Additional speeds are
    solved below the first speed, and between speeds that are far apart.

    Parameters
    ----------
    grid, body1, body2, gap, load, lubricant, shear_thinning, thermal, tol, max_iterations
        As in `steady`.
    speeds : sequence of float
        Mean speeds (u1 + u2)/2 of the surfaces along x, increasing [m/s], > 0.
    slide_to_roll : float, optional
        Slide-to-roll ratio (u1 - u2)/((u1 + u2)/2) [-]. It affects the film only with
        `shear_thinning` or `thermal`. Default: 0.
    boundary : Boundary
        Boundary layer, which carries the load at low speeds.
    order : {1, 2, 3}, optional
        Order of the interpolation of the film thickness to the faces of the cells. It affects the
        load share of the boundary layer if this is below 0.1; `StribeckCurve.share_error` contains
        the estimated errors. Default: 3.

    Returns
    -------
    StribeckCurve

    Raises
    ------
    ValueError, TypeError
        As for `steady`, or if the speeds are not positive and increasing.
    ConvergenceError
        No convergence; its attribute `curve` contains the films at the preceding speeds, if any.
    """
    given = finite_array("speeds", speeds)
    if given.ndim != 1 or not given.size or given[0] <= 0 or np.any(np.diff(given) <= 0):
        raise ValueError(
            f"speeds must be positive and increasing [m/s], got {list(map(float, given.ravel()))}"
        )
    slip = finite("slide_to_roll", slide_to_roll)
    unit = 1.0 + 0.5 * slip, 1.0 - 0.5 * slip
    task = checked_task(
        grid, (body1, body2), gap, load, None, unit, 0.0, lubricant, None, boundary, order, tol,
        max_iterations,
    )  # fmt: skip
    task = with_shear(task, grid, shear_thinning, thermal)
    if task.boundary is None:
        raise ValueError("boundary is required: it carries the load that thin films cannot carry")
    mixed = MixedFilm(task, grid)
    solutions: list[FilmSolution] = []
    try:
        for speed in map(float, given):
            moving = mixed.task_at(speed)
            found, error = mixed.solved(speed, states_error=True)
            level = mixed.level(found)
            require_converged(found, moving)
            solution = solution_of(grid, mixed.gap, moving, found, [level])
            solutions.append(replace(solution, share_error=error))
            if thermal:
                check_heated(solutions[-1], mixed.dry.radius)
    except BaseException as error:  # Ctrl-C too
        if solutions:
            attach(error, curve=StribeckCurve(tuple(solutions), mixed.dry.pressure))
        raise
    return StribeckCurve(tuple(solutions), mixed.dry.pressure)
