# SPDX-License-Identifier: GPL-3.0-or-later
"""Retraction of two adhesive bodies until they separate."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from .._util.checks import choice, integer, positive
from .._util.display import ShortRepr
from .._util.errors import IncrementWarning
from .._util.short_text import in_short

MAX_STEPS = 10_000
"""Largest number of increments of a retraction."""
MAX_RISE = 0.05
"""Increase of the tension in the increment that ends at the maximum, relative to the maximum, above
which a warning is issued."""
PAST_MAXIMUM = 0.98
"""Fraction of the maximum tension below which a retraction counts as past the maximum."""


@dataclass(frozen=True)
class Retraction:
    """Retraction of two adhesive bodies until they separate, as a part of a path.

    An entry ``{"pull_off": Retraction()}`` of the path of `Simulation.run` stands for as many
    increments as the separation requires. The approach decreases by `step` in each of them,
    starting from the preceding state; with a machine of finite stiffness, it is the prescribed
    approach of the machine that decreases. The function `pull_off` retracts a simulation
    immediately instead.

    Attributes
    ----------
    step : float or None
        Decrease of the approach in an increment [m], > 0. None: a quarter of the length w/a_max,
        where w is the work of adhesion and a_max the largest attraction of the law of adhesion on
        the grid; for the exponential law, a quarter of its range.
    until : {"apart", "maximum"}
        End of the retraction, as in `pull_off`.
    max_steps : int
        Largest number of increments, from 1 to 10000.
    speed : float or None
        Rate at which the approach decreases [m/s], > 0, for viscoelastic bodies and friction laws
        that require durations.

    Raises
    ------
    ValueError, TypeError
        An attribute has an invalid value or type.
    """

    step: float | None = None
    until: str = "apart"
    max_steps: int = 400
    speed: float | None = None

    def __post_init__(self) -> None:
        for name in ("step", "speed"):
            if (value := getattr(self, name)) is not None:
                object.__setattr__(self, name, positive(name, value))
        choice("until", self.until, ("apart", "maximum"))
        object.__setattr__(self, "max_steps", integer("max_steps", self.max_steps, 1, MAX_STEPS))


@dataclass(frozen=True, repr=False)
class PullOff(ShortRepr):
    """Retraction of two bodies, from `pull_off`.

    Attributes
    ----------
    states : list of State
        States of the retraction; the first is the state before the retraction.
    pull_off : float
        Largest tension [N], >= 0.
    approach : float
        Approach at the largest tension [m].
    work : float
        Work of the external force on the bodies [J], by the trapezoidal rule over the increments:
        negative under a compressive load, positive under tension.
    is_apart : bool
        Whether the surfaces are separated at the end.
    """

    states: Sequence[Any]
    pull_off: float
    approach: float
    work: float
    is_apart: bool


def pull_off(
    simulation: Any,
    *,
    step: float,
    until: str = "apart",
    max_steps: int = 400,
    speed: float | None = None,
) -> PullOff:
    """Retract a simulation with adhesion, until its surfaces separate.

    The approach decreases by `step` in each increment; with a machine of finite stiffness, it is
    the prescribed approach of the machine that decreases. The contact follows its branch of
    equilibrium and jumps apart where the branch ends: past the largest tension with a rigid
    machine, at the largest tension with a soft one. The surfaces count as separated if no cell is
    in contact and the tension has fallen to a hundredth of its maximum.

    Parameters
    ----------
    simulation : Simulation
        Simulation with adhesion; it remains at the last state.
    step : float
        Decrease of the approach in one increment [m], > 0. The largest tension is taken from one
        increment, so its error decreases with the square of the step.
    until : {"apart", "maximum"}, optional
        End of the retraction: when the surfaces are separated, or as soon as the tension is 2 %
        below its maximum (the opening of single cells reduces the tension by less).
    max_steps : int, optional
        Largest number of increments.
    speed : float, optional
        Rate at which the approach decreases [m/s], > 0, for viscoelastic bodies and friction laws
        that require durations.

    Returns
    -------
    PullOff

    Raises
    ------
    ValueError
        Invalid arguments, surfaces without adhesion, or surfaces that are not separated after
        `max_steps` increments.

    Warns
    -----
    IncrementWarning
        The tension rises by more than 5 % of its maximum in the increment that ends at the maximum,
        or it is largest at the start.
    """
    step = positive("step", step)
    retraction = Retraction(step, until, max_steps, speed)
    if not hasattr(simulation, "adhesion") or not hasattr(simulation, "step"):
        raise TypeError(f"simulation must be a samcontact.Simulation, got {in_short(simulation)}")
    if not simulation.adhesion.attracts:
        raise ValueError(
            f"simulation must have adhesion, got adhesion = {simulation.adhesion!r}: without "
            "attraction, the largest tension is 0"
        )
    require_speed(retraction, simulation.engine.setup.needs_duration)
    states = [simulation.state]
    work = 0.0
    for arguments in retraction_increments(
        retraction, lambda: states[-1], step, simulation.stiffness
    ):
        before, state = states[-1], simulation.step(**arguments)
        states.append(state)
        work += 0.5 * (before.load + state.load) * (state.approach - before.approach)
    pulled = max(states, key=lambda state: -state.load)
    most = max(-pulled.load, 0.0)
    return PullOff(states, most, pulled.approach, work, _is_apart(states[-1], most))


def require_speed(retraction: Retraction, needed: bool) -> None:
    """Raise ValueError if a needed speed is missing, or if a speed is given but not needed."""
    if (retraction.speed is not None) != needed:
        raise ValueError(
            "speed must be given if, and only if, a body is viscoelastic or the friction law "
            f"depends on the slip rate, got {retraction.speed!r}: "
            + ("set the speed of the retraction [m/s]" if needed else "omit it")
        )


def retraction_increments(
    retraction: Retraction, current: Callable[[], Any], step: float, stiffness: float | None
) -> Iterator[dict[str, float]]:
    """Iterate over the arguments of the increments; solve each before requesting the next.

    current: function that returns the present state. step: decrease of the approach in an
    increment [m]. stiffness: stiffness of the machine [N/m], None: rigid. Raises ValueError if
    `max_steps` increments do not separate the surfaces. Warns (IncrementWarning) if the
    increments do not resolve the largest tension.
    """
    state = current()
    compliance = 0.0 if stiffness is None else 1.0 / stiffness
    machine = state.approach + compliance * state.load
    lasts = {} if retraction.speed is None else {"duration": step / retraction.speed}
    tension = [-state.load]
    for n in range(1, retraction.max_steps + 1):
        yield {"approach": machine - n * step, **lasts}
        state = current()
        tension.append(-state.load)
        most = max(tension)
        is_past = most > 0 and tension[-1] < PAST_MAXIMUM * most
        if _is_apart(state, most) or (retraction.until == "maximum" and is_past):
            _warn_of_step(tension, step)
            return
    raise ValueError(
        f"max_steps = {retraction.max_steps} increments of {step:.3g} m do not separate the "
        f"surfaces: at the approach {state.approach:.4g} m the tension is {-state.load:.4g} N; "
        "use a larger step or max_steps"
    )


def _is_apart(state: Any, most: float) -> bool:
    """Whether the surfaces are separated; `most`: largest tension so far [N]."""
    return not state.in_contact.any() and -state.load <= 0.01 * max(most, 0.0)


def _warn_of_step(tension: Sequence[float], step: float) -> None:
    """Warn if the increments do not resolve the maximum of the tension."""
    peak = max(range(len(tension)), key=tension.__getitem__)
    if tension[peak] <= 0.0:
        return
    rise = 1.0 if peak == 0 else (tension[peak] - tension[peak - 1]) / tension[peak]
    if rise > MAX_RISE:
        where = "is largest at the start"
        if peak > 0:
            where = f"rises by {100 * rise:.3g} % to its maximum"
        warnings.warn(
            f"the tension {where} in increments of {step:.3g} m, so the pull-off force may be too "
            "small: use a smaller step",
            IncrementWarning,
            stacklevel=4,
        )
