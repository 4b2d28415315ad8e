# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact area, with the contact edge located between the cells of the grid."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._util.checks import FloatArray
from ..problem.contact_law import in_contact
from .outline import Sides, around, sides_of, steps_next_to

AREA_PER_SIDE = (math.pi - 1 + math.log(2)) / 24
"""Mean excess of the area of a contact spot that is found by counting cells, per cell side on the
outline of the spot [cells]."""
MAX_LOCATED_CORRECTION, MIN_COUNTED_CORRECTION = 0.08, 0.14
"""Limits of the perimeter correction, relative to the counted area (in nearly full contact on a
periodic grid, relative to the open area). If the correction is below the first limit, the contact
edge is located from the pressure; if it is above the second limit, only the perimeter correction is
used. The limits correspond to round spots that are 7.5 and 4.3 cells in diameter."""
_EXTRAPOLATION_CELLS = range(1, 5)  # numbered from the edge; used to extrapolate the pressure
_PADDING_CELLS = 4  # cells added around a field


def contact_area(
    pressure: ArrayLike, cell_area: float, periodic: str = "", gap: ArrayLike | None = None
) -> float:
    """Contact area from the pressure in the cells of a grid [m^2].

    Counting the cells under pressure is a method of first order, and nearly always overestimates
    the area. If the contact spots are resolved, the contact edge is located within the cells from
    the squared pressure, which falls linearly to zero at the edge of a smooth contact. This method
    is of second order. If the spots are not resolved, or if the located area would exceed the count
    (nearly full contact), each cell side on the contact outline reduces the count by (pi - 1
    + ln 2)/24 of a cell. This is the mean overestimate of counting, averaged over all directions of
    a smooth edge (Yastrebov, Anciaux and Molinari 2017, doi:10.1016/j.triboint.2017.04.023). For
    intermediate resolution, the area is a weighted mean of the areas by the two methods. Cell sides
    at the edge of the grid or at a step of the gap do not reduce the count, because the contact
    edge lies on these sides.

    Parameters
    ----------
    pressure : array_like, shape (nx, ny)
        Contact pressure [Pa], >= 0; with attraction, the repulsion.
    cell_area : float
        Area of a cell [m^2].
    periodic : {"", "x", "y", "xy"}, optional
        Periodic directions, as for `Grid`.
    gap : array_like, shape (nx, ny), optional
        Separation of the surfaces [m], in which steps are found that bound the contact. By default,
        no steps are considered.
    """
    return _located(pressure, periodic, gap)[0] * cell_area


def perimeter_correction(
    pressure: ArrayLike, periodic: str = "", gap: ArrayLike | None = None
) -> float:
    """Return the perimeter correction of `contact_area`, relative to the contact area [-].

    The correction is the area that `contact_area` subtracts from the area of the counted cells, in
    proportion to the number of their sides on the contact outline. It is 0 if the contact edge is
    located from the pressure. The arguments are those of `contact_area`.
    """
    area, uncertainty = _located(pressure, periodic, gap)
    return uncertainty / area if area > 0 else 0.0


def _located(pressure: ArrayLike, periodic: str, gap: ArrayLike | None) -> tuple[float, float]:
    """Return the contact area, and the perimeter correction by which it was reduced [cells]."""
    field = np.asarray(pressure, dtype=np.float64)
    inside = in_contact(field)
    count = int(np.count_nonzero(inside))
    if count == 0:
        return 0.0, 0.0
    window = around(inside, periodic)
    field, inside = field[window], inside[window]
    if gap is not None:
        gap = np.asarray(gap, dtype=np.float64)[window]
    outline = list(sides_of(inside, periodic))
    on_cells = [_on_cells(sides, gap, periodic) for sides in outline]
    smooth = [int(np.count_nonzero(~fixed)) for fixed in on_cells]
    taken_off = AREA_PER_SIDE * sum(smooth)
    if taken_off == 0:
        return float(count), 0.0
    by_perimeter = max(count - taken_off, 0.5 * count)
    # in nearly full contact, the open spots must be resolved
    reference = min(count, inside.size - count) if set(periodic) == {"x", "y"} else count
    trust = (MIN_COUNTED_CORRECTION - taken_off / reference) / (
        MIN_COUNTED_CORRECTION - MAX_LOCATED_CORRECTION
    )
    if trust <= 0:
        return by_perimeter, taken_off
    steps = [(sides, fixed) for sides, fixed in zip(outline, on_cells, strict=True) if fixed.any()]
    by_pressure = _inside_of_zero_line(field, periodic, steps)
    # the position of a straight edge along the grid is equal in all cells: up to half a cell off
    straight = smooth[0] + smooth[1] == 0 or smooth[2] + smooth[3] == 0
    slack = 0.25 * sum(smooth) if straight else 0.0
    beyond = (by_pressure - count - slack) / (slack or taken_off)
    if beyond > 0:  # nearly full contact: trust decreases with the excess over the count
        trust = min(trust, 1.0) * max(0.0, 1.0 - beyond)
        by_pressure = count + slack
    trust = min(trust, 1.0)
    return by_perimeter + trust * (by_pressure - by_perimeter), (1.0 - trust) * taken_off


