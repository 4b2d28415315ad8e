# SPDX-License-Identifier: GPL-3.0-or-later
"""Increment to the long-time state of viscoelastic bodies."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from .._util.checks import choice
from ..bodies.relaxation import long_time_share
from ..bodies.viscoelastic import relaxation_of, relaxes

if TYPE_CHECKING:
    from .engine import Engine


def relaxing_step(engine: Engine, hold: str | None) -> dict[str, Any]:
    """Return the arguments of `Simulation.step` for the long-time state.

    hold: which of "load" and "approach" is kept; None: the one that the last step prescribed.

    Raises ValueError if no body is viscoelastic, or if one is a fluid.
    """
    bodies = engine.setup.bodies
    if not relaxes(*bodies):
        raise ValueError("relax requires a viscoelastic body, see Material.with_relaxation")
    for n, body in enumerate(bodies, 1):
        terms = relaxation_of(body)
        if terms is not None and long_time_share(terms) == 0:
            raise ValueError(
                f"for relax, the relaxation shares of body{n} must have a sum < 1, got 1: a fluid "
                "flows without limit and has no long-time state"
            )
    if hold is None:
        last = (engine.history.steps or [{}])[-1]
        hold = "approach" if "approach" in last else "load"
    given = choice("hold", hold, ("load", "approach"))
    return {given: getattr(engine.state, given), "duration": math.inf}
