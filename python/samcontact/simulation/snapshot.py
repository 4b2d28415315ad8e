# SPDX-License-Identifier: GPL-3.0-or-later
"""Plain data of a simulation, for checkpoint files, pickles and copies."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any

import numpy as np

from ..problem.domain import SurfaceGeometry
from ..problem.settings import Settings
from ..problem.setup import SimulationSetup
from ..restart.tree import Tree

if TYPE_CHECKING:
    from ..heat import Heat
    from ..problem.grid import Grid
    from ..solutions.state import State


@dataclass(frozen=True)
class Snapshot:
    """Complete data of a simulation at the end of an increment."""

    arguments: dict[str, Any]
    """Arguments of `Simulation`."""
    state: Tree
    """Components of the state of the simulation, as the compiled core stores them."""
    counters: dict[str, int]

    @classmethod
    def of(cls, state: State) -> Snapshot:
        """Return the snapshot of the simulation at a state."""
        given = state.setup.on_domain(state.domain, state.heat)
        content = state._core.content()
        if "contact_gap" in content:
            # Only finite numbers are stored; the core knows the cells without a body.
            open_gap = content["contact_gap"]
            content["contact_gap"] = np.where(np.isfinite(open_gap), open_gap, 0.0)
        return cls(given, content, state.counters())

    def setup(self) -> tuple[SimulationSetup, Grid, Heat]:
        """Setup, grid and heat of the simulation."""
        given = self.arguments
        surfaces = SurfaceGeometry(*(given[name] for name in ("gap", "relief1", "relief2")))
        settings = Settings(**{item.name: given[item.name] for item in fields(Settings)})
        setup = SimulationSetup(given["body1"], given["body2"], surfaces, settings)
        return setup, given["grid"], given["heat"]
