# SPDX-License-Identifier: GPL-3.0-or-later
"""Search for the load at which a quantity of a contact reaches a given value."""

from __future__ import annotations

import math
import os
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .._core import ConvergenceError
from .._util.checks import FloatArray, boolean, number, positive
from .._util.display import HtmlTable, Rows, percent, quantity
from .._util.lazy_scipy import scipy
from .._util.progress import report_progress
from .._util.short_text import in_short
from ..bodies.material import Material
from ..restart.identity import identity
from ..simulation import coarsening, error_controlled_quantities
from ..simulation.journal import describe
from ..simulation.repeated import coarsened, coarsened_path
from .attainable_values import require_attainable
from .grid_errors import estimated
from .load_search_cases import (
    PERMANENT_DEFORMATION,
    YIELD,
    Built,
    ScaledCase,
    elastic,
    has_depth_profile,
    label_and_unit,
    max_load,
    require_known,
    resolved,
    used_strength,
)
from .solves import Solves

if TYPE_CHECKING:
    from ..cases import Case
    from ..solutions.state import State

__all__ = ["FoundLoad", "find_load"]

_MAX_FACTOR, _MIN_FACTOR = 100.0, 1e-9
"""Maximum load divided by the load of the case; minimum load divided by the first load tried."""
_RTOL = 1e-2  # relative tolerance of the load on the coarse grid
_MAX_FINE_SOLVES = 12  # maximum number of solutions on the fine grid


@dataclass(frozen=True, eq=False)
class FoundLoad(HtmlTable):
    """Result of a load search: load, value of the quantity, errors and states.

    Attributes
    ----------
    quantity : str
        Name in results files, "permanent_deformation" or "yield". Two names separated by a comma
        mean the larger value of both bodies.
    load, load_error : float
        Load [N], and its error `(error + abs(value - target))/(d(value)/d(load))` [N].
    value, error : float
        Value of the quantity at this load, and estimated grid error of the value, in SI units.
    states : list of State
        States of the run with this load; for "yield", states of an elastic run.
    """

    quantity: str
    load: float
    load_error: float
    value: float
    error: float
    states: list[State]

    def _rows(self) -> Rows:
        label, unit = label_and_unit(self.quantity)
        share = self.load_error / self.load
        return [
            ("load", f"{quantity(self.load, 'N', 5)} ± {percent(share)}"),
            (label, f"{quantity(self.value, unit, 5)} ± {percent(self.error / self.value)}"),
        ]

    def __repr__(self) -> str:
        return f"FoundLoad({self.quantity!r}, load={self.load!r}, load_error={self.load_error:.2g})"


class LoadSearch:
    """Search for a load, in which the case is solved at most once for each load and grid.

    start, max_load: initial and maximum load [N]; tolerance: relative tolerance on the quantity.
    """

    def __init__(
        self, quantity: str, target: float, build: Callable[[float], Built], start: float,
        max_load: float, tolerance: float, progress: bool,
    ) -> None:  # fmt: skip
        simulation, path = _checked_build(build, max_load)
        self.name, self.target = resolved(quantity, simulation), target
        self.build, self.start, self.max_load = build, start, max_load
        self.tolerance, self.progress = tolerance, progress
        self.bodies = simulation.body1, simulation.body2
        self.solves = Solves(describe(simulation.engine, path=list(path), quantity=self.name))
        require_attainable(self.name, target, simulation, max_load)
        self.largest = (0.0, 0.0)
        """Largest value so far, and the load [N] at which it was computed."""
        self._last: tuple[str, Built, list[State]] | None = None
        self._reported: set[str] = set()

    def find(self) -> FoundLoad:
        return _refined(self, _enclosed(self, self.start, self.max_load), self.tolerance)

    def on_coarse(self, load: float) -> float:
        """Return (value - target)/target for a load [N] on the coarse grid."""

        def made() -> Built:
            simulation, path = self._built(load)
            path, _ = coarsened_path(simulation, path)
            return coarsened(simulation, simulation.heat), path

        return self._excess(f"coarse_{load!r}", "coarse", load, made)

    def on_grid(self, load: float) -> float:
        """Return (value - target)/target for a load [N] on the fine grid."""
        return self._excess(_name(load), "fine", load, lambda: self._built(load))

    def run(self, load: float) -> tuple[Built, list[State]]:
        """Return simulation, path and states on the fine grid for a load [N]; solve if needed."""
        if self._last is None or self._last[0] != _name(load):
            self._solve(_name(load), self._built(load))
        assert self._last is not None
        return self._last[1:]

    def _built(self, load: float) -> Built:
        simulation, path = _checked_build(self.build, load)
        return (elastic(simulation), path) if self.name == YIELD else (simulation, path)

    def _solve(self, name: str, built: Built) -> list[State]:
        self._last = None  # frees memory for the next solution
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            states = self.solves.run(name, built[0], list(built[1]), progress=self.progress)
        self._last = name, built, states
        return states

    def _excess(self, name: str, where: str, load: float, make: Callable[[], Built]) -> float:
        if name not in self.solves.given:
            states = self._solve(name, make())
            marks = {len(states) - 1} if self.name == PERMANENT_DEFORMATION else _marks(states)
            reached = max(self._value_of(states[at]) for at in marks)
            self.solves.add(name, {"reached": reached})
            self.solves.forget_increments([name])
        reached = self.solves.given[name]["reached"]
        if name not in self._reported:
            self._reported.add(name)
            text = f"{where} grid, load {quantity(load, 'N', 6)}: {self._progress_text(reached)}"
            report_progress(text, shown=self.progress)
        self.largest = max(self.largest, (reached, load))
        return float(reached / self.target - 1.0)

    def _progress_text(self, reached: float) -> str:
        label, unit = label_and_unit(self.name)
        return f"{label} {quantity(reached, unit)} (target {quantity(self.target, unit)})"

    def _value_of(self, state: State) -> float:
        if self.name == YIELD:
            return max(used_strength(state, n, body) for n, body in self.yielding.items())
        values = [error_controlled_quantities.value(state, name) for name in self.parts]
        return sum(values) if self.name == PERMANENT_DEFORMATION else max(values)

    @property
    def yielding(self) -> dict[int, Material]:
        """Elastic-plastic materials by body number."""
        bodies = enumerate(self.bodies, 1)
        return {n: body for n, body in bodies if isinstance(body, Material) and body.is_plastic}

    @property
    def parts(self) -> list[str]:
        """Names, in results files, of quantities whose sum or maximum is compared with `target`."""
        if self.name == PERMANENT_DEFORMATION:
            bodies = enumerate(self.bodies, 1)
            return [f"imprint_depth_body{n}" for n, body in bodies if body.is_plastic]
        if self.name != YIELD:
            return self.name.split(",")
        return [f"max_von_mises_body{n}" for n in self.yielding]

    @property
    def has_depth_profile(self) -> bool:
        """Whether first yield is sought in a body with depth-dependent yield or initial stress."""
        return self.name == YIELD and any(map(has_depth_profile, self.yielding.values()))

    def refuse(self, reason: object) -> ValueError:
        reached, load = self.largest
        name = self.name.replace(",", " or ")
        return ValueError(
            f"value = {self.target!r} of {name} cannot be reached: the maximum is {reached:.6g} at "
            f"{load:.6g} N; {reason}"
        )


