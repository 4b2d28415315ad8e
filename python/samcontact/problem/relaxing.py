# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of the settings and increments of a simulation with viscoelastic bodies."""

from __future__ import annotations

import math
from typing import Any

from .._util.checks import non_negative, number
from ..bodies.layered import Body
from ..bodies.viscoelastic import relaxes, require_no_relaxation
from ..heat import Heat
from .grid import Grid
from .heating import checked_heat
from .settings import Settings


def possible_heat(
    given: Heat | None, bodies: tuple[Body, Body], grid: Grid, settings: Settings
) -> Heat:
    """Check the heat of a simulation against its bodies, grid and settings, and return it."""
    heat = checked_heat(given, bodies, grid, settings.law)
    if relaxes(*bodies):
        _require_possible(bodies, heat)
    return heat


def _require_possible(bodies: tuple[Body, Body], heat: Heat) -> None:
    """Raise ValueError for heat that is not supported with viscoelastic bodies."""
    for name in ("history", "partition"):
        if getattr(heat, name) is not None:
            require_no_relaxation(
                f"heat.{name} is not supported with viscoelastic bodies; set heat.factor", *bodies
            )
    require_cold(heat, bodies)


def require_cold(heat: Heat, bodies: tuple[Body, Body]) -> None:
    """Raise ValueError if heat enters a viscoelastic body, whose thermal stress would relax."""
    for n, (body, factor) in enumerate(zip(bodies, heat.shares, strict=True), 1):
        if factor > 0 and relaxes(body):
            raise ValueError(
                f"heat.factor must be 0 for viscoelastic body{n}, got {factor!r}: its thermal "
                "stress would relax, which is not computed"
            )


def relaxing_duration(duration: Any) -> float:
    """Check and return the duration of an increment [s]; infinite for the long-time state."""
    if duration is None:
        raise ValueError(
            "duration is required because a body is viscoelastic: give the duration of the "
            "increment [s], 0 for an elastic step"
        )
    return (
        math.inf if number("duration", duration) == math.inf else non_negative("duration", duration)
    )
