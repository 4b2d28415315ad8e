# SPDX-License-Identifier: GPL-3.0-or-later
"""Increments of elastic-plastic bodies under a lubricant film."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from .._core import ConvergenceError
from .._util.checks import FloatArray, positive, require_type
from .._util.display import ShortRepr
from .._util.lazy_scipy import scipy
from ..lubricants.lubricant import Lubricant
from ..problem.friction import friction_law
from ..problem.heating import NO_HEAT
from ..simulation.simulation import Simulation
from ..solutions.state import State
from .boundary import Boundary
from .film_solution import FilmSolution
from .nested import FilmTask, LevelSolver, state_of, table_of
from .sheared import check_heated, sheared_from, with_shear
from .steady import checked_task, require_converged, solution_of, solved_from_dry

DEPTH = 5
"""Number of earlier solutions that Anderson's acceleration uses."""
MAX_EVALUATIONS = 40
"""Maximum number of solutions of film and plastic flow in an increment."""


@dataclass(frozen=True, repr=False, eq=False)
class FilmIncrement(ShortRepr):
    """Increment of a simulation under a film, from `press`.

    Attributes
    ----------
    film : FilmSolution
        Film at the end of the increment.
    state : State
        State of the bodies under the pressure of the film.
    evaluations : int
        Number of solutions of film and plastic flow.
    """

    film: FilmSolution
    state: State
    evaluations: int


def press(
    simulation: Simulation,
    *,
    load: float,
    speed: Sequence[float | Sequence[float]],
    lubricant: Lubricant,
    boundary: Boundary | None = None,
    order: int = 3,
    shear_thinning: bool = False,
    thermal: bool = False,
    tol: float = 1e-4,
    max_iterations: int = 40,
) -> FilmIncrement:
    """Advance a simulation by an increment in which a steady film carries the load.

    The film replaces the dry contact. The pressure of the film causes plastic flow, and the
    residual displacement of the surfaces changes the gap of the film. Film and plastic flow are
    solved in turn until they are consistent. Afterwards the simulation is in the new state; a step
    with zero load then gives the residual imprint.

    Parameters
    ----------
    simulation : Simulation
        Simulation of the bodies, in any state. It must not have friction, heat, adhesion or moving
        topography.
    load : float
        Normal load [N], > 0.
    speed, lubricant, boundary, order, shear_thinning, thermal, max_iterations
        As in `steady`. The heat of the film changes its viscosity only: it causes no stress in the
        bodies and does not soften them.
    tol : float, optional
        Largest change of the residual displacement in the last evaluation [-], divided by the
        approach of a Hertz contact with the load and the maximum pressure of the film. Default:
        1e-4.

    Returns
    -------
    FilmIncrement

    Raises
    ------
    ValueError, TypeError
        Invalid arguments, or a simulation with friction, heat, adhesion or moving topography.
    ConvergenceError
        No convergence of the film, or of film and plastic flow. The simulation keeps its previous
        state.
    """
    require_type("simulation", simulation, Simulation)
    _require_film_alone(simulation)
    tol = positive("tol", tol)
    task = checked_task(
        simulation.grid, (simulation.body1, simulation.body2), simulation.initial_gap, load, None,
        speed, 0.0, lubricant, None, boundary, order, min(1e-6, 0.1 * tol), max_iterations,
    )  # fmt: skip
    task = with_shear(task, simulation.grid, shear_thinning, thermal)
    if task.thermal and any(body.softening for body in task.bodies):
        raise ValueError(
            "with thermal = True, the bodies of simulation must not have thermal softening, "
            "because the heat of the film reduces the viscosity only: omit with_softening, or use "
            "thermal = False"
        )
    coupling = _Coupling(simulation, task)
    before = simulation.state
    try:
        coupling.solve(tol)
    except BaseException:
        simulation.engine.stand_at(before)
        raise
    assert coupling.film is not None
    if task.thermal:
        check_heated(coupling.film, coupling.radius)
    return FilmIncrement(coupling.film, simulation.state, coupling.evaluations)


