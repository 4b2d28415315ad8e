# SPDX-License-Identifier: GPL-3.0-or-later
"""Films whose viscosity depends on the shear stress and the temperature, by outer iterations."""

from __future__ import annotations

import warnings
from dataclasses import replace
from typing import Any

import numpy as np

from .._core import ConvergenceError
from .._util.checks import FloatArray
from .._util.lazy_scipy import scipy
from .._util.short_text import in_short
from ..bodies.material import Material
from ..lubricants.shear import Newtonian
from ..problem.grid import Grid
from .film_heat import Conduction, FilmHeat
from .film_solution import FilmSolution
from .friction import friction
from .nested import FilmTask, LevelSolver, state_of
from .pressure_flow import PressureFlow, Sheared, flow_power, pressure_flow
from .surface_heat import HeatedSurfaces

COUNTS = "iterations", "krylov_steps", "operator_applications"
"""Counts of a solution that are summed over all outer iterations."""
MAX_OUTER = 60
"""Maximum number of outer iterations, in each of which the coefficients of the flow are fixed."""
MAX_CARRIED_HEAT = 1.0
"""Limit for a warning: ratio of convected to conducted heat of the film."""
MIN_FILM = 1e-12
"""Smallest film thickness for which the flow is computed [m]; an iterate may be thinner."""
HEAT_TOL = 1e-7
"""Tolerance of the iteration for the surface temperatures, relative to the maximum rise."""
DEPTH = 6
"""Number of earlier iterates in Anderson's acceleration."""
MAX_HEAT_STEPS = 100


class ShearedLevel:
    """Solver for the film on one grid with shear thinning and heating.

    more: arguments of each solution, e.g. the time step and earlier contents of a transient film.
    """

    def __init__(self, solver: LevelSolver, **more: Any) -> None:
        self._solver, self._more = solver, more
        task = solver.task
        self._surfaces: HeatedSurfaces | None = None
        if task.thermal:
            self._surfaces = HeatedSurfaces(solver.grid, task.bodies, task.velocities)
        self.heat: FilmHeat | None = None
        self._flow: PressureFlow | None = None

    def solve(self, found: Any, layer: tuple[float, float]) -> Any:
        """Solve for flow and heat, starting from a state of the film.

        The coefficients of the flow and the film are updated in turn, until the film needs no
        iteration with new coefficients.
        """
        task, counts = self._solver.task, dict.fromkeys(COUNTS, 0)
        for _ in range(MAX_OUTER):
            flow = list(self.flow(found))
            found = self._solver.solve(
                state_of(found), layer, task.order, pressure_flow=flow, **self._more
            )
            counts = {name: counts[name] + found[name] for name in COUNTS}
            if not found["converged"] or found["iterations"] == 0:
                break
        agrees = found["converged"] and found["iterations"] == 0
        return found | counts | {"heat": self.heat, "converged": agrees}

    def flow(self, found: Any) -> PressureFlow:
        """Return the coefficients of the pressure flow at a state of the film."""
        task, film = self._solver.task, np.maximum(found["film"], MIN_FILM)
        pressure = np.maximum(found["fluid_pressure"], 0.0)
        sliding = task.velocities[0] - task.velocities[1]
        sheared = Sheared(
            self._solver.grid, task.lubricant, sliding, pressure, film, None, task.thins
        )
        if task.thermal:
            self._warm(found, sheared)
        flow = pressure_flow(replace(sheared, heat=self.heat))
        self._flow = PressureFlow(*map(np.ascontiguousarray, flow))
        return self._flow

    def _warm(self, found: Any, sheared: Sheared) -> None:
        """Compute the temperatures of a film with fixed pressure and thickness."""
        task, grid = self._solver.task, self._solver.grid
        assert self._surfaces is not None
        assert task.lubricant.heat is not None
        surfaces, constants = self._surfaces, task.lubricant.heat
        power, speed = flow_power(sheared, self._flow), float(np.hypot(*sheared.sliding))
        film, filling = sheared.film, 1.0 - found["void_fraction"]
        conduction = Conduction(task.lubricant, sheared.pressure, film, filling, speed, power)
        friction = 0.0 if task.boundary is None else task.boundary.friction
        boundary = friction * speed * found["boundary_pressure"]
        latest: list[Any] = []

        def rises(walls: FloatArray) -> FloatArray:
            depth = conduction.depth(walls)
            heat = conduction.shear(walls, depth) * speed + power + boundary
            latest[:] = [depth, *surfaces.fluxes(heat, film / constants.conductivity)]
            mean: FloatArray = latest[2].mean(axis=0)
            return mean

        start = np.zeros_like(film) if self.heat is None else self.heat.wall_rise
        walls = _fixed_point(rises, start)
        depth, flux, rise = latest
        self.heat = FilmHeat(
            constants, rise, flux, depth, conduction.middle_rise(walls, depth), grid.cell_area
        )


