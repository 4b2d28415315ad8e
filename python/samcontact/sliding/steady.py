# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact in steady sliding at one velocity."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, exactly_one, require_type
from .._util.frozen import read_only
from ..bodies.layered import Body
from ..bodies.viscoelastic import relaxes
from ..contact.moving import MovingContactSolver, pressure_of, require_moving, speed_of
from ..contact.normal_drive import NormalDrive
from ..contact.solver import solve_driven
from ..contact.tangential_drive import UNSHEARED
from ..problem.grid import Grid
from ..problem.settings import ContactSettings
from ..solutions.moving_solution import SlidingSolution, slope_along_x

_AT_REST = (
    "body 1 is viscoelastic and rests in the contact: the result uses its long-time modulus, and "
    "the energy lost is that of body 2 alone; if the gap is fixed to body 2, exchange the bodies"
)


def steady(
    grid: Grid,
    body1: Body,
    body2: Body,
    gap: ArrayLike | Callable[[Grid], ArrayLike],
    *,
    load: float | None = None,
    approach: float | None = None,
    velocity: float,
    start: SlidingSolution | None = None,
    tol: float = ContactSettings.tol,
    on_border: str = ContactSettings.on_border,
    max_iterations: int = ContactSettings.max_iterations,
) -> SlidingSolution:
    """Solve the contact of body 1 sliding steadily over body 2 without adhesion or shear.

    The gap is fixed to body 1, whose roughness slides over the smooth surface of body 2. The
    material of a viscoelastic body 2 moves through the contact; a viscoelastic body 1 rests in the
    contact and has its long-time modulus (a warning is issued). The energy lost in body 2 causes
    the hysteretic part of friction. A shear stress at the interface would add to this friction.

    Parameters
    ----------
    grid : Grid
        Grid of any periodicity. `periodic="y"` with one row of cells is plane strain.
    body1, body2 : Material or Layered
        Upper and lower body; at most one is rigid. Plastic materials are treated as elastic.
    gap : array_like, shape (nx, ny), or callable
        Initial separation [m], or a function of a grid that returns this array, as in
        `ContactSolver`.
    load : float
        Normal load [N], >= 0.
    approach : float
        Rigid-body approach [m]. Exactly one of load and approach must be given.
    velocity : float
        Velocity of body 1 relative to body 2 along x [m/s]; negative: towards -x. At 0, both bodies
        have their long-time moduli.
    start : SlidingSolution, optional
        Solution on the same grid for a similar velocity or load, used as initial guess. Without it,
        a solution that does not converge is continued from solutions at higher velocities.
    tol, on_border, max_iterations
        As in `ContactSolver`.

    Returns
    -------
    SlidingSolution

    Raises
    ------
    ValueError, TypeError
        Invalid arguments; a viscoelastic fluid or free faces; GridTooSmallError if the
        contact reaches the edge of the grid.
    ConvergenceError
        No convergence, e.g. of white-noise roughness at low velocities on a body that relaxes to
        less than 0.1 % of its modulus; the error has the attributes `iterations` and `residual`.

    Notes
    -----
    The steady displacement is the elastic displacement due to an equivalent pressure, which depends
    on the pressure that each material point has passed through since it entered the contact. The
    whole track behind the contact is included. Persson (2001), J. Chem. Phys. 115, 3840, estimates
    this friction for randomly rough surfaces.
    """
    require_type("grid", grid, Grid)
    bodies = require_moving(body1, body2)
    moves = speed_of("velocity", velocity)
    name = exactly_one(load=load, approach=approach)
    normal = NormalDrive.of(name, load if approach is None else approach)
    if moves and relaxes(body1):
        warnings.warn(_AT_REST, stacklevel=2)

    def finish(cells: Grid, displaced: FloatArray, found: dict[str, Any]) -> SlidingSolution:
        return _solution(cells, displaced, moves, found)

    solver = MovingContactSolver(
        grid,
        bodies,
        (0.0, -moves),
        finish,
        tol=tol,
        on_border=on_border,
        max_iterations=max_iterations,
    )
    pressure = None if start is None else pressure_of(start, SlidingSolution)
    solution = solve_driven(solver, gap, normal, UNSHEARED, pressure)
    assert isinstance(solution, SlidingSolution)
    return solution


def _solution(
    grid: Grid, displaced: FloatArray, velocity: float, found: dict[str, Any]
) -> SlidingSolution:
    slope = slope_along_x(grid, displaced)
    force = -float(np.sum(found["pressure"] * slope)) * grid.cell_area
    return SlidingSolution(
        grid=grid,
        velocity=velocity,
        tangential_load=read_only(np.array([force, 0.0])),
        **found,
    )
