# SPDX-License-Identifier: GPL-3.0-or-later
"""Frictional heat: what goes into each body, and how hot it gets there.

The flux into a body is its heat factor times the pressure, q = Q_f p, Q_f = beta mu V with beta the
share of this body, mu the coefficient of friction and V the speed of sliding (Boucly 2008, section
2.1.3).
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ._checks import finite, non_negative, number, positive

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
    if not math.isfinite(total):
        raise ValueError(f"friction times speed must be finite, got {friction!r} and {speed!r}")
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
        1/(k sqrt(1.273 + Pe)), Pe = V a/(2 kappa). X. Tian, F. E. Kennedy, J. Tribol. 116 (1994)
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
        speed = abs(finite(name.replace("body", "velocity"), velocity))
        taken.append(conductivity * math.sqrt(1.273 + speed * radius / (2.0 * diffusivity)))
    return taken[1] / (taken[0] + taken[1])
