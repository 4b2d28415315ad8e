# SPDX-License-Identifier: GPL-3.0-or-later
"""The smallest ball around points: the amplitude of a path of stress, about the best centre."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain, combinations

import numpy as np

from .._checks import FloatArray

_ROUNDING = 1e-12


def enclosing_radius(points: FloatArray, unless: float = 0.0) -> float:
    """Radius of the smallest ball that holds points, shape (n, 2) or (n, 3).

    The farthest point joins those on the ball, whose ball is found among all of them, until none is
    farther (the radius grows each time, so that it ends). Where it is seen at once not to be larger
    than `unless`, that is returned.
    """
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
    distance = np.linalg.norm(points - middle, axis=1)
    if distance.max() <= unless:
        return unless
    first = int(distance.argmax())
    centre, radius, rim = points[first], 0.0, [first]
    while True:
        distance = np.linalg.norm(points - centre, axis=1)
        farthest = int(distance.argmax())
        if distance[farthest] <= radius * (1.0 + _ROUNDING) or farthest in rim:
            return radius
        centre, radius, rim = _ball_through(points, rim, farthest)


def _ball_through(
    points: FloatArray, rim: Sequence[int], newest: int
) -> tuple[FloatArray, float, list[int]]:
    """Smallest ball around few points, which has the newest of them on its surface."""
    near = points[[*rim, newest]]
    subsets = chain.from_iterable(combinations(rim, n) for n in range(1, len(rim) + 1))
    best: tuple[FloatArray, float, list[int]] | None = None
    for subset in subsets:
        chosen = points[[newest, *subset]]
        sides = chosen[1:] - chosen[0]
        middle = np.linalg.lstsq(2.0 * sides, np.sum(sides**2, axis=1), rcond=None)[0]
        radius, centre = float(np.linalg.norm(middle)), chosen[0] + middle
        holds = np.linalg.norm(near - centre, axis=1).max() <= radius * (1.0 + _ROUNDING)
        if holds and (best is None or radius < best[1]):
            best = centre, radius, [newest, *subset]
    assert best is not None  # the ball of all of them is among them
    return best
