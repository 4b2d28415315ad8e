# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands that read what a run has written: reports, and export for other programs."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, nullcontext
from pathlib import Path

import click

from ..files.atomic import with_ending
from ..files.ownership import recording
from .arguments import FilePath
from .errors import short_errors

_ENDINGS = (".html", ".vtr", ".pvd")


@click.command()
@click.argument("run", metavar="RUN", type=FilePath())
@click.option("--vtk", is_flag=True, help="VTK files for ParaView: volume and surface.")
@click.option("--html", is_flag=True, help="A page with the body in three dimensions.")
@click.option(
    "--quantity",
    default="von_mises",
    show_default=True,
    help="Field of the page, as in the results.",
)
@click.option(
    "--increment", type=int, default=-1, show_default=True, help="Its number; -1: last stored."
)
@click.option("--all", "every", is_flag=True, help="Every increment as VTK, and a .pvd of them.")
@click.option(
    "--body",
    type=click.Choice(["1", "2"]),
    help="Whose fields; default: that of [output], or the one that has them.",
)
@click.option("--output", type=FilePath(), help="File; default: beside the results.")
def export(
    run: Path,
    vtk: bool,
    html: bool,
    quantity: str,
    increment: int,
    every: bool,
    body: str | None,
    output: Path | None,
) -> None:
    """Write the fields of one increment, or of all, for another program or for a browser.

    RUN is the folder of a run, or the results.nc in it.
    """
    if not (vtk or html):
        raise click.UsageError("say which format: --vtk, --html, or both")
    if every and not vtk:
        raise click.UsageError("--html shows one increment: give --increment instead of --all")
    if every and increment != -1:
        raise click.UsageError("give --increment or --all, not both")
    with short_errors(files=True):
        from .. import results

        source = _results_of(run, ("results.nc",))
        target = source.with_suffix("") if output is None else output
        if output is not None and output.suffix.lower() in _ENDINGS and vtk and html:
            target = output.with_suffix("")  # each format has its own
        number = None if body is None else int(body)
        written: list[Path] = []
        # a file that the user has named is replaced whatever it is
        listed = recording(source.parent) if output is None else nullcontext()
        with results.open_results(source) as dataset, listed:
            if "pressure" not in dataset:
                raise ValueError(
                    f"{source} has no fields of a contact to export: samcontact report shows "
                    "results of tugging and wear"
                )
            if vtk and every:
                written += results.to_pvd(dataset, target, number)
            elif vtk:
                written += results.to_vtk(dataset, target, increment, number)
            if html:
                from ..plotting import save_view, view

                shown = view(dataset, increment=increment, body=number, quantity=quantity)
                page = output if output is not None and not vtk else with_ending(target, ".html")
                written.append(save_view(shown, page))
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
    """Write an HTML report of a run: RUN is its folder, or the .nc file in it."""
    with short_errors(files=True):
        from .. import report as reports
        from .. import results

        source = _results_of(run, ("results.nc", "series.nc", "wear.nc"))
        default = source.with_name("report.html")
        target = output or default
        if source.exists():  # else that is what is wrong
            _require_page(target)
        beside = source.with_name("shakedown.nc")
        with ExitStack() as opened:
            dataset = opened.enter_context(results.open_results(source))
            repeated = None
            if source.name == "results.nc" and beside.is_file():
                repeated = opened.enter_context(results.open_results(beside))
            opened.enter_context(_recorded(target, default))
            file = reports.write(dataset, target, shakedown=repeated)
            failed = [check for check in reports.checks(dataset) if not check.passed]
        for check in failed:
            text = f"check failed: {check.name}: {check.shown}, limit {check.condition}"
            click.echo(text, err=True)
        click.echo(str(file))


@contextmanager
def _recorded(target: Path, default: Path) -> Iterator[None]:
    """List files written under their default names, which replace none of others; a file that the
    user has named otherwise is replaced whatever it is."""
    if target != default:
        yield
        return
    with recording(target.parent) as record:
        record.require(target)
        yield


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


def _results_of(run: Path, names: tuple[str, ...]) -> Path:
    """The file of these names that a run has left in its folder, or the file that is given."""
    if not run.is_dir():
        return run
    found = [run / name for name in names if (run / name).exists()]
    if len(found) != 1:
        there = ", ".join(file.name for file in found) or ", ".join(
            sorted(file.name for file in run.glob("*.nc"))[:5]
        )
        raise ValueError(
            f"{run} must hold one of {', '.join(names)}, has {there or 'none of them'}: name the "
            "file"
        )
    return found[0]
