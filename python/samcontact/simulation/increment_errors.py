# SPDX-License-Identifier: GPL-3.0-or-later
"""Estimated errors due to the size of increments, from a run with more or fewer increments."""

from __future__ import annotations

import logging
import math
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .._util.checks import FloatArray
from .._util.display import HtmlTable, Rows, percent
from .._util.errors import IncrementWarning, is_ignored
from ..bodies.layered import materials_of
from ..bodies.viscoelastic import relaxes
from ..diagnostics.resolution import cells_across, spots
from ..solutions.peak import peak
from . import coarsening, error_controlled_quantities
from .increment_paths import cleaned, doubled, halved

if TYPE_CHECKING:
    from ..diagnostics.monitor import Monitor
    from ..heat import Heat
    from ..problem.grid import Grid
    from ..problem.setup import SimulationSetup
    from ..solutions.state import State
    from .engine import Engine

__all__ = ["IncrementErrors", "IncrementWarning", "estimated"]

MAX_ERROR_WITHOUT_WARNING = 0.05
"""Relative error above which a warning is issued."""
_MIN_CELLS = {True: 6.0, False: 16.0}
"""Minimum number of cells across the contact, with (True) and without (False) plastic flow. Without
plastic flow, the size of increments affects only a few cells, at the boundary of the stick zone."""
_MIN_INCREMENTS = 3
_DOUBLING_FACTORS = 2.0, 2.0
"""Error with n increments divided by the difference between results with n and 2n increments, for
plastic strain and for other fields; exact for first-order convergence."""
_HALVING_FACTORS = 2.0, 1.5
"""Error with n increments divided by the difference between results with n/2 and n increments, for
plastic strain and for other fields. In theory, this ratio is 1 for first-order convergence, and 2.4
for order 1/2, which occurs in single cells. The two values are calibrated, see
docs/theory/accuracy.md."""

_logger = logging.getLogger("samcontact")

_RELAXING_FACTORS = {True: (1.0, 1.0), False: (2.0, 2.0)}
"""Ratios like those above, for creep without plastic flow and without partial slip; the comparison
has half (True) or twice (False) as many increments. Exact for first-order convergence, and an upper
bound for second order."""

Repeat = Callable[["SimulationSetup", "Grid", "Heat", Sequence[Mapping[str, Any]]], list["State"]]
"""Function that runs a setup on a grid, with an initial heat, along a path."""


@dataclass(frozen=True, eq=False)
class IncrementErrors(HtmlTable):
    """Estimated relative errors of a run due to the size of its increments.

    Attributes
    ----------
    fields : dict of float
        Errors of "pressure", "shear" and "equivalent_plastic_strain_bodyN": maximum over all cells
        and increments, relative to the maximum value of the run. The error of plastic strain is
        relative to the maximum value or the yield strain, whichever is larger, and is determined
        only at the increment of maximum load and the last increment. It omits cells that an
        inclusion fills partly.
    values : dict of float
        Errors of the quantities with error control, by their names in results files. The errors at
        the increment of maximum load and at the last increment are compared; the larger error is
        divided by the larger of the values at these two increments.
    compared : str
        Description of the runs that were compared.
    """

    fields: dict[str, float]
    values: dict[str, float]
    compared: str

    @property
    def max_error(self) -> float:
        """Maximum error of the fields."""
        return max(self.fields.values(), default=0.0)

    def __str__(self) -> str:
        return f"{error_summary(self.fields)} of its maximum (estimated from {self.compared})"

    def _rows(self) -> Rows:
        return [(_label(name), f"± {percent(share)}") for name, share in self.fields.items()]

    def __repr__(self) -> str:
        return f"IncrementErrors({self.fields}, from {self.compared})"


def warn_of_errors(errors: IncrementErrors, *, stacklevel: int) -> bool:
    """Warn of errors above 5 %; return whether the warning was issued."""
    if errors.max_error <= MAX_ERROR_WITHOUT_WARNING:
        return False
    times = math.ceil(errors.max_error / MAX_ERROR_WITHOUT_WARNING)
    text = f"{errors}: use smaller increments, about {times} times as many for 5 %"
    warnings.warn(text, IncrementWarning, stacklevel=stacklevel + 1)
    return True


def is_path_dependent(setup: SimulationSetup, states: Sequence[State]) -> bool:
    """Whether some of the states depend on the number of increments.

    States with partial slip depend on this number. States after plastic flow depend on it unless
    `increment_tol` controls the error.
    """
    last = states[-1]
    if setup.friction.sticks:
        if any(state.shear.any() for state in states):
            return True
    elif setup.settings.increment_tol is not None:
        return False
    first, second = last.max_strains
    return first[0] > 0 or second[0] > 0


