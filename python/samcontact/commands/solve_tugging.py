# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command does with a case of tugging: solve it, print and write its series, figures."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from rich.console import Console
from rich.table import Table

from ..plotting import tugging
from ..plotting.parts import new_figure
from ..results import save
from .tables import new_table

if TYPE_CHECKING:
    import xarray as xr

    from ..asperities import Tugging
    from ..cases.tugging import TuggingCase

HEADINGS = (
    "",
    "F_x max\n[N]",
    "F_x min\n[N]",
    "F_z max\n[N]",
    "net energy\n[J]",
    "dissipated\n[J]",
    "stored\n[J]",
    "print 1\n[µm]",
    "print 2\n[µm]",
)


def solve_tugging(
    case: TuggingCase,
    directory: Path,
    checkpoints: Path | None,
    console: Console,
    figures: bool,
) -> list[Path]:
    """Write series.nc, series.csv and figures of the first pass; the files."""
    result = case.solve(progress=not console.quiet, checkpoint=checkpoints)
    series = result.series.assign_attrs(title=case.title, case=case.text)
    console.print(_table(result))
    written = [save(series, directory / "series.nc")]
    written.append(directory / "series.csv")
    by_increment = series.drop_dims("body").drop_vars(_by_pass(series))
    by_increment.to_dataframe().dropna(how="all").to_csv(written[-1])
    if case.output.figures and figures:
        written += _draw(result, directory)
    return written


def _draw(result: Tugging, directory: Path) -> list[Path]:
    """Forces and their ratio in the first pass."""
    drawn = {
        "force_x.png": tugging.force([result], new_figure().subplots(), component="x"),
        "force_z.png": tugging.force([result], new_figure().subplots(), component="z"),
        "load_ratio.png": tugging.load_ratio([result], new_figure().subplots()),
    }
    for name, ax in drawn.items():
        figure = ax.get_figure(root=True)
        assert figure is not None
        figure.savefig(directory / name)
    return [directory / name for name in drawn]


def _by_pass(series: xr.Dataset) -> list[str]:
    return [str(name) for name, field in series.data_vars.items() if field.dims == ("pass",)]


def _table(result: Tugging) -> Table:
    """One row for each pass."""
    table = new_table("Passes", *HEADINGS)
    for number in result.series["pass"].values:
        one = result.series.sel({"pass": number})
        fx, fz = one["force_x"], one["force_z"]
        energies = (one[name] for name in ("net_energy", "dissipation", "residual_energy"))
        prints = 1e6 * one["residual_displacement"].values
        values = [fx.max(), fx.min(), fz.max(), *energies, *prints]
        table.add_row(str(number), *(f"{float(value):.5g}" for value in values))
    return table
