# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments of heat that the contact solver and the simulation share."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._checks import finite_array, non_negative, positive, real_array

if TYPE_CHECKING:
    from .grid import Grid
    from .material import Material

MOST_HEAT_WAY = 1e7
"""Largest speed times extent of the grid over diffusivity [-]: the work grows with it."""


def pair(heat_factor: float | Sequence[float]) -> tuple[float, float]:
    """Checked heat factors of both bodies; a single number is that of body 2."""
    given = (
        [0.0, heat_factor]
        if np.ndim(heat_factor) == 0
        else list(real_array("heat_factor", heat_factor))
    )
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


def require_range(grid: Grid, bodies: tuple[Material, Material], entries: list[Any]) -> None:
    """Refuse what the kernels of heat would, in the words of the user's arguments."""
    extent = max(grid.nx * grid.dx, grid.ny * grid.dy)
    for n, (body, entry) in enumerate(zip(bodies, entries, strict=True), 1):
        factor, _, _, diffusivity, vx, vy, since, _ = entry.values()
        if not factor > 0 or body.thermal is None:
            continue
        speed, fastest = math.hypot(vx, vy), MOST_HEAT_WAY * diffusivity / extent
        if speed > fastest:
            raise ValueError(
                f"velocity of body {n} must be at most {fastest:.4g} m/s on this grid "
                f"({extent:.4g} m long, diffusivity {diffusivity:.4g} m^2/s), got {speed:.4g} m/s"
            )
        least = 1e-55 * diffusivity / min(grid.dx, grid.dy)
        if 0 < speed < least:
            raise ValueError(
                f"velocity of body {n} must be 0 or at least {least:.3g} m/s, got {speed:.3g} m/s"
            )
        longest = 1e55 * min(grid.dx, grid.dy) ** 2 / diffusivity
        if longest < since < math.inf:
            raise ValueError(
                f"heating_time must be at most {longest:.3g} s, or left out for ever, "
                f"got {since:.3g} s"
            )


def march(
    heat_history: Sequence[float] | None, heating_time: float | None
) -> tuple[float, float] | None:
    """Checked shortest step and longest time of a march in time [s]."""
    if heat_history is None:
        return None
    if heating_time is not None:
        raise ValueError("give heat_history or heating_time, not both")
    given = list(heat_history) if np.ndim(heat_history) == 1 else []
    if len(given) != 2:
        raise ValueError(
            f"heat_history must be a pair (shortest, longest) [s], got {heat_history!r}"
        )
    shortest, longest = (positive("heat_history", value) for value in given)
    if not shortest <= longest:  # equal: a single step
        raise ValueError(
            f"heat_history must be (shortest, longest) with shortest <= longest, got {given!r}"
        )
    return shortest, longest


def require_reference(entries: list[Any], reference: float | None) -> None:
    """For a given approach: heat at rest in the steady state displaces relative to a distance."""
    if reference is None and any(entry.needs_reference for entry in entries):
        raise ValueError(
            "heat_reference must be given with an approach: the displacement of a steady source at "
            "rest has no limit far away, it is zero at this distance [m] of a point source"
        )