def check_errors(
    engine: Engine,
    monitor: Monitor,
    states: Sequence[State],
    factor: int,
    repeat: Repeat,
    *,
    stacklevel: int,
) -> None:
    """Warn of increments that are too large, at most once per simulation.

    No error is estimated if a warning filter ignores the warning.

    states: states after the latest increments. factor: an error is estimated only if the number of
    increments has grown by this factor since the last estimate; this limits the computing time.
    """
    history = engine.history
    if not monitor.checks_increments or not states or not history.is_due(factor):
        return
    if not is_path_dependent(engine.setup, states) or is_ignored(IncrementWarning):
        return
    steps = history.steps or []
    found = estimated(engine, steps, states, history.heat, repeat)
    if found is not None:
        history.checked = len(steps)
        monitor.checks_increments = not warn_of_errors(found, stacklevel=stacklevel + 1)


def estimated(
    engine: Engine,
    path: Sequence[Mapping[str, Any]],
    states: Sequence[State],
    heat: Heat,
    repeat: Repeat,
    *,
    certified: bool = False,
) -> IncrementErrors | None:
    """Estimate the effect of smaller increments on a run that starts from undeformed bodies.

    The path is solved with half as many increments if neighbouring increments can be merged,
    otherwise with twice as many. This comparison uses a coarser grid, if the contact then still is
    at least 6 cells wide (16 cells without plastic flow).

    Parameters
    ----------
    engine : Engine
        Solver of the run; unchanged.
    path : sequence of dict
        All increments since the start.
    states : sequence of State
        States of all increments or of the last increments.
    heat : Heat
        Heat of the first increment.
    repeat : callable
        Function that solves a path and returns the states; its arguments are a setup, a grid, an
        initial heat and the path.
    certified : bool, optional
        Whether to compute `IncrementErrors.values`.

    Returns
    -------
    IncrementErrors or None
        None if the size of increments does not affect the result, or if the estimate fails (the
        logger "samcontact" records why).
    """
    path = [cleaned(step) for step in path]
    affects = is_path_dependent(engine.setup, states) or (certified and _creeps(engine, path))
    if not affects or any("pressure" in step for step in path):
        return None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # they concern an auxiliary path and grid
            return _compared(engine, path, states, heat, repeat, certified)
    except Exception as error:
        _logger.info("the error due to increments is not estimated: %s", error)
        return None


def _creeps(engine: Engine, path: Sequence[Mapping[str, Any]]) -> bool:
    """Whether a viscoelastic body creeps in an increment of the path."""
    return relaxes(*engine.setup.bodies) and any(step.get("duration") for step in path)


def _compared(
    engine: Engine,
    path: Sequence[Mapping[str, Any]],
    states: Sequence[State],
    heat: Heat,
    repeat: Repeat,
    certified: bool,
) -> IncrementErrors:
    setup, domain = engine.setup, engine.domain
    steps: Sequence[Mapping[str, Any]] = path
    level = 0
    for level in range(1, _level(states) + 1):
        try:
            coarse = coarsening.coarser(setup, domain)
            steps = coarsening.coarser_path(steps, setup.steps_of_motion(domain.grid))[0]
            setup, domain = coarse
        except ValueError:  # a periodic direction that cannot be halved further
            level -= 1
            break
    grid = domain.grid
    first = list(states)
    if level > 0 or len(states) != len(path):
        first = repeat(setup, grid, heat, steps)
    start = float(domain.initial_gap.min())
    halves = halved(steps, first, start)
    merged, ends = halves or doubled(steps, first, start, setup.steps_of_motion(grid), heat)
    compared = f"{'half' if halves else 'twice'} as many increments"
    # Motions by single cells are merged on larger cells.
    ratios = _HALVING_FACTORS if halves else _DOUBLING_FACTORS
    if not is_path_dependent(engine.setup, states):
        ratios = _RELAXING_FACTORS[halves is not None]
    factors = [ratio * len(steps) / len(path) for ratio in ratios]
    second = repeat(setup, grid, heat, merged)
    if level > 0:
        compared += f", both on cells {2**level} times as large"
    pairs = [(first[one], second[other]) for one, other in ends]
    loads = [one.load for one, _ in pairs]
    top = peak(None, [float(one.pressure.max()) for one, _ in pairs], loads)
    marks = [pairs[n] for n in sorted({top, len(pairs) - 1})]
    values = _value_differences(setup, grid, marks) if certified else {}
    return IncrementErrors(
        _scaled(_field_differences(setup, pairs, marks), factors),
        _scaled(values, factors),
        compared,
    )


