# SPDX-License-Identifier: GPL-3.0-or-later
"""Noise of measured curves: its standard deviation, and non-decreasing least-squares fits."""

from __future__ import annotations

import numpy as np

from .._util.checks import FloatArray

MAX_DEVIATIONS = 6.0
"""Maximum deviation from a fit that counts as noise, in standard deviations of the noise."""
_NORMAL_MEDIAN = 0.6745  # median magnitude of a normal distribution / standard deviation


def noise_of(x: FloatArray, y: FloatArray) -> float:
    """Standard deviation of the noise of a measured curve y(x).

    It follows from the distance of each point from the line through its two neighbours. The median
    of these distances is used, so that a few corners of the curve do not count as noise.
    """
    if len(y) < 3:
        return 0.0
    share = (x[1:-1] - x[:-2]) / (x[2:] - x[:-2])
    off = y[1:-1] - (1 - share) * y[:-2] - share * y[2:]
    weight = np.sqrt(1 + share**2 + (1 - share) ** 2)
    return float(np.median(np.abs(off) / weight)) / _NORMAL_MEDIAN


def non_decreasing(values: FloatArray) -> FloatArray:
    """Non-decreasing least-squares fit of values, by pooling of adjacent violators."""
    means: list[float] = []
    counts: list[int] = []
    for value in values.tolist():
        means.append(value)
        counts.append(1)
        while len(means) > 1 and means[-2] > means[-1]:
            mean, count = means.pop(), counts.pop()
            total = counts[-1] + count
            means[-1] += (mean - means[-1]) * count / total
            counts[-1] = total
    return np.repeat(np.array(means), counts)


def merged(x: FloatArray, y: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the distinct values of a non-decreasing x, each with the mean of y at this x."""
    if not (np.diff(x) == 0).any():
        return x, y
    distinct, group = np.unique(x, return_inverse=True)
    return distinct, np.bincount(group, y) / np.bincount(group)
