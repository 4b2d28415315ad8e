# SPDX-License-Identifier: GPL-3.0-or-later
"""Cycles of wear as a task that is solved on each grid."""

from __future__ import annotations

import itertools
import warnings
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .._util.checks import FloatArray
from .._util.quantities import Quantity, described
from .._util.wear_quantities import WEAR
from .grid_errors import of_outline
from .grid_solution import GridSolution

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import Case
    from .solves import Solves

_ORDER = 1.0
"""Lowest order of convergence: pressure and wear change abruptly at the edges of the scar and of
the stick zone, which move by whole cells."""
_OF_LAW = {
    True: ("worn_volume", "depth", "max_pressure", "contact_area", "max_equivalent_plastic_strain"),
    False: ("worn_volume", "depth", "max_pressure", "contact_area", "friction_work"),
}
"""Quantities for wear by plastic strain (True) and for wear by slip (False)."""
_OTHERS = {True: ("max_von_mises",), False: ("slip_distance", "stick_area")}
"""Quantities whose errors are controlled only if the case names the quantities."""


class WearStudy:
    """Cycles of wear, with the values of each cycle."""

    dimension = "cycle"

    def __init__(self, case: Case) -> None:
        assert case.wear is not None
        self.count = case.wear.cycles
        by_strain = case.wear.law == "threshold"
        if by_strain:
            worn: Sequence[int] = case.wear.worn
        else:
            given: Any = getattr(case.wear, case.wear.law)
            pair = given if isinstance(given, list) else [0.0, given]
            worn = [body for body in (1, 2) if pair[body - 1] > 0]
        self._per_body = ("depth", "max_equivalent_plastic_strain")
        self.default_names = [
            full
            for name in _OF_LAW[by_strain]
            for full in ([f"{name}_body{n}" for n in worn] if name in self._per_body else [name])
        ]
        self.names = [*self.default_names, *_OTHERS[by_strain]]
        self._worn = list(worn)

    def parts(self, name: str) -> int:
        return 1

    def order(self, name: str) -> float:
        return _ORDER

    def described(self, name: str) -> tuple[Quantity, int | None]:
        return described(name, WEAR)

    def solve(self, case: Case, name: str, solves: Solves, progress: bool) -> GridSolution:
        assert case.wear is not None
        with warnings.catch_warnings(record=True) as issued:
            warnings.simplefilter("always")
            simulation, cycle = case.build()
            result = case.wear.solve(simulation, cycle, solves.file(name, "cycle.h5"), progress)
        return GridSolution(case, simulation, list(result.last), issued, result)

    def marks(self, solution: GridSolution) -> list[int]:
        return list(range(len(solution.repeated.cycles)))

    def values(self, solution: GridSolution, names: Sequence[str]) -> FloatArray:
        """Return the values of each cycle.

        After wear has ceased, the values of the last cycle are repeated, with a worn depth of 0.
        """
        columns = [self._column(solution.repeated, name) for name in names]
        table = np.array(columns, dtype=np.float64).T
        missing = self.count - len(table)
        later = table[-1:].copy()
        for n, name in enumerate(names):
            if name.startswith("depth"):
                later[0, n] = 0.0
        return np.concatenate([table, np.repeat(later, missing, axis=0)])

    def _column(self, result: Any, name: str) -> list[float]:
        if name == "worn_volume":
            return list(itertools.accumulate(result.rate))
        kind, _, body = name.partition("_body")
        values = [getattr(cycle, kind) for cycle in result.cycles]
        place = result.worn.index(int(body)) if body else None
        return [float(value if place is None else value[place]) for value in values]

    def margins(self, solution: GridSolution, names: Sequence[str]) -> FloatArray:
        """Return errors of the contact area; 0 for other quantities.

        These errors are due to the outline of the contact, which changes by whole cells.
        """
        found = np.zeros((self.count, len(names)))
        loaded = max(solution.states, key=lambda state: state.load)
        for n, name in enumerate(names):
            if name == "contact_area" and loaded.in_contact.any():
                found[:, n] = of_outline(loaded) * loaded.contact_area
        return found

    def note(self, solution: GridSolution) -> str:
        return ""

    def to_dataset(self, solution: GridSolution, volume: str | None) -> xr.Dataset:
        found: xr.Dataset = solution.repeated.to_dataset()
        return found