def _scaled(differences: Mapping[str, float], factors: Sequence[float]) -> dict[str, float]:
    """Multiply differences by factors[0] for strains, factors[1] for others; return the errors."""
    return {
        name: factors[0 if "strain" in name else 1] * share for name, share in differences.items()
    }


def _level(states: Sequence[State]) -> int:
    """Return how many times the cell size is doubled to obtain the grid of the estimate."""
    top = max(states, key=lambda state: float(state.pressure.max()))
    periodic = top.grid.periodic
    yields = any(states[-1].max_equivalent_plastic_strain(body) > 0 for body in (1, 2))
    across = cells_across(top.repulsion, periodic)
    if math.isnan(across) or spots(top.repulsion, periodic) > 1:  # a rough surface
        return int(min(top.grid.surface_shape) >= 32)
    return max(0, min(_MIN_INCREMENTS, int(math.log2(across / _MIN_CELLS[yields]))))


Pairs = Sequence[tuple["State", "State"]]


def _field_differences(setup: SimulationSetup, pairs: Pairs, marks: Pairs) -> dict[str, float]:
    """Return the maximum difference of each field, relative to the maximum value of the field."""
    names = ["pressure", "shear"] if setup.friction.sticks else ["pressure"]
    found = {}
    for name in names:
        both = [(getattr(one, name), getattr(other, name)) for one, other in pairs]
        found[name] = _difference(both, 0.0)
    for number, body in enumerate(setup.bodies, 1):
        if marks[-1][0].max_equivalent_plastic_strain(number) > 0:
            both = [(_plastic_strain(one, number), _plastic_strain(other, number)) for one, other in
                    marks]  # fmt: skip
            strains = [m.min_yield_stress / m.E for m in materials_of(body) if m.is_plastic]
            name = f"equivalent_plastic_strain_body{number}"
            found[name] = _difference(both, min(strains, default=0.0))
    return {name: share for name, share in found.items() if math.isfinite(share)}


def _plastic_strain(state: State, body: int) -> FloatArray:
    """Return the equivalent plastic strain, with 0 in cells that an inclusion fills partly.

    The matrix in a cell that a void nearly fills carries hardly any load, and its strain is not
    accurate.
    """
    share, strain = state.share(body), state.equivalent_plastic_strain(body)
    return np.where((share > 0.0) & (share < 1.0), 0.0, strain)


def _difference(both: Sequence[tuple[FloatArray, ...]], floor: float) -> float:
    """Return the maximum difference, relative to the larger of the maximum value and `floor`."""
    largest = max([floor, *(float(np.abs(one).max()) for one, _ in both)])
    differences = [float(np.abs(np.subtract(*_common(*pair))).max()) for pair in both]
    return max(differences) / largest if largest > 0 else 0.0


def _common(one: FloatArray, other: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Restrict two fields with the same centre to their common cells and layers."""
    if one.shape == other.shape:
        return one, other
    x = 1 if one.ndim == 3 and len(one) == 2 else 0  # for a pair of components
    cut = []
    for field_of, like in ((one, other), (other, one)):
        for axis in (x, x + 1):
            n, m = field_of.shape[axis], min(field_of.shape[axis], like.shape[axis])
            field_of = field_of.take(range((n - m) // 2, (n - m) // 2 + m), axis)
        if field_of.ndim == 3 and x == 0:
            field_of = field_of[:, :, : like.shape[2]]
        cut.append(field_of)
    return cut[0], cut[1]


def _value_differences(setup: SimulationSetup, grid: Grid, marks: Pairs) -> dict[str, float]:
    """Return the differences of quantities with error control, relative to their maxima."""
    names = error_controlled_quantities.names(setup.bodies, volume=grid.has_volume)
    one, other = (
        [error_controlled_quantities.values(pair[which], names) for pair in marks]
        for which in (0, 1)
    )
    found = {}
    for name in names:
        largest = max(abs(values[name]) for values in one)
        if largest > 0:
            differences = [abs(a[name] - b[name]) for a, b in zip(one, other, strict=True)]
            found[name] = max(differences) / largest
    return found


def error_summary(shares: Mapping[str, float]) -> str:
    """Return a text that lists the errors of all fields, largest error first."""
    found = sorted(shares.items(), key=lambda item: -item[1])
    parts = [f"the {_label(name)} by about {percent(share)}" for name, share in found]
    return f"more increments would change {', '.join(parts)}"


def _label(name: str) -> str:
    text, _, body = name.partition("_body")
    text = text.replace("_", " ")
    return f"{text} of body {body}" if body else text
