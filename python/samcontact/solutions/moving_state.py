# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances that the bodies of a state have travelled through the contact."""

from __future__ import annotations

from typing import Any

from .._util.display import Rows, quantity
from ..problem.grid import Grid


class MovingState:
    """Base class of `State` with the travel of both bodies since the start of the simulation."""

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
        """Whether the current position of a body differs from its initial one, along x or y."""
        return any((*self.travel, *self.lateral_travel))


def rows_of_travel(state: MovingState) -> Rows:
    """Return the table rows of the travel of both bodies, for each direction of motion."""
    rows: list[tuple[str, str]] = []
    for name, travels in (("", state.travel), (" along y", state.lateral_travel)):
        if any(travels):
            rows += [(f"travel{name}, body {n}", quantity(travels[n - 1], "m")) for n in (1, 2)]
    return rows


def require_path_along_x(state: MovingState, body: int) -> None:
    """Raise ValueError if a body is displaced along y, because its track then is not along x."""
    if state.lateral_travel[body - 1] != 0.0:
        raise ValueError(
            f"body {body} must not be displaced along y for fields along its track, got a "
            f"displacement of {state.lateral_travel[body - 1]:.6g} m: use the fields of the state, "
            "which cover its grid"
        )
