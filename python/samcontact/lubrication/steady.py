# SPDX-License-Identifier: GPL-3.0-or-later
"""Steady lubricated contact of two bodies."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._core import ConvergenceError
from .._util.checks import (
    FloatArray,
    choice,
    exactly_one,
    finite,
    integer,
    number,
    positive,
    real_array,
    require_type,
)
from .._util.display import quantity
from .._util.errors import GridTooSmallWarning, ResolutionWarning, attach
from .._util.frozen import read_only
from .._util.short_text import in_short
from ..bodies.layered import Body, require_bodies
from ..bodies.viscoelastic import require_no_relaxation
from ..lubricants.lubricant import Lubricant
from ..problem.grid import Grid
from .balance import cells_per_radius, inlet_pressure
from .boundary import Boundary
from .film_accuracy import checked_accuracy, to_accuracy
from .film_limits import USUAL_REMEDY, remedy, require_thin_film
from .film_solution import FilmLevel, FilmNotResolvedError, FilmSolution
from .mixed import MixedFilm
from .nested import (
    DryContact,
    FilmTask,
    LevelSolver,
    dry_contact,
    refined,
    start_of,
    started,
    state_of,
    table_of,
)
from .share_error import warn_of_share
from .sheared import ShearedLevel, check_heated, sheared_from, with_shear

CELLS_PER_RADIUS = 12.0
"""Cells per contact radius below which a warning is issued."""
MAX_CHANGE = 0.05
"""Limit for a warning: relative change of the central film between the last two grids."""
STARVED_ITERATIONS = 120
"""Newton iterations allowed on each grid of a starved contact.

