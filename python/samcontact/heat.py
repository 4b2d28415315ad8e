# SPDX-License-Identifier: GPL-3.0-or-later
"""Frictional heat: what goes into each body, and how hot it gets there.

The flux into a body is its heat factor times the pressure, q = Q_f p, Q_f = beta mu V with beta the
share of this body, mu the coefficient of friction and V the speed of sliding (Boucly 2008, section
2.1.3).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._checks import finite_array, non_negative, number, positive

if TYPE_CHECKING:
    from .material import Material

__all__ = ["factors", "partition"]


def factors(friction: float, speed: float, partition: float = 1.0) -> tuple[float, float]:
    """Heat factors Q_f of both bodies, the argument `heat_factor` of solver and simulation.

    Parameters
    ----------
    friction : float
        Coefficient of friction mu >= 0 [-].
    speed : float
        Speed of sliding of the surfaces over each other [m/s], >= 0.
    partition : float, optional
        Share beta of the heat that enters body 2, in [0, 1]; see `partition`.

    Returns
    -------
    tuple of float
        (1 - beta) mu V and beta mu V [m/s], body 1 first.

    Raises
    ------
    ValueError
        An argument is outside its range.
    """
    total = non_negative("friction", friction) * non_negative("speed", speed)
    share = number("partition", partition)
    if not 0.0 <= share <= 1.0:
        raise ValueError(f"partition must be in [0, 1], got {share!r}")
    return (1.0 - share) * total, share * total


def partition(
    body1: Material, body2: Material, radius: float, velocity1: float = 0.0, velocity2: float = 0.0
) -> float:
    """Share of the heat that enters body 2, so that both are equally hot at most.

    Parameters
    ----------
    body1, body2 : Material
        With thermal constants.
    radius : float
        Of the contact [m].
    velocity1, velocity2 : float, optional
        Speed of each body through the contact [m/s].

    Returns
    -------
    float
        beta in (0, 1): the maximum of a parabolic source is taken as proportional to
        1/(k sqrt(1.273 + Pe)), Pe = |V| a/(2 kappa). X. Tian, F. E. Kennedy, J. Tribol. 116 (1994)
        167-174, doi:10.1115/1.2927035; without motion Charron's k2/(k1 + k2).

    Raises
    ------
    ValueError
        A body has no thermal constants, or an argument is outside its range.
    """
    radius = positive("radius", radius)
    taken = []
    for name, body, velocity in (("body1", body1, velocity1), ("body2", body2, velocity2)):
        if body.thermal is None:
            raise ValueError(f"{name} has no thermal constants: give them with with_thermal()")
        conductivity, _, diffusivity = body.thermal
        speed = abs(number(name.replace("body", "velocity"), velocity))
        taken.append(conductivity * math.sqrt(1.273 + speed * radius / (2.0 * diffusivity)))
    return taken[1] / (taken[0] + taken[1])


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
