# SPDX-License-Identifier: GPL-3.0-or-later
"""Extrapolation of values to zero cell size and infinitely many increments, with error estimates.

All functions accept several quantities at once, along the last axis of the arrays.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray

REFINEMENT_RATIO = 2.0**0.5
"""Ratio of the cell sizes of successive grids."""
MIN_ORDER, MAX_ORDER = 0.9, 4.0
"""Range of observed convergence orders for which values are extrapolated; the extrapolation uses
the observed order, but at most `ASSUMED_ORDER`."""
ASSUMED_ORDER = 2.0
SAFETY_FACTOR = 1.5
"""Estimated error divided by the difference between the last two grids. With convergence of order
1.5 the true ratio is 1.47, with order 2 it is 1."""
MIN_RELATIVE_ERROR = 0.002
"""Minimum estimated relative error on the coarsest grid. It is needed because a difference between
grids may vanish by chance. On finer grids the minimum decreases with the order of convergence."""
_ROUNDING_ERROR = 1e-12
"""Relative difference between grids below which a quantity counts as prescribed, i.e. exact."""
MIN_EXTRAPOLATION_ERROR = 0.5
"""Minimum error of an extrapolated value, as a fraction of the change due to extrapolation."""
MIN_CORRECTION_CHANGE = 0.03
"""Minimum relative change that is assumed for an increment correction between a coarse grid and the
finest grid. An increment correction extrapolates a value to infinitely many increments."""
CORRECTION_CHANGE_PER_GRID = 3.0
"""Relative change that is assumed for an increment correction, divided by the relative difference
of the values between the coarse grid and the finest grid."""

REGULAR_RATIOS = {1: (1.4, 3.0), 2: (1.4, 6.0)}
"""Range of the ratio c(n)/c(2 n) in which convergence counts as regular. The key is the highest
possible order of convergence; c(n) is the correction of a value that was computed with n
increments. The ratio is 2 for order 1 and 4 for order 2. Outside the range, the irregular part
c(n) - 2 c(2 n) of the correction may change on a finer grid."""

MIN_AREA_CORRECTION_CHANGE = 0.3
"""Relative error added for the contact area, as a fraction of the relative correction of the
maximum pressure. It is needed because the area on a coarse grid changes only by whole cells."""


class Estimate(NamedTuple):
    """Estimated values and their absolute errors, as arrays of equal shape."""

    values: FloatArray
    errors: FloatArray
    extrapolated: FloatArray
    """Whether each value is extrapolated."""


def extrapolate_grids(series: ArrayLike, lowest: ArrayLike = ASSUMED_ORDER) -> Estimate:
    """Extrapolate values to zero cell size, from grids refined by the factor `REFINEMENT_RATIO`.

    Parameters
    ----------
    series : array_like, shape (grids, ...)
        Values from the coarsest to the finest grid. With a single grid, errors are infinite.
    lowest : array_like, optional
        Lowest order of convergence of each quantity (last axis). Quantities whose lowest order is
        below `ASSUMED_ORDER` are not extrapolated, because their differences scatter.

    Returns
    -------
    Estimate
        Extrapolated values, if the last three differences between successive grids have the same
        sign and their ratios give convergence orders from `MIN_ORDER` to `MAX_ORDER`; otherwise,
        the values of the finest grid. The error of an extrapolated value is its difference from the
        value extrapolated without the finest grid, but at least `MIN_EXTRAPOLATION_ERROR` times the
        change due to extrapolation.

        The error of a value that is not extrapolated is a factor times the maximum of the last
        three differences, each scaled to the finest grid with the lowest order m. The factor is
        `SAFETY_FACTOR`, but at least 1/(`REFINEMENT_RATIO`^m - 1): with order m, all further
        differences add up to this multiple of the last difference. The relative error is at least
        `MIN_RELATIVE_ERROR` on the first grid; this minimum decreases with order m on finer grids.
    """
    f = np.asarray(series, dtype=np.float64)
    if len(f) == 1:
        unknown = np.where(f[0] == 0, 0.0, np.inf)
        return Estimate(f[0], unknown, np.zeros(f[0].shape, dtype=bool))
    steps = np.diff(f, axis=0)
    last = steps[-1]
    order = np.asarray(lowest, dtype=np.float64)
    ratio = REFINEMENT_RATIO**-order  # of differences on successive grids
    scaled = [
        np.abs(step) * REFINEMENT_RATIO ** (-order * age)
        for age, step in enumerate(steps[::-1][:3])
    ]
    floor = MIN_RELATIVE_ERROR * REFINEMENT_RATIO ** (-order * (len(f) - 1)) * np.abs(f[-1])
    widest = np.max(scaled, axis=0)  # zero for prescribed quantities
    left = np.maximum(SAFETY_FACTOR, ratio / (1.0 - ratio))
    varies = widest > _ROUNDING_ERROR * np.abs(f[-1])
    careful = np.where(varies, np.maximum(left * widest, floor), 0.0)
    if len(f) < 4:
        return Estimate(f[-1], careful, np.zeros(last.shape, dtype=bool))
    with np.errstate(divide="ignore", invalid="ignore"):
        orders = [np.log(steps[i - 1] / steps[i]) / np.log(REFINEMENT_RATIO) for i in (-1, -2)]
        clean = np.all([(each >= MIN_ORDER) & (each <= MAX_ORDER) for each in orders], axis=0)
        clean &= np.asarray(lowest) >= ASSUMED_ORDER
        order = np.where(clean, np.clip(orders[0], MIN_ORDER, ASSUMED_ORDER), ASSUMED_ORDER)
    beyond = last / (REFINEMENT_RATIO**order - 1.0)
    before = f[-2] + steps[-2] / (REFINEMENT_RATIO**order - 1.0)
    errors = np.maximum(np.abs(f[-1] + beyond - before), MIN_EXTRAPOLATION_ERROR * np.abs(beyond))
    return Estimate(np.where(clean, f[-1] + beyond, f[-1]), np.where(clean, errors, careful), clean)


def extrapolate_increments(steps: ArrayLike, used: int = 0, max_order: int = 1) -> Estimate:
    """Estimate the change of a value if the number of increments goes to infinity.

    Parameters
    ----------
    steps : array_like, shape (runs, ...)
        Change of the value when the number of increments is doubled, for each successive doubling;
        at least one doubling.
    used : int, optional
        Index in `steps` of the doubling from n to 2 n increments, where n is the number of
        increments with which the value was computed.
    max_order : {1, 2}, optional
        Highest order of convergence in the number of increments. With 1, the order is taken as 1;
        with 2, the observed order is used, limited to the range from 1 to 2.

    Returns
    -------
    Estimate
        Limit for infinitely many increments minus the value.
    """
    d = np.asarray(steps, dtype=np.float64)
    last = d[-1]
    rest = _further(d, max_order)
    left = np.abs(last)
    if len(d) > 1:
        fastest = np.abs(rest - last / (2.0**max_order - 1.0))  # the observed order may still rise
        shift = np.abs(last + rest - _further(d[:-1], max_order))
        left = np.maximum(np.maximum(shift, fastest), 0.1 * left)
    return Estimate(d[used:].sum(axis=0) + rest, left, np.ones(left.shape, dtype=bool))


def _further(d: FloatArray, max_order: int) -> FloatArray:
    """Return the change of a value in all further doublings of the number of increments.

    d: change of the value in each known doubling, shape (runs, ...). With convergence of order 1,
    all further doublings together change the value as much as the last known doubling.
    """
    last: FloatArray = d[-1]
    if max_order == 1 or len(d) == 1:
        return last
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.nan_to_num(d[-2] / last, nan=2.0)
    return np.asarray(last / (np.clip(ratio, 2.0, 2.0**max_order) - 1.0))


def by_grid(coarse: FloatArray, finest: FloatArray) -> FloatArray:
    """Estimate the relative change of an increment correction from a coarse to the finest grid.

    An increment correction extrapolates a value to infinitely many increments.

    Parameters
    ----------
    coarse, finest : ndarray
        Values on a coarse and on the finest grid, computed with equal numbers of increments.
    """
    size = np.abs(finest)
    change = np.divide(np.abs(finest - coarse), size, out=np.zeros_like(size), where=size > 0)
    return np.maximum(CORRECTION_CHANGE_PER_GRID * change, MIN_CORRECTION_CHANGE)


def irregular(more: FloatArray, doubled: FloatArray, max_order: int = 1) -> FloatArray:
    """Return the irregular part of increment corrections, see `REGULAR_RATIOS`.

    Parameters
    ----------
    more, doubled : ndarray
        Corrections of values computed with n and with 2 n increments.
    max_order : {1, 2}, optional
        Highest order of convergence in the number of increments.

    Returns
    -------
    ndarray
        Magnitude of the irregular part of each correction; zero where the ratio of the two
        corrections is within `REGULAR_RATIOS`.
    """
    low, high = REGULAR_RATIOS[max_order]
    inside = (
        (more * doubled > 0)
        & (abs(more) >= low * abs(doubled))
        & (abs(more) <= high * abs(doubled))
    )
    return np.where(inside, 0.0, np.abs(more - 2.0 * doubled))


def combined(found: Estimate, parts: Sequence[int]) -> Estimate:
    """Return the maximum of each group of values, and the error of this maximum.

    The error accounts for the values and errors of the whole group.

    Parameters
    ----------
    found : Estimate
        Estimates of all values; the groups follow each other along the last axis.
    parts : sequence of int
        Number of values in each group.
    """
    ends = np.cumsum(parts)
    columns: list[tuple[FloatArray, ...]] = []
    for first, end in zip(ends - parts, ends, strict=True):
        values, errors, extrapolated = (array[..., first:end] for array in found)
        largest = values.max(axis=-1)
        above = (values + errors).max(axis=-1) - largest
        below = largest - (values - errors).max(axis=-1)
        known = np.asarray(extrapolated.all(axis=-1))
        columns.append((largest, np.maximum(above, below), known))
    return Estimate(*(np.stack(column, axis=-1) for column in zip(*columns, strict=True)))
