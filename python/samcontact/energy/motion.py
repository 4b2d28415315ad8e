# SPDX-License-Identifier: GPL-3.0-or-later
"""Travel of the bodies in an increment, and fields on cells that move with the bodies.

In the frame of the contact, a body moves by its travel a. A field f that moves with the body
changes by -a df/dx in a cell of the grid. The change at a point of the body is therefore the change
in the cell plus a df/dx. The work of the mean tractions on a df/dx is the work of the travel.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._util.checks import FloatArray
from ..problem.grid import Grid
from ..solutions.state import State
from ..solutions.track import Track


def slope(grid: Grid, field: FloatArray) -> FloatArray:
    """Return the derivative along x of a surface field, shape (..., nx, ny)."""
    if not grid.along_x:
        return np.asarray(np.gradient(field, grid.dx, axis=-2))
    found: FloatArray = np.roll(field, -1, axis=-2) - np.roll(field, 1, axis=-2)
    return found / (2.0 * grid.dx)


def first_cell(state: State, body: int) -> int:
    """Return the index along x of the cells of a body that lie in the first row of the grid.

    It is 0 before the body has moved.
    """
    place = state.offset(body) - state.travel[body - 1] - state.origin
    return round(place / state.grid.dx)


def over_grid(track: Track, name: str, state: State) -> FloatArray:
    """Return a volume field of a track on the grid of a state; 0 where the track has no cell."""
    field: FloatArray = getattr(track, name)()
    rows = first_cell(state, track.body) + np.arange(state.grid.nx) - track.first
    if state.grid.along_x:
        rows %= track.grid.nx
    inside = (rows >= 0) & (rows < track.grid.nx)
    found = np.zeros((*field.shape[:-3], len(rows), *field.shape[-2:]))
    found[..., inside, :, :] = field[..., rows[inside], :, :]
    return found


@dataclass(frozen=True)
class Motion:
    """Motion of a body between two states on the same grid."""

    before: State
    after: State
    body: int

    @property
    def travel(self) -> float:
        """Travel of the body through the contact [m]."""
        return self.after.travel[self.body - 1] - self.before.travel[self.body - 1]

    @property
    def on_grid(self) -> float:
        """Travel relative to the grid [m], in which the contact may move by fractions of a cell."""
        return self.travel + self.after.origin - self.before.origin

    def convected(self, before: FloatArray, after: FloatArray) -> FloatArray:
        """Return the field `before`, moved with the body to its position at the end of the motion.

        before, after: volume fields at the start and at the end of the motion, shape
        (..., nx, ny, nz). Cells that enter the grid during the motion have the values of `after`.
        """
        cells = first_cell(self.before, self.body) - first_cell(self.after, self.body)
        if cells == 0:
            return before
        if self.after.grid.along_x:
            return np.asarray(np.roll(before, cells, axis=-3))
        rows = np.arange(before.shape[-3]) - cells
        inside = (rows >= 0) & (rows < len(rows))
        found: FloatArray = after.copy()
        found[..., inside, :, :] = before[..., rows[inside], :, :]
        return found

    def change(
        self, tractions: tuple[FloatArray, FloatArray], fields: tuple[FloatArray, FloatArray]
    ) -> float:
        """Return mean tractions times the displacement change of the material, summed over cells.

        Each pair contains the fields before and after the motion [N/m^2 or m], shape (..., nx, ny).
        """
        (t, u), (t_new, u_new) = zip(tractions, fields, strict=True)
        total = float(np.sum(0.5 * (t + t_new) * (u_new - u)))
        return total + self._along(tractions, fields, self.on_grid)

    def work_of_travel(
        self, pressures: tuple[FloatArray, FloatArray], surfaces: tuple[FloatArray, FloatArray]
    ) -> float:
        """Return the work done on a sloped surface that moves through the pressure, per cell area.

        The arrays are the pressure [Pa] and the depth of the surface [m] before and after the
        motion.
        """
        return self._along(pressures, surfaces, self.travel)

    def _along(
        self,
        tractions: tuple[FloatArray, FloatArray],
        fields: tuple[FloatArray, FloatArray],
        travel: float,
    ) -> float:
        if travel == 0.0:
            return 0.0
        grid, parts = self.after.grid, zip(tractions, fields, strict=True)
        return 0.5 * travel * sum(float(np.sum(t * slope(grid, f))) for t, f in parts)


def have_equal_eigenstrain(one: State, other: State) -> bool:
    """Whether the eigenstrain of each body is equal in the common cells of two states."""
    bodies = [n for n in (1, 2) if one.has_eigenstrain(n) or other.has_eigenstrain(n)]
    if not bodies:
        return True
    layers = max(one.layers, other.layers)
    a, b = one.at_layers(layers), other.at_layers(layers)
    for body in bodies:
        now = b.eigenstrain(body)
        if not np.array_equal(Motion(a, b, body).convected(a.eigenstrain(body), now), now):
            return False
    return True
