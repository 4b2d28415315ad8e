# SPDX-License-Identifier: GPL-3.0-or-later
"""Problem of a wear computation, its state between two cycles, and the simulation of a cycle."""

from __future__ import annotations

import dataclasses
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any, TypeVar

import numpy as np

from .._util.checks import FloatArray
from ..bodies.heterogeneous import Heterogeneous
from ..bodies.layered import Body
from ..bodies.viscoelastic import relaxes
from ..problem.domain import SurfaceGeometry
from ..problem.friction import FrictionLaw
from ..problem.grid import Grid
from ..problem.moving_topography import Relief, heights_over
from ..restart.tree import Tree
from ..simulation.kept_history import continue_history, creep_of
from ..simulation.kept_history import widened as widened_creep
from ..simulation.simulation import Simulation
from ..solutions.state import State
from .results import AnyCycle
from .worn_inclusions import raised

P = TypeVar("P", bound="WearProblem")


@dataclass(frozen=True)
class WearProblem(ABC):
    """Checked arguments of a wear computation, constant over all cycles, on one grid."""

    surfaces: SurfaceGeometry
    """Surfaces as given by the user; if they are functions, the grid may be enlarged."""
    grid: Grid
    bodies: tuple[Body, Body]
    gap: FloatArray
    reliefs: tuple[Relief | None, Relief | None]
    cycle: list[dict[str, Any]]
    friction: float | FrictionLaw
    worn: tuple[int, ...]
    settings: dict[str, Any]

    @property
    @abstractmethod
    def record(self) -> type[AnyCycle]:
        """Class of the results of a cycle."""

    @abstractmethod
    def rows(self, body: int) -> tuple[int, int]:
        """Return the first row that can wear in a body, and the number of such rows.

        A row is a line of cells along y. Row 0 is the first row of the grid.
        """

    @property
    def arguments(self) -> dict[str, Any]:
        """Arguments by which a checkpoint is recognised, on the initial grid before enlargement."""
        names = (item.name for item in dataclasses.fields(self) if item.name != "surfaces")
        return {name: getattr(self, name) for name in names}

    @property
    def may_grow(self) -> bool:
        """Whether the grid may be enlarged."""
        fixed = self.settings.get("on_border") == "warn" or self.grid.periodic
        return self.surfaces.are_known and not fixed

    def over(self: P, grid: Grid) -> P:
        """Return the problem on another grid."""
        if grid == self.grid:
            return self
        domain = self.surfaces.over(grid)
        return replace(self, grid=grid, gap=domain.initial_gap, reliefs=domain.reliefs)

    def initial_heights(self, body: int) -> FloatArray:
        """Return the heights of a body before any wear [m], in its rows that can wear."""
        first, rows = self.rows(body)
        relief = self.reliefs[body - 1]
        if relief is None:
            return np.zeros((rows, self.grid.ny))
        return heights_over(relief, first, rows, self.grid)


@dataclass
class BodyStrain:
    """Plastic state of a body; index 0 of its fields along x means row `first` of the grid."""

    first: int
    strain: FloatArray
    equivalent: FloatArray
    backstress: FloatArray | None = None


@dataclass
class WearProgress:
    """Initial state of the next cycle, and results of the preceding cycles."""

    grid: Grid
    """Current grid, which may have been enlarged."""
    heights: dict[int, list[FloatArray]]
    """Heights of each worn body [m], before the first cycle and after each cycle."""
    strains: dict[int, BodyStrain] = field(default_factory=dict)
    cycles: list[AnyCycle] = field(default_factory=list)
    heat: Tree = field(default_factory=dict)
    """Heat history at the end of the last cycle; empty for unheated bodies."""
    creep: Tree = field(default_factory=dict)
    """Tractions and creep at the end of the last solution; empty without viscoelastic bodies."""

    @staticmethod
    def start(problem: WearProblem) -> WearProgress:
        """Return the state before the first cycle."""
        heights = {body: [problem.initial_heights(body)] for body in problem.worn}
        return WearProgress(problem.grid, heights)

    def over(self, problem: WearProblem) -> WearProgress:
        """Return the state on the grid of `problem`, which must not be smaller than `self.grid`.

        Added cells have the initial heights of `problem`, i.e. no wear.
        """
        grid, old = problem.grid, self.grid
        if grid == old:
            return self
        i, j = (grid.nx - old.nx) // 2, (grid.ny - old.ny) // 2
        before = problem.over(old)
        heights = {}
        for body, rows in self.heights.items():
            around = problem.initial_heights(body)
            top = i + before.rows(body)[0] - problem.rows(body)[0]
            place = slice(top, top + len(rows[0])), slice(j, j + old.ny)
            heights[body] = [_placed(around, place, one) for one in rows]
        sides = (j, grid.ny - old.ny - j)
        strains = {body: _widened(kept, i, sides) for body, kept in self.strains.items()}
        creep = widened_creep(self.creep, old, grid)
        return WearProgress(grid, heights, strains, self.cycles, self.heat, creep)


