# SPDX-License-Identifier: GPL-3.0-or-later
"""How far results depend on the cells of their grid, from a solve over cells twice as large."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from .._util.checks import FloatArray, require_list, step_list
from .._util.display import Rows, Shown, percent, quantity, rows_of
from .._util.errors import ResolutionWarning
from .._util.quantities import described
from .._util.short_text import in_short
from ..diagnostics import sharp_edges
from ..diagnostics.resolution import ROUND_SPOT, area_uncertainty
from ..scene.friction import friction_law
from ..simulation import coarsening, error_controlled_quantities, increment_errors
from ..simulation.increment_errors import IncrementErrors
from ..simulation.repeated import coarsened
from ..simulation.restoring import repeat_with
from ..simulation.run import run_into
from ..simulation.steps import STEP
from ..solutions.contact_area import area_doubt
from ..solutions.peak import peak
from ..solutions.state import in_one_window
from ..solutions.tangential_quantities import ROUNDING, along_surface, not_rounding

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import Case
    from ..scene.grid import Grid
    from ..simulation.simulation import Simulation
    from ..solutions.state import State

__all__ = ["GridErrors", "estimate_errors"]

LARGEST_ERROR = 0.2
"""Relative, above which the check of a report fails."""
LARGEST_SHARE = 0.25
"""Of the mean square slope in the last octave of a grid: with more, most of it may lie beyond."""
_KINDS = (
    ("approach", "max_pressure", "max_von_mises"),
    ("max_equivalent_plastic_strain", "max_residual_von_mises", "print_depth"),
)
_LEAST = 0.2
"""Of the largest relative difference of a kind, which each of that kind has at least: where grids
differ in sign, two may agree by chance."""
_OF_AREA = 0.7
"""Bound of the relative error of an area of round spots over (cells in their radius)^-1.5: of wavy
surfaces; balls have half of it."""


@dataclass(frozen=True, eq=False)
class GridErrors(Shown):
    """Certified quantities of a run with their estimated errors.

    Attributes
    ----------
    values, errors : dict of ndarray, shape (increments,)
        By their names in results files, in SI units; the values between the cells, see
        docs/theory/accuracy.md. NaN where not estimated: quantities of the volume are at the
        increment of largest stress and at the last. Errors are infinite where a quantity does not
        converge: the largest pressure, stresses and strains at a sharp edge, see
        `SingularPressureWarning`.
    states : list of State
        Of the run itself.
    slope_beyond : float
        Of heights that are known on the grid only: share of the mean square slope of their
        roughness in waves shorter than four cells; NaN of other surfaces.
    increments : IncrementErrors or None
        What more increments would change, which is no part of `errors`; None where they have no
        part in the result, or where it is not known.
    """

    values: dict[str, FloatArray]
    errors: dict[str, FloatArray]
    states: list[State]
    slope_beyond: float
    increments: IncrementErrors | None = None

    def _rows(self) -> Rows:
        found = _largest_of(self.values, self.errors, {}, {})
        rows = [(row.label, row.with_error) for row in found]
        if self.increments is not None:
            rows += [(f"{name}, by increments", share) for name, share in rows_of(self.increments)]
        return rows

    def __repr__(self) -> str:
        return f"GridErrors({len(self.errors)} quantities of {len(self.states)} increments)"

    def add_to(self, dataset: xr.Dataset) -> None:
        """Add ``X_error`` of each X, and X itself where the dataset has none.

        The error is that of the dataset's own X: what it differs by from the value between the
        cells is added. The error by increments, relative, is the attribute ``by_increments`` of
        ``X_error``; those of whole fields are attributes ``increment_error_FIELD`` of the dataset.
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
            variable.attrs["long_name"] = f"estimated error by the cells of the grid, {text}"
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
    """Estimate how far a run depends on the cells of its grid.

    The run is repeated from its start with half as many cells along x, y and z and the same
    increments: about 1/8 of its time. Where layers yield, the coarser cells are two to three times
    as deep, so that the layers have a whole number of them. Where all surfaces are functions of a
    grid, so are those of the coarser one; heights that are known on one grid only are averaged.

    Parameters
    ----------
    run : Case or Simulation
        A case is solved; of a simulation, give what it was run with and what came out:
    path : list of dict
        As for `Simulation.run`, from the undeformed bodies on.
    states : sequence of State
        What it returned.

    Returns
    -------
    GridErrors
        An error is the difference of the two solves: three times the true error of what converges
        with the second order, once that of the first. Increments are the same in both; what their
        number does is estimated by itself (`increments`).

    Raises
    ------
    ValueError
        A grid that cannot be halved; a simulation without path and states.
    ConvergenceError, MemoryError, GridTooSmallError
        Of either solve.

    Warns
    -----
    ResolutionWarning
        Layers that yield have no whole number of deeper cells: the errors tell nothing of depth.
    IncrementWarning
        Unless the simulation gave it before: more increments would change fields by more than 5 %.
    """
    from ..cases import Case
    from ..simulation.simulation import Simulation
    from ..solutions.state import State

    if isinstance(run, Case):
        run, path = run.build()
        states = []
        run_into(states, run.engine, run.monitor, run.step, list(path), False, None)
        states = in_one_window(states)
    if not isinstance(run, Simulation):
        raise TypeError(
            f"run must be a samcontact.Simulation, or a Case of one contact, got {in_short(run)}"
        )
    if path is None or states is None:
        raise ValueError("path and states must be given with a simulation")
    path = step_list("path", path, STEP)
    require_list("states", states, State)
    if len(path) != len(states):
        raise ValueError(f"path and states must be as many, got {len(path)} and {len(states)}")
    found = estimated(run, path, states, lambda coarse, steps: coarse.run(steps, progress=False))
    by_increments = increment_errors.estimated(
        run.engine, path, states, states[0].heat, repeat_with(type(run)), certified=True
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
    """The same by a solve of the coarser simulation and its path that the caller keeps."""
    coarse = coarsened(run, states[0].heat)
    _warn_of_depth(run.grid, coarse.grid)
    steps, which = coarsening.coarser_path(path, run.grid)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of a grid that is not the user's
        found = solve(coarse, steps)
    names = error_controlled_quantities.names((run.body1, run.body2), volume=run.grid.has_volume)
    marks = _marks(states, names)
    shape = len(states)
    values = {name: np.full(shape, np.nan) for name in names}
    errors = {name: np.full(shape, np.nan) for name in names}
    for at, state in enumerate(states):
        known = [n for n in names if at in marks or n in error_controlled_quantities.OF_CONTACT]
        fine = error_controlled_quantities.values(state, known)
        sharp = sharp_edges.edge_of_state(state) is not None
        coarse_values = error_controlled_quantities.values(found[which[at]], known)
        difference = _differences(fine, coarse_values, state, sharp=sharp)
        for name in known:
            values[name][at], errors[name][at] = fine[name], difference[name]
    if friction_law(run.friction).sticks:
        for name, (value, error) in _of_slip(states, [found[n] for n in which]).items():
            values[name], errors[name] = value, error
    beyond = np.nan
    if not callable(run.engine.setup.surfaces.gap) and np.isfinite(run.initial_gap).all():
        beyond = coarsening.slope_beyond(run.initial_gap, run.grid.dx, run.grid.dy)
    return GridErrors(values, errors, list(states), beyond)


def _warn_of_depth(grid: Grid, coarse: Grid) -> None:
    """Warn of errors that tell nothing of the depth of the cells."""
    if grid.dz is not None and coarse.dz == grid.dz:
        warnings.warn(
            f"the errors hold nothing of the depth of the cells, dz = {quantity(grid.dz, 'm')}: "
            "the layers that yield have no whole number of deeper ones; with half of dz they would",
            ResolutionWarning,
            stacklevel=3,
        )


def _marks(states: Sequence[State], names: Sequence[str]) -> set[int]:
    """Increments at which the volume is compared: that of the largest stress, and the last."""
    from ..results.zones import max_von_mises

    bodies = {int(name[-1]) for name in names if name.startswith("max_von_mises")}
    stress = [[max_von_mises(state, body) for state in states] for body in bodies]
    pressure = [float(state.pressure.max()) for state in states]
    largest = np.max(stress, axis=0) if stress else None
    return {peak(largest, pressure, [state.load for state in states]), len(states) - 1}


def _differences(
    fine: Mapping[str, float], coarse: Mapping[str, float], state: State, *, sharp: bool
) -> dict[str, float]:
    """Of two solves, and no less than chance may have left of them.

    Infinite for what is singular at a sharp edge.
    """
    found = {name: abs(value - coarse[name]) for name, value in fine.items()}
    endless = {name for name in fine if sharp and sharp_edges.is_singular(name)}
    for kind in _KINDS:
        relative = {
            name: found[name] / abs(value)
            for name, value in fine.items()
            if value != 0 and name not in endless and name.partition("_body")[0] in kind
        }
        least = _LEAST * max(relative.values(), default=0.0)
        for name in relative:
            found[name] = max(found[name], least * abs(fine[name]))
    if fine["contact_area"] > 0:
        share = area_uncertainty(state.repulsion, state.grid.periodic)
        of_area = _OF_AREA * (2 * share / ROUND_SPOT) ** 1.5
        of_area += area_doubt(state.repulsion, state.grid.periodic)
        cells = np.count_nonzero(state.in_contact)
        if 0 < (open_ := state.pressure.size - cells) < cells and state.grid.periodic == "xy":
            of_area *= (cells / open_) ** 0.5  # the spots that are not resolved are the open ones
        found["contact_area"] = max(found["contact_area"], of_area * fine["contact_area"])
    return found | dict.fromkeys(endless, np.inf)


def _of_slip(
    states: Sequence[State], coarse: Sequence[State]
) -> dict[str, tuple[FloatArray, FloatArray]]:
    """Forces, motions and friction work with their errors, without what was given or is rounding.

    At each increment the error is a part of the largest so far at least: where a quantity turns
    round, both grids agree by chance.
    """
    found = {}
    mine, other = along_surface(states), along_surface(coarse)
    sizes = ([getattr(s, name) for s in states] for name in ("load", "approach", "contact_area"))
    for name in [*not_rounding(mine, *map(np.array, sizes)), "friction_work"]:
        value = mine[name]
        error = np.abs(value - other[name])
        if error.max() > ROUNDING * np.abs(value).max():
            found[name] = value, np.maximum(error, _LEAST * np.maximum.accumulate(error))
    return found


def said_of_increments(attributes: Mapping[Any, Any]) -> str:
    """What more increments would change in whole fields, from the attributes of results; nothing
    where that is not known."""
    start = "increment_error_"
    shares = {str(n).removeprefix(start): s for n, s in attributes.items() if start in str(n)}
    return f"{increment_errors.said(shares)} of its largest value" if shares else ""


def said_of_slope(share: float) -> str:
    """What a surface has beyond its grid, in words; nothing of one that is known everywhere."""
    if not np.isfinite(share):
        return ""
    beyond = (
        "most of it may lie beyond the grid, and pressures and strains of the spots are those of "
        "the cells"
        if share > LARGEST_SHARE
        else "little is beyond the grid where the spectrum goes on as it is"
    )
    return (
        f"{percent(share)} of the mean square slope of the surface is in waves shorter than "
        f"four cells: {beyond}"
    )


ENDLESS = "does not converge"
"""Of an error without a bound, at a sharp edge."""


class ErrorRow(NamedTuple):
    """A quantity where it is largest: the number of the increment, its value; its error over that
    (the largest of the run where an accuracy was asked for)."""

    label: str
    increment: int
    shown: str
    relative: float
    asked: float | None = None
    by_increments: float | None = None
    """What more increments would change, relative; None where it is not known or in `relative`."""

    @property
    def percent(self) -> str:
        """The error over the value [%], in words where it does not converge."""
        return f"{100 * self.relative:.2g}" if np.isfinite(self.relative) else ENDLESS

    @property
    def with_error(self) -> str:
        """The value with its error."""
        if np.isfinite(self.relative):
            return f"{self.shown} ± {self.percent} %"
        return f"{self.shown}, {ENDLESS}"


def error_rows(dataset: xr.Dataset) -> list[ErrorRow]:
    """Of results with errors; none of others."""
    names = [str(name)[: -len("_error")] for name in dataset if str(name).endswith("_error")]
    values = {name: dataset[f"{name}_best" if f"{name}_best" in dataset else name].values
              for name in names}  # fmt: skip
    errors = {name: dataset[f"{name}_error"].values for name in names}
    asked = {name: dataset[f"{name}_error"].attrs.get("accuracy") for name in names}
    by_increments = {name: dataset[f"{name}_error"].attrs.get("by_increments") for name in names}
    return _largest_of(values, errors, asked, by_increments)


def _largest_of(
    values: Mapping[str, FloatArray],
    errors: Mapping[str, FloatArray],
    asked: Mapping[str, float | None],
    by_increments: Mapping[str, float | None],
) -> list[ErrorRow]:
    """Without what is zero throughout, or given."""
    rows = []
    for name, error in errors.items():
        known = np.where(error > 0, np.abs(values[name]), -1.0)
        at = int(known.argmax())
        if known[at] > 0:
            quantity_of, body = described(name)
            unit = {"m2": "m²", "1": ""}.get(quantity_of.unit, quantity_of.unit)
            label = quantity_of.heading
            label = label if body is None else f"{label}, body {body}"
            shown = quantity(float(values[name][at]), unit, 5)
            wanted = asked.get(name)  # of all increments, relative to the largest value
            relative = float((error[at] if wanted is None else np.nanmax(error)) / known[at])
            row = ErrorRow(label, at + 1, shown, relative, wanted, by_increments.get(name))
            rows.append(row)
    return rows
