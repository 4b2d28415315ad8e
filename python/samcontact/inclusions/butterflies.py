# SPDX-License-Identifier: GPL-3.0-or-later
"""Butterfly maps: directions around inclusions in which a fatigue criterion is largest."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .._util.checks import BoolArray, FloatArray, integer
from .._util.display import HtmlTable, Rows, ShortRepr
from ..bodies.heterogeneous import Heterogeneous
from ..fatigue.field import FatigueField
from .surroundings import checked_field, checked_within, names_near, surroundings

MAX_SECTORS = 360
_SLICE = 0.5  # half thickness of the section through an inclusion, in radii


@dataclass(frozen=True, repr=False, eq=False)
class ButterflyMap(ShortRepr, HtmlTable):
    """Fatigue criterion in each direction around inclusions, as computed by `butterflies`.

    Attributes
    ----------
    angle : ndarray, shape (sectors,)
        Middle of each sector [rad], from -pi to pi: 0 along x, pi/2 towards the surface.
    count : ndarray of int, shape (sectors,)
        Number of inclusions for which the criterion is largest in this sector.
    relative : ndarray, shape (sectors,)
        Largest value of the criterion in the sector, divided by the largest value around the same
        inclusion; mean over the inclusions of the map. A sector without cells counts as 0.
    numbers : tuple of int
        Indices of the inclusions of the map in `Heterogeneous.inclusions`.
    """

    angle: FloatArray
    count: NDArray[np.intp]
    relative: FloatArray
    numbers: tuple[int, ...]

    @property
    def wings(self) -> FloatArray:
        """Angles of the wings [rad].

        A wing is a sector in which `relative` is not below its value in either neighbouring sector,
        and above 90 % of its maximum.
        """
        r = self.relative
        above = (r >= np.roll(r, 1)) & (r >= np.roll(r, -1)) & (r > 0.9 * r.max())
        return np.asarray(self.angle[above])

    def _rows(self) -> Rows:
        wings = ", ".join(f"{np.degrees(value):.0f}°" for value in self.wings)
        return [("inclusions", str(len(self.numbers))), ("wings", wings or "none")]


def butterflies(
    field: FatigueField, body: Heterogeneous, within: float = 1.5, sectors: int = 36
) -> ButterflyMap:
    """Return a map of the directions around inclusions in which a fatigue criterion is largest.

    Butterflies are wings of altered steel at non-metallic inclusions below a raceway. The map uses
    the cells of the matrix in a section parallel to x and z through each inclusion. The section
    contains the cells up to half a radius on each side of the plane through the centre.

    Parameters
    ----------
    field : FatigueField
        Fatigue criterion for the stresses of a rolling pass along x, e.g. from
        `samcontact.fatigue.dang_van`.
    body : Heterogeneous
        Body for which the field was computed.
    within : float, optional
        Distance from the centre of an inclusion up to which cells are used, in radii. Default: 1.5.
    sectors : int, optional
        Number of sectors, from 4 to 360. Default: 36.

    Returns
    -------
    ButterflyMap

    Raises
    ------
    ValueError
        The field has axes other than x, y and z, or is not above 0 in any cell of the matrix around
        an inclusion; or an argument is outside its range.
    TypeError
        An argument has the wrong type.
    """
    ratio = checked_within(within)
    number = integer("sectors", sectors, 4)
    if number > MAX_SECTORS:
        raise ValueError(f"sectors must be at most {MAX_SECTORS}, got {number}")
    axes = checked_field(field, body)
    around = surroundings(axes, body, ratio)
    sums, counts = np.zeros(number), np.zeros(number, dtype=int)
    used = []
    for n in names_near(around):
        found = _of_one(n, field, body, axes, around.is_matrix & (around.number == n), number)
        if found.max(initial=0.0) <= 0.0:
            continue
        used.append(n)
        sums += found / found.max()
        counts[found.argmax()] += 1
    if not used:
        raise ValueError(
            "field must be > 0 in at least one cell of the matrix around an inclusion, got none"
        )
    middle = -np.pi + 2 * np.pi * (np.arange(number) + 0.5) / number
    return ButterflyMap(middle, counts, sums / len(used), tuple(used))


def _of_one(
    number: int,
    field: FatigueField,
    body: Heterogeneous,
    axes: list[FloatArray],
    where: BoolArray,
    sectors: int,
) -> FloatArray:
    """Largest value of the criterion in each sector around one inclusion."""
    inclusion = body.inclusions[number]
    i, j, k = np.nonzero(where)
    dx, dy, dz = (
        axis[at] - c for axis, at, c in zip(axes, (i, j, k), inclusion.center, strict=True)
    )
    size = float(axes[1][1] - axes[1][0])
    inside = np.abs(dy) <= max(_SLICE * inclusion.extent[1], size / 2 * (1 + 1e-9))
    sector = _sector(np.arctan2(-dz[inside], dx[inside]), sectors)
    largest = np.zeros(sectors)
    np.maximum.at(largest, sector, field.values[i[inside], j[inside], k[inside]])
    return largest


def _sector(angle: FloatArray, sectors: int) -> NDArray[np.intp]:
    return np.asarray(((angle + np.pi) / (2 * np.pi) * sectors).astype(int) % sectors)
