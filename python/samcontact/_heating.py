# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments of heat that the contact solver and the simulation share."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._checks import finite_array, non_negative, positive

if TYPE_CHECKING:
    from .material import Material


def pair(heat_factor: float | Sequence[float]) -> tuple[float, float]:
    """Checked heat factors of both bodies; a single number is that of body 2."""
    given = [0.0, heat_factor] if np.ndim(heat_factor) == 0 else list(np.asarray(heat_factor))
    if len(given) != 2:
        raise ValueError(f"heat_factor must be a number or a pair, got {len(given)} values")
    return non_negative("heat_factor", given[0]), non_negative("heat_factor", given[1])


def velocities(velocity: ArrayLike | None) -> tuple[tuple[float, float], tuple[float, float]]:
    """Checked (Vx, Vy) of both bodies; a single one is that of body 2."""
    if velocity is None:
        return (0.0, 0.0), (0.0, 0.0)
    if np.ndim(velocity) == 1:
        v = finite_array("velocity", velocity, (2,))
        return (0.0, 0.0), (float(v[0]), float(v[1]))
    both = finite_array("velocity", velocity, (2, 2))
    return (float(both[0, 0]), float(both[0, 1])), (float(both[1, 0]), float(both[1, 1]))


def heating(
    bodies: tuple[Material, Material],
    heat_factor: float | Sequence[float],
    velocity: ArrayLike | None,
    time: float | None,
    reference: float | None,
) -> list[Any]:
    """Arguments of solver and simulation as the core takes them, one entry for each body."""
    since = math.inf if time is None else positive("heating_time", time)
    distance = 1.0 if reference is None else positive("heat_reference", reference)
    entries = []
    for number_, body, factor, v in zip(
        (1, 2), bodies, pair(heat_factor), velocities(velocity), strict=True
    ):
        if factor > 0 and body.is_rigid:
            raise ValueError(f"heat_factor of body{number_} is {factor!r}, but the body is rigid")
        if factor > 0 and body.thermal is None:
            raise ValueError(
                f"heat_factor of body{number_} is {factor!r}, but the body has no thermal "
                "constants: give them with with_thermal()"
            )
        constants = body.thermal or (1.0, 0.0, 1.0)
        entries.append(_core.Heating(factor, *constants, *v, since, distance))
    return entries


def march(
    heat_history: Sequence[float] | None, heating_time: float | None
) -> tuple[float, float] | None:
    """Checked shortest step and longest time of a march in time [s]."""
    if heat_history is None:
        return None
    if heating_time is not None:
        raise ValueError("give heat_history or heating_time, not both")
    given = list(heat_history)
    if len(given) != 2:
        raise ValueError(f"heat_history must be a pair (shortest, longest) [s], got {given!r}")
    shortest, longest = (positive("heat_history", value) for value in given)
    if not shortest < longest:
        raise ValueError(
            f"heat_history must be (shortest, longest) with shortest < longest, got {given!r}"
        )
    return shortest, longest


def require_reference(entries: list[Any], reference: float | None) -> None:
    """For a given approach: heat at rest in the steady state displaces relative to a distance."""
    if reference is None and any(entry.needs_reference for entry in entries):
        raise ValueError(
            "heat_reference must be given with an approach: the displacement of a steady source at "
            "rest has no limit far away, it is zero at this distance [m] of a point source"
        )
