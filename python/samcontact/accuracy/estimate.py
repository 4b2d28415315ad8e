# SPDX-License-Identifier: GPL-3.0-or-later
"""What a series of values tends to, and how far that may be from the truth.

All of these take values of several quantities at once, along the last axis.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray

RATIO = 2.0**0.5
"""Of cells from one grid to the next."""
LEAST_ORDER, MOST_ORDER = 0.9, 4.0
"""Observed orders that are believed; what is extrapolated has at most `USED_ORDER`."""
USED_ORDER = 2.0
SAFE = 1.5
"""Times a difference of neighbours: a term of order 1.5 leaves 1.47 of its last one, one of order 2
all of it."""
LEAST = 0.002
"""Least relative error of the coarsest grid, falling with order 2: differences may vanish."""
CLEAN = 0.5
"""Least error of an extrapolated value, over what extrapolation changed."""
MIXED = 0.03
"""How much of a correction found on a coarse grid a finer one may change at least."""
PER_GRID = 3.0
"""The same, over the relative difference that the grid itself makes."""

REGULAR = 1.4, 3.0
"""Corrections of n increments over those of 2 n, where they are of first order; elsewhere what is
beyond twice the latter may be different on a finer grid."""

MIXED_AREA = 0.3
"""The same of the contact area, over the relative correction of the largest pressure: on a coarse
grid it moves by whole cells, or not at all."""


class Estimate(NamedTuple):
    """Values with absolute errors, all of one shape."""

    values: FloatArray
    errors: FloatArray
    extrapolated: FloatArray
    """Whether each value is."""


def of_grids(series: ArrayLike) -> Estimate:
    """The limit along grids whose cells shrink by `RATIO`.

    Parameters
    ----------
    series : array_like, shape (grids, ...)
        From the coarsest on. Of a single one nothing is known: its errors are infinite.

    Returns
    -------
    Estimate
        Where three differences have one sign, fall, and show an order within limits twice, the
        value is extrapolated with it. Else it is that of the finest grid, with the largest of the
        last three differences, each scaled to the finest grid with order 2, and `LEAST` at least.
    """
    f = np.asarray(series, dtype=np.float64)
    if len(f) == 1:
        unknown = np.where(f[0] == 0, 0.0, np.inf)
        return Estimate(f[0], unknown, np.zeros(f[0].shape, dtype=bool))
    steps = np.diff(f, axis=0)
    last = steps[-1]
    scaled = [np.abs(step) * RATIO ** (-2 * age) for age, step in enumerate(steps[::-1][:3])]
    least = LEAST * RATIO ** (-2 * (len(f) - 1)) * np.abs(f[-1])
    widest = np.max(scaled, axis=0)  # nothing for what is given
    careful = np.where(widest > 0, np.maximum(SAFE * widest, least), 0.0)
    if len(f) < 4:
        return Estimate(f[-1], careful, np.zeros(last.shape, dtype=bool))
    with np.errstate(divide="ignore", invalid="ignore"):
        orders = [np.log(steps[i - 1] / steps[i]) / np.log(RATIO) for i in (-1, -2)]
        clean = np.all([(order >= LEAST_ORDER) & (order <= MOST_ORDER) for order in orders], axis=0)
        order = np.where(clean, np.clip(orders[0], LEAST_ORDER, USED_ORDER), USED_ORDER)
    beyond = last / (RATIO**order - 1.0)
    before = f[-2] + steps[-2] / (RATIO**order - 1.0)
    errors = np.maximum(np.abs(f[-1] + beyond - before), CLEAN * np.abs(beyond))
    return Estimate(np.where(clean, f[-1] + beyond, f[-1]), np.where(clean, errors, careful), clean)


def of_doublings(steps: ArrayLike, used: int = 0) -> Estimate:
    """What more increments would add to a value: their error is of first order.

    Parameters
    ----------
    steps : array_like, shape (runs, ...)
        What twice as many change, again and again; one at least.
    used : int, optional
        Which of these begins with as many increments as the value.

    Returns
    -------
    Estimate
        Of the limit minus the used value.
    """
    d = np.asarray(steps, dtype=np.float64)
    last = d[-1]  # as much as all that follow
    left = np.abs(last)
    if len(d) > 1:
        left = np.maximum(np.abs(2.0 * last - d[-2]), 0.1 * left)
    return Estimate(d[used:].sum(axis=0) + last, left, np.ones(left.shape, dtype=bool))


def by_grid(coarse: FloatArray, finest: FloatArray) -> FloatArray:
    """How much of corrections found on a coarse grid the finest may change.

    Parameters
    ----------
    coarse, finest : ndarray
        Values in the same number of increments.
    """
    size = np.abs(finest)
    change = np.divide(np.abs(finest - coarse), size, out=np.zeros_like(size), where=size > 0)
    return np.maximum(PER_GRID * change, MIXED)


def irregular(more: FloatArray, twice: FloatArray) -> FloatArray:
    """What is not of first order in the corrections of n increments.

    Parameters
    ----------
    more, twice : ndarray
        Corrections of n and 2 n increments.

    Returns
    -------
    ndarray
        Nothing where their ratio is `REGULAR`.
    """
    low, high = REGULAR
    inside = (more * twice > 0) & (abs(more) >= low * abs(twice)) & (abs(more) <= high * abs(twice))
    return np.where(inside, 0.0, np.abs(more - 2.0 * twice))


def joined(found: Estimate, parts: Sequence[int]) -> Estimate:
    """The largest of several values, with the error that theirs leave it.

    Parameters
    ----------
    found : Estimate
        Of all parts along the last axis.
    parts : sequence of int
        How many belong together, one after the other.
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
