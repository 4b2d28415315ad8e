# SPDX-License-Identifier: GPL-3.0-or-later
"""A simulation as plain data: for its file, and for pickles and copies of it and its states."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any

from ..restart.tree import Tree
from ..scene.domain import SurfaceGeometry
from ..scene.settings import Settings
from ..scene.setup import SimulationSetup

if TYPE_CHECKING:
    from ..heat import Heat
    from ..scene.grid import Grid
    from ..solutions.state import State


@dataclass(frozen=True)
class Snapshot:
    """All that makes a simulation again, standing where it stood."""

    arguments: dict[str, Any]
    """Arguments of `Simulation`."""
    state: Tree
    """Parts of its state, as the core describes them."""
    counters: dict[str, int]

    @classmethod
    def of(cls, state: State) -> Snapshot:
        """A simulation as it stood in a state."""
        given = state.setup.on_domain(state.domain, state.heat)
        return cls(given, state._core.content(), state.counters())

    def setup(self) -> tuple[SimulationSetup, Grid, Heat]:
        """Setup, grid and heat of the simulation."""
        given = self.arguments
        surfaces = SurfaceGeometry(*(given[name] for name in ("gap", "relief1", "relief2")))
        settings = Settings(**{item.name: given[item.name] for item in fields(Settings)})
        setup = SimulationSetup(given["body1"], given["body2"], surfaces, settings)
        return setup, given["grid"], given["heat"]
