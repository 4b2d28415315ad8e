# SPDX-License-Identifier: GPL-3.0-or-later
"""Repetition of a simulation from its start, with other arguments or on a coarsened grid."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from .._util.checks import FloatArray
from ..heat import Heat
from .coarsening import Path, coarser, coarser_path, coarser_strain
from .given_strain import prepare
from .restoring import without_estimates
from .simulation import Simulation


def _eigenstrain(simulation: Simulation, body: int) -> FloatArray:
    """Return the eigenstrain of a body in its initial position, shape (6, nx, ny, layers)."""
    track = simulation.state.track(body, margin=0)
    strain, rows = track.eigenstrain(), track.first + np.arange(track.grid.nx)
    field = np.zeros((6, *simulation.grid.surface_shape, strain.shape[3]))
    inside = (rows >= 0) & (rows < simulation.grid.nx)
    field[:, rows[inside]] = strain[:, inside]
    return field


def rebuilt(simulation: Simulation, **changes: Any) -> Simulation:
    """Return a copy of a simulation with changed arguments, from the same initial state."""
    setup = simulation.engine.setup
    arguments = setup.on_grid(simulation.grid, simulation.heat) | changes
    found: Simulation = without_estimates(type(simulation), arguments)
    for body in (1, 2):
        if simulation.state.has_eigenstrain(body):
            found.add_eigenstrain(body, _eigenstrain(simulation, body))
    prepare(found, simulation.engine.preparation)
    return found


def coarsened_path(simulation: Simulation, path: Path) -> tuple[list[dict[str, Any]], list[int]]:
    """Return a path for the coarsened simulation, see `coarser_path`."""
    return coarser_path(path, simulation.engine.setup.steps_of_motion(simulation.grid))


def coarsened(simulation: Simulation, heat: Heat) -> Simulation:
    """Return a new simulation at its start, with cells twice as large along x, y and z.

    Eigenstrain is averaged over the coarser cells. A preparation (e.g. dents) is repeated on them.

    Raises ValueError if the grid cannot be coarsened, see `coarser`.
    """
    setup, domain = coarser(simulation.engine.setup, simulation.engine.domain)
    arguments = setup.on_grid(domain.grid, heat)
    found: Simulation = without_estimates(type(simulation), arguments)
    for body in (1, 2):
        if simulation.state.has_eigenstrain(body):
            strain = _eigenstrain(simulation, body)
            found.add_eigenstrain(body, coarser_strain(strain, simulation.grid, domain.grid))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # they concern the coarser grid
        prepare(found, simulation.engine.preparation)
    return found
