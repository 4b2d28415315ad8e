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

    @property
    def has_travelled(self) -> bool:
        """Whether a body is displaced through the contact, along x or y."""
        return any((*self.travel, *self.lateral_travel))


def rows_of_travel(state: MovingState) -> Rows:
    """Return the table rows of the travel of bodies that moved, along x and along y."""
    rows: list[tuple[str, str]] = []
    for name, travels in (("", state.travel), (" along y", state.lateral_travel)):
        if any(travels):
            rows += [(f"travel{name}, body {n}", quantity(travels[n - 1], "m")) for n in (1, 2)]
    return rows


def require_path_along_x(state: MovingState, body: int) -> None:
    """Raise ValueError for fields along the path of a body that is displaced along y."""
    if state.lateral_travel[body - 1] != 0.0:
        raise ValueError(
            "states must not be displaced along y for fields along the path on a body, got "
            f"{state.lateral_travel[body - 1]:.6g} m for body {body}: use the fields of the "
            "states, on their grids"
        )
