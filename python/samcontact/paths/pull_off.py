# SPDX-License-Identifier: GPL-3.0-or-later
"""Retraction of two adhesive bodies until they separate."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from .._util.checks import choice, integer, positive
from .._util.display import ShortRepr
from .._util.errors import IncrementWarning
from .._util.short_text import in_short

MAX_STEPS = 10_000
"""Largest number of increments of a retraction."""
MAX_RISE = 0.05
"""Relative increase of the tension to its maximum in one increment, above which a warning is
issued."""
PAST_MAXIMUM = 0.98
"""Share of the largest tension below which a retraction is past its maximum."""


@dataclass(frozen=True, repr=False)
class PullOff(ShortRepr):
    """Retraction of two bodies, from `pull_off`.

    Attributes
    ----------
    states : list of State
        States of the retraction; the first is the state before it.
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
    simulation: Any, *, step: float, until: str = "apart", max_steps: int = 400
) -> PullOff:
    """Retract a simulation with adhesion, until its surfaces separate.

    The approach, or that of a machine of finite stiffness, decreases by `step` in each increment.
    The contact follows its branch of equilibrium and jumps apart where the branch ends: past the
    largest tension with a rigid machine, at the largest tension with a soft one. The surfaces count
    as separated if no cell is in contact and the tension has fallen to a hundredth of its maximum.

    Parameters
    ----------
    simulation : Simulation
        Simulation with adhesion; it remains at the last state.
    step : float
        Decrease of the approach in one increment [m], > 0. The largest tension is taken from one
        increment, so its error decreases with the square of the step.
    until : {"apart", "maximum"}, optional
        End of the retraction: when the surfaces are separated, or as soon as the tension is 2 %
        below its maximum (single cells that open reduce it by less).
    max_steps : int, optional
        Largest number of increments.

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
        The tension rises by more than 5 % of its maximum in the increment that ends there, or is
        largest at the start.
    """
    step = positive("step", step)
    until = choice("until", until, ("apart", "maximum"))
    max_steps = integer("max_steps", max_steps, 1, MAX_STEPS)
    if not hasattr(simulation, "adhesion") or not hasattr(simulation, "step"):
        raise TypeError(f"simulation must be a samcontact.Simulation, got {in_short(simulation)}")
    if not simulation.adhesion.attracts:
        raise ValueError(
            f"simulation must have adhesion, got adhesion = {simulation.adhesion!r}: without "
            "attraction, the largest tension is 0"
        )
    states = [simulation.state]
    most, where = -states[0].load, states[0].approach
    work = 0.0
    compliance = 0.0 if simulation.stiffness is None else 1.0 / simulation.stiffness
    machine = states[0].approach + compliance * states[0].load
    for n in range(1, max_steps + 1):
        before = states[-1]
        state = simulation.step(approach=machine - n * step)
        states.append(state)
        work += 0.5 * (before.load + state.load) * (state.approach - before.approach)
        if -state.load > most:
            most, where = -state.load, state.approach
        is_apart = not state.in_contact.any() and -state.load <= 0.01 * max(most, 0.0)
        is_past = most > 0 and -state.load < PAST_MAXIMUM * most
        if is_apart or (until == "maximum" and is_past):
            _warn_of_step(states, step)
            return PullOff(states, max(most, 0.0), where, work, bool(is_apart))
    raise ValueError(
        f"max_steps = {max_steps} increments of {step:.3g} m do not separate the surfaces: at the "
        f"approach {states[-1].approach:.4g} m the tension is {-states[-1].load:.4g} N; use a "
        "larger step or max_steps"
    )


def _warn_of_step(states: Sequence[Any], step: float) -> None:
    """Warn if the increments do not resolve the maximum of the tension."""
    tension = [-state.load for state in states]
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
            stacklevel=3,
        )
