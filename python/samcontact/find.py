# SPDX-License-Identifier: GPL-3.0-or-later
"""The load at which a quantity of a contact reaches a value."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy

from . import _certified, half_resolution
from ._checks import FloatArray, number, positive
from ._core import ConvergenceError
from ._quantities import described
from ._repr import Rows, Shown, quantity
from .grid_errors import estimate_errors
from .material import Material

if TYPE_CHECKING:
    from .cases import Case
    from .simulation import Simulation
    from .state import State

__all__ = ["FoundLoad", "find_load"]

YIELD = "yield"
SYNONYMS = {"max_plastic_strain": "max_equivalent_plastic_strain"}
_MOST = 100.0  # times the largest load of a case
_LEAST = 1e-9  # times the first load that is tried
_COARSE = 1e-2  # relative tolerance of the load on the coarser grid
_TRIES = 12  # on the grid itself

Built = tuple["Simulation", Sequence[Mapping[str, Any]]]


@dataclass(frozen=True, eq=False)
class FoundLoad(Shown):
    """A load and what is reached under it.

    Attributes
    ----------
    quantity : str
        By its name in results files, or "yield"; by two names where it is the larger of both.
    load, load_error : float
        [N]; the error is that of the value over its slope.
    value, error : float
        What is reached, in SI units, with its estimated error by the cells of the grid.
    states : list of State
        Of the run with this load; with "yield" of bodies that stay elastic.
    """

    quantity: str
    load: float
    load_error: float
    value: float
    error: float
    states: list[State]

    def _rows(self) -> Rows:
        label, unit = "von Mises stress over yield stress", ""
        if self.quantity != YIELD:
            known, body = described(self.quantity.partition(",")[0])
            body = None if "," in self.quantity else body
            unit = {"m2": "m²", "1": ""}.get(known.unit, known.unit)
            label = known.heading if body is None else f"{known.heading}, body {body}"
        share = self.load_error / self.load
        return [
            ("load", f"{quantity(self.load, 'N', 5)} ± {100 * share:.2g} %"),
            (label, f"{quantity(self.value, unit, 5)} ± {100 * self.error / self.value:.2g} %"),
        ]

    def __repr__(self) -> str:
        return f"FoundLoad({self.quantity!r}, load={self.load!r}, load_error={self.load_error:.2g})"


@dataclass
class _Search:
    """What was tried so far."""

    name: str
    target: float
    bodies: tuple[Material, Material]
    build: Callable[[float], Built]
    fine: dict[float, tuple[float, Built, list[State]]] = field(default_factory=dict)
    largest: tuple[float, float] = (0.0, 0.0)
    """Value and load."""

    def on_coarse(self, load: float) -> float:
        """What is missing [of the target], on cells twice as large."""
        simulation, path = self._built(load)
        path, _ = half_resolution.coarser_path(path, simulation.grid)
        return self._value(half_resolution.coarser(simulation, simulation.heat), path, load)[0]

    def on_grid(self, load: float) -> float:
        """The same on the grid itself."""
        if load not in self.fine:
            built = self._built(load)
            missing, states = self._value(*built, load)
            self.fine[load] = missing, built, states
        return self.fine[load][0]

    def _built(self, load: float) -> Built:
        simulation, path = self.build(load)
        return (_elastic(simulation), path) if self.name == YIELD else (simulation, path)

    def _value(
        self, simulation: Simulation, path: Sequence[Mapping[str, Any]], load: float
    ) -> tuple[float, list[State]]:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            states = simulation.run(path, progress=False)
        reached = max(self._reached(states[at]) for at in _marks(states))
        self.largest = max(self.largest, (reached, load))
        return reached / self.target - 1.0, states

    def _reached(self, state: State) -> float:
        return max(_certified.value(state, name) / by for name, by in self.parts.items())

    @property
    def parts(self) -> dict[str, float]:
        """What the quantity is the largest of, each divided by a number."""
        if self.name != YIELD:
            return dict.fromkeys(self.name.split(","), 1.0)
        return {
            f"max_von_mises_body{n}": float(body.yield_stress(0.0))
            for n, body in enumerate(self.bodies, 1)
            if body.is_plastic
        }

    def refuse(self, why: object) -> ValueError:
        reached, load = self.largest
        name = self.name.replace(",", " or ")
        return ValueError(
            f"value = {self.target!r} of {name} is not reached: the largest is {reached:.6g} at "
            f"{load:.6g} N; {why}"
        )


def find_load(
    case: Case | Callable[[float], Built],
    quantity: str,
    value: float = 1.0,
    *,
    tolerance: float = 1e-3,
    largest_load: float | None = None,
) -> FoundLoad:
    """Find the load at which a quantity reaches a value.

    The load is enclosed on cells twice as large (Brent's method), then found on the grid itself by
    secants, which take three or four solves.

    Parameters
    ----------
    case : Case or callable
        A case, all of whose loads are multiplied by the same factor; or a function that makes the
        simulation and the path (for `Simulation.run`) of a largest load [N].
    quantity : str
        Of those with errors in results files, e.g. "max_pressure", "print_depth_body2"; without a
        body the larger of both. It is taken under the largest load and at the end of the path, the
        larger of both. "yield": largest von Mises stress over yield stress of bodies that
        stay elastic, 1 where the first one yields.
    value : float, optional
        To be reached, > 0, in SI units.
    tolerance : float, optional
        Relative, of what is reached; in [1e-8, 0.1].
    largest_load : float, optional
        Where the search ends [N]; 100 times that of the case. A function needs it.

    Returns
    -------
    FoundLoad

    Raises
    ------
    ValueError
        The value is not reached; the text has the largest one. An argument out of range, a case
        without loads, wear; with "yield", bodies that cannot, or that soften.
    """
    target, relative = positive("value", value), number("tolerance", tolerance)
    if not 1e-8 <= relative <= 0.1:
        raise ValueError(f"tolerance must be in [1e-8, 0.1], got {tolerance!r}")
    if callable(case):
        if largest_load is None:
            raise ValueError("largest_load must be given with a function, got None")
        build, most = case, positive("largest_load", largest_load)
    else:
        first = _largest_load(case)
        build = _Scaled(case, first)
        most = _MOST * first if largest_load is None else positive("largest_load", largest_load)
    made, _ = build(most)
    name = _resolved(quantity, made)
    search = _Search(name, target, (made.body1, made.body2), build)
    start = most if callable(case) else min(_largest_load(case), most)
    near = _enclosed(search, start, most)
    return _refined(search, near, relative)


@dataclass(frozen=True)
class _Scaled:
    """A case under other loads."""

    case: Case
    largest: float

    def __call__(self, load: float) -> Built:
        factor = load / self.largest
        path = [
            segment.model_copy(
                update={
                    "load": factor * (segment.load or 0.0),
                    "start": None if segment.start is None else factor * segment.start,
                }
            )
            for segment in self.case.path
        ]
        return self.case.model_copy(update={"path": path}).build()


def _largest_load(case: Case) -> float:
    if case.wear is not None:
        raise ValueError("wear: a load is found of one contact, not of cycles of wear")
    loads = [segment.load for segment in case.path]
    given = [load for load in loads if load is not None]
    if len(given) < len(loads) or not max(given) > 0:
        raise ValueError("path: a load is found of a path of loads, one at least > 0")
    return max(given)


def _resolved(name: str, simulation: Simulation) -> str:
    """A name as `value_of` takes it; ValueError for one that the simulation has not."""
    bodies = simulation.body1, simulation.body2
    if name == YIELD:
        if not any(body.is_plastic for body in bodies):
            raise ValueError('quantity = "yield" needs a body that yields')
        if any(body.softening for body in bodies):
            raise ValueError('quantity = "yield" is not for bodies that soften by heat')
        if not simulation.grid.has_volume:
            raise ValueError('quantity = "yield" needs a grid with dz')
        return name
    name = SYNONYMS.get(name, name)
    known = _certified.names(bodies, volume=simulation.grid.has_volume)
    found = [one for one in known if one in (name, f"{name}_body1", f"{name}_body2")]
    if not found or name == "load":
        allowed = [one for one in known if one != "load"]
        raise ValueError(f"quantity must be one of {', '.join(allowed)}, yield, got {name!r}")
    return name if name in found else ",".join(found)


def _elastic(simulation: Simulation) -> Simulation:
    """With bodies that do not yield."""
    bodies = {}
    for name in ("body1", "body2"):
        body = getattr(simulation, name)
        if body.is_plastic:
            elastic = Material.elastic(body.E, body.nu)
            bodies[name] = elastic if body.thermal is None else elastic.with_thermal(*body.thermal)
    return half_resolution.remade(simulation, **bodies)


def _marks(states: Sequence[State]) -> set[int]:
    """The last increment under the largest load, and the last."""
    loads = [state.load for state in states]
    most = max(loads) * (1 - 1e-9)
    return {max(n for n, load in enumerate(loads) if load >= most), len(states) - 1}


def _enclosed(search: _Search, start: float, most: float) -> float:
    """About where, on cells twice as large."""
    try:
        half_resolution.coarser_grid(search.build(start)[0].grid)
        missing = search.on_coarse
    except ValueError:
        missing = search.on_grid
    why: list[object] = [f"largest_load is {most:.6g} N"]

    def tried(load: float) -> float | None:
        """None under loads that have no solution."""
        try:
            return missing(load)
        except (ValueError, ConvergenceError, MemoryError) as error:
            why[0] = error
            return None

    low, value = start, tried(start)
    while (value is None or value > 0) and low > _LEAST * start:
        most, low = (low, 0.5 * low) if value is None else (most, 0.5 * low)
        value = tried(low)
    if value is None or value > 0:
        raise search.refuse(why[0])
    high, value = low, -1.0
    while value is None or value < 0:
        low, most = (high, most) if value is not None else (low, 0.5 * (low + high))
        high = min(2.0 * low, most)
        if high < (1 + _COARSE) * low:
            raise search.refuse(why[0])
        value = tried(high)
    found: float = scipy.optimize.brentq(missing, low, high, xtol=_COARSE * low, rtol=_COARSE)
    return found


def _refined(search: _Search, near: float, tolerance: float) -> FoundLoad:
    """By secants on the grid itself; halves where these leave what encloses the load."""
    low, high = 0.0, math.inf
    points: list[tuple[float, float]] = []
    load = near
    for _ in range(_TRIES):
        missing = search.on_grid(load)
        points.append((load, missing))
        low, high = (load, high) if missing < 0 else (low, load)
        if abs(missing) <= tolerance and len(points) > 1:
            return _outcome(search, load, _slope(points))
        step = -missing / _slope(points) if len(points) > 1 else -missing * load
        load += min(max(step if step else tolerance * load, -0.5 * load), load)
        if not low < load < high:
            load = 0.5 * (low + high)
    raise search.refuse(f"within {_TRIES} solves the tolerance {tolerance!r} is not met")


def _slope(points: Sequence[tuple[float, float]]) -> float:
    """Of the last point and the one nearest to it."""
    *others, (load, missing) = points
    other, value = min(others, key=lambda point: abs(point[0] - load))
    slope = (missing - value) / (load - other)
    return slope if slope > 0 else 1.0 / load


def _outcome(search: _Search, load: float, slope: float) -> FoundLoad:
    missing, (simulation, path), states = search.fine[load]
    try:
        estimated = estimate_errors(simulation, path, states)
        errors = [_relative(estimated.values[n], estimated.errors[n]) for n in search.parts]
        error = max(errors)
    except (ValueError, ConvergenceError, MemoryError):  # it has none, which NaN tells
        error = math.nan
    value = search.target * (1.0 + missing)
    load_error = (abs(missing) + error) / slope
    return FoundLoad(search.name, load, load_error, value, error * value, states)


def _relative(values: FloatArray, errors: FloatArray) -> float:
    """Where the value is largest."""
    known = np.where(np.isfinite(errors), np.abs(values), -1.0)
    at = int(known.argmax())
    return float(errors[at] / known[at])
