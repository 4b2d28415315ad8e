# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat of a contact: flux into each body, and its partition between the bodies.

The heat flux into a body is its heat factor times the pressure, q = Q_f p. In full sliding Q_f =
beta mu V, where beta is the fraction of the heat that enters this body, mu the coefficient of
friction and V the sliding speed (Boucly 2008, section 2.1.3). In partial slip there are two kinds
of heat. One flux is a fraction of the frictional power, q = beta s . w/t, with the shear traction s
and the slip w in an increment of duration t. The other flux, Q_f p, is not due to slip, e.g. heat
from a hotter body through a conductance that is proportional to the pressure.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, fields

from numpy.typing import ArrayLike

from ._util.checks import (
    finite,
    finite_array,
    non_negative,
    number,
    positive,
    real_array,
    value_per_body,
)
from ._util.short_text import in_short
from .bodies.material import Material

__all__ = ["factors", "partition"]

Pair = tuple[float, float]


@dataclass(frozen=True, init=False, repr=False)
class Heat:
    """Heating of a contact, for `ContactSolver` and `Simulation`.

    The attributes equal the parameters; factor and velocity are stored for both bodies: (Q_1, Q_2)
    and ((V_x, V_y), (V_x, V_y)).

    Parameters
    ----------
    factor : float or pair of floats, optional
        Q_f >= 0 [m/s]: heat flux per unit pressure, a number for body 2 or a pair for bodies 1 and
        2. In full sliding, `factors` computes this pair. In partial slip (only in a `Simulation`),
        this heat flux is not due to slip but to another cause, e.g. a hotter body. Heated bodies
        must have thermal constants. Default: 0, no heating.
    velocity : array_like, shape (2,) or (2, 2), optional
        Velocity (V_x, V_y) of body 2, or velocities of bodies 1 and 2, relative to the contact and
        thus to the heat source [m/s]. Default: at rest.
    time : float, optional
        Duration for which the current heat flux has acted [s], > 0. Default: infinite (steady
        state).
    history : pair of floats, optional
        Pair (shortest, longest) [s], 0 < shortest <= longest, for transient heating with load
        history in a `Simulation`, instead of `time`. Time steps are at least `shortest` long. The
        heat of earlier steps is taken into account for the time `longest`. Each step then requires
        a `duration`.
    reference : float, optional
        Distance [m] from a steady point source at rest at which its thermal surface displacement is
        zero by definition; in a layered body, this is the displacement of the substrate. The
        definition is needed because the displacement has no limit far away. The choice affects only
        the approach. Required under approach control; default under load control: 1 m.
    partition : float, optional
        Fraction beta of the frictional power that enters body 2, in [0, 1]; the rest enters body 1.
        See the function `partition`. Only with `Coulomb` friction in a `Simulation`, instead of
        `factor`. Each step then requires a `duration`; the heat flux is the mean over this
        duration.
    track : float or pair of floats, optional
        Longest distance along x between two positions of a body [m], > 0, or a pair of such
        distances along x and y; only with `history` and instead of `velocity`. The heat then
        follows the travel of the bodies, which may stop, turn and return unloaded, as in several
        passes. The memory grows with these distances. Default: each body has the constant
        velocity `velocity`, and does not return.

    Raises
    ------
    ValueError, TypeError
        An argument has an invalid value or type.
    """

    factor: Pair
    velocity: tuple[Pair, Pair]
    time: float | None
    history: Pair | None
    reference: float | None
    partition: float | None
    track: float | Pair | None

    def __init__(
        self,
        factor: float | Sequence[float] = 0.0,
        velocity: ArrayLike | None = None,
        time: float | None = None,
        history: Sequence[float] | None = None,
        reference: float | None = None,
        partition: float | None = None,
        track: float | Sequence[float] | None = None,
    ) -> None:
        if history is not None and time is not None:
            raise ValueError("history and time cannot be combined: set one of them to None")
        factors = value_per_body("factor", factor)
        checked = {
            "factor": factors,
            "velocity": _velocities(velocity),
            "time": None if time is None else positive("time", time),
            "history": None if history is None else _history(history),
            "reference": None if reference is None else positive("reference", reference),
            "partition": None if partition is None else _share("partition", partition),
            "track": None if track is None else _track(track),
        }
        if track is not None and history is None:
            raise ValueError(
                f"track requires history, got {in_short(track)}: set history, or omit track"
            )
        if track is not None and checked["velocity"] != _AT_REST:
            raise ValueError(
                f"velocity cannot be combined with track, got {in_short(velocity)}: the bodies "
                "move as each step states; omit velocity"
            )
        if partition is not None and any(factors):
            raise ValueError(
                f"factor must be 0 with partition, got {in_short(factor)}: the heat flux follows "
                "from the slip, not from the pressure"
            )
        for name, value in checked.items():
            object.__setattr__(self, name, value)

    @property
    def shares(self) -> Pair:
        """Heat flux into each body per unit pressure [m/s]; with `partition`, shares of it [-]."""
        return self.factor if self.partition is None else (1.0 - self.partition, self.partition)

    @property
    def tracks(self) -> Pair:
        """Lengths of the track along x and y [m]; zeros without a track."""
        if self.track is None:
            return 0.0, 0.0
        return self.track if isinstance(self.track, tuple) else (self.track, 0.0)

    @property
    def march(self) -> tuple[float, float, float, float]:
        """Both times of `history` [s] and both lengths of `tracks` [m]; zeros if not given."""
        return (*(self.history or (0.0, 0.0)), *self.tracks)

    def __repr__(self) -> str:
        """Constructor call with all arguments that differ from their defaults."""
        given = {field.name: getattr(self, field.name) for field in fields(self)}
        shown = {n: v for n, v in given.items() if v is not None and v != _AT_REST}
        return f"Heat({', '.join(f'{name}={value!r}' for name, value in shown.items())})"


