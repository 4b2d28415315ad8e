# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat history of a simulation, which another simulation of the same bodies can continue."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from ..restart.tree import Tree
from .snapshot import Snapshot

if TYPE_CHECKING:
    from ..solutions.state import State
    from .engine import Engine

_PARTS = ("past1", "past2", "past_symmetry", "time", "duration")
"""Parts of a state that contain the heat of earlier increments."""


def heat_of(state: State) -> Tree:
    """Return the heat history at an unloaded state as plain data."""
    content = Snapshot.of(state).state
    return {name: content[name] for name in _PARTS if name in content}


def continue_heat(engine: Engine, heat: Tree) -> None:
    """Let a simulation that has not started yet continue a heat history on the same grid."""
    if heat:
        kept = engine.snapshot()
        engine.restore(replace(kept, state={**kept.state, **heat}))
