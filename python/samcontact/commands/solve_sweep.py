# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameter study of ``samcontact sweep``: parse the values, solve the cases, print a table."""

from __future__ import annotations

import importlib
import re
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from ..cases import load_case
from ..sweeps import SweepInterrupted, sweep
from . import array_libraries
from .errors import EXIT_FAILED
from .find import parse_target
from .signals import exit_code
from .sweep_summary import summary_of
from .tables import new_console

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

if TYPE_CHECKING:
    import xarray as xr

MAX_PRINTED_ERRORS = 10  # maximum number of printed errors
MAX_PRINTED_CASES = 20  # maximum number of printed cases if the statistics are printed as well
MAX_RANGE = 100_000  # maximum number of values in a range
_RANGE = re.compile(r"(-?\d{1,18})\.\.(-?\d{1,18})")


def run_sweep(
    case_file: Path,
    settings: Sequence[str],
    zipped: bool,
    jobs: int | None,
    address: str | None,
    find: str | None,
    output: Path | None,
    quiet: bool,
) -> int:
    """Solve all cases, print a table and the paths of the results, and return the exit code."""
    if jobs is not None and address is not None:
        raise ValueError("--jobs and --dask cannot be combined: omit one of them")
    parameters = parse_settings(settings)
    case = load_case(case_file)
    folder = case.output_directory / "sweep" if output is None else output
    console = new_console(quiet)
    console.print(case.title, style="bold", markup=False, highlight=False)
    mode, code = "zip" if zipped else "product", 0
    search = (
        None if find is None else dict(zip(("quantity", "value"), parse_target(find), strict=True))
    )
    with _executor(jobs, address) as executor:
        try:
            dataset = sweep(
                case,
                parameters,
                executor=executor,
                output=folder,
                progress=not quiet,
                mode=mode,
                find=search,
            )
        except SweepInterrupted as stop:
            dataset, code = stop.dataset, exit_code(stop.__cause__ or stop)
    summary = summary_of(dataset, list(parameters), case)
    statistics = summary.statistics()
    if statistics is None or dataset["status"].size <= MAX_PRINTED_CASES:
        console.print(summary.sheet())
    if statistics is not None:
        console.print(statistics)
    status = dataset["status"].values
    for word in ("failed", "cancelled"):
        if count := int(np.count_nonzero(status == word)):
            click.echo(f"{count} of {status.size} cases {word}", err=True)
            code = code or EXIT_FAILED
    for text in _errors(dataset):
        click.echo(f"  {text}", err=True)
    written = [summary.write_csv(folder / "sweep.csv")]
    if case.output.figures and (figure := summary.write_figure(folder / "sweep.png")) is not None:
        written.append(figure)
    for file in (*written, folder / "sweep.nc"):
        click.echo(str(file))
    return code


@contextmanager
def _executor(jobs: int | None, address: str | None) -> Iterator[Any]:
    if address is None:
        yield jobs
        return
    array_libraries.show()
    try:
        distributed = importlib.import_module("distributed")
    except ImportError as error:
        raise ValueError("--dask requires Dask: pip install 'samcontact[sweep]'") from error
    with distributed.Client(address) as client:
        yield client


def parse_settings(settings: Sequence[str]) -> dict[str, list[Any]]:
    """Convert texts FIELD=VALUE,VALUE,... to a dictionary of fields and their lists of values.

    Values are written as in TOML; texts need no quotes. A range "0..199" stands for the whole
    numbers from 0 to 199.
    """
    parameters: dict[str, list[Any]] = {}
    for setting in settings:
        name, equals, text = setting.partition("=")
        name = name.strip()
        if not equals or not text.strip():
            raise ValueError(f"--set must be FIELD=VALUE,VALUE,..., got {setting!r}")
        if name in parameters:
            raise ValueError(f"--set must name each field once, got {name} twice")
        try:
            parameters[name] = _values(text)
        except RecursionError:
            raise ValueError(f"--set {name}: lists are nested too deeply") from None
    return parameters


def _values(text: str) -> list[Any]:
    try:
        return list(tomllib.loads(f"v = [{text}]")["v"])
    except tomllib.TOMLDecodeError:
        words = [word.strip() for word in text.split(",")]
        return [value for word in words for value in (_in_range(word) or [_value(word)])]


def _in_range(word: str) -> list[Any]:
    """Return the whole numbers of a range such as "0..199", or [] if the text is not a range."""
    found = _RANGE.fullmatch(word)
    if found is None:
        return []
    first, last = map(int, found.groups())
    if not first <= last < first + MAX_RANGE:
        raise ValueError(
            f"--set: a range FIRST..LAST must have 1 to {MAX_RANGE} whole numbers, got {word}"
        )
    return list(range(first, last + 1))


def _value(word: str) -> Any:
    """Convert text to a TOML value or to a number such as "1."; return any other text unchanged."""
    try:
        return tomllib.loads(f"v = {word}")["v"]
    except tomllib.TOMLDecodeError:
        try:
            return float(word)
        except ValueError:
            return word


def _errors(dataset: xr.Dataset) -> list[str]:
    """Return each different error message of the cases once, and at most `MAX_PRINTED_ERRORS`."""
    texts = [text for text in dict.fromkeys(dataset["error"].values.flat) if text]
    if len(texts) > MAX_PRINTED_ERRORS:
        texts[MAX_PRINTED_ERRORS:] = [
            f"and {len(texts) - MAX_PRINTED_ERRORS} more, see error in sweep.nc"
        ]
    return texts
