# SPDX-License-Identifier: GPL-3.0-or-later
"""Warnings of increments or cells that do not resolve the relaxation of viscoelastic bodies."""

from __future__ import annotations

import math
from dataclasses import dataclass

from .._util.display import quantity
from .._util.errors import IncrementWarning, ResolutionWarning
from ..bodies.relaxation import creep_terms
from ..bodies.viscoelastic import relaxation_of
from ..solutions.state import State

MIN_JUMP, MAX_HOLD = 0.5, 0.01
"""Minimum change of the load in an increment that counts as a jump, and maximum change that counts
as a constant load. Both are relative to the larger load of the increment."""
MIN_SHARE = 0.01
"""Minimum share, i.e. relaxing fraction of the modulus, for which a relaxation time counts."""
MAX_TIMES = 3.0
"""Maximum duration of an increment that resolves a relaxation, divided by the relaxation time."""


CREEP_CELLS = 0.02, 1.0
"""Range of the creep distance [cells] in which cells do not resolve the creep of moving material.
The creep distance is the speed times the creep time. Below the range, the material has its
long-time modulus everywhere."""


@dataclass
class RelaxationSteps:
    """Checks whether increments and cells resolve the relaxation of viscoelastic bodies.

    A load jump in a long increment, followed by a constant load, causes a warning. Tractions are
    assumed to change linearly with time in an increment. If the load was in fact applied at the
    start of the increment, part of the relaxation during the increment is missing. A load that
    continues to rise is a ramp and causes no warning.
    """

    jump: str = ""
    """Text of the warning about the last increment if the load jumped in that increment."""
    warned: bool = False
    coarse: bool = False
    """Whether the warning about cells that do not resolve the creep was issued."""

    def warnings(self, before: State, after: State) -> list[UserWarning]:
        """Return the warnings after an increment; each is issued once."""
        found: list[UserWarning] = []
        if text := self._jump_text(before, after):
            found.append(IncrementWarning(text))
        if text := self._coarse_text(before, after):
            found.append(ResolutionWarning(text))
        return found

    def _coarse_text(self, before: State, after: State) -> str:
        """Text of the warning if moving material creeps within less than a cell; otherwise ""."""
        duration = after.time - before.time
        if self.coarse or not 0 < duration < math.inf or after.load == 0:
            return ""
        cell = after.grid.dx
        moved = zip(after.travel, before.travel, strict=True)
        for number, (body, (now, then)) in enumerate(
            zip(after.setup.bodies, moved, strict=True), 1
        ):
            terms = relaxation_of(body)
            if terms is None or now == then:
                continue
            shares, times, _ = creep_terms(terms)
            if not (counts := shares >= MIN_SHARE * shares.sum()).any():
                continue
            reach = abs(now - then) / duration * float(times[counts].max())
            if CREEP_CELLS[0] * cell < reach < CREEP_CELLS[1] * cell:
                self.coarse = True
                return (
                    f"the material of body {number} creeps within {quantity(reach, 'm')} as it "
                    "moves through the contact, which is less than a cell "
                    f"({quantity(cell, 'm')}): the resistance to its motion is not resolved; use "
                    "smaller cells or, if this resistance is negligible, an elastic body with the "
                    "long-time modulus"
                )
        return ""

    def _jump_text(self, before: State, after: State) -> str:
        """Text of the warning if the load has jumped and is now constant; otherwise ""."""
        if self.warned:
            return ""
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
                    f"is then constant, but the relaxation time of body {number} is only "
                    f"{quantity(min(fast), 's')}. The load is assumed to change steadily during "
                    "the increment. Apply a sudden change with duration = 0, and then use short "
                    "increments (paths.creep); divide a slow change into several increments"
                )
        return ""
