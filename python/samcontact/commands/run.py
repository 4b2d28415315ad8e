# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands `run` and `resume`, which solve a case file."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from .arguments import FilePath
from .errors import short_errors
from .loading import uncollected
from .signals import exit_code

if TYPE_CHECKING:
    from ..cases import AnyCase
    from .tables import Printer


@click.command()
@click.argument("case_file", metavar="CASE.toml", type=FilePath())
@click.option("--output", type=FilePath(), help="Folder of the results.")
@click.option("--no-figures", is_flag=True, help="Do not write figures.")
@click.option(
    "--animate",
    is_flag=True,
    help="Also write rolling.gif for a path that moves the bodies, partial_slip.gif with Coulomb "
    "friction, and film.gif for a film in time.",
)
@click.option(
    "--resume",
    is_flag=True,
    help="Write a checkpoint after each increment and continue from existing checkpoints.",
)
@click.option("--quiet", is_flag=True, help="Print only the paths of the result files.")
def run(
    case_file: Path, output: Path | None, no_figures: bool, animate: bool, resume: bool, quiet: bool
) -> None:
    """Solve a case file and write results.nc and figures."""
    with short_errors(files=True):
        with uncollected():
            from ..cases import load_case
            from .interrupted import is_interrupted
            from .tables import new_console

            case = load_case(case_file)
        directory = case.output_directory if output is None else output
        console, figures = new_console(quiet), not no_figures
        try:
            written = _solve(
                case, directory, console, figures=figures, animate=animate, resume=resume
            )
        except KeyboardInterrupt as stop:
            if not is_interrupted(directory):
                raise
            click.echo(f"interrupted; resume with:\n  samcontact resume {directory}", err=True)
            raise SystemExit(exit_code(stop)) from None
    for file in written:
        click.echo(str(file))


def _solve(
    case: AnyCase, directory: Path, console: Printer, *, figures: bool, animate: bool, resume: bool
) -> list[Path]:
    """Solve a case of any kind, and return the files written."""
    from ..cases import Case

    if animate and getattr(case, "accuracy", None) is not None:
        raise ValueError("--animate cannot be combined with accuracy: omit one of them")
    if case.study:
        from .solve_study import solve_study

        return solve_study(
            case, directory, console, figures=figures, animate=animate, resume=resume
        )
    with uncollected():
        from .solve_contact import solve_contact, solve_to_accuracy

    assert isinstance(case, Case)
    if case.accuracy is not None:
        return solve_to_accuracy(case, directory, console, figures=figures, resume=resume)
    return solve_contact(case, directory, console, figures=figures, animate=animate, resume=resume)


@click.command()
@click.argument("run_", metavar="RUN", type=FilePath())
@click.option("--no-figures", is_flag=True, help="Do not write figures.")
@click.option("--quiet", is_flag=True, help="Print only the paths of the result files.")
@click.pass_context
def resume(context: click.Context, run_: Path, no_figures: bool, quiet: bool) -> None:
    """Resume an interrupted run.

    RUN is the folder of the run, or a file in it.
    """
    with short_errors(files=True):
        from .interrupted import interrupted_case

        is_folder = run_.is_dir() or run_.suffix != ".nc"  # results.nc need not exist yet
        directory = run_ if is_folder and not run_.is_file() else run_.parent
        file = interrupted_case(directory)
    context.invoke(
        run, case_file=file, output=directory, no_figures=no_figures, animate=False, resume=True,
        quiet=quiet,
    )  # fmt: skip
