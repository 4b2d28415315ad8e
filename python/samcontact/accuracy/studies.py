# SPDX-License-Identifier: GPL-3.0-or-later
"""Tasks that are solved on each grid (path, cycles of wear), and values compared between grids."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from .._util.checks import FloatArray
from .._util.quantities import Quantity, described
from ..bodies.layered import Body
from ..bodies.layers import Layered
from ..simulation import error_controlled_quantities
from . import fatigue_quantities
from .grid_errors import of_outline
from .grid_solution import GridSolution, marks_of
from .shakedown_study import ShakedownStudy
from .slip_quantities import SLIP_QUANTITIES, driven, orders_of, values_of
from .wear_study import WearStudy

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import Case
    from .solves import Solves

DEFAULT_ORDER = 2.0
SPOTS_ORDER = 1.0
"""Lowest order of convergence for surfaces that may touch in many spots, because spots appear and
merge on finer grids."""


class Study(Protocol):
    """Task that is solved on each grid."""

    dimension: str
    """Dimension of the values in results files: "increment" or "cycle"."""
    names: list[str]
    """Quantities whose errors can be controlled, by their names in results files."""
    default_names: list[str]
    """Quantities whose errors are controlled if none are named."""

    def parts(self, name: str) -> int:
        """Return the number of values whose maximum is the quantity, e.g. one per material."""
        ...

    def order(self, name: str) -> float:
        """Return the lowest order of convergence of a quantity in the cell size."""
        ...

    def described(self, name: str) -> tuple[Quantity, int | None]:
        """Return names and unit of a quantity, and the number of its body or None."""
        ...

    def solve(self, case: Case, name: str, solves: Solves, progress: bool) -> GridSolution:
        """Solve the case on its grid, continuing from the increments stored under a name."""
        ...

    def marks(self, solution: GridSolution) -> list[int]:
        """Return the indices, along `dimension`, of the values that are compared."""
        ...

    def values(self, solution: GridSolution, names: Sequence[str]) -> FloatArray:
        """Return the compared values, shape (marks, parts of all quantities)."""
        ...

    def margins(self, solution: GridSolution, names: Sequence[str]) -> FloatArray:
        """Return errors that a comparison of grids may miss, in the shape of the values."""
        ...

    def note(self, solution: GridSolution) -> str:
        """Return a result, as text, that must be the same on the two finest grids, or ""."""
        ...

    def to_dataset(self, solution: GridSolution, volume: str | None) -> xr.Dataset:
        """Return the results on a grid, in the form of a results file."""
        ...


class PathStudy:
    """Path that is solved once."""

    dimension = "increment"

    def __init__(self, case: Case, bodies: Sequence[Body]) -> None:
        self.bodies = bodies
        self._has_spots = bool(case.reason_for_grid)
        steps = case.steps()
        drives = {name for step in steps for name in ("load", "approach") if name in step}
        given = drives if len(drives) == 1 else set()
        layered = any(isinstance(body, Layered) for body in bodies)
        crossed = layered and not any(body.is_plastic for body in bodies)
        names = error_controlled_quantities.names(
            bodies, case.output.body, volume=case.has_volume and not crossed
        )
        self.default_names = [name for name in names if name not in given]
        self.names = list(self.default_names)
        self._orders: dict[str, float] = {}
        if case.sticks:
            self._orders = orders_of(self.names, moves=case.moves)
            yields = any(body.is_plastic for body in bodies)
            # the stress of elastic bodies has a cusp that converges slowly
            self.default_names = [
                name for name in self.names if yields or name not in self._orders
            ] + driven(steps)
            self.names += SLIP_QUANTITIES
        self._criteria = fatigue_quantities.names(case, bodies)
        self._orders |= dict.fromkeys(self._criteria, fatigue_quantities.ORDER)
        self.default_names += self._criteria
        self.names += self._criteria

    def parts(self, name: str) -> int:
        if name in self._criteria:
            return fatigue_quantities.PARTS
        return error_controlled_quantities.count_parts(name, self.bodies)

    def order(self, name: str) -> float:
        return self._orders.get(name, SPOTS_ORDER if self._has_spots else DEFAULT_ORDER)

    def described(self, name: str) -> tuple[Quantity, int | None]:
        return described(name, fatigue_quantities.QUANTITIES)

    def solve(self, case: Case, name: str, solves: Solves, progress: bool) -> GridSolution:
        with warnings.catch_warnings(record=True) as issued:
            warnings.simplefilter("always")
            simulation, path = case.build()
            states = solves.run(name, simulation, path, progress=progress)
        return GridSolution(case, simulation, states, issued)

    def marks(self, solution: GridSolution) -> list[int]:
        return marks_of(solution.case)

    def values(self, solution: GridSolution, names: Sequence[str]) -> FloatArray:
        states = [solution.states[mark] for mark in self.marks(solution)]
        tol: Any = solution.case.contact
        columns: list[list[tuple[float, ...]]] = []
        of_path = fatigue_quantities.parts(solution, [n for n in names if n in self._criteria])
        for name in names:
            if name in of_path:
                columns.append([of_path[name]] * len(states))
            elif name in SLIP_QUANTITIES:
                columns.append([(value,) for value in values_of(states, name, tol.tol)])
            else:
                columns.append([error_controlled_quantities.parts(s, name) for s in states])
        return np.array([[v for parts in row for v in parts] for row in zip(*columns, strict=True)])

    def margins(self, solution: GridSolution, names: Sequence[str]) -> FloatArray:
        """Return the errors of contact areas that consist of many spots; 0 for other quantities.

        These errors are due to the outlines of the spots, which change by whole cells.
        """
        columns: list[FloatArray] = []
        for name in names:
            of_spots = self._has_spots and name == "contact_area"
            found = [
                of_outline(state) * state.contact_area
                if of_spots and state.in_contact.any() else 0.0
                for state in (solution.states[mark] for mark in self.marks(solution))
            ]  # fmt: skip
            columns += [np.array(found)] * self.parts(name)
        return np.stack(columns, axis=-1)

    def note(self, solution: GridSolution) -> str:
        return ""

    def to_dataset(self, solution: GridSolution, volume: str | None) -> xr.Dataset:
        from .. import results  # here, so that importing the package does not load xarray

        return results.to_dataset(
            solution.simulation, solution.states, solution.case, volume=volume
        )


def study_of(case: Case, bodies: Sequence[Body]) -> Study:
    """Return the task that a case solves on each grid."""
    if case.wear is not None:
        return WearStudy(case)
    return PathStudy(case, bodies) if case.shakedown is None else ShakedownStudy(case, bodies)