def _on_cells(sides: Sides, gap: ArrayLike | None, periodic: str) -> NDArray[np.bool_]:
    """Return, for each cell side, whether a step of the gap fixes the contact edge on this side."""
    if gap is None:
        return np.zeros(len(sides.i), dtype=np.bool_)
    return steps_next_to(sides, np.asarray(gap, dtype=np.float64), periodic)[0]


def _inside_of_zero_line(
    pressure: FloatArray, periodic: str, steps: list[tuple[Sides, NDArray[np.bool_]]]
) -> float:
    """Return the area inside the zero line of the extrapolated squared pressure [cells].

    The squared pressure is extrapolated to the first cells without pressure by a parabola through
    the second to fourth cell from the edge; the first cell is omitted, because its pressure depends
    on the position of the edge in this cell. The extrapolated value is at most zero. At a step of
    the gap, the squared pressure vanishes half-way between the cell centres. The area is summed
    over triangles whose corners are cell centres and the points midway between four of them.
    """
    field = (pressure / pressure.max()) ** 2
    held = np.full(field.shape, np.nan)
    for sides, fixed in steps:
        i, j = sides.neighbours(field.shape)
        held[i[fixed], j[fixed]] = -field[sides.i[fixed], sides.j[fixed]]
    for axis, name in enumerate("xy"):
        width = [(_PADDING_CELLS, _PADDING_CELLS) if n == axis else (0, 0) for n in (0, 1)]
        if name in periodic:
            field, held = (np.pad(f, width, mode="wrap") for f in (field, held))
        else:
            field, held = (
                np.pad(f, width, constant_values=v) for f, v in ((field, 0.0), (held, np.nan))
            )
    level = _continued(field)
    level = np.where(np.isnan(held), level, held)
    rows, columns = (
        slice(_PADDING_CELLS if name in periodic else _PADDING_CELLS - 1, 1 - _PADDING_CELLS)
        for name in "xy"
    )
    return _area_above_zero(level[rows, columns])


def _continued(squared: FloatArray) -> FloatArray:
    """Extrapolate squared pressures to values <= 0 in the adjacent cells without pressure."""
    inside = squared > 0
    level = np.where(inside, squared, np.nan)
    total, weights = np.zeros_like(level), np.zeros_like(level)
    for i, j in ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, 1), (1, -1), (-1, -1)):
        first, second, third, fourth = (
            np.roll(level, (n * i, n * j), (0, 1)) for n in _EXTRAPOLATION_CELLS
        )
        continued = 6.0 * second - 8.0 * third + 3.0 * fourth
        # narrow spots: a line; a single cell ends half-way to its neighbours
        line = 2.0 * first - np.where(np.isnan(second), 3.0 * first, second)
        continued = np.where(np.isnan(continued), line, continued)
        known = np.isfinite(continued)
        weight = 0.5 if i and j else 1.0
        total[known] += weight * continued[known]
        weights[known] += weight
    rim = ~inside & (weights > 0)
    level[rim] = np.minimum(total[rim] / weights[rim], 0.0)
    return np.nan_to_num(level, nan=-1.0)


def _area_above_zero(level: FloatArray) -> float:
    """Area in which values interpolated between lattice points are positive [lattice squares]."""
    corners = (level[:-1, :-1], level[1:, :-1], level[1:, 1:], level[:-1, 1:])
    middle = 0.25 * sum(corners)
    area = 0.0
    for first, second in zip(corners, (*corners[1:], corners[0]), strict=True):
        low, mid, high = np.sort(np.stack([first, second, middle]), axis=0)
        with np.errstate(divide="ignore", invalid="ignore"):
            tip = high**2 / ((high - low) * (high - mid))
            blunt = 1.0 - low**2 / ((mid - low) * (high - low))
        share = np.select([low >= 0, mid >= 0, high > 0], [np.ones_like(low), blunt, tip], 0.0)
        area += 0.25 * float(np.sum(share))
    return area
