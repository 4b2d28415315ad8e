# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands that read what a run has written: reports, and export for other programs."""

from __future__ import annotations

from pathlib import Path

import click

from .errors import short_errors


@click.command()
@click.argument("results_file", metavar="RESULTS.nc", type=click.Path(path_type=Path))
@click.option("--vtk", is_flag=True, help="VTK files for ParaView: volume and surface.")
@click.option(
    "--increment", type=int, default=-1, show_default=True, help="Its number; -1: last stored."
)
@click.option(
    "--body", type=click.Choice(["1", "2"]), default="2", show_default=True, help="Whose fields."
)
@click.option(
    "--output", type=click.Path(path_type=Path), help="File; default: RESULTS.vtr beside it."
)
def export(results_file: Path, vtk: bool, increment: int, body: str, output: Path | None) -> None:
    """Write the fields of one increment for another program."""
    if not vtk:
        raise click.UsageError("say which format: --vtk")
    with short_errors():
        from .. import results

        target = results_file.with_suffix(".vtr") if output is None else output
        with results.open_results(results_file) as dataset:
            for file in results.to_vtk(dataset, target, increment, int(body)):
                click.echo(str(file))


@click.command()
@click.argument("run", metavar="RUN", type=click.Path(path_type=Path))
@click.option(
    "--output",
    type=click.Path(path_type=Path),
    help="Default: report.html beside the results.",
)
def report(run: Path, output: Path | None) -> None:
    """Write an HTML report of a run: RUN is its directory, or the .nc file in it."""
    with short_errors():
        from .. import report as reports
        from .. import results

        source = _results_of(run) if run.is_dir() else run
        with results.open_results(source) as dataset:
            file = reports.write(dataset, output or source.with_name("report.html"))
            failed = [check for check in reports.checks(dataset) if not check.passed]
        for check in failed:
            text = f"check failed: {check.name}: {check.shown}, limit {check.condition}"
            click.echo(text, err=True)
        click.echo(str(file))


def _results_of(folder: Path) -> Path:
    """The file that a run of a contact, of tugging or of wear has left."""
    names = ("results.nc", "series.nc", "wear.nc")
    found = [folder / name for name in names if (folder / name).exists()]
    if len(found) != 1:
        there = ", ".join(file.name for file in found) or "none of them"
        raise ValueError(
            f"{folder} must hold one of {', '.join(names)}, has {there}: name the file"
        )
    return found[0]
