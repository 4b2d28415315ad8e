# SPDX-License-Identifier: GPL-3.0-or-later
"""Dents pressed into a surface by hard particles, and a body that rolls over them.

`indent` simulates the indentations. The dented body keeps its imprint, its residual stress and its
hardening. `roll_over` then simulates another body that rolls over the dented body.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import fatigue, paths
from ._util.cached_property import cached_property
from ._util.checks import (
    FloatArray,
    finite,
    in_cells,
    integer,
    load_or_approach,
    non_negative,
    positive,
    require_list,
    require_type,
)
from ._util.short_text import in_short
from .bodies.layered import Body, backstresses_of, require_bodies
from .bodies.material import Material
from .problem.grid import Grid
from .simulation.simulation import Simulation
from .solutions.state import State
from .solutions.track import Track
from .surfaces import require_surface

__all__ = ["Overrolling", "Particle", "indent", "particles", "roll_over"]

_MAX_PARTICLES = 10_000


@dataclass(frozen=True)
class Particle:
    """Hard spherical particle that is pressed into a surface.

    Parameters
    ----------
    radius : float
        Radius [m], > 0.
    load : float, optional
        Maximum load [N], > 0.
    approach : float, optional
        Maximum depth below the undeformed surface [m], > 0, smaller than the radius. Exactly one of
        load and approach must be given.
    x, y : float, optional
        Position on the body [m].

    Raises
    ------
    ValueError
        An argument is outside its range.
    """

    radius: float
    load: float | None = None
    approach: float | None = None
    x: float = 0.0
    y: float = 0.0

    def __post_init__(self) -> None:
        R = positive("radius", self.radius)
        name, value = load_or_approach(self.load, self.approach)
        positive(name, value)
        if name == "approach" and value >= R:
            raise ValueError(f"approach must be < radius = {R!r} m, got {value!r} m")
        finite("x", self.x)
        finite("y", self.y)

    def gap(self, grid: Grid) -> FloatArray:
        """Gap of the particle above the surface [m]; inf outside the particle."""
        require_surface(grid)
        r2 = (grid.x[:, None] - self.x) ** 2 + (grid.y[None, :] - self.y) ** 2
        inside = r2 < self.radius**2
        height = np.sqrt(self.radius**2 - np.where(inside, r2, 0.0))
        return np.where(inside, r2 / (self.radius + height), math.inf)

    def path(self, increments: int) -> paths.Path:
        """Return the steps that press the particle in and unload it, for `Simulation.run`."""
        loading = paths.ramp(load=self.load, approach=self.approach, increments=increments)
        return [*loading, {"load": 0.0}]


def particles(
    length: float,
    width: float,
    density: float,
    radius: float,
    *,
    spread: float = 0.0,
    depth_ratio: float = 0.05,
    seed: int,
) -> list[Particle]:
    """Random particles on a rectangle around the origin, as from a contaminated lubricant.

    The number of particles has a Poisson distribution, positions are uniform, and radii have a
    log-normal distribution.

    Parameters
    ----------
    length, width : float
        Sides of the rectangle along x and y [m], > 0.
    density : float
        Mean number of particles per area [1/m^2], >= 0.
    radius : float
        Median radius [m], > 0.
    spread : float, optional
        Standard deviation of the logarithm of the radius [-], >= 0.
    depth_ratio : float, optional
        Approach of each particle divided by its radius [-], in (0, 1).
    seed : int
        Seed of `numpy.random.default_rng`: equal seeds give equal particles.

    Returns
    -------
    list of Particle

    Raises
    ------
    ValueError
        An argument is outside its range, or the mean number of particles exceeds 10000.
    """
    sides = positive("length", length), positive("width", width)
    mean = non_negative("density", density) * sides[0] * sides[1]
    if mean > _MAX_PARTICLES:
        raise ValueError(
            f"density * length * width must be at most {_MAX_PARTICLES} particles, got {mean:g}"
        )
    median, deviation = positive("radius", radius), non_negative("spread", spread)
    if deviation > 2.0:
        raise ValueError(f"spread must be in [0, 2], got {spread!r}")
    if not 0.0 < finite("depth_ratio", depth_ratio) < 1.0:
        raise ValueError(f"depth_ratio must be in (0, 1), got {depth_ratio!r}")
    rng = np.random.default_rng(integer("seed", seed, 0, None))
    count = int(rng.poisson(mean))
    x, y = ((rng.random(count) - 0.5) * side for side in sides)
    radii = median * np.exp(deviation * rng.standard_normal(count))
    return [
        Particle(float(R), approach=float(depth_ratio * R), x=float(a), y=float(b))
        for R, a, b in zip(radii, x, y, strict=True)
    ]


def indent(
    grid: Grid,
    body2: Body,
    particles: Sequence[Particle],
    *,
    increments: int = 8,
    body1: Body | None = None,
    progress: bool = False,
    **settings: Any,
) -> Track:
    """Press particles into a body, one after the other.

    Parameters
    ----------
    grid : Grid
        Grid with layers (dz), so large that it contains the contacts of all particles.
    body2 : Material or Layered
        Elastic-plastic body into which the particles are pressed.
    particles : sequence of Particle
        Particles in the order in which they are pressed in, at least one.
    increments : int, optional
        Number of increments in which each particle is loaded.
    body1 : Material or Layered, optional
        Material of the particles; rigid by default.
    progress : bool, optional
        Whether to show a progress bar for each particle.
    **settings
        Further settings of `Simulation`, such as `tol` or `friction`.

    Returns
    -------
    Track
        Residual fields of the unloaded body with its dents: `residual_displacement`,
        `residual_stress`, `plastic_strain` and others.

    Raises
    ------
    ValueError, TypeError
        An argument is outside its range, the body is not elastic-plastic, the centre of a particle
        is outside the grid, or a `Simulation` raises an error.
    """
    require_type("grid", grid, Grid)
    require_list("particles", particles, Particle)
    if not particles:
        raise ValueError("particles must contain at least one Particle, got an empty list")
    require_bodies(body2 if body1 is None else body1, body2)
    if not body2.is_plastic:
        raise ValueError(
            f"body2 must be elastic-plastic, got {in_short(body2)}: no dent remains in an elastic "
            "body"
        )
    _require_inside(grid, particles)
    count = integer("increments", increments, 1)
    upper = Material.rigid() if body1 is None else body1
    dented: Track | None = None
    for one in particles:
        simulation = Simulation(grid, upper, body2, one.gap(grid), **settings)
        if dented is not None:
            start_from(simulation, dented)
        dented = simulation.run(one.path(count), progress=progress)[-1].track(2)
    assert dented is not None
    return dented


def _require_inside(grid: Grid, particles: Sequence[Particle]) -> None:
    """Raise ValueError for a particle whose centre is outside the grid."""
    for number, one in enumerate(particles):
        for axis, place, half in (
            ("x", one.x, 0.5 * grid.nx * grid.dx), ("y", one.y, 0.5 * grid.ny * grid.dy),
        ):  # fmt: skip
            if not abs(place) < half:
                raise ValueError(
                    f"{axis} of particles[{number}] must be between {-half:.6g} and {half:.6g} m, "
                    f"on the grid, got {place!r} m: enlarge n{axis}, or move the particle"
                )


def _require_same_material(dented: Track, body2: Body) -> None:
    """Raise ValueError if the dented body is not `body2`."""
    if dented.material != body2:
        raise ValueError(
            f"body2 must be the body with the dents, {in_short(dented.material)}, because its "
            f"plastic strain and hardening are carried over, got {in_short(body2)}"
        )


def _require_same_cells(grid: Grid, dented: Track) -> None:
    """Raise ValueError if the cells of a grid do not coincide with those of the dented body."""
    cells = [(g.ny, g.dx, g.dy, g.dz, g.periodic) for g in (grid, dented.grid)]
    if cells[0] != cells[1]:
        raise ValueError(
            "grid must have the same (ny, dx, dy, dz, periodic) as the grid of dented, "
            f"{cells[1]}, got {cells[0]}"
        )
    if grid.along_x and grid.nx != dented.grid.nx:
        raise ValueError(
            f"if grid is periodic along x, its nx must be that of the grid of dented, "
            f"{dented.grid.nx}, got {grid.nx}"
        )
    rows = (dented.x[0] - grid.x[0]) / grid.dx
    if abs(rows - round(rows)) > 1e-6:
        raise ValueError(
            f"nx must be {'odd' if grid.nx % 2 == 0 else 'even'}, as on the grid of dented, got "
            f"{grid.nx}: otherwise the dents would move by half a cell along x"
        )


def start_from(simulation: Simulation, dented: Track) -> None:
    """Change body 2 of a simulation: give it the plastic strain and hardening of a dented body."""
    backstress = dented.backstress() if backstresses_of(simulation.body2) else None
    first = round((dented.x[0] - simulation.grid.x[0]) / simulation.grid.dx)
    simulation.set_plastic_strain(
        2, dented.plastic_strain(), dented.equivalent_plastic_strain(), backstress, first
    )


@dataclass(frozen=True)
class Overrolling:
    """Pass of a body over a dented surface, from `roll_over`.

    Attributes
    ----------
    dented : Track
        Residual fields before the pass.
    states : list of State
        States during the pass; the last state is unloaded.
    """

    dented: Track
    states: list[State]

    def __repr__(self) -> str:
        return f"Overrolling(states={len(self.states)}, dented={self.dented!r})"

    @cached_property
    def position(self) -> FloatArray:
        """Position of the contact on the body at each state [m], shape (n,)."""
        return np.array([-state.travel[1] for state in self.states])

    @cached_property
    def max_pressure(self) -> FloatArray:
        """Maximum pressure of each state [Pa], shape (n,)."""
        return np.array([state.pressure.max() for state in self.states])

    @cached_property
    def peak(self) -> int:
        """Index of the state with the largest pressure."""
        return int(np.argmax(self.max_pressure))

    @property
    def peak_place(self) -> tuple[float, float]:
        """Position (x, y) on the body where the pressure of the pass is largest [m]."""
        state = self.states[self.peak]
        i, j = np.unravel_index(np.argmax(state.pressure), state.pressure.shape)
        x = state.grid.x[i] - state.origin + self.position[self.peak]
        return float(x), float(state.grid.y[j])

    @cached_property
    def track(self) -> Track:
        """Residual fields after the pass."""
        return self.states[-1].track(2)

    def dang_van(self, slope: float) -> fatigue.FatigueField:
        """Dang Van's fatigue criterion over the states of the pass: see `fatigue.dang_van`.

        slope: weight of the mean normal stress [-].
        """
        return fatigue.dang_van(self.states, 2, slope)


def roll_over(
    grid: Grid,
    body1: Body,
    body2: Body,
    dented: Track,
    gap: ArrayLike | Callable[[Grid], ArrayLike],
    *,
    load: float,
    distance: float,
    step: float,
    middle: float = 0.0,
    slide_to_roll: float = 0.0,
    increments: int = 4,
    progress: bool = False,
    **settings: Any,
) -> Overrolling:
    """Roll another body over a dented surface.

    Parameters
    ----------
    grid : Grid
        Grid with the same ny, dx, dy and dz as in `indent`. Its nx may differ by an even number
        from nx in `indent`; dents keep their positions on the body.
    body1, body2 : Material or Layered
        Upper body, and the body with the dents.
    dented : Track
        Residual fields of body 2, from `indent` or from an earlier pass (`Overrolling.track`).
    gap : array_like, shape (nx, ny), or callable
        Gap of the undeformed bodies without dents [m], as in `Simulation`.
    load : float
        Normal load [N].
    distance, step : float
        Rolling distance, and distance per increment [m], whole numbers of cells.
    middle : float, optional
        Position of the middle of the path on body 2 [m], a whole number of cells. If `distance` is
        an odd number of cells, its actual middle is half a cell away from this position.
    slide_to_roll : float, optional
        Slide-to-roll ratio [-], as in `paths.rolling`.
    increments : int, optional
        Number of increments in which the load is applied before the pass.
    progress : bool, optional
        Whether to show a progress bar.
    **settings
        Further settings of `Simulation`, such as `tol` or `friction`.

    Returns
    -------
    Overrolling

    Raises
    ------
    ValueError, TypeError
        An argument is outside its range, body 2 is not the dented body, the cells of the grid do
        not coincide with those of `dented`, or `Simulation` raises an error.
    """
    require_type("grid", grid, Grid)
    require_type("dented", dented, Track)
    require_bodies(body1, body2)
    _require_same_material(dented, body2)
    _require_same_cells(grid, dented)
    for name, length in (("distance", distance), ("step", step), ("middle", middle)):
        number = in_cells(name, finite(name, length), grid.dx)
        if abs(number - round(number)) > 1e-6:
            raise ValueError(
                f"{name} must be a whole number of cells of {grid.dx!r} m, got {length!r} m"
            )
    start = middle - 0.5 * positive("distance", distance)
    first = grid.dx * round(in_cells("distance", start, grid.dx))
    simulation = Simulation(grid, body1, body2, gap, **settings)
    start_from(simulation, dented)
    simulation.step(load=0.0, advance=(-first, -first))
    path = paths.rolling(
        load=load, distance=distance, step=step, slide_to_roll=slide_to_roll, increments=increments
    )
    return Overrolling(dented, simulation.run(path, progress=progress))
