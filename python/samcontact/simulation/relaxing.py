# SPDX-License-Identifier: GPL-3.0-or-later
"""Long-time state of a simulation with viscoelastic bodies."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from .._util.checks import choice
from ..bodies.relaxation import long_time_share
from ..bodies.viscoelastic import relaxation_of, relaxes
from ..solutions.state import State

if TYPE_CHECKING:
    from .engine import Engine


class HasLongTimeState:
    """Base class of `Simulation` with the relaxed state of viscoelastic bodies."""

    engine: Engine
    step: Any

    def relax(self, hold: str | None = None) -> State:
        """Advance to the long-time state under the present load or approach.

        All relaxation ends: the state is that of elastic bodies with the long-time moduli, whatever
        the earlier states. `State.time` is unchanged, and `State.viscous_work` counts an
        infinitely slow change from the present to the relaxed displacement, at which the
        dissipation on the way is not resolved.

        Parameters
        ----------
        hold : {"load", "approach"}, optional
            Quantity that remains constant. Default: that of the last step; the load after a
            checkpoint or `State` was restored.

        Returns
        -------
        State

        Raises
        ------
        ValueError
            No body is viscoelastic, or one is a fluid (shares of sum 1), which never comes to rest.
        """
        bodies = self.engine.setup.bodies
        if not relaxes(*bodies):
            raise ValueError("relax requires a viscoelastic body, see Material.with_relaxation")
        for n, body in enumerate(bodies, 1):
            terms = relaxation_of(body)
            if terms is not None and long_time_share(terms) == 0:
                raise ValueError(
                    f"shares of body{n} must have a sum < 1 for relax, got 1: a fluid flows "
                    "without limit and has no long-time state"
                )
        given = self._last_drive() if hold is None else choice("hold", hold, ("load", "approach"))
        state = self.engine.state
        relaxed: State = self.step(**{given: getattr(state, given)}, duration=math.inf)
        return relaxed

    def _last_drive(self) -> str:
        last = (self.engine.history.steps or [{}])[-1]
        return "approach" if "approach" in last else "load"
