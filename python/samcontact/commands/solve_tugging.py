# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command does with a case of tugging: solve it, print and write its series, figures."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from rich.console import Console

from ..plotting import tugging
from ..plotting.parts import save as save_figure
from ..results.dataset import completeness
from .errors import StoppedEarlyError, tell_partial
from .folder import publish
from .interrupted import checkpoints_of
from .tables import Sheet, numbers

if TYPE_CHECKING:
    import xarray as xr

    from ..asperities import Tugging
    from ..cases.tugging import TuggingCase


def solve_tugging(
    case: TuggingCase, directory: Path, console: Console, *, figures: bool, resume: bool
) -> list[Path]:
    """Write series.nc, series.csv and figures of the first pass; the files.

    Each increment leaves a checkpoint.
    """

    def write(result: Tugging, stopped_by: str = "") -> list[Path]:
        return _write(case, result, stopped_by, directory, console, figures)

    with checkpoints_of(directory, case) as checkpoints:
        checkpoints.claim(resume)
        console.print(case.title, style="bold", markup=False, highlight=False)
        try:
            with checkpoints.used() as folder:
                result = case.solve(progress=not console.quiet, checkpoint=folder)
        except Exception as error:
            done: Tugging | None = getattr(error, "result", None)
            if done is None:
                raise
            what = f"{done.series.sizes['pass']} of {case.tugging.passes} passes, the last in part,"
            told = tell_partial(lambda reason: write(done, reason), error, what, directory)
            raise StoppedEarlyError(told) from error
        return write(result)


def _write(
    case: TuggingCase,
    result: Tugging,
    stopped_by: str,
    directory: Path,
    console: Console,
    figures: bool,
) -> list[Path]:
    attributes = {"title": case.title, "case": case.text, **completeness(stopped_by)}
    series = result.series.assign_attrs(attributes)
    written = [publish(series, directory / "series.nc")]
    console.print(_table(result))
    written.append(directory / "series.csv")
    by_increment = series.drop_dims("body").drop_vars(_by_pass(series))
    by_increment.to_dataframe().dropna(how="all").to_csv(written[-1])
    if case.output.figures and figures:
        written += _draw(result, directory)
    return written


def _draw(result: Tugging, directory: Path) -> list[Path]:
    """Forces and their ratio in the first pass."""
    drawn = {
        "force_x.png": tugging.force([result], component="x"),
        "force_z.png": tugging.force([result], component="z"),
        "load_ratio.png": tugging.load_ratio([result]),
    }
    return [save_figure(ax.get_figure(root=True), directory / name) for name, ax in drawn.items()]


def _by_pass(series: xr.Dataset) -> list[str]:
    return [str(name) for name, field in series.data_vars.items() if field.dims == ("pass",)]


def _table(result: Tugging) -> Sheet:
    """One row for each pass."""
    series = result.series
    print1, print2 = (1e6 * series["residual_displacement"].sel(body=b).values for b in (1, 2))
    columns = {
        "F_x max\n[N]": series["force_x"].max("increment").values,
        "F_x min\n[N]": series["force_x"].min("increment").values,
        "F_z max\n[N]": series["force_z"].max("increment").values,
        "net energy\n[J]": series["net_energy"].values,
        "dissipated\n[J]": series["dissipation"].values,
        "stored\n[J]": series["residual_energy"].values,
        "print 1\n[µm]": print1,
        "print 2\n[µm]": print2,
    }
    sheet = Sheet("Passes")
    sheet.add("", [str(number) for number in series["pass"].values])
    for heading, values in columns.items():
        sheet.add(heading, numbers(values))
    return sheet
