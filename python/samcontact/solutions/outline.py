# SPDX-License-Identifier: GPL-3.0-or-later
"""Outline of a contact on the cells of its grid, and steps of the gap at this outline."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _core
from .._util.checks import FloatArray
from ..problem.contact_law import in_contact

MIN_EDGE_PRESSURE_RATIO = 1.05
"""Minimum pressure in a cell at a sharp edge, divided by the pressure in the next inner cell."""
MIN_STEP_RATIO = 8.0
"""Minimum height of a step of the gap, divided by the change of slope next to the step. Slopes are
differences of the gap between neighbouring cells."""

Ints = NDArray[np.intp]
_MARGIN_CELLS = 5
"""Width of the margin around a contact [cells]; the gap within this margin determines whether the
contact edge is sharp."""


def around(inside: NDArray[np.bool_], periodic: str) -> tuple[slice, slice]:
    """Return slices along x and y that contain the contact and a margin; all cells if periodic."""
    found = []
    for axis, name in enumerate("xy"):
        at = np.flatnonzero(inside.any(axis=1 - axis))
        if name in periodic or at.size == 0:
            found.append(slice(None))
        else:
            found.append(slice(max(0, int(at[0]) - _MARGIN_CELLS), int(at[-1]) + 1 + _MARGIN_CELLS))
    return found[0], found[1]


class Outline(NamedTuple):
    """Size of a contact and length of its outline in cells, and data of its pressure."""

    cells: int
    """Number of cells in contact."""
    sides: int
    """Number of cell sides on the outline, i.e. between cells in contact and open cells."""
    reach: int
    """Number r of cells. Along x and y, all cells are in contact from r cells before the cell of
    maximum pressure to r - 1 cells after it, so the contact is at least 2 r cells wide."""
    rises: bool
    """Whether the pressure in any cell at the outline is higher than in the next inner cell."""
    largest: float
    """Maximum pressure [Pa]."""


def outline_of(pressure: ArrayLike, periodic: str = "") -> Outline:
    """Return the outline of the contact for a pressure >= 0 [Pa]; `periodic` is as for `Grid`."""
    field = np.asarray(pressure, dtype=np.float64)
    return Outline(
        *_core.contact_outline(field, "x" in periodic, "y" in periodic, MIN_EDGE_PRESSURE_RATIO)
    )


class Sides(NamedTuple):
    """Sides, normal to `axis`, of the cells (i, j); `step` is +1 or -1, from a cell to its side."""

    i: Ints
    j: Ints
    axis: int
    step: int

    def neighbours(self, shape: tuple[int, ...], cells: int = 1) -> tuple[Ints, Ints]:
        """Return i and j of the cells that are `cells` cells outwards of the cells (i, j).

        With `cells` < 0, they are inwards. Indices beyond the grid continue at its opposite end.
        """
        moved = [self.i, self.j]
        moved[self.axis] = (moved[self.axis] + self.step * cells) % shape[self.axis]
        return moved[0], moved[1]


def away_from_border(sides: Sides, shape: tuple[int, ...], periodic: str) -> Sides:
    """Return the sides for which all cells used by `steps_next_to` lie inside the grid."""
    if "xy"[sides.axis] in periodic:
        return sides
    at, n = (sides.i if sides.axis == 0 else sides.j), shape[sides.axis]
    ends = at - 2 * sides.step, at + 3 * sides.step
    whole = (np.minimum(*ends) >= 0) & (np.maximum(*ends) < n)
    return sides._replace(i=sides.i[whole], j=sides.j[whole])


def sides_of(inside: NDArray[np.bool_], periodic: str) -> Iterator[Sides]:
    """Yield, for each of four directions, the sides between cells in contact and open cells.

    The edge of the grid does not count as a side, except in a periodic direction.
    """
    return sides_between(inside, ~inside, periodic)


def sides_between(
    inside: NDArray[np.bool_], other: NDArray[np.bool_], periodic: str
) -> Iterator[Sides]:
    """Yield, for each of four directions, the sides from cells of one mask to cells of another."""
    for axis, name in enumerate("xy"):
        for step in (1, -1):
            outside = np.roll(other, -step, axis)
            if name not in periodic:
                border: list[slice | int] = [slice(None), slice(None)]
                border[axis] = -1 if step > 0 else 0
                outside[tuple(border)] = False
            i, j = np.nonzero(inside & outside)
            yield Sides(i, j, axis, step)


def steps_next_to(
    sides: Sides, gap: FloatArray, periodic: str
) -> tuple[NDArray[np.bool_], FloatArray]:
    """Return whether the gap has an upward step at each side, and the height of each step [m].

    Slopes are differences of the gap between neighbouring cells. A jump of the gap is a step if its
    height exceeds both the change of slope across the side and `MIN_STEP_RATIO` times the larger
    change of slope next to the side. Where a body ends at the side (gap NaN or infinite outside),
    the height is infinite.
    """
    heights = [_along(sides, gap, cells, periodic) for cells in range(-2, 4)]
    with np.errstate(invalid="ignore"):
        further_in, inner, own, outer, next_out, further_out = heights
        into, out = own - inner, next_out - outer
        bends = np.abs(into - (inner - further_in)), np.abs(further_out - next_out - out)
        height = outer - own - 0.5 * (into + out)
        threshold = np.maximum(np.abs(out - into), MIN_STEP_RATIO * np.maximum(*bends))
        # rounding of heights with a large offset
        threshold = np.maximum(threshold, 1e-9 * np.abs(own))
        found = np.nan_to_num(height, nan=0.0) > np.nan_to_num(threshold, nan=0.0, posinf=0.0)
    no_body = ~np.isfinite(outer)
    return np.asarray(found | no_body), np.where(no_body, np.inf, height)


def _along(sides: Sides, gap: FloatArray, cells: int, periodic: str) -> FloatArray:
    """Return the gap `cells` cells outwards of the cells of `sides`.

    Beyond the grid, it is the gap of the last cell; in a periodic direction, the gap repeats.
    """
    i, j = sides.i, sides.j
    at = (i if sides.axis == 0 else j) + sides.step * cells
    n = gap.shape[sides.axis]
    at = at % n if "xy"[sides.axis] in periodic else np.clip(at, 0, n - 1)
    found: FloatArray = gap[at, j] if sides.axis == 0 else gap[i, at]
    return found


def may_have_steps(gap: FloatArray, periodic: str) -> bool:
    """Whether the gap of undeformed bodies may have a step between two cells.

    If False, `steps_next_to` finds no step, except perhaps within three cells of the edge of the
    grid, i.e. at sides that `away_from_border` does not return.
    """
    return _core.may_have_steps(gap, "x" in periodic, "y" in periodic, MIN_STEP_RATIO)


def has_ridge(pressure: FloatArray, periodic: str = "") -> bool:
    """Whether in any cell the pressure is higher than in both neighbours along x, or along y.

    Higher means at least by the factor `MIN_EDGE_PRESSURE_RATIO`. Every contact edge towards which
    the pressure rises has such a cell, and a smooth contact has none.
    """
    for axis, name in enumerate("xy"):
        p = pressure if axis == 0 else pressure.T
        if len(p) == 1:
            continue
        neighbours = np.maximum(p[:-2], p[2:])
        if (in_contact(neighbours) & (p[1:-1] > MIN_EDGE_PRESSURE_RATIO * neighbours)).any():
            return True
        ends = ((p[0], p[1], p[-1]), (p[-1], p[-2], p[0]))
        for own, inner, around_the_end in ends:
            others = np.maximum(inner, around_the_end) if name in periodic else inner
            if (in_contact(others) & (own > MIN_EDGE_PRESSURE_RATIO * others)).any():
                return True
    return False


def _rising(sides: Sides, pressure: FloatArray) -> NDArray[np.bool_]:
    """Return, for each side, whether its cell has a higher pressure than both adjacent cells."""
    own, inner = pressure[sides.i, sides.j], pressure[sides.neighbours(pressure.shape, -1)]
    outer = pressure[sides.neighbours(pressure.shape, 1)]
    found: NDArray[np.bool_] = (
        in_contact(inner)
        & (own > MIN_EDGE_PRESSURE_RATIO * inner)
        & (own > MIN_EDGE_PRESSURE_RATIO * outer)
    )
    return found
