# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands that read what a run has written: reports, and export for other programs."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path

import click

from .arguments import FilePath
from .errors import short_errors


@click.command()
@click.argument("results_file", metavar="RESULTS.nc", type=FilePath())
@click.option("--vtk", is_flag=True, help="VTK files for ParaView: volume and surface.")
@click.option("--html", is_flag=True, help="A page with the body in three dimensions.")
@click.option(
    "--quantity",
    default="von_mises",
    show_default=True,
    help="Field of the page, as in RESULTS.nc.",
)
@click.option(
    "--increment", type=int, default=-1, show_default=True, help="Its number; -1: last stored."
)
@click.option("--all", "every", is_flag=True, help="Every increment, and a .pvd of them.")
@click.option(
    "--body", type=click.Choice(["1", "2"]), default="2", show_default=True, help="Whose fields."
)
@click.option("--output", type=FilePath(), help="File; default: beside RESULTS.nc.")
def export(
    results_file: Path,
    vtk: bool,
    html: bool,
    quantity: str,
    increment: int,
    every: bool,
    body: str,
    output: Path | None,
) -> None:
    """Write the fields of one increment, or of all, for another program or for a browser."""
    if vtk == html:
        raise click.UsageError("say which format: --vtk or --html")
    if html and every:
        raise click.UsageError("--html shows one increment: give --increment instead of --all")
    if every and increment != -1:
        raise click.UsageError("give --increment or --all, not both")
    with short_errors(files=True):
        from .. import results

        ending = ".html" if html else ".pvd" if every else ".vtr"
        target = results_file.with_suffix(ending) if output is None else output
        with results.open_results(results_file) as dataset:
            if html:
                from ..plotting import save_view, view

                shown = view(dataset, increment=increment, body=int(body), quantity=quantity)
                written = [save_view(shown, target)]
            elif every:
                written = results.to_pvd(dataset, target, int(body))
            else:
                written = results.to_vtk(dataset, target, increment, int(body))
        for file in written:
            click.echo(str(file))


@click.command()
@click.argument("run", metavar="RUN", type=FilePath())
@click.option(
    "--output",
    type=FilePath(),
    help="Default: report.html beside the results.",
)
def report(run: Path, output: Path | None) -> None:
    """Write an HTML report of a run: RUN is its directory, or the .nc file in it."""
    with short_errors(files=True):
        from .. import report as reports
        from .. import results

        source = _results_of(run) if run.is_dir() else run
        target = output or source.with_name("report.html")
        if source.exists():  # else that is what is wrong
            _require_page(target)
        beside = source.with_name("shakedown.nc")
        with ExitStack() as opened:
            dataset = opened.enter_context(results.open_results(source))
            repeated = None
            if source.name == "results.nc" and beside.is_file():
                repeated = opened.enter_context(results.open_results(beside))
            file = reports.write(dataset, target, shakedown=repeated)
            failed = [check for check in reports.checks(dataset) if not check.passed]
        for check in failed:
            text = f"check failed: {check.name}: {check.shown}, limit {check.condition}"
            click.echo(text, err=True)
        click.echo(str(file))


def _require_page(target: Path) -> None:
    """Nothing but an older page is replaced; what cannot be written is told before the work."""
    if target.exists() and not target.is_file():  # a device would become a file
        kind = "directory" if target.is_dir() else "device or pipe"
        raise ValueError(f"--output must be a file, and {target} is a {kind}")
    if not target.parent.is_dir():
        raise ValueError(
            f"--output must be in a directory that exists: there is no {target.parent}"
        )
    if target.is_file() and target.suffix.lower() not in (".html", ".htm"):
        raise ValueError(
            f"--output must end in .html where there is a file: {target} would be lost"
        )


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
