# SPDX-License-Identifier: GPL-3.0-or-later
"""Summary of a sweep, with one value of each quantity for each case: table, CSV file, figure."""

from __future__ import annotations

import csv
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from .._util.checks import FloatArray
from .._util.film_quantities import FILMS
from .._util.quantities import ASPERITIES, Quantity
from .._util.sliding_quantities import SLIDING
from .._util.sweep_quantities import SWEEP
from .._util.wear_quantities import WEAR
from ..cases.films import FilmCase
from ..files.atomic import replacing
from ..files.ownership import recording
from ..solutions.peak import peak_of_dataset
from .sweep_statistics import are_realisations, known_numbers, statistics_sheet
from .tables import CONTACT_COLUMNS, Sheet, contact_columns, numbers

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import AnyCase

_COLUMNS_OF_MAXIMA = {
    "asperities": {
        name: ASPERITIES[row]
        for name, row in (
            ("force_x", "max_force_x"),
            ("force_z", "max_force_z"),
            ("max_pressure", "max_pressure"),
            ("net_energy", "net_energy"),
            ("residual_displacement", "residual_displacement"),
        )
    },
    "sliding": {
        name: SLIDING[name]
        for name in ("friction", "contact_area", "contact_share", "max_pressure")
    },
}
"""Columns of tables of maxima by kind of study: quantity to show, by name of the variable."""


@dataclass(frozen=True)
class SweepSummary:
    """Parameters, quantities and status of all cases of a sweep, in the order of the cases."""

    title: str
    """Title that states which values are shown, e.g. "At maximum von Mises stress"."""
    parameters: dict[str, list[Any]]
    """Values of each parameter, one for each case: numbers in SI units, or texts."""
    units: dict[str, str]
    """SI unit of each parameter; "" without a unit."""
    quantities: dict[str, Quantity]
    values: dict[str, list[Any]]
    """Values of each quantity, one for each case: SI numbers (NaN if missing), or words."""
    status: list[str]
    errors: list[str]

    def sheet(self) -> Sheet:
        """Return the table for the terminal, with one row for each case."""
        sheet = Sheet(self.title)
        sheet.add("case", [str(number) for number in range(1, len(self.status) + 1)])
        for name, column in self.parameters.items():
            sheet.add(name.replace(".", ".\n"), [str(value) for value in column])
        for name, quantity in self.quantities.items():
            column = self.values[name]
            if _are_words(column):
                sheet.add(quantity.column(), [word or "-" for word in column])
            else:
                shown = np.asarray(column) * quantity.factor
                sheet.add(quantity.column(), numbers(shown, quantity.digits))
        sheet.add("status", self.status)
        return sheet

    def statistics(self) -> Sheet | None:
        """Return the table of statistics of a sweep over seeds, or None for any other sweep."""
        if not are_realisations(self.parameters):
            return None
        return statistics_sheet(self.title, self.quantities, self.values)

    def write_csv(self, file: Path) -> Path:
        """Write a CSV file with one row for each case; values are in SI units."""
        heads = [_headed(name, self.units[name]) for name in self.parameters]
        heads += [_headed(name, quantity.unit) for name, quantity in self.quantities.items()]
        columns = [*self.parameters.values(), *self.values.values(), self.status, self.errors]
        with (
            recording(file.parent),
            replacing(file) as part,
            part.open("w", encoding="utf-8", newline="") as opened,
        ):
            rows = csv.writer(opened, lineterminator="\n")
            rows.writerow(["case", *heads, "status", "error"])
            for number, row in enumerate(zip(*columns, strict=True), 1):
                rows.writerow([number, *map(_plain, row)])
        return file

    def write_figure(self, file: Path) -> Path | None:
        """Draw the quantities versus the parameters, and return the path of the figure.

        For realisations, which differ in seeds only, histograms are drawn instead. Return None if
        nothing varies.
        """
        from ..plotting.parts import save
        from ..plotting.realisations import realisations_figure
        from ..plotting.sweeps import study_figure

        if are_realisations(self.parameters):
            samples = {name: known_numbers(column) for name, column in self.values.items()}
            figure = realisations_figure(self.quantities, samples)
        else:
            figure = study_figure(self.parameters, self.units, self.quantities, self.values)
        if figure is None:
            return None
        with recording(file.parent):
            return save(figure, file)


