# SPDX-License-Identifier: GPL-3.0-or-later
"""Path of a contact or heat source that travels over the bodies in any direction."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import (
    MAX_INCREMENTS_OF_PATH,
    choice,
    exactly_one,
    finite_array,
    load_or_approach,
    positive,
    real_array,
)
from .._util.short_text import in_short
from .ramps import Path


def traverse(
    points: ArrayLike,
    *,
    step: float,
    load: float | None = None,
    approach: float | None = None,
    pressure: ArrayLike | None = None,
    slider: int | None = None,
    speed: float | None = None,
) -> Path:
    """Move the contact over the bodies along straight legs between points of the x-y plane.

    The bodies move in the opposite direction. Motion along y is not supported for viscoelastic
    bodies or for bodies with reliefs or inclusions, see `Simulation.step`. The bodies are loaded
    from the first step on; unload them with a step ``{"load": 0.0}``.

    Parameters
    ----------
    points : array_like, shape (n, 2)
        Positions (x, y) of the contact on the bodies [m], at least two: the start, and the ends of
        the legs.
    step : float
        Maximum length of a step [m], > 0. All steps of a leg are equally long.
    load, approach, pressure : optional
        Load [N] or approach [m] during the motion, or prescribed pressure [Pa], shape (nx, ny).
        Exactly one must be given.
    slider : {1, 2}, optional
        The body on which the contact stays; the other one moves. Default: both bodies move, as in
        rolling or under a heat source that travels over the contact.
    speed : float, optional
        Speed of the contact [m/s], > 0: sets the duration of each step. For a heat history, set
        `track` of the heat to the extents of the path along x and y.

    Returns
    -------
    list of dict
        Steps for `Simulation.run`.

    Raises
    ------
    ValueError
        Not exactly one of load, approach and pressure is given, two successive points coincide, or
        a value is outside its range.

    Examples
    --------
    >>> for step in traverse([(0, 0), (4e-5, 0), (4e-5, 2e-5)], step=2e-5, load=3.0, slider=1):
    ...     print(step)
    {'load': 3.0, 'advance': (0.0, -2e-05)}
    {'load': 3.0, 'advance': (0.0, -2e-05)}
    {'load': 3.0, 'advance': ((0.0, 0.0), (0.0, -2e-05))}
    """
    name = exactly_one(load=load, approach=approach, pressure=pressure)
    target: Any
    if pressure is None:
        name, target = load_or_approach(load, approach)
    else:
        target = finite_array("pressure", pressure)
    moving = (True, True)
    if slider is not None:
        moving = (choice("slider", slider, (1, 2)) == 2, slider == 1)
    if speed is not None:
        speed = positive("speed", speed)
    longest = positive("step", step)
    steps: Path = []
    for number, (start, end) in enumerate(pairwise(_corners(points))):
        leg = [q - p for p, q in zip(start, end, strict=True)]
        length = math.hypot(*leg)
        if length == 0.0:
            raise ValueError(
                f"points must differ from one to the next, got {tuple(start)!r} twice, as points "
                f"{number} and {number + 1}: omit one of them"
            )
        parts = length / longest * (1.0 - 1e-12)
        if len(steps) + parts > MAX_INCREMENTS_OF_PATH:
            raise ValueError(
                f"step must yield at most {MAX_INCREMENTS_OF_PATH} steps in all, got "
                f"{in_short(step)} m: lengths are in metres"
            )
        count = max(1, math.ceil(parts))
        x, y = (-d / count + 0.0 for d in leg)
        advance: Any = tuple(x if moves else 0.0 for moves in moving)
        if y != 0.0:
            advance = tuple((x, y) if moves else (0.0, 0.0) for moves in moving)
        one: dict[str, Any] = {name: target, "advance": advance}
        if speed is not None:
            one["duration"] = length / count / speed
        steps += [dict(one) for _ in range(count)]
    return steps


def _corners(points: ArrayLike) -> list[list[float]]:
    given = real_array("points", points)
    if given.ndim != 2 or given.shape[0] < 2 or given.shape[1] != 2:
        raise ValueError(
            f"points must have shape (n, 2), n >= 2: positions (x, y) [m], got {in_short(points)}"
        )
    corners: list[list[float]] = np.asarray(finite_array("points", points)).tolist()
    return corners