def sheared_from(
    solver: LevelSolver, state: dict[str, Any], layer: tuple[float, float], **more: Any
) -> Any:
    """Solve with shear thinning and heat, starting from a state, e.g. of a coarser grid.

    more: as for `ShearedLevel`.
    """
    task = solver.task
    solver.task = replace(task, max_iterations=0)
    begun = solver.solve(state, layer, task.order, **more)  # the film that belongs to the state
    solver.task = task
    return ShearedLevel(solver, **more).solve(begun, layer)


def with_shear(task: FilmTask, grid: Grid, thins: bool, thermal: bool) -> FilmTask:
    """Return a task with shear thinning or heating switched on, if its data allow this."""
    for name, given in (("shear_thinning", thins), ("thermal", thermal)):
        if not isinstance(given, bool):
            raise TypeError(f"{name} must be True or False, got {in_short(given)}")
    if thins and task.lubricant.thinning == Newtonian():
        raise ValueError(
            "with shear_thinning = True, lubricant must have a law of shear thinning, got none (a "
            "limiting shear stress is no such law, it changes the friction only): use "
            "Lubricant.with_eyring or with_carreau"
        )
    if thermal:
        _require_heat(task, grid)
    return replace(task, thins=thins, thermal=thermal)


def _require_heat(task: FilmTask, grid: Grid) -> None:
    """Raise ValueError or TypeError unless lubricant, grid and bodies allow heating."""
    if task.lubricant.heat is None:
        raise ValueError(
            "with thermal = True, lubricant must have thermal constants, got none: use "
            "Lubricant.with_thermal"
        )
    if grid.along_y and grid.ny > 1:
        raise ValueError(
            "with thermal = True, a grid that is periodic along y must have ny = 1, got ny = "
            f"{grid.ny}: use one row of cells (a line contact), or a grid that is not periodic"
        )
    for number, (body, speed) in enumerate(zip(task.bodies, task.velocities, strict=True), 1):
        if not isinstance(body, Material):
            raise TypeError(
                f"with thermal = True, body{number} must be a Material, got {type(body).__name__}"
            )
        if body.is_rigid or body.thermal is None:
            raise ValueError(
                f"with thermal = True, body{number} must have thermal constants, got none: use "
                "Material.with_thermal"
            )
        if grid.ny == 1 and speed[0] == 0.0:
            raise ValueError(
                f"with thermal = True, the speed of body{number} in a line contact must differ "
                "from 0, got 0: the steady temperature of a body at rest under a line source is "
                "infinite"
            )


def check_heated(film: FilmSolution, radius: float) -> None:
    """Check the friction and the convected heat of a heated film.

    Raises ValueError where `friction` does. Warns if more heat is convected along the film than
    conducted across it. radius: contact radius, or half-width of a line contact [m].
    """
    friction(film)  # refuses that of a Newtonian oil that no oil can transmit
    assert film.heat is not None
    speed = float(np.hypot(*film.velocities.mean(axis=0)))
    constants = film.heat.constants
    carried = speed * constants.capacity * film.central_film**2 / (constants.conductivity * radius)
    if carried > MAX_CARRIED_HEAT:
        warnings.warn(
            f"the flow along the film carries {carried:.2g} times the heat that is conducted "
            f"across the film (at most {MAX_CARRIED_HEAT:g} expected): the computed temperature "
            "of the film is too high, because it neglects the heat that the flow carries",
            UserWarning,
            stacklevel=3,
        )


def _fixed_point(function: Any, start: FloatArray) -> FloatArray:
    """Return the solution of x = function(x) by Anderson acceleration.

    The last call of `function` is at the solution.
    """
    first = function(start)
    size = max(float(np.abs(first).max()), 1e-12)
    if np.abs(first - start).max() <= HEAT_TOL * size:
        return start
    try:
        found: FloatArray = size * scipy.optimize.anderson(
            lambda x: function(size * x) / size - x, start / size, alpha=0.5, M=DEPTH,
            f_tol=HEAT_TOL, maxiter=MAX_HEAT_STEPS, line_search=None,
        )  # fmt: skip
    except scipy.optimize.NoConvergence:
        raise ConvergenceError(
            "temperature of the film did not converge: use a smaller sliding speed, or a lubricant "
            "with a limiting shear stress (with_limiting_shear)"
        ) from None
    function(found)
    return found