def _require_film_alone(simulation: Simulation) -> None:
    """Raise ValueError if a simulation has features that cannot be combined with a film.

    These features are moving topography, friction, heat and adhesion.
    """
    setup = simulation.engine.setup
    if simulation.relief1 is not None or simulation.relief2 is not None:
        raise ValueError(
            "simulation must not have relief1 or relief2 under a film, got a relief: subtract its "
            "heights from the gap"
        )
    if setup.friction != friction_law(0.0):
        raise ValueError(
            f"simulation must not have friction under a film, got {setup.friction!r}: omit it, and "
            "find the friction of the film by lubrication.friction"
        )
    if simulation.heat != NO_HEAT:
        raise ValueError(
            "simulation must not have heat under a film, got frictional heating: omit heat, and "
            "use thermal = True to heat the film"
        )
    if setup.adhesion.attracts:
        raise ValueError(
            f"simulation must not have adhesion under a film, got {setup.adhesion!r}: omit adhesion"
        )


class _Coupling:
    """Iteration between film and plastic flow for the residual displacement of one increment."""

    def __init__(self, simulation: Simulation, task: FilmTask) -> None:
        self._simulation, self._task = simulation, task
        self._gap: FloatArray = simulation.initial_gap
        self._start = simulation.state
        self.film: FilmSolution | None = None
        self.evaluations = 0
        self._found: Any = None
        self._layer = 0.0, 0.0
        self._table: Any = None

    def solve(self, tol: float) -> None:
        """Iterate until the residual displacement changes by less than `tol`."""
        # The pressure of the film is close to that of the dry contact.
        first = _residual(self._simulation.step(load=self._task.target))
        change = self._change(first)
        size = self._size()
        if np.abs(change).max() <= tol * size:
            return
        try:
            scipy.optimize.anderson(
                lambda x: self._change(x * size) / size, (first + change) / size, alpha=1.0,
                M=DEPTH, f_tol=tol, maxiter=MAX_EVALUATIONS, line_search=None,
            )  # fmt: skip
        except scipy.optimize.NoConvergence:
            raise ConvergenceError(
                f"film and plastic flow did not converge at load {self._task.target:g} N after "
                f"{self.evaluations} solutions: use smaller increments of the load"
            ) from None

    @property
    def radius(self) -> float:
        """Radius of a Hertz contact with the load and the largest pressure of the film [m]."""
        assert self.film is not None
        return math.sqrt(1.5 * self.film.load / (math.pi * float(self.film.pressure.max())))

    def _size(self) -> float:
        """Approach of a Hertz contact with the load and the largest pressure of the film [m]."""
        assert self.film is not None
        radius = self.radius
        gap = self.film.gap - self.film.gap.min()
        grid = self.film.grid
        near = np.abs(gap)[np.hypot(grid.x[:, None], grid.y[None, :]) <= 1.01 * radius + grid.dx]
        return max(2.0 * float(near.max()), 1e-12)

    def _change(self, residual: FloatArray) -> FloatArray:
        """Return the residual displacement that a film causes, minus the assumed one [m].

        residual: assumed residual displacement [m], which is added to the gap of the film.
        """
        self.evaluations += 1
        gap = self._gap + residual
        self.film = self._film(gap)
        engine = self._simulation.engine
        engine.stand_at(self._start)
        state = self._simulation.step(pressure=self.film.pressure)
        return _residual(state) - residual

    def _film(self, gap: FloatArray) -> FilmSolution:
        task = replace(self._task, gap=gap)
        grid = self._simulation.grid
        if self._found is None:
            film, dry, self._found = solved_from_dry(task, grid)
            self._layer, self._table = task.layer(dry.peak), table_of(task.lubricant, dry.peak)
            return film
        solver = LevelSolver(task, grid, gap, self._table)
        state = state_of(self._found)
        if task.is_sheared:
            self._found = sheared_from(solver, state, self._layer)
        else:
            self._found = solver.solve(state, self._layer, task.order)
        require_converged(self._found, task)
        return solution_of(grid, gap, task, self._found, [solver.level(self._found)])


def _residual(state: State) -> FloatArray:
    """Sum of the residual displacements of both bodies, which opens the gap [m], shape (nx, ny)."""
    total: FloatArray = np.zeros(state.grid.surface_shape)
    for body, material in enumerate(state.setup.bodies, 1):
        if material.is_plastic:
            total = total + state.residual_displacement(body)
    return total
