# SPDX-License-Identifier: GPL-3.0-or-later
"""Plastic state of the bodies at the end of a cycle, and its change in a cycle."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .._util.checks import FloatArray
from ..simulation.simulation import Simulation
from ..solutions.common_cells import on_common_cells
from ..solutions.state import State
from ..solutions.track import Track

FIELDS = ("plastic_strain", "equivalent_plastic_strain", "backstress")
_SHEAR_WEIGHTS = np.array([1.0, 1.0, 1.0, 2.0, 2.0, 2.0])[:, None, None, None]


@dataclass(frozen=True)
class PlasticChange:
    """Change of the plastic state of a body in one cycle.

    Index 0 of its fields along x means row `first` of the grid.
    """

    first: int
    before: dict[str, FloatArray]
    """Fields before the cycle, by the names of FIELDS."""
    after: dict[str, FloatArray]

    def of(self, field: str) -> FloatArray:
        return self.after[field] - self.before[field]

    @property
    def flow(self) -> float:
        return float(self.of("equivalent_plastic_strain").max())

    @property
    def net(self) -> float:
        return max_equivalent(self.of("plastic_strain"))


def max_equivalent(strain: FloatArray) -> float:
    """Return the maximum over all cells of sqrt(2/3 e:e), for a strain e."""
    squares: FloatArray = np.sum(_SHEAR_WEIGHTS * strain**2, axis=0)
    return math.sqrt(2.0 / 3.0 * float(squares.max()))


def product(one: FloatArray, other: FloatArray) -> float:
    """Return the sum of the product of two fields, over all cells and all tensor components."""
    weights = _SHEAR_WEIGHTS if one.ndim > 3 else 1.0
    return float(np.sum(weights * one * other))


def at_common_depth(fields: Sequence[FloatArray]) -> list[FloatArray]:
    """Extend fields by layers of zeros (no plastic strain) to an equal number of layers."""
    deepest = max(field.shape[-1] for field in fields)
    return [
        np.pad(field, [(0, 0)] * (field.ndim - 1) + [(0, deepest - field.shape[-1])])
        for field in fields
    ]


def tracks(simulation: Simulation, state: State, bodies: Sequence[int]) -> dict[int, Track]:
    """Return the fields of each elastic-plastic body in all cells where the contact has passed.

    Raises ValueError if plastic strain lies outside the volume fields.
    """
    for body in bodies:
        box = state._core.strain_beyond(body - 1)
        if box is None:
            continue
        _, first, _, ny, nz = box
        grid = simulation.grid
        if (grid.nz and nz > grid.nz) or first < 0 or first + ny > grid.ny:
            raise ValueError(
                f"grid must contain the plastic strain of body {body}, which extends over {nz} "
                f"layers and from index {first} to {first + ny - 1} along y, got {grid!r}: "
                "omit nz, or enlarge ny"
            )
    return {body: state.track(body, margin=0) for body in bodies}


def change(before: Track, after: Track) -> PlasticChange:
    """Return the change of the plastic state of a body between two instants."""
    pairs = {name: on_common_cells(before, after, name) for name in FIELDS}
    start = min(before.x[0], after.x[0])
    first = after.first - round((after.x[0] - start) / after.grid.dx)
    return PlasticChange(first, *({name: pair[n] for name, pair in pairs.items()} for n in (0, 1)))
