# SPDX-License-Identifier: GPL-3.0-or-later
"""Travel of the bodies through the contact in a state."""

from __future__ import annotations

from typing import Any

from .._util.display import Rows, quantity
from ..problem.grid import Grid


class MovingState:
    """Travel of both bodies since the start."""

    _core: Any
    grid: Grid

    @property
    def travel(self) -> tuple[float, float]:
        """Accumulated displacement of surfaces 1 and 2 through the contact, along +x [m]."""
        first, second = self._core.travel
        return first * self.grid.dx, second * self.grid.dx

    @property
    def lateral_travel(self) -> tuple[float, float]:
        """Accumulated displacement of surfaces 1 and 2 through the contact, along +y [m]."""
        first, second = self._core.lateral_travel
        return first * self.grid.dy, second * self.grid.dy


def rows_of_travel(state: MovingState) -> Rows:
    """Return the table rows of the travel of bodies that moved, along x and along y."""
    rows: list[tuple[str, str]] = []
    for name, travels in (("", state.travel), (" along y", state.lateral_travel)):
        if any(travels):
            rows += [(f"travel{name}, body {n}", quantity(travels[n - 1], "m")) for n in (1, 2)]
    return rows
