# SPDX-License-Identifier: GPL-3.0-or-later
"""Extrapolation of plastic strain over many cycles, from the changes in the last three cycles.

Let d_n be the change of the plastic strain in cycle n. The changes tend to a limit like a geometric
series; the limit is zero if flow ceases. The difference e = d_n - d_(n-1) is mu times the preceding
difference, so

    d_(n+j) = d_n + (mu + ... + mu^j) e .

A jump over many cycles (Cojocaru and Karlsson 2006, Int. J. Fatigue 28, 1677-1689) adds the sum of
these changes to the strain. The jump is made if the expected error is small, and is undone unless
the next cycle agrees with the prediction.
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
from .plastic import FIELDS, PlasticChange, at_common_depth, max_equivalent, product

MAX_JUMP_CYCLES = 20
"""Maximum number of cycles in one jump."""
_MAX_PREDICTION_ERROR = 0.3
"""Maximum error of a predicted plastic strain, relative to the change per cycle.

This limit applies to the sum of the changes over a jump and to the change in the cycle after the
jump.
"""
_MIN_REMAINING_FRACTION = 0.1
"""Fraction of a decaying change per cycle that must remain after a jump, so that solved cycles
still contribute to the strain."""
_MAX_DECAY_RATIO = 0.98
Changes = Mapping[int, PlasticChange]


def norm(fields: Sequence[FloatArray]) -> float:
    return math.sqrt(sum(product(field, field) for field in fields))


@dataclass(frozen=True)
class Trend:
    """Trend of a field: its changes in each of the last three cycles, for every body."""

    oldest: list[FloatArray]
    older: list[FloatArray]
    last: list[FloatArray]

    @cached_property
    def steps(self) -> tuple[list[FloatArray], list[FloatArray]]:
        """Differences of successive changes (first the earlier difference, then the latest one)."""
        pairs = (self.oldest, self.older), (self.older, self.last)
        then, now = ([b - a for a, b in zip(*pair, strict=True)] for pair in pairs)
        return then, now

    @cached_property
    def factor(self) -> float:
        """Ratio mu of successive differences, in [0, 0.98]."""
        then, now = self.steps
        size = norm(then) ** 2
        cross = sum(product(a, b) for a, b in zip(then, now, strict=True))
        return min(max(cross / size, 0.0), _MAX_DECAY_RATIO) if size > 0 else 0.0

    @cached_property
    def misfit(self) -> float:
        """Norm of (latest difference - mu * preceding difference), with mu = `factor`."""
        return norm([b - self.factor * a for a, b in zip(*self.steps, strict=True)])

    def weight(self, cycles: int) -> float:
        """Return mu + ... + mu^cycles, the factor of the latest difference in `later`."""
        return float(np.sum(self.factor ** np.arange(1, cycles + 1)))

    def total(self, cycles: int) -> float:
        """Return weight(1) + ... + weight(cycles).

        `summed` multiplies the latest difference by this factor.
        """
        return float(np.sum(self.factor ** np.arange(1, cycles + 1) * np.arange(cycles, 0, -1)))

    def later(self, cycles: int) -> list[FloatArray]:
        """Return the predicted change in a single cycle, `cycles` cycles after the last one."""
        weight = self.weight(cycles)
        return [d + weight * e for d, e in zip(self.last, self.steps[1], strict=True)]

    def summed(self, cycles: int) -> list[FloatArray]:
        """Return the predicted sum of the changes in the next `cycles` cycles."""
        total = self.total(cycles)
        return [cycles * d + total * e for d, e in zip(self.last, self.steps[1], strict=True)]

    def safe_cycles(self, max_cycles: int) -> int:
        """Return the largest number of cycles for which the expected prediction error is small."""
        size = norm(self.last)
        if size == 0:
            return 0
        if self.factor > 0 and norm(self.later(10 * MAX_JUMP_CYCLES)) < 0.2 * size:  # it decays
            max_cycles = min(
                max_cycles, math.ceil(math.log(_MIN_REMAINING_FRACTION) / math.log(self.factor))
            )
        counts = range(1, max_cycles + 1)
        # The misfit may accumulate like the differences, and at least like that of a single cycle.
        missed = [self.misfit * max(self.total(n), n) for n in counts]
        return sum(miss <= _MAX_PREDICTION_ERROR * size for miss in missed)


def trend(changes: Sequence[Changes], field: str) -> Trend | None:
    """Return the trend of a field over three cycles; None if the cells of the field differ."""
    by_body = [at_common_depth([each[body].of(field) for each in changes]) for body in changes[-1]]
    cells = {tuple((c.first, c.of(field).shape[:-1]) for c in each.values()) for each in changes}
    if len(cells) != 1:
        return None
    return Trend(*([fields[moment] for fields in by_body] for moment in range(3)))


@dataclass(frozen=True)
class Jump:
    """Extrapolation (jump) over several cycles, and the state before it."""

    state: State
    cycles: int
    trend: Trend
    """Trend of the plastic strain before the jump."""

    def away(self, found: Changes, after: int = 1) -> list[FloatArray]:
        """Return the strain change in a cycle after the jump, minus the predicted change.

        found: changes in this cycle. after: number of the cycle, counted from the jump.
        """
        real = (change.of("plastic_strain") for change in found.values())
        expected = self.trend.later(self.cycles + after)
        pairs = [at_common_depth(pair) for pair in zip(real, expected, strict=True)]
        return [a - b for a, b in pairs if a.shape == b.shape]

    def confirmed(self, found: Changes) -> bool:
        """Whether the cycle after the jump agrees with the prediction."""
        away = self.away(found)
        return len(away) == len(found) and norm(away) <= _MAX_PREDICTION_ERROR * norm(
            self.trend.last
        )

    def error(self, first: Changes, second: Changes | None = None) -> float:
        """Estimate the plastic strain error due to the jump [-], from the cycles after the jump.

        A deviation is the change in a solved cycle minus the predicted change. The error is the
        deviation in the first cycle after the jump plus the deviations in the skipped cycles. The
        deviations in the skipped cycles are assumed to grow uniformly from 0 to the deviation in
        the second cycle, or in the first cycle if there is no second cycle.
        """
        missed = max(map(max_equivalent, self.away(first)))
        grown = (
            missed
            if second is None
            else max(map(max_equivalent, self.away(second, 2)), default=0.0)
        )
        return missed + 0.5 * self.cycles * grown


def jump(simulation: Simulation, changes: Sequence[Changes], max_cycles: int) -> Jump | None:
    """Extrapolate over as many cycles as is safe; return the jump, or None if no jump is safe."""
    flow = trend(changes, "plastic_strain")
    if flow is None or (cycles := flow.safe_cycles(max_cycles)) < 2:
        return None
    state, added = simulation.state, {name: trend(changes, name) for name in FIELDS}
    for place, (body, now) in enumerate(changes[-1].items()):
        fields = {}
        for name, each in added.items():
            assert each is not None  # all have equal cells
            fields[name] = np.add(*at_common_depth([now.after[name], each.summed(cycles)[place]]))
        accumulated = np.maximum(*at_common_depth([fields[FIELDS[1]], now.after[FIELDS[1]]]))
        back = fields["backstress"] if len(fields["backstress"]) else None
        simulation.set_plastic_strain(
            body, fields["plastic_strain"], accumulated, back, first=now.first
        )
    return Jump(state, cycles, flow)
