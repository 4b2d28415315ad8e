# SPDX-License-Identifier: GPL-3.0-or-later
"""Display of a simulation as a table of its setup and current state."""

from __future__ import annotations

from typing import Any

from .._util.display import Rows, counts, lengths, quantity
from ..bodies.display import material_in_short


def _friction(law: Any) -> str:
    return quantity(law) if isinstance(law, float) else repr(law)


def simulation_rows(simulation: Any) -> Rows:
    """Return the table rows that describe the setup and the current state of a simulation."""
    grid, state = simulation.grid, simulation.state
    cells = counts(*(grid.volume_shape if grid.nz > 0 else grid.surface_shape))
    sizes = lengths(*(size for size in (grid.dx, grid.dy, grid.dz) if size is not None))
    return [
        ("grid", f"{cells} cells of {sizes}"),
        ("body 1", material_in_short(simulation.body1)),
        ("body 2", material_in_short(simulation.body2)),
        ("friction", _friction(simulation.friction)),
        ("tolerance", quantity(simulation.tol)),
        ("load", quantity(state.load, "N")),
        ("approach", quantity(state.approach, "m")),
        ("maximum pressure", quantity(float(state.pressure.max()), "Pa")),
    ]
