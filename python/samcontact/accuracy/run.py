# SPDX-License-Identifier: GPL-3.0-or-later
"""Grids and increments that become finer until the errors of all quantities are small enough."""

from __future__ import annotations

import logging
import math
import warnings
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _memory
from .._checks import FloatArray, positive
from .estimate import (
    MIXED,
    MIXED_AREA,
    RATIO,
    Estimate,
    irregular,
    joined,
    of_grids,
    of_increments,
)
from .outcome import AccuracyWarning, Accurate, largest
from .scene import Refinable, Run

if TYPE_CHECKING:
    from ..cases import Case

_logger = logging.getLogger("samcontact")

FEWEST_GRIDS = 3
FEWEST, MOST = 2, 512
"""Increments of a segment."""
INCREMENTS_ON = 1
"""The grid on which increments are judged: their error hardly depends on it."""
OF_INCREMENTS = ("max_pressure", "contact_area")
"""Always there: how the first changes with the increments tells of the second."""
PART_OF_TIME = 0.3
"""Of all that is allowed, for judging increments."""
UNEVEN = 0.25
"""What of that correction is not of first order, over the accuracy."""
RAW = 10.0
"""Error of the increments used, over the accuracy, that is corrected instead of solved."""
MOST_GRIDS = 24
HOUR = 3600.0


def to_accuracy(
    case: Case | str | Path | Mapping[str, Any],
    accuracy: float | Mapping[str, float] | None = None,
    *,
    quantities: Sequence[str] | None = None,
    max_memory: float | None = None,
    max_time: float | None = None,
) -> Accurate:
    """Solve a case on grids that become finer, until the errors of its values are small enough.

    Window, cells, layers and increments are chosen; a [grid] of the case, its ``increments`` and
    the ``step`` of passes are not used. docs/theory.md, "Accuracy", has how errors are estimated.

    Parameters
    ----------
    case : Case, path or dict
        A case of one contact, from `load_case`, its file, or a dictionary of the same layout.
    accuracy : float or dict, optional
        Relative error [-], in (0, 1), of all quantities or of each by its name; default that of the
        case.
    quantities : sequence of str, optional
        Names in results files, e.g. "max_pressure", "print_depth_body2"; default all that the
        case has, or those that it names.
    max_memory : float, optional
        Of the finest grid [bytes]; default what is available.
    max_time : float, optional
        In all [s]; default an hour. The first three grids are solved whatever they take.

    Returns
    -------
    Accurate

    Raises
    ------
    ValueError
        An argument out of range, or a case with surfaces that are known on one grid only: the text
        names them and what to do instead.

    Warns
    -----
    AccuracyWarning
        The accuracy needs more memory or time than allowed: what it would need. The best values so
        far are returned with their errors.
    """
    known = _case(case, accuracy)
    scene = Refinable(known)
    asked = _asked(scene, known, accuracy, quantities)
    scene.accept(min(asked.values()))
    scene.names = [name for name in scene.names if name in asked or name in OF_INCREMENTS]
    memory = known.max_memory if max_memory is None else positive("max_memory", max_memory)
    limit = known.max_time if max_time is None else positive("max_time", max_time)
    if memory is None:
        memory = _memory.available() or math.inf
    return _Search(scene, asked, memory, HOUR if limit is None else limit).search()


def _case(case: Case | str | Path | Mapping[str, Any], accuracy: Any) -> Case:
    from ..cases import Case, load_case
    from ..cases.case import validated

    made: object = case
    if isinstance(case, (str, Path)):
        made = load_case(Path(case))
    elif isinstance(case, Mapping):
        given = accuracy is None or "grid" in case
        asked = {} if given else {"accuracy": accuracy}
        made = validated({"title": "to an accuracy", **case, **asked}, Path("case"))
    if not isinstance(made, Case):
        raise ValueError(
            "case must be a case of one contact, a path of its file, or a dict, got "
            f"{type(made).__name__}"
        )
    return made


def _asked(
    scene: Refinable,
    case: Case,
    accuracy: float | Mapping[str, float] | None,
    quantities: Sequence[str] | None,
) -> dict[str, float]:
    """Relative accuracy of each quantity that is judged."""
    given = case.accuracy if accuracy is None else accuracy
    if given is None:
        raise ValueError("accuracy must be a number in (0, 1), e.g. 0.01, or a dict of them")
    chosen = case.quantities if quantities is None else quantities
    if isinstance(given, Mapping):
        asked = dict(given)
        for name in chosen or ():
            if name not in asked:
                raise ValueError(f"accuracy has no value for {name!r} of quantities")
    else:
        asked = dict.fromkeys(scene.names if chosen is None else chosen, given)
    if not asked:
        raise ValueError("quantities must name one at least, got none")
    for name, value in asked.items():
        if name not in scene.names:
            raise ValueError(
                f"quantities: {name!r} is none of this case, which has {', '.join(scene.names)}"
            )
        positive("accuracy", value)
        if not value < 1:
            raise ValueError(
                f"accuracy must be a relative error in (0, 1), e.g. 0.01 for 1 %, got {value!r}"
            )
    return asked


