# SPDX-License-Identifier: GPL-3.0-or-later
"""Repeated load cycles, until shakedown or ratcheting, as a task that is solved on each grid."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from .._util.checks import FloatArray
from .._util.quantities import Quantity, described
from ..bodies.layered import Body
from ..simulation import error_controlled_quantities
from .grid_solution import GridSolution

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import Case
    from .solves import Solves

_PER_CYCLE = {"plastic_strain_per_cycle": "rate", "plastic_flow_per_cycle": "flow"}
"""Quantities of the last cycle, and their names in `ShakedownResult`."""
_OF_CONTACT = ("max_pressure", "contact_area")


class ShakedownStudy:
    """Path that is repeated in cycles. Errors are estimated for the state after the last cycle."""

    dimension = "increment"

    def __init__(self, case: Case, bodies: Sequence[Body]) -> None:
        self.bodies = bodies
        names = error_controlled_quantities.names(bodies, case.output.body)
        self.default_names = [
            name for name in names if "_body" in name and not name.startswith("max_von_mises")
        ]
        self.names = [*self.default_names, *_OF_CONTACT, *_PER_CYCLE]

    def parts(self, name: str) -> int:
        return error_controlled_quantities.count_parts(name, self.bodies)

    def order(self, name: str) -> float:
        return 1.0 if name in _PER_CYCLE else 2.0

    def described(self, name: str) -> tuple[Quantity, int | None]:
        return described(name)

    def solve(self, case: Case, name: str, solves: Solves, progress: bool) -> GridSolution:
        assert case.shakedown is not None
        with warnings.catch_warnings(record=True) as issued:
            warnings.simplefilter("always")
            simulation, path = case.build()
            found = case.shakedown.solve(simulation, path, progress, solves.file(name, "shakedown"))
        return GridSolution(case, simulation, [found.state], issued, found)

    def marks(self, solution: GridSolution) -> list[int]:
        return [0]

    def values(self, solution: GridSolution, names: Sequence[str]) -> FloatArray:
        """Return the values after the last cycle.

        Plastic strain per cycle below the tolerance of [shakedown] is returned as 0.
        """
        found, section = solution.repeated, solution.case.shakedown
        assert section is not None
        row: list[float] = []
        for name in names:
            if name in _PER_CYCLE:
                value = getattr(found, _PER_CYCLE[name])
                row.append(value if value > section.tol * found.yield_strain else 0.0)
            else:
                row += error_controlled_quantities.parts(found.state, name)
        return np.array([row])

    def margins(self, solution: GridSolution, names: Sequence[str]) -> FloatArray:
        """Return the estimated error of the plastic strain due to extrapolation over cycles."""
        error = solution.repeated.error
        strains = [name.startswith("max_equivalent_plastic_strain") for name in names]
        columns = [
            [error if is_strain else 0.0] * self.parts(name)
            for name, is_strain in zip(names, strains, strict=True)
        ]
        return np.array([[value for column in columns for value in column]])

    def note(self, solution: GridSolution) -> str:
        return f"the response is {solution.repeated.response}"

    def to_dataset(self, solution: GridSolution, volume: str | None) -> xr.Dataset:
        from .. import results  # here, so that importing the package does not load xarray

        return results.to_dataset(
            solution.simulation, solution.states, solution.case, volume=volume
        )