def find_load(
    case: Case | str | Path | Mapping[str, Any] | Callable[[float], Built],
    quantity: str,
    value: float = 1.0,
    *,
    tolerance: float = 1e-3,
    largest_load: float | None = None,
    progress: bool = True,
    checkpoint: str | os.PathLike[str] | None = None,
) -> FoundLoad:
    """Find the load at which a quantity reaches a value.

    The load is located by Brent's method on a grid with cells twice as large, and then refined by
    the secant method on the grid itself, which takes three or four solutions.

    Parameters
    ----------
    case : Case, path, dict or callable
        Case, path of a case file, or dictionary of the same layout; the search scales all forces of
        the case. Or a function that takes the maximum load [N] and returns simulation and path.
    quantity : str
        Name of a quantity whose error is in results files, e.g. "max_pressure" or
        "imprint_depth_body2". A name without body number means the larger value of both bodies. The
        larger of the values at maximum load and at the end of the path is used. Special names:
        "permanent_deformation", the sum of both residual imprint depths at the end of the path;
        "yield", the maximum of von Mises stress / yield stress in an elastic solution.
    value : float, optional
        Target value in SI units, > 0. Default: 1.
    tolerance : float, optional
        Relative tolerance on the quantity [-], in [1e-8, 0.1].
    largest_load : float, optional
        Maximum contact load [N], required for a function. Default: 100 times the load of the case.
    progress : bool, optional
        Print one line per trial load to stderr.
    checkpoint : path, optional
        Folder that stores the values of all loads and the increments of the last load. Repeating
        the call continues from this folder, with bit-identical results. Remove the folder when it
        is no longer needed.

    Returns
    -------
    FoundLoad

    Raises
    ------
    ValueError
        No load reaches the value; the message gives the maximum, or a bound found before the
        search. An argument is out of range, the quantity is unknown, the case lacks loads or has
        wear, or `checkpoint` belongs to another call. With "yield": no body is elastic-plastic, or
        a body that can yield is layered, softens, or first yields in the deepest grid layer.
    """
    search = prepare_search(
        case, quantity, value, tolerance=tolerance, largest_load=largest_load, progress=progress
    )
    if checkpoint is not None and callable(case):  # the identity describes the largest load only
        search.solves.run_identity |= identity(function=case)
    with search.solves.kept_in(checkpoint):
        return search.find()


