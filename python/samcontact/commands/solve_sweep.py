# SPDX-License-Identifier: GPL-3.0-or-later
"""What ``samcontact sweep`` does: read lists of values, solve, print a table."""

from __future__ import annotations

import importlib
import math
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np
from rich.console import Console
from rich.table import Table
from rich.text import Text

from ..cases import load_case
from ..cases.tugging import TuggingCase
from ..sweeps import SweepInterrupted, sweep
from .errors import FAILED, INTERRUPTED
from .tables import contact_columns

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import Case

MOST_ERRORS = 10  # printed
# variable, heading, factor, format
_TUGGING = [
    ("force_x", "F_x max\n[N]", 1.0, ".5g"),
    ("force_z", "F_z max\n[N]", 1.0, ".5g"),
    ("max_pressure", "p_max\n[MPa]", 1e-6, ".1f"),
    ("net_energy", "net energy\nmax [J]", 1.0, ".5g"),
    ("residual_displacement", "print max\n[µm]", 1e6, ".5g"),
]


def run_sweep(
    case_file: Path,
    settings: Sequence[str],
    zipped: bool,
    jobs: int | None,
    address: str | None,
    output: Path | None,
    quiet: bool,
) -> int:
    """Solve, print the table and the path of the results; the exit code."""
    if jobs is not None and address is not None:
        raise ValueError("give --jobs or --dask, not both")
    parameters = parse_settings(settings)
    case = load_case(case_file)
    folder = case.output_directory / "sweep" if output is None else output
    console = Console(quiet=quiet)
    console.print(case.title, style="bold", markup=False, highlight=False)
    mode, code = "zip" if zipped else "product", 0
    with _executor(jobs, address) as executor:
        try:
            dataset = sweep(
                case, parameters, executor=executor, output=folder, progress=not quiet, mode=mode
            )
        except SweepInterrupted as stop:
            dataset, code = stop.dataset, INTERRUPTED
    console.print(_table(dataset, list(parameters), case))
    status = dataset["status"].values
    for word in ("failed", "cancelled"):
        if count := int(np.count_nonzero(status == word)):
            click.echo(f"{count} of {status.size} cases {word}", err=True)
            code = code or FAILED
    for text in _errors(dataset):
        click.echo(f"  {text}", err=True)
    click.echo(str(folder / "sweep.nc"))
    return code


@contextmanager
def _executor(jobs: int | None, address: str | None) -> Iterator[Any]:
    if address is None:
        yield jobs
        return
    try:
        distributed = importlib.import_module("distributed")
    except ImportError as error:
        raise ValueError("--dask needs Dask: pip install 'samcontact[sweep]'") from error
    with distributed.Client(address) as client:
        yield client


def parse_settings(settings: Sequence[str]) -> dict[str, list[Any]]:
    """FIELD=VALUE,VALUE,... as values by field: those of TOML, or words without quotes."""
    parameters: dict[str, list[Any]] = {}
    for setting in settings:
        name, equals, text = setting.partition("=")
        name = name.strip()
        if not equals or not text.strip():
            raise ValueError(f"--set must be FIELD=VALUE,VALUE,..., got {setting!r}")
        if name in parameters:
            raise ValueError(f"--set must name each field once, got {name} twice")
        try:
            parameters[name] = tomllib.loads(f"v = [{text}]")["v"]
        except tomllib.TOMLDecodeError:
            parameters[name] = [_value(word.strip()) for word in text.split(",")]
    return parameters


def _value(word: str) -> Any:
    """A TOML value, a number as other programs write it ("1."), or the word itself."""
    try:
        return tomllib.loads(f"v = {word}")["v"]
    except tomllib.TOMLDecodeError:
        try:
            return float(word)
        except ValueError:
            return word


def _errors(dataset: xr.Dataset) -> list[str]:
    """The different errors; sweep.nc tells which case had which."""
    texts = [text for text in dict.fromkeys(dataset["error"].values.flat) if text]
    if len(texts) > MOST_ERRORS:
        texts[MOST_ERRORS:] = [f"and {len(texts) - MOST_ERRORS} more, see error in sweep.nc"]
    return texts


def _columns(case: Case | TuggingCase) -> list[tuple[str, str, float, str]]:
    if isinstance(case, TuggingCase):
        return _TUGGING
    return contact_columns(case.output.body)


def _table(dataset: xr.Dataset, names: Sequence[str], case: Case | TuggingCase) -> Table:
    """One row for each case: its values at the peak load; of a tugging, the largest ones."""
    shown = [column for column in _columns(case) if column[0] in dataset]
    title = "Largest values" if isinstance(case, TuggingCase) else "At the peak load"
    table = Table(title=title, title_justify="left")
    for name in names:
        # Text: "path[0].load" in a plain string would be read as markup
        table.add_column(Text(name.replace(".", ".\n")), overflow="fold")
    for heading in (*(heading for _, heading, _, _ in shown), "status"):
        table.add_column(Text(heading), justify="right")
    status = dataset["status"]
    for place in np.ndindex(*status.shape):
        one = dataset.isel(dict(zip(status.dims, place, strict=True)))
        values = [_shown(one, name, case) for name, _, _, _ in shown]
        cells = [
            "" if math.isnan(value) else format(value * factor, form)
            for value, (_, _, factor, form) in zip(values, shown, strict=True)
        ]
        labels = (str(one[name].item()) for name in names)
        words = (*labels, *cells, one["status"].item())
        table.add_row(*(Text(word) for word in words))
    return table


def _shown(one: xr.Dataset, name: str, case: Case | TuggingCase) -> float:
    values = one[name].values
    if np.all(np.isnan(values)):
        return math.nan
    if isinstance(case, TuggingCase):
        return float(np.nanmax(values))
    return float(values[int(np.nanargmax(one["load"].values))])
