# SPDX-License-Identifier: GPL-3.0-or-later
"""Statistics of a sweep over seeds: realisations of random surfaces, dents or inclusions."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from .._util.checks import FloatArray
from .._util.quantities import Quantity
from .tables import Sheet, numbers

MIN_REALISATIONS = 3
"""Minimum number of realisations for a table of statistics."""
_COLUMNS = ("mean", "standard\ndeviation", "standard error\nof the mean", "minimum", "5 %",
            "median", "95 %", "maximum")  # fmt: skip


def are_realisations(parameters: Mapping[str, Sequence[Any]]) -> bool:
    """Whether the cases of a sweep differ in seeds only, with at least `MIN_REALISATIONS` cases."""
    varied = [name for name, column in parameters.items() if len(set(map(str, column))) > 1]
    seeds = bool(varied) and all(name.rpartition(".")[2] == "seed" for name in varied)
    return seeds and len(parameters[varied[0]]) >= MIN_REALISATIONS


def known_numbers(column: Sequence[Any]) -> FloatArray:
    """Return the finite values of a quantity, or an empty array if its values are words."""
    if any(isinstance(value, str) for value in column):
        return np.array([])
    values = np.asarray(column, dtype=np.float64)
    return values[np.isfinite(values)]


def statistics_of(values: FloatArray) -> list[float]:
    """Return the statistics listed in `_COLUMNS`: mean, standard deviation, quantiles and others.

    The standard deviation is an estimate for the population, with the divisor n - 1.
    """
    deviation = float(np.std(values, ddof=1))
    low, five, median, most, high = np.quantile(values, (0.0, 0.05, 0.5, 0.95, 1.0)).tolist()
    return [float(np.mean(values)), deviation, deviation / math.sqrt(values.size), low, five,
            median, most, high]  # fmt: skip


def statistics_sheet(
    title: str, quantities: Mapping[str, Quantity], values: Mapping[str, Sequence[Any]]
) -> Sheet | None:
    """Return the table of statistics, with one row for each quantity that has enough numbers.

    Return None if no quantity has at least `MIN_REALISATIONS` numbers.
    """
    found = {name: known_numbers(values[name]) for name in quantities}
    shown = [name for name, sample in found.items() if sample.size >= MIN_REALISATIONS]
    if not shown:
        return None
    rows = [
        numbers([v * quantities[name].factor for v in statistics_of(found[name])], 5)
        for name in shown
    ]
    sheet = Sheet(f"Realisations: {title[0].lower()}{title[1:]}")
    sheet.add("", [quantities[name].column().replace("\n", " ") for name in shown])
    for heading, cells in zip(_COLUMNS, zip(*rows, strict=True), strict=True):
        sheet.add(heading, cells)
    sheet.add("cases", [str(found[name].size) for name in shown])
    return sheet
