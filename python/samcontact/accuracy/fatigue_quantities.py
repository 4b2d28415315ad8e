# SPDX-License-Identifier: GPL-3.0-or-later
"""Fatigue criteria whose errors can be estimated, by their names in results files."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from .._util.quantities import CONTACT
from .._util.sweep_quantities import SWEEP
from ..bodies.layered import Body, materials_of
from ..simulation.error_controlled_quantities import below_and_at_surface

if TYPE_CHECKING:
    from ..cases import Case
    from .grid_solution import GridSolution

PREFIX = "fatigue_"
PARTS = 2
"""Number of values per criterion, one maximum below the surface and one at the surface."""
ORDER = 1.0
"""Lowest order of convergence in the cell size. It is only 1 because the maximum moves between
cells and between instants as the grid is refined."""
QUANTITIES = CONTACT | {name: SWEEP[name] for name in SWEEP if name.startswith(PREFIX)}


def names(case: Case, bodies: Sequence[Body]) -> list[str]:
    """Return the names of the criteria in the section [fatigue] of a case.

    There are none for a layered body, because the criteria are discontinuous at interfaces.
    """
    if case.fatigue is None or len(materials_of(bodies[case.output.body - 1])) > 1:
        return []
    return [f"{PREFIX}{name}" for name in case.fatigue.criteria]


def depends_on_increments(case: Case) -> bool:
    """Whether the stress cycle contains all increments, so that criteria depend on their number."""
    return case.fatigue is not None and case.fatigue.steady_axis is None


def parts(solution: GridSolution, chosen: Sequence[str]) -> dict[str, tuple[float, ...]]:
    """Return, for each criterion, its maximum below the surface and its maximum at the surface."""
    if not chosen:
        return {}
    section, body = solution.case.fatigue, solution.case.output.body
    assert section is not None
    layers = max(state.layers for state in solution.states)
    states = [state.at_layers(layers) for state in solution.states]
    fields = {f"{PREFIX}{field.criterion}": field for field in section.fields(states, body)}
    return {name: below_and_at_surface(fields[name].values) for name in chosen}