In each iteration, the edge of the filled inlet moves by about one cell."""
THICK = 20.0
"""Ratio of predicted film to layer thickness above which a full film is tried first."""
MAX_SHARE = 1e-3
"""Maximum load share of the boundary layer for which the full-film solution is accepted."""
MAX_EDGE_PRESSURE = 1e-3
"""Limit for a warning: pressure at the inlet edge divided by the maximum pressure."""


def steady(
    grid: Grid,
    body1: Body,
    body2: Body,
    gap: ArrayLike | Callable[[Grid], ArrayLike],
    *,
    load: float | None = None,
    approach: float | None = None,
    speed: Sequence[float | Sequence[float]],
    spin: float = 0.0,
    lubricant: Lubricant,
    supply: float | None = None,
    boundary: Boundary | None = None,
    order: int = 3,
    shear_thinning: bool = False,
    thermal: bool = False,
    accuracy: float | Mapping[str, float] | None = None,
    tol: float = 1e-6,
    max_iterations: int = 40,
) -> FilmSolution:
    """Solve a steady elastohydrodynamic contact: pressure, film and cavitation.

    The film obeys Reynolds' equation with mass-conserving cavitation; the bodies deform as in
    `ContactSolver`. The contact is solved by Newton's method on nested grids, starting from the dry
    contact on the coarsest grid.

    Parameters
    ----------
    grid : Grid
        Grid around the contact. It should extend from 2.5 contact radii before the contact centre
        (4.5 under light loads) to 1.5 radii behind it, and have 12 or more cells per radius. The
        grid of a line contact has one row of cells and `periodic="y"`.
    body1, body2 : Material or Layered
        Upper and lower body; plastic materials are treated as elastic.
    gap : array_like, shape (nx, ny), or callable
        Gap of the undeformed surfaces [m], or a function of a grid that returns this array.
    load : float
        Normal load [N], > 0.
    approach : float
        Rigid-body approach of the bodies [m]. Exactly one of load and approach must be given.
    speed : pair
        Velocities (u1, u2) of the surfaces along x, or ((u1, v1), (u2, v2)) along x and y, in the
        frame of the contact [m/s].
    spin : float, optional
        Mean angular velocity of the surfaces about the z axis through the centre of the grid
        [rad/s]. Default: 0.
    lubricant : Lubricant
    supply : float, optional
        Thickness of the film that arrives at the inlet [m]. Default: fully flooded.
    boundary : Boundary, optional
        Boundary layer, which carries load where the film is thin. Default: no layer (full film).
    order : {1, 2, 3}, optional
        Order of the interpolation of the film thickness to the faces of the cells, along the flow.
        Default: 3.
    shear_thinning : bool, optional
        Whether the law of `Lubricant.with_eyring` or `with_carreau` reduces the viscosity in the
        flow. By default, thinning and sliding do not change the film.
    thermal : bool, optional
        Whether shear and pressure flow heat the film and the surfaces and so reduce the viscosity.
        Requires thermal constants of the lubricant and of both bodies. The bodies and the inlet are
        at the temperature for which the viscosity is given.
    accuracy : float or dict, optional
        Largest estimated relative error of central and minimum film due to the grid [-], e.g. 0.01,
        or a dictionary of errors by name, e.g. {"central_film": 0.01}. The given grid is solved
        first; finer and larger grids follow until the accuracy is reached. The attribute `errors`
        of the result states the estimated errors. Requires a `gap` that is a function. Default:
        only the given grid is solved.
    tol : float, optional
        Largest residual of flow and load [-], in [1e-10, 1e-2].
    max_iterations : int, optional
        Maximum number of Newton iterations on each grid.

    Returns
    -------
    FilmSolution

    Raises
    ------
    ValueError, TypeError
        Invalid arguments, or a film that is not positive everywhere because the cells are too
        large.
    ConvergenceError
        No convergence; the attributes `iterations` and `residual` state how far it got.

    Warns
    -----
    ResolutionWarning
        Fewer than 12 cells per contact radius, a central film that changes by more than 5 % between
        the last two grids, or a load share of the boundary layer that is below 0.1 and has an
        estimated error of more than 10 % of its value.
    GridTooSmallWarning
        Noticeable pressure at an edge of the grid through which lubricant enters.
    AccuracyWarning
        An accuracy that needs more than 420 x 420 cells (16384 in a line contact); the result
        states the errors reached.
    UserWarning
        A heated film so thick or fast that convection along it exceeds conduction across it.

    Notes
    -----
    Cavitation: Elrod (1981), doi:10.1115/1.3251669. The pressure spike at the outlet converges
    slowly with decreasing cell size. See docs/theory/lubrication.md.
    """
    task = checked_task(
        grid, (body1, body2), gap, load, approach, speed, spin, lubricant, supply, boundary, order,
        tol, max_iterations,
    )  # fmt: skip
    task = with_shear(task, grid, shear_thinning, thermal)
    if accuracy is not None:
        targets = checked_accuracy(accuracy, task)
        return to_accuracy(task, grid, targets, lambda task, grid: _checked(task, grid)[0])
    solution, dry = _checked(task, grid, states_error=True)
    _warn_of_grid(solution, dry)
    warn_of_share(solution, task)
    return solution


def _checked(
    task: FilmTask, grid: Grid, states_error: bool = False
) -> tuple[FilmSolution, DryContact]:
    """Return the solution and the dry contact, after checking the solution of a heated film."""
    solution, dry, _ = solved_from_dry(task, grid, states_error)
    if task.thermal:
        check_heated(solution, dry.radius)
    return solution, dry


Found = tuple[FilmSolution, DryContact, Any]
"""Solution, the dry contact from which it started, and the result of the compiled core."""


def solved_from_dry(task: FilmTask, grid: Grid, states_error: bool = False) -> Found:
    """Return the solution with or without a boundary layer, starting from the dry contact.

    states_error: whether to estimate the error of a small share of the boundary layer.
    """
    if task.boundary is None:
        return _full_film(task, grid)
    return _mixed_film(task, grid, states_error)


def _full_film(task: FilmTask, grid: Grid) -> Found:
    """Return the solution on nested grids, starting from a full film."""
    grids, dry = started(task, grid)
    require_thin_film(task, dry)
    table = table_of(task.lubricant, dry.peak)
    layer = task.layer(dry.peak)
    levels: list[FilmLevel] = []
    found: Any = None
    for n, cells in enumerate(grids):
        gap = task.gap_on(cells, grid)
        if found is not None and found["converged"]:
            state = refined(found, cells.surface_shape)
        else:  # a state that has not converged misleads the next grid
            state = start_of(task, cells, gap, dry if n == 0 else dry_contact(task, cells, gap))
        solver = LevelSolver(task, cells, gap, table)
        if math.isfinite(task.supply):
            allowed = max(task.max_iterations, STARVED_ITERATIONS)
            solver.task = replace(task, max_iterations=allowed)
        is_near = task.is_sheared and found is not None and found["converged"]
        found = sheared_from(solver, state, layer) if is_near else None
        if found is None or not found["converged"]:
            found = _solved(solver, state, layer)
            if task.is_sheared and found["converged"]:
                found = ShearedLevel(solver).solve(found, layer)
        levels.append(solver.level(found))
    require_converged(found, task, remedy(task, dry, grid))
    return solution_of(grid, gap, task, found, levels), dry, found


def _mixed_film(task: FilmTask, grid: Grid, states_error: bool) -> Found:
    """Return the solution with a boundary layer, starting from a full film or the dry contact."""
    assert task.boundary is not None
    mixed = MixedFilm(task, grid)
    require_thin_film(task, mixed.dry)
    if mixed.dry.film > THICK * task.boundary.thickness:
        try:
            thick = _full_film(task, grid)
        except (ValueError, RuntimeError):
            pass  # a rough surface may touch
        else:
            if thick[0].boundary_share < MAX_SHARE:
                return thick
    found, error = mixed.solved(1.0, states_error)
    require_converged(found, task, remedy(task, mixed.dry, grid))
    solution = solution_of(grid, mixed.gap, task, found, [mixed.level(found)])
    return replace(solution, share_error=error), mixed.dry, found


def checked_task(
    grid: Grid, bodies: tuple[Body, Body], gap: Any, load: float | None, approach: float | None,
    speed: Any, spin: float, lubricant: Lubricant, supply: float | None,
    boundary: Boundary | None, order: int, tol: float, max_iterations: int,
) -> FilmTask:  # fmt: skip
    """Return the task that the arguments of `steady` describe, after checking them."""
    require_type("grid", grid, Grid)
    require_bodies(*bodies)
    require_type("lubricant", lubricant, Lubricant)
    if boundary is not None:
        require_type("boundary", boundary, Boundary)
    require_no_relaxation("films between viscoelastic bodies are not supported", *bodies)
    if "x" in grid.periodic:
        raise ValueError(
            f"grid must not be periodic along x, got periodic = {grid.periodic!r}: lubricant "
            "enters and leaves at the ends of the grid along x"
        )
    if grid.ny == 1 and not grid.periodic:
        raise ValueError('grid with one row of cells must have periodic = "y" (a line contact)')
    name = exactly_one(load=load, approach=approach)
    target = positive("load", load) if load is not None else number("approach", approach)
    velocities = velocities_of(speed)
    if grid.ny == 1 and velocities[:, 1].any():
        raise ValueError(f"speed along y must be 0 for a line contact, got {in_short(speed)}")
    spin = finite("spin", spin)
    if not velocities.mean(axis=0).any() and spin == 0:
        raise ValueError(
            "the mean speed of the surfaces or the spin must differ from 0, got speed = "
            f"{in_short(speed)}: otherwise no lubricant is drawn into the contact"
        )
    tol = positive("tol", tol)
    if not 1e-10 <= tol <= 1e-2:
        raise ValueError(f"tol must be in [1e-10, 1e-2], got {tol!r}")
    return FilmTask(
        bodies, gap, name == "load", target, velocities, spin, lubricant,
        math.inf if supply is None else positive("supply", supply), boundary,
        choice("order", order, (1, 2, 3)), tol, integer("max_iterations", max_iterations, 1),
    )  # fmt: skip


def velocities_of(speed: Any) -> FloatArray:
    """Return the velocities of bodies 1 and 2 along x and y [m/s], shape (2, 2)."""
    given = real_array("speed", speed)
    if given.shape == (2,):
        given = np.stack([given, np.zeros(2)], axis=1)
    if given.shape != (2, 2) or not np.isfinite(given).all():
        raise ValueError(
            "speed must be (u1, u2) along x, or ((u1, v1), (u2, v2)) along x and y, all finite "
            f"[m/s], got {in_short(speed)}"
        )
    return given


def _solved(solver: LevelSolver, start: dict[str, Any], layer: tuple[float, float]) -> Any:
    """Return the solution on a grid; if it fails, retry from a solution with `order` 1."""
    found = solver.solve(start, layer, solver.task.order)
    if found["converged"] or solver.task.order == 1:
        return found
    first = solver.solve(start, layer, 1)
    if not first["converged"]:
        return found
    return solver.solve(state_of(first), layer, solver.task.order)


def require_converged(
    found: Any,
    task: FilmTask,
    advice: str = USUAL_REMEDY,
) -> None:
    """Raise an error for a state that has not converged or is physically impossible."""
    target = quantity(task.target, "N" if task.is_load else "m")
    if not found["converged"]:
        error = ConvergenceError(
            f"film at {'load' if task.is_load else 'approach'} {target} did not converge: residual "
            f"{found['error']:.3g} after {found['iterations']} iterations, tol {task.tol:g}: "
            + advice
        )
        attach(error, iterations=found["iterations"], residual=found["error"])
        raise error
    lowest = float(found["film"].min())
    if not lowest > 0:
        raise FilmNotResolvedError(
            f"film must be > 0 everywhere, got {lowest:.3g} m: the cells are too large for this "
            "film; use smaller cells, or a boundary layer for surfaces that touch"
        )


def solution_of(
    grid: Grid, gap: FloatArray, task: FilmTask, found: Any, levels: list[FilmLevel]
) -> FilmSolution:
    fluid, layer, film = (
        read_only(found[name]) for name in ("fluid_pressure", "boundary_pressure", "film")
    )
    return FilmSolution(
        grid=grid, lubricant=task.lubricant, velocities=read_only(task.velocities), gap=gap,
        filling=read_only(1.0 - found["void_fraction"]), approach=found["approach"],
        load=found["load"], residual=found["error"], levels=tuple(levels),
        boundary=task.boundary, spin=task.spin, bodies=task.bodies,
        fluid_pressure=fluid, boundary_pressure=layer, film=film, order=task.order,
        supply=task.supply, shear_thinning=task.thins, heat=found.get("heat"),
    )  # fmt: skip


def _warn_of_grid(solution: FilmSolution, dry: DryContact) -> None:
    """Warn if the cells are too large, or if the grid is too short at the inlet."""
    films = [level.central_film for level in solution.levels[-2:]]
    cells = cells_per_radius(dry.pressure, solution.grid)
    if cells < CELLS_PER_RADIUS:
        warnings.warn(
            f"the film is resolved by {cells:.3g} cells per contact radius (at least "
            f"{CELLS_PER_RADIUS:g} recommended): use smaller cells",
            ResolutionWarning,
            stacklevel=3,
        )
    elif len(films) == 2 and abs(films[1] - films[0]) > MAX_CHANGE * abs(films[1]):
        warnings.warn(
            f"the central film changes from {quantity(films[0], 'm')} to {quantity(films[1], 'm')} "
            "between the last two grids: use smaller cells",
            ResolutionWarning,
            stacklevel=3,
        )
    if (share := inlet_pressure(solution)) > MAX_EDGE_PRESSURE:
        warnings.warn(
            f"the pressure at the inlet edge of the grid is {share:.2g} times the maximum (at most "
            f"{MAX_EDGE_PRESSURE:g} times expected): enlarge the grid towards the inlet",
            GridTooSmallWarning,
            stacklevel=3,
        )


__all__ = ["steady"]
