# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands that solve a case file, and go on with one that was interrupted."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.console import Console

from .errors import INTERRUPTED, short_errors

if TYPE_CHECKING:
    from ..cases import Case, TuggingCase


@click.command()
@click.argument("case_file", metavar="CASE.toml", type=click.Path(path_type=Path))
@click.option("--output", type=click.Path(path_type=Path), help="Directory of the results.")
@click.option("--no-figures", is_flag=True, help="Write no figures.")
@click.option(
    "--animate", is_flag=True, help="Write rolling.gif too, for a path that moves the bodies."
)
@click.option(
    "--resume",
    is_flag=True,
    help="Write a checkpoint after each increment, and go on from those of an interrupted run.",
)
@click.option("--quiet", is_flag=True, help="Print the paths of the results only.")
def run(
    case_file: Path, output: Path | None, no_figures: bool, animate: bool, resume: bool, quiet: bool
) -> None:
    """Solve a case file; write results.nc and figures."""
    with short_errors():
        from ..cases import TuggingCase, load_case
        from .interrupted import is_interrupted

        case = load_case(case_file)
        directory = case.output_directory if output is None else output
        console, figures = Console(quiet=quiet), not no_figures
        try:
            if isinstance(case, TuggingCase) or case.wear is not None:
                written = _solve_study(case, directory, console, figures, animate)
            else:
                from .solve_contact import solve_contact

                written = solve_contact(
                    case, directory, console, figures=figures, animate=animate, journal=resume
                )
        except KeyboardInterrupt:
            if not is_interrupted(directory):
                raise
            click.echo(f"interrupted: go on with\n  samcontact resume {directory}", err=True)
            raise SystemExit(INTERRUPTED) from None
    for file in written:
        click.echo(str(file))


def _solve_study(
    case: Case | TuggingCase, directory: Path, console: Console, figures: bool, animate: bool
) -> list[Path]:
    """Tugging, or the cycles of wear; their checkpoints cost little, and are always written."""
    from ..cases import TuggingCase
    from .interrupted import forget_case, remember_case

    if animate:
        section = "tugging" if isinstance(case, TuggingCase) else "wear"
        raise ValueError(f"--animate is not for a case with [{section}]")
    checkpoints = remember_case(directory, case)
    console.print(case.title, style="bold", markup=False, highlight=False)
    if isinstance(case, TuggingCase):
        from .solve_tugging import solve_tugging

        written = solve_tugging(case, directory, checkpoints, console, figures)
    else:
        from .solve_wear import solve_wear

        written = solve_wear(case, directory, checkpoints, console, figures)
    forget_case(directory)
    return written


@click.command()
@click.argument("directory", type=click.Path(path_type=Path))
@click.option("--no-figures", is_flag=True, help="Write no figures.")
@click.option("--quiet", is_flag=True, help="Print the paths of the results only.")
@click.pass_context
def resume(context: click.Context, directory: Path, no_figures: bool, quiet: bool) -> None:
    """Go on with a run that was interrupted, from the directory of its results."""
    with short_errors():
        from .interrupted import interrupted_case

        file = interrupted_case(directory)
    context.invoke(
        run, case_file=file, output=directory, no_figures=no_figures, animate=False, resume=True,
        quiet=quiet,
    )  # fmt: skip
