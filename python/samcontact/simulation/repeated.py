# SPDX-License-Identifier: GPL-3.0-or-later
"""The same simulation again, from its start, with other arguments or on coarser cells."""

from __future__ import annotations

from typing import Any

from ..heat import Heat
from .coarsening import coarser
from .simulation import Simulation


def remade(simulation: Simulation, **changes: Any) -> Simulation:
    """The same simulation at its start, but for some arguments."""
    setup = simulation.engine.setup
    return _silent(simulation, setup.on_grid(simulation.grid, simulation.heat) | changes)


def coarsened(simulation: Simulation, heat: Heat) -> Simulation:
    """The same simulation at its start with this heat, over cells twice as long, wide and deep.

    Raises ValueError where the grid cannot be halved, see `coarser`.
    """
    setup, domain = coarser(simulation.engine.setup, simulation.engine.domain)
    return _silent(simulation, setup.on_grid(domain.grid, heat))


def _silent(simulation: Simulation, arguments: dict[str, Any]) -> Simulation:
    made = type(simulation)(**arguments)
    made.monitor.checks_increments = False  # it is for those who judge a simulation
    return made
