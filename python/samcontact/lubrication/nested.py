# SPDX-License-Identifier: GPL-3.0-or-later
"""Solution of a lubricated contact on nested grids, starting from the dry contact."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .. import _core, hertz
from .._util.checks import FloatArray, finite_array
from .._util.lazy_scipy import scipy
from ..bodies.layered import Body, softest
from ..contact.solver import ContactSolver
from ..lubricants.lubricant import Lubricant
from ..problem.grid import Grid
from .boundary import Boundary
from .film_solution import FilmLevel, film_at_centre
from .formulas import dowson_higginson_of, line_limits, nijenbanning
from .groups import film_groups

COARSEST_SIDE = 24
"""Smallest number of cells along x of a coarser grid."""
COARSE_CELLS, COARSE_CELLS_OF_LINE = 5.0, 10.0
"""Smallest number of cells per contact radius, or half-width of a line contact, on a coarser
grid."""
TABLE_RANGE = 10.0
"""Largest pressure in the lubricant tables, relative to the maximum pressure of the dry contact."""
MIN_TABLE_PRESSURE = 1e8
"""Lower limit of the largest pressure in the lubricant tables [Pa]."""
MIN_FILM_SHARE = 1e-9
"""Smallest film thickness with which flow is computed, divided by the range of the gap."""
_GHOST_CELLS = 3  # beyond the edges of a field that is resampled
_FILMS_OF_SUPPLY = 9.0  # film of a starved contact that is not filled at the start, in supplies
_ENTERING_VOID = 1e-6
"""Minimum initial void fraction of a cell that is cavitated on the coarser grid."""


def face_velocities(
    grid: Grid, velocities: FloatArray, spin: float
) -> tuple[FloatArray, FloatArray]:
    """Return the mean surface velocities through the cell faces along x and along y [m/s].

    velocities: of bodies 1 and 2 along x and y [m/s]; spin: mean angular velocity of the surfaces
    about z [rad/s].
    """
    u, v = velocities.mean(axis=0)
    nx, ny = grid.surface_shape
    y = (np.arange(ny) - 0.5 * (ny - 1)) * grid.dy
    x = (np.arange(nx) - 0.5 * (nx - 1)) * grid.dx
    along_x = np.broadcast_to(u - spin * y, (nx + 1, ny))
    along_y = np.broadcast_to((v + spin * x)[:, None], (nx, ny + 1))
    return np.ascontiguousarray(along_x), np.ascontiguousarray(along_y)


@dataclass(frozen=True)
class FilmTask:
    """Lubricated contact that is solved on several grids."""

    bodies: tuple[Body, Body]
    gap: ArrayLike | Callable[[Grid], ArrayLike]
    is_load: bool
    target: float
    """Load [N] or approach [m]."""
    velocities: FloatArray
    """Velocities of bodies 1 and 2 along x and y [m/s]."""
    spin: float
    lubricant: Lubricant
    supply: float
    boundary: Boundary | None
    order: int
    tol: float
    max_iterations: int
    thins: bool = False
    """Whether the shear stress reduces the viscosity in the flow."""
    thermal: bool = False
    """Whether the film is heated."""

    @property
    def is_sheared(self) -> bool:
        """Whether the viscosity also depends on the shear stress or the temperature."""
        return self.thins or self.thermal

    def gap_on(self, grid: Grid, finest: Grid) -> FloatArray:
        """Return the gap [m] on `grid`, which covers the same area as the grid `finest`."""
        if callable(self.gap):
            return finite_array("gap", self.gap(grid), grid.surface_shape)
        given = finite_array("gap", self.gap, finest.surface_shape)
        return given if grid == finest else resampled(given, grid.surface_shape, order=1)

    def face_velocities(self, grid: Grid) -> tuple[FloatArray, FloatArray]:
        """Return the mean surface velocities through the cell faces along x and along y [m/s]."""
        return face_velocities(grid, self.velocities, self.spin)

    def layer(self, peak: float) -> tuple[float, float]:
        """Return thickness [m] and pressure [Pa] of the boundary layer; (0, 0) without a layer.

        peak: largest pressure of the dry contact [Pa].
        """
        if self.boundary is None:
            return 0.0, 0.0
        pressure = self.boundary.pressure
        return self.boundary.thickness, peak if pressure is None else pressure

    @property
    def entrainment(self) -> float:
        """Magnitude of the mean velocity of the surfaces [m/s]."""
        return float(np.hypot(*self.velocities.mean(axis=0)))


@dataclass(frozen=True)
class DryContact:
    """Dry contact of the bodies of a `FilmTask`, from which the solution of the film starts."""

    pressure: FloatArray
    approach: float
    load: float
    radius: float
    """Radius (half-width of a line) of the Hertz contact with this load and peak pressure [m]."""
    gap_radius: float
    """Reduced radius of curvature of the gap of this Hertz contact [m]."""
    film: float
    """Central film that a formula predicts [m]."""

    @property
    def peak(self) -> float:
        """Largest pressure [Pa]."""
        return float(self.pressure.max())


def grids_up_to(finest: Grid) -> list[Grid]:
    """Return the nested grids, from the coarsest to the given one."""
    grids = [finest]
    while (nx := grids[0].nx // 2) >= COARSEST_SIDE:
        last = grids[0]
        ny = last.ny if last.ny == 1 else last.ny // 2
        if ny < 1 or (last.periodic and ny > 1 and ny % 2):
            break
        dx, dy = finest.nx * finest.dx / nx, finest.ny * finest.dy / ny
        grids.insert(0, replace(finest, nx=nx, ny=ny, dx=dx, dy=dy))
    return grids


def started(task: FilmTask, finest: Grid) -> tuple[list[Grid], DryContact]:
    """Return the nested grids that resolve the contact, and the dry contact on the first grid."""
    grids = grids_up_to(finest)
    while True:
        dry = dry_contact(task, grids[0], task.gap_on(grids[0], finest))
        needed = COARSE_CELLS_OF_LINE if grids[0].ny == 1 else COARSE_CELLS
        if len(grids) == 1 or dry.radius >= needed * grids[0].dx:
            return grids, dry
        del grids[0]


def resampled(field: FloatArray, shape: tuple[int, int], order: int = 3) -> FloatArray:
    """Return a field interpolated to another number of cells on the same area, by splines.

    shape: new numbers of cells; order: order of the splines. Beyond the edges, the field is
    continued by its odd reflection, so that its slope at the edges is kept.
    """
    ghosts = [min(_GHOST_CELLS, n - 1) for n in field.shape]
    wide = np.pad(field, [(n, n) for n in ghosts], mode="reflect", reflect_type="odd")
    places = [
        (np.arange(n) + 0.5) * m / n - 0.5 + ghost
        for n, m, ghost in zip(shape, field.shape, ghosts, strict=True)
    ]
    at = np.meshgrid(*places, indexing="ij")
    found: FloatArray = scipy.ndimage.map_coordinates(wide, at, order=order, mode="nearest")
    return found


def dry_contact(task: FilmTask, grid: Grid, gap: FloatArray) -> DryContact:
    """Return the dry contact on a grid, with the film that a formula predicts for it."""
    solver = ContactSolver(grid, *task.bodies, tol=1e-6, on_border="warn")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # a film needs more cells, and is checked by itself
        if task.is_load:
            found = solver.solve(gap, load=task.target)
        else:
            found = solver.solve(gap, approach=task.target)
    if not found.load > 0:
        raise ValueError(
            f"approach must bring the dry surfaces into contact, got {task.target!r} m: increase "
            "approach, or prescribe the load"
        )
    if found.in_contact[0].any() and found.in_contact[-1].any():
        name = "load" if task.is_load else "approach"
        raise ValueError(
            f"{name} must leave room for an inlet on the grid, got {task.target!r}: the dry "
            "contact reaches from edge to edge along x; enlarge the grid"
        )
    E_star = hertz.effective_modulus(*map(softest, task.bodies))
    peak = float(found.pressure.max())
    speeds = 2.0 * task.entrainment, 0.0
    if grid.ny == 1 or "y" in grid.periodic:
        per_length = found.load / (grid.ny * grid.dy)
        radius = 2.0 * per_length / (math.pi * peak)
        R = math.pi * E_star * radius**2 / (4.0 * per_length)
        line = hertz.line(R, E_star, load_per_length=per_length)
        groups = film_groups(line, speeds, task.lubricant)
        film = max(dowson_higginson_of(groups), line_limits(groups).elastic_isoviscous)
    else:
        radius = math.sqrt(1.5 * found.load / (math.pi * peak))
        R = 4.0 * E_star * radius**3 / (3.0 * found.load)
        film = nijenbanning(hertz.point(R, E_star, load=found.load), speeds, task.lubricant)
    return DryContact(found.pressure, found.approach, found.load, radius, R, film)


def start_of(task: FilmTask, grid: Grid, gap: FloatArray, dry: DryContact) -> dict[str, Any]:
    """Return initial pressures, void fractions and approach of a film, based on the dry contact.

    Under a light load, the initial pressure extends farther than that of the dry contact.
    """
    pressure = dry.pressure
    peak = int(np.argmax(pressure))
    # half-width of the film at which the gap of the surfaces has grown by itself
    wide = dry.radius * math.sqrt(2.0 * dry.film / _height_at(gap, grid, dry.radius))
    if wide > dry.radius and task.is_load:
        x, y = (c - c.ravel()[peak] for c in np.broadcast_arrays(grid.x[:, None], grid.y[None, :]))
        along_y = 0.0 if grid.ny == 1 or "y" in grid.periodic else 1.0
        pressure = np.maximum(1.0 - (x**2 + along_y * y**2) / wide**2, 0.0)
        pressure *= dry.load / (pressure.sum() * grid.cell_area)
    solver = ContactSolver(grid, *task.bodies)
    deformed = gap + sum(
        solver.displacement(pressure, body=n)[2]
        for n, body in enumerate(task.bodies, 1)
        if not body.is_rigid
    )
    approach = float(deformed.ravel()[int(np.argmax(pressure))]) - dry.film
    if not task.is_load:
        approach = dry.approach
    film = np.maximum(deformed - approach, 1e-300)
    is_empty = film > _FILMS_OF_SUPPLY * task.supply
    return {
        "fluid_pressure": np.where(is_empty, 0.0, pressure),
        "boundary_pressure": np.zeros(grid.surface_shape),
        "void_fraction": np.where(is_empty, 1.0 - task.supply / film, 0.0),
        "approach": approach,
    }


def _height_at(gap: FloatArray, grid: Grid, radius: float) -> float:
    """Return the height of a gap at a radius from its minimum, as if the gap were parabolic [m].

    The height follows from the mean height of the gap within this radius.
    """
    i, j = np.unravel_index(int(np.argmin(gap)), gap.shape)
    x, y = grid.x[:, None] - grid.x[i], grid.y[None, :] - grid.y[j]
    inside = x**2 + (0.0 if grid.ny == 1 or "y" in grid.periodic else 1.0) * y**2 <= radius**2
    heights = (gap - gap.min())[np.broadcast_to(inside, gap.shape)]
    share = 3.0 if grid.ny == 1 or "y" in grid.periodic else 2.0
    return max(share * float(heights.mean()), 1e-12 * float(np.ptp(gap)), 1e-300)


def refined(state: dict[str, Any], shape: tuple[int, int]) -> dict[str, Any]:
    """Return a state interpolated to a finer grid, as the initial state on that grid."""
    cavitated = resampled((state["void_fraction"] > 0).astype(np.float64), shape) > 0.5
    voids = np.clip(resampled(state["void_fraction"], shape), _ENTERING_VOID, 1.0)
    fluid = np.maximum(resampled(state["fluid_pressure"], shape), 0.0)
    return {
        "fluid_pressure": np.where(cavitated, 0.0, fluid),
        "boundary_pressure": np.maximum(resampled(state["boundary_pressure"], shape), 0.0),
        "void_fraction": np.where(cavitated, voids, 0.0),
        "approach": state["approach"],
    }


def state_of(found: Any) -> dict[str, Any]:
    """Return the state of a solution, as the initial state of another solution."""
    names = "fluid_pressure", "boundary_pressure", "void_fraction", "approach"
    return {name: found[name] for name in names}


class LevelSolver:
    """Solver of a lubricated contact on one grid."""

    def __init__(self, task: FilmTask, grid: Grid, gap: FloatArray, table: Any) -> None:
        self.task, self.grid, self.gap, self._table = task, grid, gap, table
        self._core = _core.FilmSolver(grid._core, *(body._core for body in task.bodies))

    def solve(
        self, start: dict[str, Any], layer: tuple[float, float], order: int, **more: Any
    ) -> Any:
        """Return a solution from an initial state, as a dictionary.

        The solution may not have converged. more: time step and earlier contents of a transient
        film, or coefficients of the pressure flow.
        """
        task = self.task
        along_x, along_y = task.face_velocities(self.grid)
        state = {
            name: value if name == "approach" else np.ascontiguousarray(value)
            for name, value in start.items()
        }
        return self._core.solve(
            lubricant=self._table, gap=self.gap, is_load=task.is_load, target=task.target,
            along_x=along_x, along_y=along_y, order=order, supply=task.supply,
            thinnest=MIN_FILM_SHARE * float(np.ptp(self.gap)), layer=layer, start=state,
            tol=task.tol, max_iterations=task.max_iterations, **more,
        )  # fmt: skip

    def level(self, found: Any) -> FilmLevel:
        """Return the summary of a solution on this grid."""
        return FilmLevel(
            self.grid.surface_shape, found["iterations"], found["krylov_steps"],
            found["operator_applications"], found["error"],
            film_at_centre(found["film"], self.gap),
        )  # fmt: skip


def table_of(lubricant: Lubricant, peak: float) -> Any:
    """Return the tables of a lubricant for the compiled core.

    peak: maximum pressure of the dry contact [Pa].
    """
    tables = lubricant.tables(max(TABLE_RANGE * peak, MIN_TABLE_PRESSURE))
    return _core.LubricantTable(
        scale=tables.scale, step=tables.step, reduced=tables.reduced, fluidity=tables.fluidity,
        density=tables.density, density_slope=tables.density_slope,
    )  # fmt: skip
