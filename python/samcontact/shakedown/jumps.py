# SPDX-License-Identifier: GPL-3.0-or-later
"""Cycles that need not be solved: what the next ones would add, from what the last three did.

The changes d of successive cycles tend to a limit like a geometric series, the limit being zero
where flow comes to rest: with e = d_n - d_(n-1), which is mu times the one before,

    d_(n+j) = d_n + (mu + ... + mu^j) e .

A jump of many cycles (Cojocaru and Karlsson 2006, Int. J. Fatigue 28, 1677-1689) takes their sum.
It is made where it should hold, and kept if the cycle after it is what it said.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from .._util.cached_property import cached_property
from .._util.checks import FloatArray
from ..simulation.simulation import Simulation
from ..solutions.state import State
from .plastic import FIELDS, Change, as_deep, largest, product

MOST = 20
"""Cycles in one jump."""
_STRAY = 0.3
"""Of the change in a cycle: what the sum over a jump may miss by, and what the next cycle may."""
_LEFT = 0.1
"""Of changes that die down, what is left to do by cycles."""
_STEEPEST = 0.98
Changes = Mapping[int, Change]


def norm(fields: Sequence[FloatArray]) -> float:
    return math.sqrt(sum(product(field, field) for field in fields))


@dataclass(frozen=True)
class Trend:
    """Of a field in the last three cycles, of all bodies."""

    oldest: list[FloatArray]
    older: list[FloatArray]
    last: list[FloatArray]

    @cached_property
    def steps(self) -> tuple[list[FloatArray], list[FloatArray]]:
        """By how much the change differed from the one before, then and now."""
        pairs = (self.oldest, self.older), (self.older, self.last)
        then, now = ([b - a for a, b in zip(*pair, strict=True)] for pair in pairs)
        return then, now

    @cached_property
    def factor(self) -> float:
        """mu, in [0, 0.98]."""
        then, now = self.steps
        size = norm(then) ** 2
        cross = sum(product(a, b) for a, b in zip(then, now, strict=True))
        return min(max(cross / size, 0.0), _STEEPEST) if size > 0 else 0.0

    @cached_property
    def unlike(self) -> float:
        """Norm of what mu leaves of the last step."""
        return norm([b - self.factor * a for a, b in zip(*self.steps, strict=True)])

    def weight(self, cycles: int) -> float:
        """How often the last step is in the change of the cycle that many later."""
        return float(np.sum(self.factor ** np.arange(1, cycles + 1)))

    def total(self, cycles: int) -> float:
        """The same of all cycles up to that."""
        return float(np.sum(self.factor ** np.arange(1, cycles + 1) * np.arange(cycles, 0, -1)))

    def later(self, cycles: int) -> list[FloatArray]:
        """Change in the cycle that many later."""
        weight = self.weight(cycles)
        return [d + weight * e for d, e in zip(self.last, self.steps[1], strict=True)]

    def summed(self, cycles: int) -> list[FloatArray]:
        """Change in all cycles up to that."""
        total = self.total(cycles)
        return [cycles * d + total * e for d, e in zip(self.last, self.steps[1], strict=True)]

    def safe_cycles(self, most: int) -> int:
        """Over how many the sum misses little."""
        size = norm(self.last)
        if size == 0:
            return 0
        if self.factor > 0 and norm(self.later(10 * MOST)) < 0.2 * size:  # it dies down
            most = min(most, math.ceil(math.log(_LEFT) / math.log(self.factor)))
        counts = range(1, most + 1)
        # What is unlike may go on as the steps do, and not less than that of a single one does.
        missed = [self.unlike * max(self.total(n), n) for n in counts]
        return sum(miss <= _STRAY * size for miss in missed)


def trend(changes: Sequence[Changes], field: str) -> Trend | None:
    """Of a field in three successive cycles; None where they are on other cells."""
    of_bodies = [as_deep([each[body].of(field) for each in changes]) for body in changes[-1]]
    cells = {tuple((c.first, c.of(field).shape[:-1]) for c in each.values()) for each in changes}
    if len(cells) != 1:
        return None
    return Trend(*([fields[moment] for fields in of_bodies] for moment in range(3)))


@dataclass(frozen=True)
class Jump:
    """Over cycles, from a state."""

    state: State
    cycles: int
    trend: Trend
    """Of the plastic strain, before it."""

    def away(self, found: Changes, after: int = 1) -> list[FloatArray]:
        """What a cycle after it did otherwise than expected."""
        real = (change.of("plastic_strain") for change in found.values())
        expected = self.trend.later(self.cycles + after)
        pairs = [as_deep(pair) for pair in zip(real, expected, strict=True)]
        return [a - b for a, b in pairs if a.shape == b.shape]

    def confirmed(self, found: Changes) -> bool:
        """Whether the cycle after it is as was expected."""
        away = self.away(found)
        return len(away) == len(found) and norm(away) <= _STRAY * norm(self.trend.last)

    def error(self, first: Changes, second: Changes | None = None) -> float:
        """Estimate of the error it has left in the plastic strain [-], from the cycles after it.

        The first one makes up for what the jump has missed; what the second does otherwise has
        grown evenly in the cycles that were left out. Without a second, all of it has.
        """
        missed = max(map(largest, self.away(first)))
        grown = missed if second is None else max(map(largest, self.away(second, 2)), default=0.0)
        return missed + 0.5 * self.cycles * grown


def jump(simulation: Simulation, changes: Sequence[Changes], most: int) -> Jump | None:
    """Make one from the last three cycles where it is safe; None where it is not."""
    flow = trend(changes, "plastic_strain")
    if flow is None or (cycles := flow.safe_cycles(most)) < 2:
        return None
    state, added = simulation.state, {name: trend(changes, name) for name in FIELDS}
    for place, (body, now) in enumerate(changes[-1].items()):
        fields = {}
        for name, each in added.items():
            assert each is not None  # all are on the same cells
            fields[name] = np.add(*as_deep([now.after[name], each.summed(cycles)[place]]))
        accumulated = np.maximum(*as_deep([fields[FIELDS[1]], now.after[FIELDS[1]]]))
        back = fields["backstress"] if len(fields["backstress"]) else None
        simulation.set_plastic_strain(
            body, fields["plastic_strain"], accumulated, back, first=now.first
        )
    return Jump(state, cycles, flow)
