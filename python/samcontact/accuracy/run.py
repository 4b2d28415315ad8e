# SPDX-License-Identifier: GPL-3.0-or-later
"""Refinement of grid and increments until the errors of all quantities are small enough."""

from __future__ import annotations

import logging
import math
import warnings
from functools import partial

import numpy as np

from .._util.checks import FloatArray
from .._util.display import counts, percent
from .._util.errors import AccuracyWarning, SingularPressureWarning
from .._util.progress import report_progress
from ..diagnostics.sharp_edges import is_singular
from .estimate import (
    ASSUMED_ORDER,
    MIN_AREA_CORRECTION_CHANGE,
    REFINEMENT_RATIO,
    Estimate,
    combined,
    extrapolate_grids,
)
from .grid_solution import GridSolution
from .grids import interpolated_surface, slope_between_samples
from .increments import TRIAL_LEVEL, Correction, correction, trial_runs
from .outcome import AccuracyResult, largest
from .refinable_case import GridRun, RefinableCase
from .solves import Solves

_logger = logging.getLogger("samcontact")

MIN_GRIDS = {False: 3, True: 4}
"""Minimum number of grids. It is larger (key True) with quantities that may converge with an order
below 2: two successive differences of such quantities are often both small by chance."""
MIN_INCREMENTS, MAX_INCREMENTS = 2, 512
"""Range of the number of increments per segment."""
INCREMENT_QUANTITIES = ("max_pressure", "contact_area")
"""Quantities that are always evaluated, because the error of the contact area due to increments is
estimated from the change of the maximum pressure."""
INCREMENT_TIME_SHARE = 0.3
"""Maximum fraction of the allowed time that is spent on choosing the number of increments."""
MAX_IRREGULAR_SHARE = 0.25
"""Limit of the ratio of `Correction.irregular` to the prescribed accuracy."""
MAX_CORRECTION_CHANGE = 0.5
"""Limit of the error that a correction from coarse grids may have on the finest grid, divided by
the prescribed accuracy. Above this limit, the correction is determined on a finer grid."""
NEXT_GRID_TIME_SHARE = 0.5
"""Time limit of a run with more increments on a finer grid, relative to the expected time of the
next grid."""
MAX_CORRECTED_ERROR = 10.0
"""Maximum error due to the increments that is corrected by extrapolation, divided by the prescribed
accuracy. If the error is larger, the number of increments is increased."""
MAX_GRIDS = 24


