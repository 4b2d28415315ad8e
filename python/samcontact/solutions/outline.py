# SPDX-License-Identifier: GPL-3.0-or-later
"""Outline of a contact in the cells of its grid, and steps of the gap beside it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._core import contact_outline
from .._util.checks import FloatArray
from ..scene.contact_law import in_contact

RISE = 1.05
"""Pressure of a cell at a sharp edge over that of its neighbour further inside, at least."""
STEP = 8.0
"""Height of a step over the bends of the gap beside it."""

Ints = NDArray[np.intp]
_BLOCK = 1 << 18
"""Cells that are looked at together, for the memory of it."""
_MARGIN = 5
"""Cells around a contact, in which all lies that says whether its edge is sharp."""


def around(inside: NDArray[np.bool_], periodic: str) -> tuple[slice, slice]:
    """Rows and columns of the contact with a margin; all of them where the grid is periodic."""
    found = []
    for axis, name in enumerate("xy"):
        at = np.flatnonzero(inside.any(axis=1 - axis))
        if name in periodic or at.size == 0:
            found.append(slice(None))
        else:
            found.append(slice(max(0, int(at[0]) - _MARGIN), int(at[-1]) + 1 + _MARGIN))
    return found[0], found[1]


class Outline(NamedTuple):
    """Outline of a contact in the cells of its grid."""

    cells: int
    """Cells in contact."""
    sides: int
    """Sides of `sides_of` in all."""
    reach: int
    """Cells: contact reaches from so many before the largest pressure to one less behind it, along
    x and y, so that its spot is twice as wide at least."""
    rises: bool
    """Whether the pressure rises to a side of the contact, from the next cell further inside."""
    largest: float
    """Pressure [Pa]."""


def outline_of(pressure: ArrayLike, periodic: str = "") -> Outline:
    """Outline of the contact under a pressure >= 0 [Pa], shape (nx, ny); periodic: as of a Grid."""
    field = np.asarray(pressure, dtype=np.float64)
    return Outline(*contact_outline(field, "x" in periodic, "y" in periodic, RISE))


class Sides(NamedTuple):
    """Cells with a neighbour of another kind along an axis; step: +1 or -1, towards it."""

    i: Ints
    j: Ints
    axis: int
    step: int

    def neighbours(self, shape: tuple[int, ...], cells: int = 1) -> tuple[Ints, Ints]:
        """Rows and columns so many cells further out; around the end of the grid."""
        moved = [self.i, self.j]
        moved[self.axis] = (moved[self.axis] + self.step * cells) % shape[self.axis]
        return moved[0], moved[1]


def away_from_border(sides: Sides, shape: tuple[int, ...], periodic: str) -> Sides:
    """The sides on whose both sides all cells that `steps_beside` looks at are in the grid."""
    if "xy"[sides.axis] in periodic:
        return sides
    at, n = (sides.i if sides.axis == 0 else sides.j), shape[sides.axis]
    ends = at - 2 * sides.step, at + 3 * sides.step
    whole = (np.minimum(*ends) >= 0) & (np.maximum(*ends) < n)
    return sides._replace(i=sides.i[whole], j=sides.j[whole])


def sides_of(inside: NDArray[np.bool_], periodic: str) -> Iterator[Sides]:
    """Sides that cells in contact share with those that are not, of four directions.

    The border of the grid is no side, but where it repeats itself.
    """
    return sides_between(inside, ~inside, periodic)


def sides_between(
    inside: NDArray[np.bool_], beside: NDArray[np.bool_], periodic: str
) -> Iterator[Sides]:
    """Sides that cells of one kind share with those of another, of four directions."""
    for axis, name in enumerate("xy"):
        for step in (1, -1):
            outside = np.roll(beside, -step, axis)
            if name not in periodic:
                border: list[slice | int] = [slice(None), slice(None)]
                border[axis] = -1 if step > 0 else 0
                outside[tuple(border)] = False
            i, j = np.nonzero(inside & outside)
            yield Sides(i, j, axis, step)


def steps_beside(
    sides: Sides, gap: FloatArray, periodic: str
) -> tuple[NDArray[np.bool_], FloatArray]:
    """Whether the gap has a step up at each side, and its height [m].

    A step is higher than what the slopes on both sides can make between two cells, and `STEP` times
    the bends of the gap on both sides. Where there is no body outside (NaN or infinite) it is
    infinitely high.
    """
    heights = [_along(sides, gap, cells, periodic) for cells in range(-2, 4)]
    with np.errstate(invalid="ignore"):
        further_in, inner, own, outer, next_out, further_out = heights
        into, out = own - inner, next_out - outer
        bends = np.abs(into - (inner - further_in)), np.abs(further_out - next_out - out)
        height = outer - own - 0.5 * (into + out)
        least = np.maximum(np.abs(out - into), STEP * np.maximum(*bends))
        # rounding of heights that lie far away
        least = np.maximum(least, 1e-9 * np.abs(own))
        found = np.nan_to_num(height, nan=0.0) > np.nan_to_num(least, nan=0.0, posinf=0.0)
    nothing = ~np.isfinite(outer)
    return np.asarray(found | nothing), np.where(nothing, np.inf, height)


def _along(sides: Sides, gap: FloatArray, cells: int, periodic: str) -> FloatArray:
    """Heights so many cells further out; of the last cell beyond the end of the grid."""
    i, j = sides.i, sides.j
    at = (i if sides.axis == 0 else j) + sides.step * cells
    n = gap.shape[sides.axis]
    at = at % n if "xy"[sides.axis] in periodic else np.clip(at, 0, n - 1)
    found: FloatArray = gap[at, j] if sides.axis == 0 else gap[i, at]
    return found


def may_have_steps(gap: FloatArray, periodic: str) -> bool:
    """Whether the gap of undeformed bodies may have a step between two cells.

    Without one, `steps_beside` finds none at any side that is `away_from_border`.
    """
    if not np.isfinite(gap).all():
        return True
    for axis, name in enumerate("xy"):
        heights = gap if axis == 0 else gap.T
        if name in periodic:  # the cells around its end, several times of few
            heights = heights.take(range(len(heights) + 5), axis=0, mode="wrap")
        columns = max(1, _BLOCK // len(heights))
        for first in range(0, heights.shape[1], columns):
            if _bends_suddenly(heights[:, first : first + columns]):
                return True
    return False


def _bends_suddenly(heights: FloatArray) -> bool:
    """Whether there may be a step along the first axis between two of the heights."""
    rises = heights[1:] - heights[:-1]
    count = max(len(rises) - 4, 0)
    before, into, rise, out, after = [rises[n : n + count] for n in range(5)]
    height = np.abs(rise - 0.5 * (into + out))
    bends = np.maximum(np.abs(into - before), np.abs(after - out))
    return bool((height > np.maximum(np.abs(out - into), STEP * bends)).any())


def has_ridge(pressure: FloatArray, periodic: str = "") -> bool:
    """Whether the pressure of some cell is above that of both neighbours along an axis by `RISE`.

    So it is at every edge to which the pressure rises; a smooth contact has none.
    """
    for axis, name in enumerate("xy"):
        p = pressure if axis == 0 else pressure.T
        if len(p) == 1:
            continue
        neighbours = np.maximum(p[:-2], p[2:])
        if (in_contact(neighbours) & (p[1:-1] > RISE * neighbours)).any():
            return True
        ends = ((p[0], p[1], p[-1]), (p[-1], p[-2], p[0]))
        for own, inner, around_the_end in ends:
            others = np.maximum(inner, around_the_end) if name in periodic else inner
            if (in_contact(others) & (own > RISE * others)).any():
                return True
    return False


def _rising(sides: Sides, pressure: FloatArray) -> NDArray[np.bool_]:
    """Where the pressure is more than further inside, and falls by as much or more beside."""
    own, inner = pressure[sides.i, sides.j], pressure[sides.neighbours(pressure.shape, -1)]
    beside = pressure[sides.neighbours(pressure.shape, 1)]
    found: NDArray[np.bool_] = in_contact(inner) & (own > RISE * inner) & (own > RISE * beside)
    return found
