# SPDX-License-Identifier: GPL-3.0-or-later
"""Protocol of an application: commands, answers with errors and checks, and a picture."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from samcontact.results import open_results


@dataclass(frozen=True)
class Answer:
    """Value found by the commands, with its estimated error and an independent value.

    The error is relative; NaN if the commands do not estimate it. It is then replaced by the
    difference from the answer on coarser cells.
    """

    key: str
    quantity: str
    value: float
    unit: str
    error: float = math.nan
    check: str = ""
    expected: float = math.nan


@dataclass(frozen=True)
class Work:
    """Folder in which the commands of an application have run, and their output."""

    folder: Path
    name: str
    outputs: tuple[str, ...]

    def dataset(self, file: str = "results.nc") -> xr.Dataset:
        """Return the results in a file of the results folder, read into memory."""
        path = self.folder / "results" / self.name / file
        if file == "results.nc":
            with open_results(path) as opened:
                found: xr.Dataset = opened.load()
        else:
            with xr.open_dataset(path) as opened:
                found = opened.load()
        return found

    def row(self, label: str, command: int = 0) -> list[tuple[float, float]]:
        """Return the values with errors, in SI units, in the row of a printed table."""
        lines = [line for line in self.outputs[command].splitlines() if label in line]
        cells = [cell.strip() for cell in lines[0].split("│")[2:-1]]
        return [_value(cell) for cell in cells]


_FACTORS = {"k": 1e3, "M": 1e6, "G": 1e9, "m": 1e-3, "µ": 1e-6, "n": 1e-9, "": 1.0}


def _value(cell: str) -> tuple[float, float]:
    """Return value and relative error of a cell such as "13.34 kN ± 0.2 %"."""
    found = re.match(r"(-?[\d.e+-]+)(?: ([kMGmµn]?)(?:N|Pa|m|J)\b)?(?: ± ([\d.e+-]+) %)?", cell)
    assert found is not None, cell
    error = math.nan if found[3] is None else float(found[3]) / 100
    return float(found[1]) * _FACTORS[found[2] or ""], error


def largest(dataset: xr.Dataset, name: str) -> tuple[float, float]:
    """Return the value of a quantity with the largest magnitude, and its relative error."""
    values = dataset[name].values
    place = int(np.nanargmax(np.abs(values)))
    if f"{name}_error" not in dataset:
        return float(values[place]), math.nan
    errors = dataset[f"{name}_error"].values
    known = np.flatnonzero(np.isfinite(errors))
    nearest = known[np.argmin(np.abs(known - place))]
    return float(values[place]), float(errors[nearest] / abs(values[nearest]))


@dataclass(frozen=True)
class Application:
    """Task of an engineer, answered by commands without Python.

    Attributes
    ----------
    name, title : str
        Name of the page, and its title.
    kind : str
        KIND of ``samcontact new KIND``, which writes the case file.
    gains : str
        What a reader gets, in one or two sentences.
    text : str
        Explanation of the answers; {KEY} stands for the value of an answer.
    commands : tuple of str
        Commands after ``samcontact new``, without the word samcontact.
    shown : tuple of str
        Titles of the printed tables that the page shows.
    functions : tuple of (str, str)
        Functions of the Python interface, and what each computes.
    guide : (str, str)
        Title of the guide, and its page.
    limits : str
        What the answer does not contain.
    answers : function
        Answers from the results of the commands.
    picture : function
        Figure from the results of the commands.
    caption : str
        Text below the picture.
    coarser : tuple of (str, str)
        Lines of the case file, and the lines that replace them for coarser cells; none if the
        commands estimate all errors.
    """

    name: str
    title: str
    kind: str
    gains: str
    text: str
    commands: tuple[str, ...]
    shown: tuple[str, ...]
    functions: tuple[tuple[str, str], ...]
    guide: tuple[str, str]
    limits: str
    answers: Callable[[Work], list[Answer]]
    picture: Callable[[Work], Figure]
    caption: str
    coarser: tuple[tuple[str, str], ...] = ()

    def coarse_case(self, case: str) -> str:
        """Return the text of a case file with coarser cells."""
        for old, new in self.coarser:
            assert case.count(f"\n{old}\n") == 1, old
            case = case.replace(f"\n{old}\n", f"\n{new}\n")
        return case


def with_errors(fine: list[Answer], coarse: list[Answer]) -> list[Answer]:
    """Return answers with the differences from those on coarser cells as missing errors."""
    found = []
    for one, other in zip(fine, coarse, strict=True):
        difference = abs(other.value / one.value - 1.0)
        found.append(replace(one, error=difference) if math.isnan(one.error) else one)
    return found


def as_record(answer: Answer) -> dict[str, Any]:
    """Return an answer with six significant digits, as it is stored."""
    record = dict(vars(answer))
    for name in ("value", "error", "expected"):
        number = record[name]
        record[name] = None if math.isnan(number) else float(f"{number:.6g}")
    return record