class _Search:
    """Runs of a scene, each at most once, and what they tell together."""

    def __init__(
        self, scene: Refinable, asked: dict[str, float], memory: float, limit: float
    ) -> None:
        self.scene, self.asked, self.memory, self.limit = scene, asked, memory, limit
        self.parts = scene.parts
        self.chosen = [scene.names.index(name) for name in asked]
        self.wanted = np.array(list(asked.values()))
        self.runs: dict[tuple[int, int], Run] = {}
        self.solved: list[tuple[int, int, int, float]] = []
        self.used = FEWEST if scene.has_history else 1
        self.needs = ""

    def run(self, level: int, increments: int) -> Run:
        key = level, increments
        if key not in self.runs:
            made = self.runs[key] = self.scene.run(level, increments)
            grid = made.simulation.grid
            self.solved.append((grid.nx, grid.ny, increments, made.seconds))
            _logger.info(
                "%d x %d cells, %d increments: %.2f s", grid.nx, grid.ny, increments, made.seconds
            )
        return self.runs[key]

    @property
    def seconds(self) -> float:
        return sum(seconds for *_, seconds in self.solved)

    def search(self) -> Accurate:
        self.scene.settle(self.run(0, self.used))
        if self.scene.has_history:
            self._judge_increments()
        grids = [self.run(0, self.used)]
        while True:
            enough = len(grids) >= FEWEST_GRIDS
            worst = float(np.max(self._relative(self._estimate(grids)) / self.wanted))
            if enough and worst <= 1.0:
                break
            if enough and self._increments_matter(grids) and self._more_increments():
                continue
            if not self._affordable(grids, worst):
                break
            for run in self.runs.values():  # only the finest states are handed on
                run.states = []
            grids.append(self.run(len(grids), self.used))
        return self._outcome(grids)

    def _judge_increments(self) -> None:
        """Runs on a coarse grid with ever more increments, and how many the others need."""
        while True:
            series = self._of_increments()
            if len(series) >= 3:
                limit = self._limit(series)
                if np.all(self._relative(limit) <= 0.25 * self.wanted):
                    break
            if not self._more_increments():
                break
        for run in series[:-1]:
            self.used = run.increments
            off = np.abs(limit.values - self._join(run.values, 0.0 * run.values).values)
            uneven = self._join(run.values, irregular(*self._corrections()))
            if np.all(
                (self._relative(limit._replace(errors=off)) <= RAW * self.wanted)
                & (self._relative(uneven) <= UNEVEN * self.wanted)
            ):
                break

    def _limit(self, series: list[Run]) -> Estimate:
        """Of more and more increments on one grid."""
        more = of_increments([run.values for run in series])
        return self._join(series[0].values + more.values, more.errors)

    def _join(self, values: FloatArray, errors: FloatArray) -> Estimate:
        """Of the quantities, of whose parts these are."""
        return joined(Estimate(values, errors, np.zeros(values.shape, dtype=bool)), self.parts)

    def _of_increments(self) -> list[Run]:
        found = [run for (level, _), run in self.runs.items() if level == INCREMENTS_ON]
        return sorted(found, key=lambda run: run.increments)

    def _more_increments(self) -> bool:
        series = self._of_increments()
        count = 2 * series[-1].increments if series else FEWEST
        costs = self.seconds + 2 * series[-1].seconds if len(series) >= 3 else 0.0
        if count > MOST or costs > PART_OF_TIME * self.limit:
            return False
        self.run(INCREMENTS_ON, count)
        return True

    def _correction(self) -> Estimate:
        series = self._of_increments()
        at = [run.increments for run in series].index(self.used)
        return of_increments([run.values for run in series], at)

    def _corrections(self) -> tuple[FloatArray, FloatArray]:
        """Of the increments used, and of twice as many."""
        series = self._of_increments()
        at = [run.increments for run in series].index(self.used)
        values = [run.values for run in series]
        return of_increments(values, at).values, of_increments(values, at + 1).values

    def _estimate(self, grids: list[Run]) -> Estimate:
        """Of space and increments together, shape (marks, names)."""
        found = of_grids([run.values for run in grids])
        if self.scene.has_history:
            more = self._correction()
            errors = found.errors + more.errors + self._mixed(found.values, more.values)
            found = Estimate(found.values + more.values, errors, found.extrapolated)
        return joined(found, self.parts)

    def _mixed(self, values: FloatArray, more: FloatArray) -> FloatArray:
        """What a finer grid may change in corrections that were found on a coarse one."""
        mixed: FloatArray = MIXED * np.abs(more) + irregular(*self._corrections())
        before = self.scene.names.index
        area, pressure = (sum(self.parts[: before(n)]) for n in ("contact_area", "max_pressure"))
        p = values[:, pressure]
        share = np.divide(np.abs(more[:, pressure]), p, out=np.zeros_like(p), where=p > 0)
        mixed[:, area] += MIXED_AREA * share * values[:, area]
        return mixed

    def _relative(self, found: Estimate) -> FloatArray:
        """Errors of the chosen quantities over the largest values, the largest of all marks."""
        scale = np.max(np.abs(found.values), axis=0)
        share = np.divide(found.errors, scale, out=np.zeros_like(found.errors), where=scale > 0)
        return np.asarray(np.max(share, axis=0)[self.chosen])

    def _increments_matter(self, grids: list[Run]) -> bool:
        """Whether they alone spoil the accuracy."""
        if not self.scene.has_history:
            return False
        spoiled = self._join(grids[-1].values, self._correction().errors)
        return bool(np.any(self._relative(spoiled) > 0.5 * self.wanted))

    def _affordable(self, grids: list[Run], worst: float) -> bool:
        """Whether the next grid is within memory and time; else `needs` says what it all takes.

        worst: the largest error over what is wanted, which about halves from grid to grid.
        """
        last = grids[-1]
        growth = 2.5 * RATIO if len(grids) < 3 else last.seconds / max(grids[-2].seconds, 1e-3)
        growth = min(max(growth, 2.0), 8.0)
        seconds, size = last.seconds * growth, memory_of(last) * RATIO**3
        # without some grids there is no error to tell
        spent = self.seconds + seconds if len(grids) >= FEWEST_GRIDS else 0.0
        if len(grids) < MOST_GRIDS and size <= self.memory and spent <= self.limit:
            return True
        more = max(1, math.ceil(math.log2(worst))) if math.isfinite(worst) else FEWEST_GRIDS
        seconds = self.seconds + sum(last.seconds * growth**n for n in range(1, more + 1))
        self.needs = (
            f"{more} finer grids would need about {memory_of(last) * RATIO ** (3 * more) / 1e9:.2g}"
            f" GB and {seconds:.2g} s in all"
        )
        return False

    def _outcome(self, grids: list[Run]) -> Accurate:
        found, names, last = self._estimate(grids), self.scene.names, grids[-1]
        for warning in last.told:
            warnings.warn(warning.message, stacklevel=4)
        values, errors = largest(found.values, found.errors)
        relative = self._relative(found)
        reached = bool(np.all(relative <= self.wanted))
        if not reached:
            at = int(np.argmax(relative / self.wanted))
            warnings.warn(
                f"the accuracy of {self.wanted[at]:.3g} is not reached: "
                f"{list(self.asked)[at]} has a relative error of {relative[at]:.2g}; {self.needs}: "
                "raise max_memory or max_time, ask for less, or leave it out of quantities",
                AccuracyWarning,
                stacklevel=4,
            )
        kept = [names.index(name) for name in self.asked]
        return Accurate(
            values={names[i]: float(values[i]) for i in kept},
            errors={names[i]: float(errors[i]) for i in kept},
            accuracy=self.asked,
            reached=reached,
            series={names[i]: found.values[:, i] for i in kept},
            series_errors={names[i]: found.errors[:, i] for i in kept},
            increments=tuple(last.marks),
            states=last.states,
            simulation=last.simulation,
            case=last.case,
            runs=tuple(self.solved),
            needs=self.needs,
        )


def memory_of(run: Run) -> float:
    """What a run takes with the fields of its states [bytes]."""
    grid = run.simulation.grid
    layers = max((len(state.depths) for state in run.states[-1:]), default=0)
    plastic = float(run.simulation.counters["volume_bytes"])
    fields = _memory.volume(grid, _memory.VOLUME_FIELD, layers)
    return _memory.surface(grid, _memory.SIMULATION) + plastic + fields