def centred(field: FloatArray, shape: tuple[int, int]) -> FloatArray:
    """Return a surface field in the middle of a larger grid, with zeros around it."""
    before = [(n - m) // 2 for n, m in zip(shape, field.shape, strict=True)]
    after = [n - m - b for n, m, b in zip(shape, field.shape, before, strict=True)]
    padded: FloatArray = np.pad(field, list(zip(before, after, strict=True)))
    return padded


def _placed(around: FloatArray, place: tuple[slice, slice], heights: FloatArray) -> FloatArray:
    placed: FloatArray = around.copy()
    placed[place] = heights
    return placed


def _widened(kept: BodyStrain, rows: int, sides: tuple[int, int]) -> BodyStrain:
    """Return a plastic state for a larger grid, with zeros in the added cells.

    rows: number of rows added before the first row of the grid. sides: numbers of cells added at
    the two ends of each row.
    """

    def padded(of: FloatArray) -> FloatArray:
        wide: FloatArray = np.pad(of, [*[(0, 0)] * (of.ndim - 2), sides, (0, 0)])
        return wide

    back = None if kept.backstress is None else padded(kept.backstress)
    return BodyStrain(kept.first + rows, padded(kept.strain), padded(kept.equivalent), back)


def creep_after(problem: WearProblem, state: State) -> Tree:
    """Return the tractions and creep in a state; empty without viscoelastic bodies."""
    return creep_of(state) if relaxes(*problem.bodies) else {}


def reliefs_of(problem: WearProblem, standing: WearProgress) -> list[Relief | None]:
    """Return the current surfaces of both bodies; None for a smooth surface without wear."""
    reliefs = list(problem.reliefs)
    for body in problem.worn:
        first, _ = problem.rows(body)
        heights = standing.heights[body]
        worn = np.maximum(heights[0] - heights[-1], 0.0)
        # Inclusions come closer to the surface instead.
        moves = isinstance(problem.bodies[body - 1], Heterogeneous)
        reliefs[body - 1] = Relief(heights[-1], first, worn=None if moves else worn)
    return reliefs


def _bodies_now(problem: WearProblem, standing: WearProgress) -> list[Body]:
    """Return both bodies, with inclusions moved up by the wear of the surface above them."""
    bodies = list(problem.bodies)
    for body in problem.worn:
        if isinstance(bodies[body - 1], Heterogeneous):  # its rows are those of the grid
            heights = standing.heights[body]
            worn = np.maximum(heights[0] - heights[-1], 0.0)
            bodies[body - 1] = raised(bodies[body - 1], body, worn, standing.grid)
    return bodies


def simulation_of(problem: WearProblem, standing: WearProgress) -> Simulation:
    """Return an unloaded simulation with the current surfaces, plastic strain, heat and creep.

    If the surfaces are given as functions, the simulation enlarges a grid that is too small.
    """
    given = _surfaces_now(problem, standing)
    body1, body2 = _bodies_now(problem, standing)
    simulation = Simulation(
        standing.grid, body1, body2, given.gap, problem.friction,
        relief1=given.relief1, relief2=given.relief2, **problem.settings,
    )  # fmt: skip
    simulation.monitor.checks_steps = False
    simulation.monitor.checks_increments = False  # not for each of many cycles
    for body, kept in standing.strains.items():
        simulation.set_plastic_strain(
            body, kept.strain, kept.equivalent, kept.backstress, first=kept.first
        )
    continue_history(simulation.engine, standing.heat, standing.creep)
    return simulation


def _surfaces_now(problem: WearProblem, standing: WearProgress) -> SurfaceGeometry:
    """Return the current surfaces, as functions of the grid if the given surfaces are functions."""
    now = problem.over(standing.grid)
    reliefs = reliefs_of(now, standing)
    if not problem.surfaces.are_known:
        return SurfaceGeometry(now.gap, *reliefs)

    def relief(body: int) -> Callable[[Grid], Relief] | None:
        def over(grid: Grid) -> Relief:
            larger = now.over(grid)
            found = reliefs_of(larger, standing.over(larger))[body - 1]
            assert found is not None
            return found

        return None if reliefs[body - 1] is None else over

    return SurfaceGeometry(lambda grid: now.over(grid).gap, relief(1), relief(2))
