# SPDX-License-Identifier: GPL-3.0-or-later
"""Repetition of a simulation from its start, with other arguments or on a coarsened grid."""

from __future__ import annotations

from typing import Any

from ..heat import Heat
from .coarsening import coarser
from .restoring import without_estimates
from .simulation import Simulation


def remade(simulation: Simulation, **changes: Any) -> Simulation:
    """Return the simulation at its start, with some arguments changed."""
    setup = simulation.engine.setup
    arguments = setup.on_grid(simulation.grid, simulation.heat) | changes
    found: Simulation = without_estimates(type(simulation), arguments)
    return found


def coarsened(simulation: Simulation, heat: Heat) -> Simulation:
    """Return the simulation at its start, on a grid coarsened by 2 along x, y and z.

    Raises ValueError where the grid cannot be halved, see `coarser`.
    """
    setup, domain = coarser(simulation.engine.setup, simulation.engine.domain)
    arguments = setup.on_grid(domain.grid, heat)
    found: Simulation = without_estimates(type(simulation), arguments)
    return found