def prepare_search(
    case: Case | str | Path | Mapping[str, Any] | Callable[[float], Built],
    quantity: str,
    value: float,
    *,
    tolerance: float,
    largest_load: float | None,
    progress: bool,
) -> LoadSearch:
    """Check the arguments of `find_load` and prepare the search."""
    boolean("progress", progress)
    require_known(quantity)
    target, relative = positive("value", value), number("tolerance", tolerance)
    if not 1e-8 <= relative <= 0.1:
        raise ValueError(f"tolerance must be in [1e-8, 0.1], got {tolerance!r}")
    build: Callable[[float], Built]
    if callable(case):
        if largest_load is None:
            raise ValueError("if case is a function, largest_load must be given [N], got None")
        build, start = case, positive("largest_load", largest_load)
    else:
        from .given_case import case_of_contact

        known = case_of_contact("case", case)
        start = max_load(known)
        build = ScaledCase(known, start)
    limit = _MAX_FACTOR * start if largest_load is None else positive("largest_load", largest_load)
    return LoadSearch(quantity, target, build, min(start, limit), limit, relative, progress)


def _checked_build(build: Callable[[float], Built], load: float) -> Built:
    """Return the simulation and path that the user's function gives for a load [N]."""
    built = build(load)
    if not (isinstance(built, tuple) and len(built) == 2):
        raise TypeError(
            "case must be a function that returns a simulation and its path, got a function that "
            f"returns {in_short(built)}"
        )
    return built


def _marks(states: Sequence[State]) -> set[int]:
    """Return the indices of the last increment at maximum load and the last of all increments."""
    loads = [state.load for state in states]
    max_load = max(loads) * (1 - 1e-9)
    return {max(n for n, load in enumerate(loads) if load >= max_load), len(states) - 1}


def _name(load: float) -> str:
    """Return the name under which the fine-grid solution for a load [N] is stored."""
    return f"grid_{load!r}"


def _enclosed(search: LoadSearch, start: float, max_load: float) -> float:
    """Return the approximate load [N], found on the coarse grid if the grid can be coarsened."""
    try:
        coarsening.coarser_grid(search.build(start)[0].grid)
        deviation = search.on_coarse
    except ValueError:
        deviation = search.on_grid
    reason: list[object] = [f"increase largest_load, which is {max_load:.6g} N"]

    def trial_value(load: float) -> float | None:
        """Return (value - target)/target for a load [N]; None if the solution failed."""
        try:
            return deviation(load)
        except (ValueError, ConvergenceError, MemoryError) as error:
            reason[0] = error
            return None

    low, value = start, trial_value(start)
    while (value is None or value > 0) and low > _MIN_FACTOR * start:
        max_load, low = (low, 0.5 * low) if value is None else (max_load, 0.5 * low)
        value = trial_value(low)
    if value is None or value > 0:
        raise search.refuse(reason[0])
    high, value = low, -1.0
    while value is None or value < 0:
        low, max_load = (high, max_load) if value is not None else (low, 0.5 * (low + high))
        high = min(2.0 * low, max_load)
        if high < (1 + _RTOL) * low:
            raise search.refuse(reason[0])
        value = trial_value(high)
    found: float = scipy.optimize.brentq(deviation, low, high, xtol=_RTOL * low, rtol=_RTOL)
    return found


def _refined(search: LoadSearch, near: float, tolerance: float) -> FoundLoad:
    """Refine the load [N] on the fine grid by the secant method, safeguarded by bisection."""
    low, high = 0.0, math.inf
    points: list[tuple[float, float]] = []
    load = near
    for _ in range(_MAX_FINE_SOLVES):
        deviation = search.on_grid(load)
        points.append((load, deviation))
        low, high = (load, high) if deviation < 0 else (low, load)
        if abs(deviation) <= tolerance and len(points) > 1:
            return _outcome(search, load, deviation, _slope(points))
        step = -deviation / _slope(points) if len(points) > 1 else -deviation * load
        load += min(max(step if step else tolerance * load, -0.5 * load), load)
        if not low < load < high:
            load = 0.5 * (low + high)
    missed = f"{tolerance!r} was not reached in {_MAX_FINE_SOLVES} solutions"
    raise search.refuse(f"tolerance = {missed}: increase tolerance")


def _slope(points: Sequence[tuple[float, float]]) -> float:
    """Return the slope of (value - target)/target from the nearest other load to the last load."""
    *others, (load, deviation) = points
    other, value = min(others, key=lambda point: abs(point[0] - load))
    slope = (deviation - value) / (load - other)
    return slope if slope > 0 else 1.0 / load


def _outcome(search: LoadSearch, load: float, deviation: float, slope: float) -> FoundLoad:
    (simulation, path), states = search.run(load)
    try:
        solve = partial(search.solves.run, f"errors_{load!r}")
        estimates = estimated(simulation, path, states, solve)
        errors = [_relative(estimates.values[n], estimates.errors[n]) for n in search.parts]
        if search.has_depth_profile:  # error of a depth profile with kinks, known to one layer
            errors.append(abs(search.on_coarse(load) - deviation))
        error = max(errors)
    except (ValueError, ConvergenceError, MemoryError):  # the error is unknown
        error = math.nan
    value = search.target * (1.0 + deviation)
    load_error = (abs(deviation) + error) / slope
    return FoundLoad(search.name, load, load_error, value, error * value, states)


def _relative(values: FloatArray, errors: FloatArray) -> float:
    """Return the relative error at the increment with the largest value."""
    known = np.where(np.isfinite(errors), np.abs(values), -1.0)
    at = int(known.argmax())
    return float(errors[at] / known[at]) if known[at] > 0 else 0.0
