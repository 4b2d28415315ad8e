# SPDX-License-Identifier: GPL-3.0-or-later
"""Sources of the stress history of a cycle: several states, one steady state, or an array.

A block is a range of points: a slice along the last axis of the points, which is normally the
depth. Fields of a block have this axis before the other axes of the points, as in the compiled
core: their shape is (instants, 6, block, ...).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from .._util.checks import FloatArray
from ..solutions.moving_state import require_path_along_x
from ..solutions.state import State


class Paths(Protocol):
    """Protocol of a source of stress and plastic strain, for all points and all instants."""

    @property
    def moments(self) -> int: ...
    @property
    def shape(self) -> tuple[int, ...]: ...
    @property
    def has_plastic_strain(self) -> bool: ...
    def stress(self, block: slice) -> FloatArray: ...
    def plastic_strain(self, block: slice) -> FloatArray: ...


@dataclass(frozen=True)
class GivenPaths:
    """Stress history from a stress array; the plastic strain is optional."""

    given: FloatArray
    strain: FloatArray | None

    @property
    def moments(self) -> int:
        return int(self.given.shape[0])

    @property
    def shape(self) -> tuple[int, ...]:
        return tuple(self.given.shape[2:]) or (1,)

    @property
    def has_plastic_strain(self) -> bool:
        return self.strain is not None

    def stress(self, block: slice) -> FloatArray:
        return self._part(self.given, block)

    def plastic_strain(self, block: slice) -> FloatArray:
        assert self.strain is not None
        return self._part(self.strain, block)

    def _part(self, array: FloatArray, block: slice) -> FloatArray:
        shaped = array.reshape(self.moments, 6, *self.shape)
        return np.ascontiguousarray(np.moveaxis(shaped[..., block], -1, 2))


@dataclass(frozen=True)
class StatePaths:
    """Stress history from several states, in the cells of a body that lie in all their grids."""

    states: Sequence[State]
    body: int
    first: int  # index along x of the first of these cells
    shape: tuple[int, int, int]

    @classmethod
    def of(cls, states: Sequence[State], body: int) -> StatePaths:
        for state in states:
            require_path_along_x(state, body)
        firsts = [state._core.first_cell[body - 1] for state in states]
        grid = states[0].grid
        rows = min(firsts) + grid.nx - max(firsts)
        if rows < 1:
            raise ValueError(
                "states must have cells of the body in common, but the contact travels farther "
                f"than the length of the grid, {grid.nx * grid.dx:.6g} m: use a longer grid, or "
                "samcontact.fatigue.steady_cycle(state) for steady rolling"
            )
        layers = max(state.layers for state in states)
        return cls(states, body, max(firsts), (rows, grid.ny, layers))

    @property
    def moments(self) -> int:
        return len(self.states)

    @property
    def has_plastic_strain(self) -> bool:
        return any(state.max_plastic_strain_magnitude(self.body) > 0 for state in self.states)

    def stress(self, block: slice) -> FloatArray:
        return self._gathered(block, lambda state: state.stress(self.body))

    def plastic_strain(self, block: slice) -> FloatArray:
        return self._gathered(block, lambda state: state.plastic_strain(self.body))

    def _gathered(self, block: slice, field: Callable[[State], FloatArray]) -> FloatArray:
        rows, ny, layers = self.shape
        out = np.empty((self.moments, 6, block.stop - block.start, rows, ny))
        for n, state in enumerate(self.states):
            ahead = self.first - state._core.first_cell[self.body - 1]
            # with all layers, because the last digits of a field depend on the number of layers
            values = field(state.at_layers(layers))[:, ahead : ahead + rows, :, block]
            out[n] = values.transpose(0, 3, 1, 2)
        return out


@dataclass(frozen=True)
class SteadyPaths:
    """Stress history of material that moves along an axis through the field of a steady state."""

    state: State
    body: int
    axis: int
    at_rest: bool  # whether the initial stress, far from the contact, is one more instant
    shape: tuple[int, int]

    @classmethod
    def of(cls, state: State, body: int, axis: int, at_rest: bool) -> SteadyPaths:
        return cls(state, body, axis, at_rest, (state.grid.surface_shape[1 - axis], state.layers))

    @property
    def moments(self) -> int:
        return int(self.state.grid.surface_shape[self.axis]) + self.at_rest

    @property
    def has_plastic_strain(self) -> bool:
        return self.state.max_plastic_strain_magnitude(self.body) > 0

    def stress(self, block: slice) -> FloatArray:
        rest = self.state.initial_stress(self.body) if self.at_rest else None
        return self._lines(self.state.stress(self.body), rest, block)

    def plastic_strain(self, block: slice) -> FloatArray:
        strain = self.state.plastic_strain(self.body)
        return self._lines(strain, np.zeros_like(strain) if self.at_rest else None, block)

    def _lines(self, field: FloatArray, rest: FloatArray | None, block: slice) -> FloatArray:
        fields = [field] if rest is None else [field, rest.take([0], 1 + self.axis)]
        along = [np.moveaxis(part[..., block], (1 + self.axis, 3), (0, 2)) for part in fields]
        return np.ascontiguousarray(np.concatenate(along))
