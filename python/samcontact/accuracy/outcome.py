# SPDX-License-Identifier: GPL-3.0-or-later
"""What solving to an accuracy gives."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._util.checks import FloatArray
from .._util.display import Rows, Shown, counts, percent, quantity
from .._util.quantities import described

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import Case
    from ..scene.grid import Grid
    from ..simulation.simulation import Simulation
    from ..solutions.state import State


@dataclass(frozen=True, eq=False)
class Accurate(Shown):
    """Values with their errors, and the simulation of the finest grid.

    Of each quantity, by its name in results files: ``values[name]`` is the largest of the run and
    ``errors[name]`` its estimated error, both in SI units. ``series[name]`` and
    ``series_errors[name]`` have them at the end of each segment of the path (of passes, also at the
    last increment under load), at the positions ``increments`` of ``states``.
    """

    values: dict[str, float]
    errors: dict[str, float]
    accuracy: dict[str, float]
    """Relative, as asked for; of the largest value of the run."""
    reached: bool
    """Whether all errors are below it."""
    series: dict[str, FloatArray]
    series_errors: dict[str, FloatArray]
    increments: tuple[int, ...]
    states: list[State]
    """Of the finest grid, as they were solved there."""
    simulation: Simulation
    case: Case
    """With the finest grid and the increments used there."""
    runs: tuple[tuple[int, int, int, float], ...]
    """Cells along x and y, increments of a segment and time [s] of all that was solved."""
    needs: str = ""
    """What the accuracy would have needed, where it is not reached."""

    @property
    def grid(self) -> Grid:
        """The finest grid."""
        return self.simulation.grid

    @property
    def relative_errors(self) -> dict[str, float]:
        """Errors over the largest values; 0 where there is nothing."""
        return {
            name: self.errors[name] / abs(value) if value else 0.0
            for name, value in self.values.items()
        }

    def to_dataset(self, *, volume: str | None = None) -> xr.Dataset:
        """Results of the finest grid, with these values and their errors.

        Beside each ``X`` as it was solved on the finest grid there is ``X_best``, the value at
        ``increments``, and ``X_error``, its error, with the accuracy asked for as its attribute;
        both are NaN elsewhere.

        Parameters
        ----------
        volume : {"none", "last", "peak_and_last", "all"}, optional
            As of `samcontact.results.to_dataset`.
        """
        from .. import results

        dataset = results.to_dataset(self.simulation, self.states, self.case, volume=volume)
        for name, series in self.series.items():
            known, body = described(name)
            text = known.variable("increment", [], body).attrs["long_name"]
            found = {"best": series, "error": self.series_errors[name]}
            for suffix, label in (("best", "best value"), ("error", "its estimated error")):
                values = np.full(len(self.states), np.nan)
                values[list(self.increments)] = found[suffix]
                variable = known.variable("increment", values, body)
                variable.attrs["long_name"] = f"{text}: {label}"
                dataset[f"{name}_{suffix}"] = variable
            dataset[f"{name}_error"].attrs["accuracy"] = self.accuracy[name]
        dataset.attrs["accuracy_reached"] = int(self.reached)
        if self.needs:
            dataset.attrs["accuracy_needs"] = self.needs
        return dataset

    def _rows(self) -> Rows:
        rows = []
        for name, relative in self.relative_errors.items():
            known, body = described(name)
            unit = "m²" if known.unit == "m2" else "" if known.unit == "1" else known.unit
            label = known.heading if body is None else f"{known.heading}, body {body}"
            error = f"± {percent(relative)}" if np.isfinite(relative) else "(does not converge)"
            rows.append((label, f"{quantity(self.values[name], unit)} {error}"))
        rows.append(("finest grid", f"{counts(self.grid.nx, self.grid.ny)} cells"))
        rows.append(("accuracy reached", "yes" if self.reached else f"no: {self.needs}"))
        return rows

    def __repr__(self) -> str:
        worst = max(self.relative_errors.values(), default=0.0)
        return f"Accurate({len(self.values)} quantities, largest relative error {worst:.2g})"


def largest(series: FloatArray, errors: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Of each quantity the largest value of all marks, with its error; shapes (marks, names)."""
    at = np.abs(series).argmax(axis=0)
    columns = np.arange(series.shape[1])
    return series[at, columns], errors[at, columns]
