# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameter study of ``samcontact sweep``: parse lists of values, solve, print a table."""

from __future__ import annotations

import importlib
import math
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import click
import numpy as np

from .._util.checks import FloatArray
from .._util.quantities import ASPERITIES, Quantity
from .._util.sweep_quantities import SWEEP
from .._util.wear_quantities import WEAR
from ..cases import load_case
from ..cases.asperities import AsperityCase
from ..solutions.peak import peak_of_dataset
from ..sweeps import SweepInterrupted, sweep
from . import array_libraries
from .errors import EXIT_FAILED
from .find import parse_target
from .signals import exit_code
from .tables import CONTACT_COLUMNS, Sheet, contact_columns, new_console, numbers

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import Case

MAX_PRINTED_ERRORS = 10  # maximum number of printed errors
_ASPERITY_COLUMNS = {
    name: ASPERITIES[row]
    for name, row in (
        ("force_x", "max_force_x"),
        ("force_z", "max_force_z"),
        ("max_pressure", "max_pressure"),
        ("net_energy", "net_energy"),
        ("residual_displacement", "residual_displacement"),
    )
}


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
    """Solve all cases, print the table and the path of the results, and return the exit code."""
    if jobs is not None and address is not None:
        raise ValueError("--jobs and --dask cannot be combined")
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
    console.print(_table(dataset, list(parameters), case))
    status = dataset["status"].values
    for word in ("failed", "cancelled"):
        if count := int(np.count_nonzero(status == word)):
            click.echo(f"{count} of {status.size} cases {word}", err=True)
            code = code or EXIT_FAILED
    for text in _errors(dataset):
        click.echo(f"  {text}", err=True)
    click.echo(str(folder / "sweep.nc"))
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
    """Convert texts FIELD=VALUE,VALUE,... to a list of values (TOML, or plain words) by field."""
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
        return [_value(word.strip()) for word in text.split(",")]


def _value(word: str) -> Any:
    """Convert text to a TOML value or a number (e.g. "1."); return any other text unchanged."""
    try:
        return tomllib.loads(f"v = {word}")["v"]
    except tomllib.TOMLDecodeError:
        try:
            return float(word)
        except ValueError:
            return word


def _errors(dataset: xr.Dataset) -> list[str]:
    """Return each different error message once; sweep.nc contains the error of each case."""
    texts = [text for text in dict.fromkeys(dataset["error"].values.flat) if text]
    if len(texts) > MAX_PRINTED_ERRORS:
        texts[MAX_PRINTED_ERRORS:] = [
            f"and {len(texts) - MAX_PRINTED_ERRORS} more, see error in sweep.nc"
        ]
    return texts


class _Table(NamedTuple):
    """Title and columns of the table of a sweep, and the choice among the values of a case."""

    title: str
    columns: dict[str, Quantity]
    chosen: Callable[[FloatArray, xr.Dataset], float]


def _contents(dataset: xr.Dataset, case: Case | AsperityCase) -> _Table:
    if isinstance(case, AsperityCase):
        columns = {n: quantity for n, quantity in _ASPERITY_COLUMNS.items() if n in dataset}
        return _Table("Maxima", columns, lambda values, _: float(np.nanmax(values)))
    of_case = {name: SWEEP[name] for name in SWEEP if name in dataset and SWEEP[name].short}
    if "increment" in dataset.dims:
        columns = contact_columns(dataset, CONTACT_COLUMNS, case.output.body)
        return _Table(
            "At maximum von Mises stress",
            columns | of_case,
            lambda values, one: float(values[peak_of_dataset(one)]),
        )
    of_wear = {name: WEAR[name] for name in WEAR if name in dataset and WEAR[name].short}
    return _Table(
        "Load search" if of_case else "Last cycle",
        of_wear | of_case,
        lambda values, _: float(values[np.flatnonzero(~np.isnan(values))[-1]]),
    )


def _table(dataset: xr.Dataset, names: Sequence[str], case: Case | AsperityCase) -> Sheet:
    """Return the table of a sweep: one row for each case.

    The table shows the values at the increment of maximum von Mises stress; for asperity
    collisions, the maxima of all increments; for wear, the values of the last cycle.
    """
    status = dataset["status"]
    places = [dict(zip(status.dims, place, strict=True)) for place in np.ndindex(*status.shape)]
    cases = [dataset.isel(place) for place in places]
    title, columns, chosen = _contents(dataset, case)
    sheet = Sheet(title)
    sheet.add("case", [str(number) for number in range(1, len(cases) + 1)])
    for name in names:
        sheet.add(name.replace(".", ".\n"), [str(one[name].item()) for one in cases])
    for name, quantity in columns.items():
        if meanings := dataset[name].attrs.get("flag_meanings"):
            sheet.add(quantity.column(), [_word(float(one[name]), meanings) for one in cases])
            continue
        values = [_table_value(one, name, chosen) * quantity.factor for one in cases]
        sheet.add(quantity.column(), numbers(values, quantity.digits))
    sheet.add("status", [one["status"].item() for one in cases])
    return sheet


def _word(number: float, meanings: str) -> str:
    """Return the name that a number stands for; "-" for a failed case."""
    return "-" if math.isnan(number) else meanings.split()[int(number)].replace("_", " ")


def _table_value(
    one: xr.Dataset, name: str, chosen: Callable[[FloatArray, xr.Dataset], float]
) -> float:
    values = one[name].values
    if np.all(np.isnan(values)):
        return math.nan
    return chosen(values, one) if values.ndim else float(values)
