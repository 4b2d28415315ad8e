# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that frictional heating agrees with the motion of the bodies, and with wear."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import Any

from .._util.travels import both_axes
from ..heat import Heat
from ..problem.heating import NO_HEAT
from ..simulation.steps import require_whole_cells


def require_motion_of_heat(case: Any) -> None:
    """Raise ValueError for motion or wear that the kind of heating does not support."""
    heat = NO_HEAT if case.heat is None else case.heat.build()
    if heat.history is None:
        _require_no_return_time(case)
        if case.wear is not None and case.wear.keep_heat:
            raise ValueError("wear.keep_heat requires heat.history: add it, or omit keep_heat")
        return
    _require_track(case, heat)
    if case.grid is not None and heat.tracks[1] == 0:
        require_steps_of_cells(case, 0)


def require_velocity_of_motion(
    heat: Heat, travels: Sequence[Sequence[float]], duration: float
) -> None:
    """Raise ValueError unless heated bodies move at heat.velocity.

    travels: displacements [m], indexed by body and axis. duration: time for these [s].
    """
    axes = "xy" if travels[0][1] or travels[1][1] else "x"
    for body, (n, axis) in itertools.product((1, 2), enumerate(axes)):
        speed, given = travels[body - 1][n] / duration, heat.velocity[body - 1][n]
        if heat.shares[body - 1] > 0 and abs(speed - given) > 1e-6 * max(abs(speed), abs(given)):
            raise ValueError(
                f"heat.velocity must agree with the motion of heated body {body}, "
                f"{speed:.9g} m/s along {axis}, got {given:.9g} m/s: change one of them, or "
                "set heat.track instead of heat.velocity"
            )


def require_steps_of_cells(case: Any, axis: int) -> None:
    """Raise ValueError unless all steps move bodies by whole cells along x (axis 0) or y (1)."""
    name = ("dx", "dy")[axis]
    size = getattr(case.grid, name)
    for number, steps in enumerate(case.steps_of_segments()):
        field, remedy = "advance", "advance or increments"
        if case.path[number].passes is not None:
            kind = "roll" if case.path[number].roll is not None else "slide"
            field, remedy = f"{kind}.step", f"{kind}.step and {kind}.distance"
        for step in steps:
            moved = (both_axes(step.get("advance", (0.0, 0.0)))[:, axis] / size).tolist()
            try:
                require_whole_cells(moved, size, axis)
            except ValueError as error:
                raise ValueError(
                    f"path[{number}].{field}: {error}: change {remedy}, or grid.{name}"
                ) from error


def _require_track(case: Any, heat: Heat) -> None:
    """Raise ValueError if a heated body reverses without heat.track, or moves beyond its track."""
    moved = [both_axes(step.get("advance", (0.0, 0.0))) for step in case.steps()]
    for body, axis in itertools.product((1, 2), (0, 1)):
        moves = [float(step[body - 1, axis]) for step in moved]
        positions = [0.0, *itertools.accumulate(moves)]
        length = max(positions) - min(positions)
        if heat.shares[body - 1] == 0:
            continue
        where = " along y" if axis else ""
        track = heat.tracks[axis]
        if heat.track is not None and length > track * (1.0 + 1e-9):
            raise ValueError(
                f"heat.track{where} must be at least the length of the path of body {body}{where}, "
                f"{length:.9g} m, got {track!r} m: increase heat.track"
            )
        if heat.track is None and min(moves) < 0.0 < max(moves):
            value = f"[length along x, {length:.9g}]" if axis else f"{length:.9g}"
            raise ValueError(
                f"heat.track is required because the path moves heated body {body} back and forth"
                f"{where}: set heat.track = {value} instead of heat.velocity"
            )


def _require_no_return_time(case: Any) -> None:
    for number, segment in enumerate(case.path):
        if segment.passes is not None and segment.passes.return_time is not None:
            raise ValueError(f"path[{number}]: return_time requires heat.history: omit return_time")