def _headed(name: str, unit: str) -> str:
    return f"{name} [{unit}]" if unit not in ("", "1") else name


def _plain(value: Any) -> Any:
    """Return a value for a CSV file: all digits of a number, "" for a missing one."""
    if isinstance(value, float):
        return "" if math.isnan(value) else repr(value)
    return value


def _are_words(column: Sequence[Any]) -> bool:
    return any(isinstance(value, str) for value in column)


def summary_of(dataset: xr.Dataset, names: Sequence[str], case: AnyCase) -> SweepSummary:
    """Return the summary of a sweep over the parameters `names`.

    The value of each quantity is selected as follows. Contact: at the increment of maximum von
    Mises stress. Asperity collision or sliding: the maximum over all increments or velocities.
    Wear: after the last cycle. Lubricated contact: at the last load or speed; if it is solved over
    time, at the instant of the largest pressure.
    """
    status = dataset["status"]
    places = [dict(zip(status.dims, place, strict=True)) for place in np.ndindex(*status.shape)]
    cases = [dataset.isel(place) for place in places]
    title, columns, chosen = _contents(dataset, case)
    errors = [one["error"].item() if "error" in one else "" for one in cases]
    return SweepSummary(
        title,
        {name: [one[name].item() for one in cases] for name in names},
        {name: dataset[name].attrs.get("units", "") for name in names},
        columns,
        {name: [_value(one, name, chosen) for one in cases] for name in columns},
        [one["status"].item() for one in cases],
        errors,
    )


class _Contents(NamedTuple):
    """Title and columns of the table of a sweep, and the function that selects the value shown."""

    title: str
    columns: dict[str, Quantity]
    chosen: Callable[[FloatArray, xr.Dataset], float]


def _contents(dataset: xr.Dataset, case: AnyCase) -> _Contents:
    if case.study in _COLUMNS_OF_MAXIMA:
        shown = _COLUMNS_OF_MAXIMA[case.study]
        columns = {n: quantity for n, quantity in shown.items() if n in dataset}
        return _Contents("Maxima", columns, lambda values, _: float(np.nanmax(values)))
    if isinstance(case, FilmCase):
        columns = {n: quantity for n, quantity in FILMS.items() if quantity.short and n in dataset}
        if case.film.transient is not None:
            return _Contents("At the largest pressure over time", columns, _at_largest_pressure)
        title = "At the largest load" if case.yields else "At the highest speed"
        return _Contents(title, columns, lambda values, _: float(values[-1]))
    of_case = {name: SWEEP[name] for name in SWEEP if name in dataset and SWEEP[name].short}
    if "increment" in dataset.dims:
        body = getattr(case.output, "body", 2)  # other kinds have no increments of one contact
        columns = contact_columns(dataset, CONTACT_COLUMNS, body)
        return _Contents(
            "At maximum von Mises stress",
            columns | of_case,
            lambda values, one: float(values[peak_of_dataset(one)]),
        )
    of_wear = {name: WEAR[name] for name in WEAR if name in dataset and WEAR[name].short}
    return _Contents(
        "Load search" if of_case else "Last cycle",
        of_wear | of_case,
        lambda values, _: float(values[np.flatnonzero(~np.isnan(values))[-1]]),
    )


def _at_largest_pressure(values: FloatArray, one: xr.Dataset) -> float:
    return float(values[int(np.argmax(one["max_pressure"].values))])


def _value(
    one: xr.Dataset, name: str, chosen: Callable[[FloatArray, xr.Dataset], float]
) -> float | str:
    values = one[name].values
    if values.dtype.kind == "O":
        return str(values.item())
    if np.all(np.isnan(values)):
        return math.nan
    return chosen(values, one) if values.ndim else float(values)
