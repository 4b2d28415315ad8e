# SPDX-License-Identifier: GPL-3.0-or-later
"""Solution of a case on one grid: states, and the data from which later grids are chosen."""

from __future__ import annotations

import itertools
import warnings
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from .._util import memory
from ..solutions.strained_cells import strained_extent
from ..solutions.tangential_quantities import ROUNDING_ERROR

if TYPE_CHECKING:
    from ..cases import Case
    from ..simulation.simulation import Simulation
    from ..solutions.state import State


class GridSolution(NamedTuple):
    """Solution on one grid: case with this grid, simulation, states and issued warnings."""

    case: Case
    simulation: Simulation
    states: list[State]
    issued: list[warnings.WarningMessage]
    repeated: Any = None
    """Result of repeated cycles (wear or shakedown); None for a path that is solved once."""

    @property
    def half(self) -> tuple[float, float]:
        """Half-widths along x and y [m] of the region that contains contact and plastic strain.

        They are 0 for repeated cycles, because only some of their states are stored.
        """
        if self.repeated is not None:
            return 0.0, 0.0
        reach = [0, 0]
        for state in self.states:
            nx, ny = state.grid.surface_shape
            touched = np.nonzero(state.in_contact)
            found = [touched] if touched[0].size else []
            if state is self.states[-1]:
                extents = [strained_extent(state, body) for body in (1, 2)]
                found += [tuple(np.array(axis) for axis in e[:2]) for e in extents if e]
            for cells in found:
                for axis, n in enumerate((nx, ny)):
                    ends = int(cells[axis].min()), int(cells[axis].max())
                    reach[axis] = max(reach[axis], n - 2 * ends[0], 2 * ends[1] + 2 - n)
        grid = self.simulation.grid
        return 0.5 * reach[0] * grid.dx, 0.5 * reach[1] * grid.dy

    @property
    def elastic(self) -> list[int]:
        """Indices of the path segments without plastic flow and without partial slip."""
        if self.repeated is not None:  # the states are not those of all segments
            return []
        ends = ends_of(self.case)
        parts = zip([0, *ends], ends, strict=False)
        return [
            number for number, (first, end) in enumerate(parts)
            if self.case.path[number].start is None
            and not any(state.iterations or _is_sheared(state) for state in self.states[first:end])
        ]  # fmt: skip

    @property
    def memory(self) -> float:
        """Memory of the solution, including the fields of its states [bytes]."""
        grid = self.simulation.grid
        layers = max((len(state.depths) for state in self.states[-1:]), default=0)
        plastic = float(self.simulation.counters["volume_bytes"])
        fields = memory.volume(grid, memory.VOLUME_FIELD_BYTES, layers)
        return (
            memory.surface(grid, memory.CONTACT_BYTES + memory.SIMULATION_BYTES) + plastic + fields
        )


def _is_sheared(state: State) -> bool:
    """Whether a state has shear traction that follows from a law of partial slip."""
    if not state.setup.friction.sticks:
        return False
    return bool(np.abs(state.shear).max() > ROUNDING_ERROR * np.abs(state.pressure).max())


def marks_of(case: Case) -> list[int]:
    """Return the indices of the increments at which values are compared.

    These are the last increment of each segment; for passes, also the last increment under load;
    for fretting, also the increments at which the direction changes.
    """
    marks: list[int] = []
    count = 0
    for segment, made in zip(case.path, case.steps_of_segments(), strict=True):
        if segment.passes is not None:
            target = getattr(segment, segment.quantity)
            under = [i for i, step in enumerate(made) if step.get(segment.quantity) == target]
            marks.append(count + under[-1])
        if segment.fret is not None:
            quarter = segment.increments
            marks += range(count + quarter - 1, count + len(made) - 1, 2 * quarter)
        count += len(made)
        marks.append(count - 1)
    return marks


def ends_of(case: Case) -> list[int]:
    """Return the cumulative number of increments at the end of each segment."""
    return list(itertools.accumulate(len(steps) for steps in case.steps_of_segments()))
