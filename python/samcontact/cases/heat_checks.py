# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of a case whose heat follows the motion of the bodies, or lasts over cycles."""

from __future__ import annotations

from itertools import accumulate
from typing import Any

from ..heat import Heat
from ..problem.heating import NO_HEAT
from ..simulation.steps import require_whole_cells


def require_motion_of_heat(case: Any) -> None:
    """Raise ValueError for motion or wear that the heat of a case excludes."""
    heat = NO_HEAT if case.heat is None else case.heat.build()
    if heat.history is None:
        _require_no_return_time(case)
        if case.wear is not None and case.wear.keep_heat:
            raise ValueError("wear.keep_heat requires heat.history: set it, or omit keep_heat")
        return
    _require_track(case, heat)
    if case.grid is not None:
        _require_steps_of_cells(case, case.grid.dx)


def _require_steps_of_cells(case: Any, dx: float) -> None:
    """Raise ValueError for a segment whose steps are not whole cells, naming its fields."""
    for number, steps in enumerate(case.steps_of_segments()):
        segment = case.path[number]
        field, remedy = "advance", "advance or increments"
        if segment.passes is not None:
            kind = "roll" if segment.roll is not None else "slide"
            field, remedy = f"{kind}.step", f"{kind}.step and {kind}.distance"
        for step in steps:
            moved = [distance / dx for distance in step.get("advance", ())]
            try:
                require_whole_cells(moved, dx)
            except ValueError as error:
                raise ValueError(
                    f"path[{number}].{field}: {error}: change {remedy}, or grid.dx"
                ) from error


def _require_track(case: Any, heat: Heat) -> None:
    """Raise ValueError if heated bodies return without a track, or travel beyond it."""
    steps = case.steps()
    for body in (1, 2):
        moves = [step.get("advance", (0.0, 0.0))[body - 1] for step in steps]
        positions = [0.0, *accumulate(moves)]
        length = max(positions) - min(positions)
        if heat.shares[body - 1] == 0:
            continue
        if heat.track is not None and length > heat.track * (1.0 + 1e-9):
            raise ValueError(
                f"heat.track must be at least the length of the path of body {body}, "
                f"{length:.9g} m, got {heat.track!r} m: increase heat.track"
            )
        if heat.track is None and min(moves) < 0.0 < max(moves):
            raise ValueError(
                f"heat.track is required because the path moves heated body {body} back and forth: "
                f"set heat.track = {length:.9g} instead of heat.velocity"
            )


def _require_no_return_time(case: Any) -> None:
    for number, segment in enumerate(case.path):
        if segment.passes is not None and segment.passes.return_time is not None:
            raise ValueError(f"path[{number}]: return_time requires heat.history: omit return_time")