class AccuracySearch:
    """Runs of a case with several grids and numbers of increments, and errors estimated from them.

    No combination of grid and number of increments is solved twice.
    """

    def __init__(
        self,
        refinable: RefinableCase,
        targets: dict[str, float],
        memory: float,
        limit: float,
        progress: bool,
    ) -> None:
        self.refinable, self.targets, self.memory, self.limit = refinable, targets, memory, limit
        self.parts = refinable.parts
        self.chosen = [refinable.names.index(name) for name in targets]
        self.target_values = np.array(list(targets.values()))
        self.progress = progress
        slow = [refinable.study.order(name) < ASSUMED_ORDER for name in targets]
        self.min_grids = MIN_GRIDS[any(slow)]
        self.solves = Solves(refinable.run_identity)
        self.runs: dict[tuple[int, int], GridRun] = {}
        order = refinable.max_increment_order
        self.correction = partial(correction, self.runs, max_order=order)
        self.grids: list[GridRun] = []
        self.used = MIN_INCREMENTS if refinable.has_history else 1
        self.needs = ""

    def run(self, level: int, increments: int) -> GridRun:
        key = level, increments
        if key not in self.runs:
            made = self.refinable.run(level, increments, self.solves, progress=self.progress)
            self.runs[key] = made
            self._forget(but=[made, *self.grids[-1:]])
            each = f", {increments} increments per segment" if self.refinable.has_history else ""
            line = f"grid {level + 1}: {counts(*made.cells)} cells{each}, {made.seconds:.2g} s"
            _logger.info("%s", line)
            report_progress(line, shown=self.progress)
        return self.runs[key]

    def _forget(self, but: list[GridRun]) -> None:
        """Release the states of all runs except those in `but`."""
        for run in self.runs.values():
            if run not in but:
                run.solved = None
        # names sort by grid; the last one may belong to an interrupted run
        self.solves.forget_increments([max(self.solves.given), *(run.name for run in but)])

    @property
    def seconds(self) -> float:
        return sum(run.seconds for run in self.runs.values())

    def search(self) -> AccuracyResult:
        first = self.run(0, self.used)
        self.refinable.settle(first)
        self._leave_out_singular(first)
        if self.refinable.has_history:
            self._choose_increments()
        grids = self.grids = [self.run(0, self.used)]
        while True:
            if not np.isfinite(self.target_values).any():  # no quantity converges
                break
            enough = len(grids) >= self.min_grids
            found = self._estimate(grids)
            worst = float(np.max(self._relative(found) / self.target_values))
            report_progress(self._errors_above_target(found), shown=self.progress and enough)
            if enough and worst <= 1.0 and not _disagreement(grids):
                break
            if enough and self._reduce_increment_error(grids):
                continue
            if not self._affordable(grids, worst):
                break
            grids.append(self.run(len(grids), self.used))
            self._leave_out_singular(grids[-1])
        outcome = self._outcome(grids)
        _warn_of(outcome, self._finest(self.grids[-1]))
        return outcome

    def _leave_out_singular(self, run: GridRun) -> None:
        """Exclude quantities that do not converge because the pressure is singular at an edge."""
        issued = () if run.solved is None else run.solved.issued
        if any(issubclass(warning.category, SingularPressureWarning) for warning in issued):
            endless = [is_singular(name) for name in self.targets]
            self.target_values = np.where(endless, np.inf, self.target_values)
            if any(endless):
                names = ", ".join(name for name in self.targets if is_singular(name))
                self.needs = f"{names} do not converge at a sharp edge on any grid"

    def best(self) -> AccuracyResult | None:
        """Return the result so far, or None if there are too few grids to estimate errors."""
        return self._outcome(self.grids) if len(self.grids) >= self.min_grids else None

    def _errors_above_target(self, found: Estimate) -> str:
        """Return a text that lists the errors that exceed the prescribed accuracy."""
        relative = dict(zip(self.targets, self._relative(found), strict=True))
        above = [f"{n} {percent(e)}" for n, e in relative.items() if e > self.targets[n]]
        return f"  estimated errors: {', '.join(above) or 'all below the prescribed accuracy'}"

    def _choose_increments(self) -> None:
        """Choose the number of increments, from coarse-grid runs with 2, 4, 8 ... increments."""
        while True:
            series = trial_runs(self.runs)
            if len(series) >= 3:
                more = self.correction(MIN_INCREMENTS, series[0].values)
                limit = self._join(series[0].values + more.values, more.errors)
                if np.all(self._relative(limit) <= 0.25 * self.target_values):
                    break
            if not self._more_increments():
                break
        allowed = self.target_values
        for run in series[:-1]:
            self.used = run.increments
            off = np.abs(limit.values - self._join(run.values, 0.0 * run.values).values)
            left = self.correction(self.used, run.values).irregular
            uneven = self._join(run.values, left)
            if np.all(
                (self._relative(limit._replace(errors=off)) <= MAX_CORRECTED_ERROR * allowed)
                & (self._relative(uneven) <= MAX_IRREGULAR_SHARE * allowed)
            ):
                break

    def _join(self, values: FloatArray, errors: FloatArray) -> Estimate:
        """Return the estimate of each quantity: the maximum over its parts (e.g. materials)."""
        return combined(Estimate(values, errors, np.zeros(values.shape, dtype=bool)), self.parts)

    def _more_increments(self) -> bool:
        """Solve grid `TRIAL_LEVEL` with twice as many increments as before.

        Return False if the limit on the number of increments or on the time prevents the solution.
        """
        series = trial_runs(self.runs)
        count = 2 * series[-1].increments if series else MIN_INCREMENTS
        costs = self.seconds + 2 * series[-1].seconds if len(series) >= 3 else 0.0
        if count > MAX_INCREMENTS or costs > INCREMENT_TIME_SHARE * self.limit:
            return False
        self.run(TRIAL_LEVEL, count)
        return True

    def _on_finer_grid(self, grids: list[GridRun], found: Correction) -> bool:
        """Repeat the least accurate doubling of increments on a finer grid, if the time allows it.

        Return whether a solution was added.
        """
        error_ratios = [self._error_ratio(grids, errors) for errors in found.by_grid]
        count, before = found.doublings[int(np.argmax(error_ratios))]
        allowed = min(
            NEXT_GRID_TIME_SHARE * self._growth(grids) * grids[-1].seconds,
            self.limit - self.seconds,
        )
        for level in range(len(grids) - 1, before, -1):
            missing = [n for n in (count, 2 * count) if (level, n) not in self.runs]
            if sum(n / self.used * grids[level].seconds for n in missing) <= allowed:
                for n in missing:
                    self.run(level, n)
                return True
        return False

    def _estimate(self, grids: list[GridRun]) -> Estimate:
        """Return values with the errors due to grid and increments.

        The arrays have shape (compared increments, quantities).
        """
        found = extrapolate_grids([run.values for run in grids], self.refinable.orders)
        found = found._replace(errors=found.errors + grids[-1].margins)
        if self.refinable.has_history:
            more = self.correction(self.used, grids[-1].values)
            errors = found.errors + more.errors + self._with_cross_error(found.values, more)
            found = Estimate(found.values + more.values, errors, found.extrapolated)
        return combined(found, self.parts)

    def _with_cross_error(self, values: FloatArray, more: Correction) -> FloatArray:
        """Return the possible error of applying increment corrections to the finest grid.

        The corrections were computed on coarse grids.
        """
        mixed: FloatArray = sum(more.by_grid) + more.irregular
        before = self.refinable.names.index
        area, pressure = (sum(self.parts[: before(n)]) for n in ("contact_area", "max_pressure"))
        p = values[:, pressure]
        share = np.divide(np.abs(more.values[:, pressure]), p, out=np.zeros_like(p), where=p > 0)
        mixed[:, area] += MIN_AREA_CORRECTION_CHANGE * share * values[:, area]
        return mixed

    def _relative(self, found: Estimate) -> FloatArray:
        """Return the maximum error of each chosen quantity, divided by the maximum value."""
        scale = np.max(np.abs(found.values), axis=0)
        share = np.divide(found.errors, scale, out=np.zeros_like(found.errors), where=scale > 0)
        return np.asarray(np.max(share, axis=0)[self.chosen])

    def _error_ratio(self, grids: list[GridRun], errors: FloatArray) -> float:
        """Return the maximum ratio of relative errors to the prescribed accuracy."""
        return float(
            np.max(self._relative(self._join(grids[-1].values, errors)) / self.target_values)
        )

    def _reduce_increment_error(self, grids: list[GridRun]) -> bool:
        """Add a run if the increment error is too large; return whether a run was added.

        The run has more increments, or is on a finer grid.
        """
        if not self.refinable.has_history:
            return False
        found = self.correction(self.used, grids[-1].values)
        if self._error_ratio(grids, found.errors) > 0.5 and self._more_increments():
            return True
        depends = self._error_ratio(grids, np.sum(found.by_grid, axis=0)) > MAX_CORRECTION_CHANGE
        return depends and self._on_finer_grid(grids, found)

    def _growth(self, grids: list[GridRun]) -> float:
        """Return (estimated time for the next grid)/(time for the last grid) [-]."""
        known = len(grids) > 2
        growth = (
            grids[-1].seconds / max(grids[-2].seconds, 1e-3) if known else 2.5 * REFINEMENT_RATIO
        )
        return min(max(growth, 2.0), 8.0)

    def _affordable(self, grids: list[GridRun], worst: float) -> bool:
        """Whether memory and time suffice for the next grid.

        If not, `needs` is set to a text on the memory and time required. worst: maximum ratio of
        error to prescribed accuracy; it is assumed that each finer grid halves this ratio.
        """
        last = grids[-1]
        growth, size = self._growth(grids), last.memory * REFINEMENT_RATIO**3
        seconds = last.seconds * growth
        # an error estimate requires a minimum number of grids
        spent = self.seconds + seconds if len(grids) >= self.min_grids else 0.0
        if len(grids) < MAX_GRIDS and size <= self.memory and spent <= self.limit:
            return True
        more = max(1, math.ceil(math.log2(worst))) if math.isfinite(worst) else self.min_grids
        seconds = self.seconds + sum(last.seconds * growth**n for n in range(1, more + 1))
        memory = last.memory * REFINEMENT_RATIO ** (3 * more)
        self.needs = (
            f"{more} finer grids would require about {memory / 1e9:.2g} GB and {seconds:.2g} s in "
            "total"
        )
        return False

    def _finest(self, last: GridRun) -> GridSolution:
        if last.solved is None:  # values were read from a checkpoint
            last.solved = self.refinable.solve(last.level, last.increments, self.solves)
        return last.solved

    def _outcome(self, grids: list[GridRun]) -> AccuracyResult:
        found, names, last = self._estimate(grids), self.refinable.names, self._finest(grids[-1])
        kept = [names.index(name) for name in self.targets]
        endless = [
            i for i, target in zip(kept, self.target_values, strict=True) if np.isinf(target)
        ]
        found.errors[:, endless] = np.inf
        values, errors = largest(found.values, found.errors)
        return AccuracyResult(
            values={names[i]: float(values[i]) for i in kept},
            errors={names[i]: float(errors[i]) for i in kept},
            accuracy=self.targets,
            reached=not (endless or _disagreement(grids))
            and bool(np.all(self._relative(found) <= self.target_values)),
            series={names[i]: found.values[:, i] for i in kept},
            series_errors={names[i]: found.errors[:, i] for i in kept},
            increments=tuple(self.refinable.study.marks(last)),
            states=last.states,
            simulation=last.simulation,
            case=last.case,
            repeated=last.repeated,
            runs=tuple((*run.cells, run.increments, run.seconds) for run in self.runs.values()),
            needs="; ".join(filter(None, (_disagreement(grids), self.needs))),
            surface=interpolated_surface(self.refinable.case),
            slope_beyond=slope_between_samples(self.refinable.case),
            _study=self.refinable.study,
            _solution=last,
        )


def _disagreement(grids: list[GridRun]) -> str:
    """Return a text if `Study.note` differs between the last two grids, otherwise ""."""
    last, before = grids[-1].note, grids[-2].note if len(grids) > 1 else grids[-1].note
    return "" if last == before else f"{last} on the finest grid, but {before} on the one before"


def _warn_of(outcome: AccuracyResult, last: GridSolution) -> None:
    """Issue the warnings of the last grid, and a warning if the accuracy is not reached."""
    for warning in last.issued:
        warnings.warn(warning.message, stacklevel=4)
    if not outcome.reached:
        relative, targets = outcome.relative_errors, outcome.accuracy
        name = max(targets, key=lambda one: relative[one] / targets[one])
        warnings.warn(
            f"prescribed accuracy not reached: estimated relative error of {name} is "
            f"{relative[name]:.2g}, target {targets[name]:.3g}; {outcome.needs}: to reach "
            "the target, increase max_memory or max_time, relax the accuracy, or exclude "
            f"{name} from quantities",
            AccuracyWarning,
            stacklevel=4,
        )
