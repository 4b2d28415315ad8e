# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands `report` and `export`, which use the results of a run."""

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


@click.command(short_help="Export fields for ParaView or a browser.")
@click.argument("run", metavar="RUN", type=FilePath())
@click.option("--vtk", is_flag=True, help="Write VTK files for ParaView: volume and surface.")
@click.option("--html", is_flag=True, help="Write a page with a three-dimensional view of a body.")
@click.option(
    "--quantity",
    default="von_mises",
    show_default=True,
    help="Field shown on the page, by its name in the results.",
)
@click.option(
    "--increment",
    type=int,
    default=-1,
    show_default=True,
    help="Number of the increment; -1: last stored.",
)
@click.option(
    "--all", "every", is_flag=True, help="Export all increments as VTK files and a .pvd collection."
)
@click.option(
    "--body",
    type=click.Choice(["1", "2"]),
    help="Body whose fields are exported; default: the only body with fields or, if both have "
    "fields, the body of [output].",
)
@click.option("--output", type=FilePath(), help="File; default: in the folder of the results.")
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
    """Export the fields of one increment, or of all increments, for ParaView or a browser.

    RUN is the folder of a run, or the file results.nc in it.
    """
    if not (vtk or html):
        raise click.UsageError("output format required: --vtk, --html or both")
    if every and not vtk:
        raise click.UsageError(
            "--html exports a single increment: use --increment instead of --all"
        )
    if every and increment != -1:
        raise click.UsageError("--increment and --all cannot be combined")
    with short_errors(files=True):
        from .. import results

        source = _results_of(run, ("results.nc",))
        target = source.with_suffix("") if output is None else output
        if output is not None and output.suffix.lower() in _ENDINGS and vtk and html:
            target = output.with_suffix("")  # one suffix per format is added later
        number = None if body is None else int(body)
        written: list[Path] = []
        # a file named by the user is replaced in any case
        listed = recording(source.parent) if output is None else nullcontext()
        with results.open_results(source) as dataset, listed:
            if "pressure" not in dataset or "increment" not in dataset.dims:
                raise ValueError(
                    f"{source} contains no contact fields to export: use samcontact report for "
                    "results of asperity collisions, wear, films and sliding"
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
    help="File; default: report.html in the folder of the results.",
)
def report(run: Path, output: Path | None) -> None:
    """Write an HTML report of a run.

    RUN is the folder of the run, or the .nc file in it.
    """
    with short_errors(files=True):
        from .. import report as reports
        from .. import results

        names = ("results.nc", "series.nc", "wear.nc", "film.nc", "sliding.nc")
        source = _results_of(run, names)
        default = source.with_name("report.html")
        target = output or default
        if source.exists():  # a missing file is reported below
            _require_page(target)
        with ExitStack() as opened:
            dataset = opened.enter_context(results.open_results(source))
            more = {}
            for name in ("shakedown", "fatigue"):
                other = source.with_name(f"{name}.nc")
                if source.name == "results.nc" and other.is_file():
                    more[name] = opened.enter_context(results.open_results(other))
            opened.enter_context(_recorded(target, default))
            file = reports.write(dataset, target, **more)
            failed = [check for check in reports.checks(dataset) if not check.passed]
        for check in failed:
            text = f"check failed: {check.name}: {check.shown}, limit {check.condition}"
            click.echo(text, err=True)
        click.echo(str(file))


@contextmanager
def _recorded(target: Path, default: Path) -> Iterator[None]:
    """Context manager that protects files of other programs while the report is written.

    A report with the default name is recorded as written by this package; ValueError is raised if
    the report would replace a file without such a record. A report that the user named with
    --output replaces any file.
    """
    if target != default:
        yield
        return
    with recording(target.parent) as record:
        record.require(target)
        yield


def _require_page(target: Path) -> None:
    """Raise ValueError, before any work, if the page cannot be written to `target`."""
    if target.exists() and not target.is_file():  # a device would be replaced by a file
        kind = "directory" if target.is_dir() else "device or pipe"
        raise ValueError(f"--output must be a file, got {target}, a {kind}")
    if not target.parent.is_dir():
        raise ValueError(f"--output must be in an existing folder: there is no {target.parent}")
    if target.is_file() and target.suffix.lower() not in (".html", ".htm"):
        raise ValueError(
            f"--output must end in .html to replace an existing file: {target} would be lost"
        )


def _results_of(run: Path, names: tuple[str, ...]) -> Path:
    """Return the file `run`, or the only file with a name in `names` in the folder `run`."""
    if not run.is_dir():
        return run
    found = [run / name for name in names if (run / name).exists()]
    if len(found) != 1:
        there = ", ".join(file.name for file in found) or ", ".join(
            sorted(file.name for file in run.glob("*.nc"))[:5]
        )
        raise ValueError(
            f"{run} must contain one of {', '.join(names)}, got {there or 'none'}: specify the file"
        )
    return found[0]
