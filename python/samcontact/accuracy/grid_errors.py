# SPDX-License-Identifier: GPL-3.0-or-later
"""Estimated grid errors of results, from a second solution with cells twice as large."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from .._util.checks import FloatArray, require_list
from .._util.display import HtmlTable, Rows, percent, quantity, rows_of
from .._util.errors import ResolutionWarning
from .._util.quantities import described
from .._util.short_text import in_short
from ..diagnostics import sharp_edges
from ..diagnostics.resolution import ROUND_SPOT_AREA_ERROR, area_uncertainty
from ..problem.friction import friction_law
from ..simulation import coarsening, error_controlled_quantities, increment_errors
from ..simulation.increment_errors import IncrementErrors
from ..simulation.repeated import coarsened, coarsened_path
from ..simulation.restoring import repeat_with
from ..simulation.run import run_into
from ..simulation.unfolding import run_list, solved_path
from ..solutions.contact_area import perimeter_correction
from ..solutions.peak import peak
from ..solutions.state import on_common_grid
from ..solutions.tangential_quantities import ROUNDING_ERROR, along_surface, not_rounding
from .error_rows import rows_of_maxima

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import Case
    from ..problem.grid import Grid
    from ..simulation.simulation import Simulation
    from ..solutions.state import State

__all__ = ["GridErrors", "estimate_errors"]

MAX_RELATIVE_ERROR = 0.2
"""Estimated relative error above which the error check of a report fails."""
MAX_SLOPE_FRACTION = 0.25
"""Largest acceptable fraction of the mean-square slope at wavelengths below four cells. With a
larger fraction, most of the slope may be at wavelengths that the grid does not contain."""
_KINDS = (
    ("approach", "max_pressure", "max_von_mises"),
    (
        "max_equivalent_plastic_strain",
        "max_residual_von_mises",
        "imprint_depth",
        "viscous_work",
    ),
)
_MIN_ERROR_OF_KIND = 0.2
"""Minimum relative error of a quantity, as a fraction of the largest relative difference between
the two grids among the quantities of its group in `_KINDS`. It is needed because the values of a
quantity on two grids may agree by chance."""
_AREA_ERROR_FACTOR = 0.7
"""Factor C of the bound C (cells per radius)^-1.5 on the relative error of the area of round spots.
The factor applies to wavy surfaces; the error for a sphere is half as large."""


@dataclass(frozen=True, eq=False)
class GridErrors(HtmlTable):
    """Quantities of a run with their estimated errors.

    Attributes
    ----------
    values, errors : dict of ndarray, shape (increments,)
        Values and absolute errors in SI units, by the name of the quantity in results files. Values
        are interpolated between cells, see docs/theory/accuracy.md. Stresses, strains and imprint
        depths, with their errors, are given at the increment of maximum stress and at the last
        increment; they are NaN elsewhere. At a sharp edge, maximum pressure, stresses and strains
        do not converge, and their errors are infinite, see `SingularPressureWarning`.
    states : list of State
        States of the run itself, not of the coarser solution.
    slope_beyond : float
        Fraction of the mean-square slope at wavelengths below four cells, for heights that are
        known on the grid only; NaN for other surfaces.
    increments : IncrementErrors or None
        Estimated change of the results with more increments, which `errors` does not include; None
        if increments do not affect the results, or if the change is unknown.
    """

    values: dict[str, FloatArray]
    errors: dict[str, FloatArray]
    states: list[State]
    slope_beyond: float
    increments: IncrementErrors | None = None

    def _rows(self) -> Rows:
        found = rows_of_maxima(self.values, self.errors, {}, {})
        rows = [(row.label, row.with_error) for row in found]
        if self.increments is not None:
            rows += [
                (f"{name}, due to increments", share) for name, share in rows_of(self.increments)
            ]
        return rows

    def __repr__(self) -> str:
        return f"GridErrors({len(self.errors)} quantities of {len(self.states)} increments)"

    def add_to(self, dataset: xr.Dataset) -> None:
        """Add ``X_error`` to a dataset for each quantity X, and X itself if it is missing.

        ``X_error`` is the error of X as stored in the dataset. It includes the difference between X
        and the value interpolated between cells. The relative error due to increments is stored as
        the attribute ``by_increments`` of ``X_error`` or, for whole fields, as the attribute
        ``increment_error_FIELD`` of the dataset.
        """
        if not hasattr(dataset, "attrs"):
            raise TypeError(f"dataset must be an xarray.Dataset, got {in_short(dataset)}")
        for name, errors in self.errors.items():
            known, body = described(name)
            if name not in dataset:
                dataset[name] = known.variable("increment", self.values[name], body)
            total = errors + np.abs(dataset[name].values - self.values[name])
            variable = known.variable("increment", total, body)
            text = dataset[name].attrs["long_name"]
            variable.attrs["long_name"] = f"estimated absolute grid error of: {text}"
            if self.increments is not None and name in self.increments.values:
                variable.attrs["by_increments"] = self.increments.values[name]
            dataset[f"{name}_error"] = variable
        if self.increments is not None:
            fields = self.increments.fields.items()
            dataset.attrs |= {f"increment_error_{name}": share for name, share in fields}
        if np.isfinite(self.slope_beyond):
            dataset.attrs["slope_beyond"] = self.slope_beyond


def estimate_errors(
    run: Case | Simulation,
    path: Sequence[Mapping[str, Any]] | None = None,
    states: Sequence[State] | None = None,
) -> GridErrors:
    """Estimate the grid errors of a run.

    The run is repeated with the same increments and half as many cells along x, y and z. This takes
    about 1/8 of the time of the run. For elastic-plastic layers, the coarser cells are two to three
    times as deep, so that each layer has a whole number of cells. Surfaces given as functions are
    evaluated on the coarser grid; heights known on one grid only are averaged.

    Parameters
    ----------
    run : Case or Simulation
        Case, which is solved first; or a simulation after a run, together with `path` and `states`.
    path : list of dict
        Argument of the call of `Simulation.run`, which must have started from undeformed bodies.
    states : sequence of State
        States returned by `Simulation.run`.

    Returns
    -------
    GridErrors
        Each error is the difference between the two solutions. It is three times the true error for
        second-order convergence, and equal to the true error for first-order convergence. Both
        solutions have the same increments; the effect of the increments is estimated separately
        (`GridErrors.increments`).

    Raises
    ------
    ValueError
        The grid cannot be coarsened, a simulation is given without path and states, path and states
        differ in length, or a plastic strain was prescribed by `Simulation.set_plastic_strain`.
    ConvergenceError, MemoryError, GridTooSmallError
        One of the two solutions failed.

    Warns
    -----
    ResolutionWarning
        The errors do not include the effect of dz, because the elastic-plastic layers cannot be
        divided into a whole number of deeper cells.
    IncrementWarning
        More increments would change fields by more than 5 %. The warning is not repeated if the
        simulation has already issued it.
    """
    from ..cases import Case
    from ..simulation.simulation import Simulation
    from ..solutions.state import State

    if isinstance(run, Case):
        run, path = run.build()
        states = []
        run_into(states, run.engine, run.monitor, run.step, list(path), False, None)
        states = on_common_grid(states)
    if not isinstance(run, Simulation):
        raise TypeError(
            f"run must be a samcontact.Simulation, or a Case of one contact, got {in_short(run)}"
        )
    if run.engine.history.has_given_strain:
        raise ValueError(
            "run must be a simulation without a plastic strain prescribed by set_plastic_strain, "
            "because this strain is known on one grid only: repeat the run on a grid with half as "
            "many cells along each axis, and compare the results"
        )
    if path is None or states is None:
        raise ValueError("path and states are required if run is a samcontact.Simulation")
    path = run_list("path", path)
    require_list("states", states, State)
    if len(path) <= len(states):  # a retraction has several states
        path = solved_path(path, run.engine, states)
    if len(path) != len(states):
        raise ValueError(
            f"path and states must have equal lengths, got {len(path)} and {len(states)}"
        )
    found = estimated(run, path, states, lambda coarse, steps: coarse.run(steps, progress=False))
    repeat = repeat_with(type(run), run.engine.preparation)
    by_increments = increment_errors.estimated(
        run.engine, path, states, states[0].heat, repeat, certified=True
    )
    if by_increments is not None and run.monitor.checks_increments:
        run.monitor.checks_increments = not increment_errors.warn_of_errors(
            by_increments, stacklevel=2
        )
    return replace(found, increments=by_increments)


def estimated(
    run: Simulation,
    path: Sequence[Mapping[str, Any]],
    states: Sequence[State],
    solve: Callable[[Simulation, Sequence[Mapping[str, Any]]], list[State]],
) -> GridErrors:
    """Estimate the grid errors of a simulation from its path and states.

    solve: function that solves a simulation on the coarser grid and returns its states.
    """
    steps, which = coarsened_path(run, path)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # these warnings concern the coarser grid
        coarse = coarsened(run, states[0].heat)
        found = solve(coarse, steps)
    _warn_of_depth(run.grid, coarse.grid)
    names = error_controlled_quantities.names((run.body1, run.body2), volume=run.grid.has_volume)
    marks = _marks(states, names)
    shape = len(states)
    values = {name: np.full(shape, np.nan) for name in names}
    errors = {name: np.full(shape, np.nan) for name in names}
    for at, state in enumerate(states):
        known = [
            n for n in names if at in marks or n in error_controlled_quantities.CONTACT_QUANTITIES
        ]
        fine = error_controlled_quantities.values(state, known)
        sharp = sharp_edges.edge_of_state(state) is not None
        coarse_values = error_controlled_quantities.values(found[which[at]], known)
        difference = _differences(fine, coarse_values, state, sharp=sharp)
        for name in known:
            values[name][at], errors[name][at] = fine[name], difference[name]
    if friction_law(run.friction).sticks:
        for name, (value, error) in _slip_errors(states, [found[n] for n in which]).items():
            values[name], errors[name] = value, error
    beyond = np.nan
    if not callable(run.engine.setup.surfaces.gap) and np.isfinite(run.initial_gap).all():
        beyond = coarsening.slope_beyond(run.initial_gap, run.grid.dx, run.grid.dy)
    return GridErrors(values, errors, list(states), beyond)


def _warn_of_depth(grid: Grid, coarse: Grid) -> None:
    """Warn if the errors do not include the effect of dz."""
    if grid.dz is not None and coarse.dz == grid.dz:
        warnings.warn(
            f"estimated errors exclude the effect of dz = {quantity(grid.dz, 'm')}: the "
            "elastic-plastic layers cannot be divided into thicker cells. To see the "
            "effect of dz, solve again with half this dz",
            ResolutionWarning,
            stacklevel=3,
        )


def _marks(states: Sequence[State], names: Sequence[str]) -> set[int]:
    """Return the indices of increments at which errors of all quantities are estimated."""
    from ..results.zones import max_von_mises

    bodies = {int(name[-1]) for name in names if name.startswith("max_von_mises")}
    stress = [[max_von_mises(state, body) for state in states] for body in bodies]
    pressure = [float(state.pressure.max()) for state in states]
    largest = np.max(stress, axis=0) if stress else None
    return {peak(largest, pressure, [state.load for state in states]), len(states) - 1}


def _differences(
    fine: Mapping[str, float], coarse: Mapping[str, float], state: State, *, sharp: bool
) -> dict[str, float]:
    """Return the difference of each quantity between two grids, by name.

    Because values on two grids may agree by chance, each relative difference is raised to at least
    20 % of the largest in its group of `_KINDS`. The relative difference of the contact area is
    raised to at least the error that `of_outline` returns. The difference is infinite for
    quantities that are singular at a sharp edge.
    """
    found = {name: abs(value - coarse[name]) for name, value in fine.items()}
    endless = {name for name in fine if sharp and sharp_edges.is_singular(name)}
    for kind in _KINDS:
        relative = {
            name: found[name] / abs(value)
            for name, value in fine.items()
            if value != 0 and name not in endless and name.partition("_body")[0] in kind
        }
        floor = _MIN_ERROR_OF_KIND * max(relative.values(), default=0.0)
        for name in relative:
            found[name] = max(found[name], floor * abs(fine[name]))
    if fine["contact_area"] > 0:
        found["contact_area"] = max(found["contact_area"], of_outline(state) * fine["contact_area"])
    return found | dict.fromkeys(endless, np.inf)


def of_outline(state: State) -> float:
    """Return the relative error of the contact area due to cells at the edges of contact spots."""
    share = area_uncertainty(state.repulsion, state.grid.periodic)
    of_area = _AREA_ERROR_FACTOR * (2 * share / ROUND_SPOT_AREA_ERROR) ** 1.5
    of_area += perimeter_correction(state.repulsion, state.grid.periodic)
    cells = np.count_nonzero(state.in_contact)
    if 0 < (open_ := state.pressure.size - cells) < cells and state.grid.periodic == "xy":
        of_area *= (cells / open_) ** 0.5  # unresolved: small open spots
    return float(of_area)


def _slip_errors(
    states: Sequence[State], coarse: Sequence[State]
) -> dict[str, tuple[FloatArray, FloatArray]]:
    """Return value and error of the frictional work and of tangential quantities, by name.

    Quantities that are prescribed or zero are omitted. The error of each increment is at least 20 %
    of the largest error up to this increment, because both grids may agree by chance where a
    quantity changes sign.
    """
    found = {}
    mine, other = along_surface(states), along_surface(coarse)
    sizes = ([getattr(s, name) for s in states] for name in ("load", "approach", "contact_area"))
    for name in [*not_rounding(mine, *map(np.array, sizes)), "friction_work"]:
        value = mine[name]
        error = np.abs(value - other[name])
        if error.max() > ROUNDING_ERROR * np.abs(value).max():
            found[name] = (
                value,
                np.maximum(error, _MIN_ERROR_OF_KIND * np.maximum.accumulate(error)),
            )
    return found


def increments_note(attributes: Mapping[Any, Any]) -> str:
    """Return a text on the effect of more increments on whole fields, or "" if it is unknown."""
    start = "increment_error_"
    shares = {str(n).removeprefix(start): s for n, s in attributes.items() if start in str(n)}
    return f"{increment_errors.error_summary(shares)} of its maximum" if shares else ""


def slope_note(share: float) -> str:
    """Return a text on the fraction of the mean-square slope at wavelengths below four cells."""
    if not np.isfinite(share):
        return ""
    beyond = (
        "most of the slope may be unresolved, and pressures and strains depend on the cell size"
        if share > MAX_SLOPE_FRACTION
        else "little slope is unresolved if the spectrum continues in this way"
    )
    return (
        f"{percent(share)} of the mean-square slope of the surface is at wavelengths below "
        f"four cells: {beyond}"
    )
