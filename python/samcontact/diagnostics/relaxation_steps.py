# SPDX-License-Identifier: GPL-3.0-or-later
"""Warning of a sudden load that is applied too slowly for the relaxation of the bodies."""

from __future__ import annotations

import math
from dataclasses import dataclass

from .._util.display import quantity
from ..bodies.viscoelastic import relaxation_of
from ..solutions.state import State

MIN_JUMP, MAX_HOLD = 0.5, 0.01
"""Change of the load in an increment, relative to the larger load, that is a jump or a hold."""
MIN_SHARE = 0.01
"""Share of the modulus from which a relaxation time counts."""
MAX_TIMES = 3.0
"""Duration of an increment over a relaxation time up to which the time is resolved."""


@dataclass
class RelaxationSteps:
    """Observer of increments: a jump of the load in a long increment, then a constant load.

    Remembered tractions change linearly with time in an increment. If the load was applied at its
    start, the relaxation since then is missing; a load that continues to rise is a ramp.
    """

    jump: str = ""
    """Text about the last increment if the load jumped in it."""
    warned: bool = False

    def warning(self, before: State, after: State) -> str:
        """Text of the warning after an increment, "" for none."""
        duration, largest = after.time - before.time, max(after.load, before.load)
        change = abs(after.load - before.load)
        if self.jump and change <= MAX_HOLD * largest and duration > 0:
            self.warned = True
            return self.jump
        jumps = change >= MIN_JUMP * largest > 0 and 0 < duration < math.inf
        self.jump = self._text(before, after, duration) if jumps else ""
        return ""

    def _text(self, before: State, after: State, duration: float) -> str:
        for number, body in enumerate(after.setup.bodies, 1):
            terms = relaxation_of(body)
            if terms is None:
                continue
            fast = [tau for tau, share in zip(*terms, strict=True) if share >= MIN_SHARE]
            if fast and duration > MAX_TIMES * min(fast):
                return (
                    f"the load changes from {quantity(before.load, 'N')} to "
                    f"{quantity(after.load, 'N')} in an increment of {quantity(duration, 's')} and "
                    f"is then constant, but body {number} relaxes with the time "
                    f"{quantity(min(fast), 's')}: the change counts as steady during the "
                    "increment; apply it with duration = 0, then short increments (paths.creep), "
                    "or in several increments if it is slow"
                )
        return ""
