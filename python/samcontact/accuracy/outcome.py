# SPDX-License-Identifier: GPL-3.0-or-later
"""Result of a solution to a prescribed accuracy."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from .._util.checks import FloatArray
from .._util.display import HtmlTable, Rows, counts, percent, quantity

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import Case
    from ..problem.grid import Grid
    from ..shakedown import ShakedownResult
    from ..simulation.simulation import Simulation
    from ..solutions.state import State
    from ..wear import FrettingResult, WearResult
    from .grid_solution import GridSolution
    from .studies import Study


@dataclass(frozen=True, eq=False)
class AccuracyResult(HtmlTable):
    """Values with errors, and the simulation of the finest grid.

    ``values[name]`` is the maximum of a quantity in the run and ``errors[name]`` its estimated
    error, both in SI units; ``name`` is the name of the quantity in results files.
    ``series[name]`` and ``series_errors[name]`` are values and errors at selected increments: the
    end of each path segment and, for passes, also the last loaded increment. ``increments``
    contains the indices of these increments in ``states``.
    """

    values: dict[str, float]
    errors: dict[str, float]
    accuracy: dict[str, float]
    """Prescribed accuracy of each quantity, as error divided by the maximum of the run [-]."""
    reached: bool
    """Whether all errors are below the prescribed accuracy."""
    series: dict[str, FloatArray]
    series_errors: dict[str, FloatArray]
    increments: tuple[int, ...]
    states: list[State]
    """States of the finest grid."""
    simulation: Simulation
    case: Case
    """Case with the finest grid and the increments used on this grid."""
    runs: tuple[tuple[int, int, int, float], ...]
    """Cells along x and along y, increments per segment and computing time [s] of each run."""
    repeated: WearResult | FrettingResult | ShakedownResult | None = None
    """Result of repeated cycles on the finest grid, or None for a path that is solved once."""
    needs: str = ""
    """Reason why the prescribed accuracy was not reached, as text; empty if it was reached."""
    surface: str = ""
    """Note on the surface to which the errors refer, if heights are interpolated; else empty."""
    slope_beyond: float = math.nan
    """Fraction of the mean-square slope of an interpolated surface at wavelengths below four
    samples; NaN for a surface that is given as a function."""
    _study: Study = field(kw_only=True, repr=False)
    _solution: GridSolution = field(kw_only=True, repr=False)

    @property
    def shakedown(self) -> ShakedownResult | None:
        """Response to repeated cycles on the finest grid, or None without [shakedown]."""
        from ..shakedown import ShakedownResult

        return self.repeated if isinstance(self.repeated, ShakedownResult) else None

    @property
    def grid(self) -> Grid:
        """Finest grid."""
        return self.simulation.grid

    @property
    def relative_errors(self) -> dict[str, float]:
        """Errors divided by the maximum values [-]; 0 for quantities that are zero."""
        return {
            name: self.errors[name] / abs(value) if value else 0.0
            for name, value in self.values.items()
        }

    def to_dataset(self, *, volume: str | None = None) -> xr.Dataset:
        """Return the results of the finest grid, with values and errors.

        ``X`` is the value on the finest grid. ``X_best`` is the best estimate of ``X``. ``X_error``
        is the error of ``X_best``, with the prescribed accuracy as the attribute ``accuracy``.
        ``X_best`` and ``X_error`` are NaN except at ``increments``.

        Parameters
        ----------
        volume : {"none", "last", "peak_and_last", "all"}, optional
            Argument of `samcontact.results.to_dataset`.
        """
        dataset = self._study.to_dataset(self._solution, volume)
        dimension = self._study.dimension
        length = dataset.sizes[dimension]
        for name, series in self.series.items():
            known, body = self._study.described(name)
            text = known.variable(dimension, [], body).attrs["long_name"]
            found = {"best": series, "error": self.series_errors[name]}
            for suffix, label in (
                ("best", "best estimate"),
                ("error", "estimated absolute error of the best estimate"),
            ):
                values = np.full(length, np.nan)
                values[list(self.increments)] = found[suffix]
                variable = known.variable(dimension, values, body)
                variable.attrs["long_name"] = f"{text}: {label}"
                dataset[f"{name}_{suffix}"] = variable
            dataset[f"{name}_error"].attrs["accuracy"] = self.accuracy[name]
        dataset.attrs["accuracy_reached"] = int(self.reached)
        if self.needs:
            dataset.attrs["accuracy_needs"] = self.needs
        if self.surface:
            dataset.attrs["accuracy_surface"] = self.surface
        if np.isfinite(self.slope_beyond):
            dataset.attrs["slope_beyond"] = self.slope_beyond
        return dataset

    def _rows(self) -> Rows:
        rows = []
        for name, relative in self.relative_errors.items():
            known, body = self._study.described(name)
            unit = {"m2": "m²", "m3": "m³", "1": ""}.get(known.unit, known.unit)
            label = known.heading if body is None else f"{known.heading}, body {body}"
            error = f"± {percent(relative)}" if np.isfinite(relative) else "(does not converge)"
            rows.append((label, f"{quantity(self.values[name], unit)} {error}"))
        rows.append(("finest grid", f"{counts(self.grid.nx, self.grid.ny)} cells"))
        rows.append(("accuracy reached", "yes" if self.reached else f"no: {self.needs}"))
        if self.surface:
            rows.append(("surface", self.surface))
        return rows

    def __repr__(self) -> str:
        worst = max(self.relative_errors.values(), default=0.0)
        return f"AccuracyResult({len(self.values)} quantities, maximum relative error {worst:.2g})"


def largest(series: FloatArray, errors: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the value of largest magnitude of each quantity over the increments, and its error.

    series, errors: values and their errors, shape (increments, quantities).
    """
    at = np.abs(series).argmax(axis=0)
    columns = np.arange(series.shape[1])
    return series[at, columns], errors[at, columns]
