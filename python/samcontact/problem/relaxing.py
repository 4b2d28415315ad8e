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
        _require_no_extrapolation(bodies, heat, settings)
        require_known_stress(heat, bodies, grid)
    return heat


def _require_no_extrapolation(bodies: tuple[Body, Body], heat: Heat, settings: Settings) -> None:
    """Raise ValueError for increment_tol with heat.history, which would advance the creep twice."""
    yields = any(body.is_plastic for body in bodies)
    if heat.history is not None and settings.increment_tol is not None and yields:
        require_no_relaxation(
            "increment_tol and heat.history together are not supported with viscoelastic bodies; "
            "omit increment_tol",
            *bodies,
        )


def require_known_stress(heat: Heat, bodies: tuple[Body, Body], grid: Grid) -> None:
    """Raise ValueError if heat enters a viscoelastic body on a grid with layers.

    The expansion of the body does not depend on its modulus, but its thermal stress relaxes.
    """
    name = "heat.factor" if heat.partition is None else "heat.partition (fraction of the heat)"
    for n, (body, share) in enumerate(zip(bodies, heat.shares, strict=True), 1):
        if share > 0 and relaxes(body) and grid.has_volume:
            raise ValueError(
                f"{name} must be 0 for viscoelastic body{n} on a grid with layers, got {share!r}: "
                "the relaxation of the thermal stress in this body is not computed; omit grid.dz "
                "(pressure and displacement are exact without it), or let all heat enter the other "
                "body"
            )


def relaxing_duration(duration: Any) -> float:
    """Check and return the duration of an increment [s]; infinite for the long-time state.

    A duration of 0 is an elastic step. It passes this check, but heating may require more than 0.
    """
    if duration is None:
        raise ValueError(
            "duration is required because a body is viscoelastic: give the duration of the "
            "increment [s], 0 for an elastic step"
        )
    return (
        math.inf if number("duration", duration) == math.inf else non_negative("duration", duration)
    )