_AT_REST = ((0.0, 0.0), (0.0, 0.0))


def _share(name: str, value: float) -> float:
    share = number(name, value)
    if not 0.0 <= share <= 1.0:
        raise ValueError(f"{name} must be in [0, 1], got {share!r}")
    return share


def _track(track: float | Sequence[float]) -> float | Pair:
    """Return the track along x, or the tracks along x and y [m]."""
    if real_array("track", track).ndim == 0:
        return positive("track", track)
    along_x, along_y = finite_array("track", track, (2,)).tolist()
    pair = non_negative("track", along_x), non_negative("track", along_y)
    if not any(pair):
        raise ValueError(f"track must be > 0 along x or y [m], got {in_short(track)}")
    return pair


def _velocities(velocity: ArrayLike | None) -> tuple[Pair, Pair]:
    """Return the velocities (Vx, Vy) of both bodies [m/s]; a single velocity applies to body 2."""
    if velocity is None:
        return _AT_REST
    if real_array("velocity", velocity).ndim == 1:
        v = finite_array("velocity", velocity, (2,))
        return (0.0, 0.0), (float(v[0]), float(v[1]))
    both = finite_array("velocity", velocity, (2, 2))
    return (float(both[0, 0]), float(both[0, 1])), (float(both[1, 0]), float(both[1, 1]))


def _history(history: Sequence[float]) -> Pair:
    given = list(history) if real_array("history", history).ndim == 1 else []
    if len(given) != 2:
        raise ValueError(f"history must be a pair (shortest, longest) [s], got {in_short(history)}")
    shortest, longest = (positive("history", value) for value in given)
    if not shortest <= longest:  # equal: a single step
        raise ValueError(
            f"history must be (shortest, longest) with shortest <= longest, got {given!r}"
        )
    return shortest, longest


def factors(friction: float, speed: float, partition: float = 1.0) -> tuple[float, float]:
    """Return the heat flux per unit pressure, Q_f, into each body: the argument `factor` of `Heat`.

    Parameters
    ----------
    friction : float
        Coefficient of friction mu >= 0 [-].
    speed : float
        Sliding speed [m/s], >= 0.
    partition : float, optional
        Fraction beta of the heat that enters body 2, in [0, 1]; see `partition`.

    Returns
    -------
    tuple of float
        Heat factors [m/s]: (1 - beta) mu V of body 1 and beta mu V of body 2.

    Raises
    ------
    ValueError
        An argument is outside its range.
    """
    total = non_negative("friction", friction) * non_negative("speed", speed)
    if not math.isfinite(total):
        raise ValueError(f"friction times speed must be finite, got {friction!r} and {speed!r}")
    share = _share("partition", partition)
    return (1.0 - share) * total, share * total


def partition(
    body1: Material, body2: Material, radius: float, velocity1: float = 0.0, velocity2: float = 0.0
) -> float:
    """Return the fraction of heat into body 2 for equal maximum temperatures of both bodies [-].

    Parameters
    ----------
    body1, body2 : Material
        Materials with thermal constants.
    radius : float
        Contact radius [m].
    velocity1, velocity2 : float, optional
        Speed of each body through the contact [m/s].

    Returns
    -------
    float
        Heat partition coefficient beta, in (0, 1). The maximum temperature under a parabolic source
        of radius a is taken as proportional to 1/(k sqrt(1.273 + Pe)), with the conductivity k, the
        diffusivity kappa and the Peclet number Pe = V a/(2 kappa): X. Tian, F. E. Kennedy, J.
        Tribol. 116 (1994) 167-174, doi:10.1115/1.2927035. Without motion, beta is k2/(k1 + k2), as
        proposed by Charron.

    Raises
    ------
    ValueError
        A body has no thermal constants, or an argument is outside its range.
    """
    radius = positive("radius", radius)
    taken = []
    for name, body, velocity in (("body1", body1, velocity1), ("body2", body2, velocity2)):
        if not isinstance(body, Material):
            raise TypeError(f"{name} must be a samcontact.Material, got {in_short(body)}")
        if body.thermal is None:
            raise ValueError(f"{name} must have thermal constants: set them with with_thermal()")
        conductivity, _, diffusivity = body.thermal
        speed = abs(finite(name.replace("body", "velocity"), velocity))
        taken.append(conductivity * math.sqrt(1.273 + speed * radius / (2.0 * diffusivity)))
    return taken[1] / (taken[0] + taken[1])
