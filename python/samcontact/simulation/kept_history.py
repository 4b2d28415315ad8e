# SPDX-License-Identifier: GPL-3.0-or-later
"""Histories of heat and creep of a simulation, which a new simulation can continue.

The new simulation has the same bodies; their surfaces may have been worn in between. Its plastic
strain is set separately.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from .._util.checks import FloatArray
from ..restart.tree import Tree
from .snapshot import Snapshot

if TYPE_CHECKING:
    from ..problem.grid import Grid
    from ..solutions.state import State
    from .engine import Engine

_HEAT = ("past1", "past2", "past_symmetry", "time", "duration")
"""Parts of a state that contain the heat of earlier increments."""
_MEMORIES = ("traction_memory1", "traction_memory2")
_FIELDS = ("pressure", "shear_x", "shear_y", "slip_rate", "plastic_slip")
"""Surface fields from which an increment with partial slip continues."""
_CREEP = (
    *_MEMORIES, *_FIELDS, "load", "approach", "tilt", "motion", "shear_symmetry", "travel",
    "lateral_travel", "time",
)  # fmt: skip
"""Parts of a state from which increments with viscoelastic bodies continue."""


def heat_of(state: State) -> Tree:
    """Return the heat of earlier increments that an unloaded state contains, as plain data."""
    return _parts_of(state, _HEAT)


def creep_of(state: State) -> Tree:
    """Return the tractions on viscoelastic bodies and their memory of earlier tractions."""
    return _parts_of(state, _CREEP)


def continue_history(engine: Engine, *parts: Tree) -> None:
    """Let a new simulation continue the histories `parts` of heat or creep.

    The histories must be on the grid of the simulation. An empty history has no effect.
    """
    if any(parts):
        kept = engine.snapshot()
        content = dict(kept.state)
        for part in parts:
            content |= part
        content.pop("contact_gap", None)  # of the surfaces before wear; computed when needed
        engine.restore(replace(kept, state=content))


def widened(creep: Tree, old: Grid, grid: Grid) -> Tree:
    """Return the result of `creep_of` for a larger grid with the same centre."""
    before = [(n - m) // 2 for n, m in zip(grid.surface_shape, old.surface_shape, strict=True)]
    wider = dict(creep)
    for name in _FIELDS:
        if name in creep and len(creep[name]):
            wider[name] = _centred(creep[name], old, grid, before)
    for name in _MEMORIES:
        if creep.get(name) is not None:
            i, j, *size = np.asarray(creep[name]["box"]).tolist()
            wider[name] = {**creep[name], "box": [i + before[0], j + before[1], *size]}
    return wider


def _centred(field: FloatArray, old: Grid, grid: Grid, before: list[int]) -> FloatArray:
    larger = np.zeros(grid.surface_shape)
    i, j = before
    larger[i : i + old.nx, j : j + old.ny] = np.reshape(field, old.surface_shape)
    return larger.ravel()


def _parts_of(state: State, names: tuple[str, ...]) -> Tree:
    content = Snapshot.of(state).state
    return {name: content[name] for name in names if name in content}
