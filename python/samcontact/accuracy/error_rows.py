# SPDX-License-Identifier: GPL-3.0-or-later
"""Table rows, each with the maximum of one quantity in a run and the error of this maximum."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from .._util.checks import FloatArray
from .._util.display import quantity
from .._util.quantities import CONTACT, Quantity, described
from .._util.wear_quantities import WEAR
from . import fatigue_quantities

if TYPE_CHECKING:
    import xarray as xr

NO_LIMIT = "does not converge"
"""Text instead of an infinite error, e.g. that of the maximum pressure at a sharp edge."""


class ErrorRow(NamedTuple):
    """Maximum of a quantity in a run: label, increment number, value and relative error.

    If the accuracy was prescribed, `relative` is the maximum error of all increments divided by the
    maximum value.
    """

    label: str
    increment: int
    shown: str
    relative: float
    target: float | None = None
    by_increments: float | None = None
    """Relative error due to increments; None if unknown or already included in `relative`."""

    @property
    def percent(self) -> str:
        """Relative error [%] as text, or a note that the quantity does not converge."""
        return f"{100 * self.relative:.2g}" if np.isfinite(self.relative) else NO_LIMIT

    @property
    def with_error(self) -> str:
        """Value with its error as text."""
        if np.isfinite(self.relative):
            return f"{self.shown} ± {self.percent} %"
        return f"{self.shown}, {NO_LIMIT}"


def error_rows(dataset: xr.Dataset) -> list[ErrorRow]:
    """Return one row for each quantity whose error is in the results; without errors, no rows."""
    names = [str(name)[: -len("_error")] for name in dataset if str(name).endswith("_error")]
    values = {name: dataset[f"{name}_best" if f"{name}_best" in dataset else name].values
              for name in names}  # fmt: skip
    errors = {name: dataset[f"{name}_error"].values for name in names}
    targets = {name: dataset[f"{name}_error"].attrs.get("accuracy") for name in names}
    by_increments = {name: dataset[f"{name}_error"].attrs.get("by_increments") for name in names}
    quantities = WEAR if "cycle" in dataset.dims else fatigue_quantities.QUANTITIES
    return rows_of_maxima(values, errors, targets, by_increments, quantities)


def rows_of_maxima(
    values: Mapping[str, FloatArray],
    errors: Mapping[str, FloatArray],
    targets: Mapping[str, float | None],
    by_increments: Mapping[str, float | None],
    quantities: Mapping[str, Quantity] = CONTACT,
) -> list[ErrorRow]:
    """Return a row for the maximum of each quantity that is neither prescribed nor zero."""
    rows = []
    for name, error in errors.items():
        known = np.where(error > 0, np.abs(values[name]), -1.0)
        at = int(known.argmax())
        if known[at] > 0:
            quantity_of, body = described(name, quantities)
            unit = {"m2": "m²", "m3": "m³", "1": ""}.get(quantity_of.unit, quantity_of.unit)
            label = quantity_of.heading or quantity_of.long_name
            label = label if body is None else f"{label}, body {body}"
            shown = quantity(float(values[name][at]), unit, 5)
            target = targets.get(name)  # prescribed relative error of all increments
            relative = float((error[at] if target is None else np.nanmax(error)) / known[at])
            row = ErrorRow(label, at + 1, shown, relative, target, by_increments.get(name))
            rows.append(row)
    return rows
