# SPDX-License-Identifier: GPL-3.0-or-later
"""The command ``samcontact``: run case files, one or many of a kind, report, print Hertz values.

Exit codes: 0 success, 1 the computation or writing its results failed, 2 bad input,
130 interrupted.
"""

from __future__ import annotations

import math
import shutil
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import click
import numpy as np
from rich.console import Console
from rich.table import Table
from rich.text import Text

from . import hertz as _hertz
from ._checks import poisson_ratio
from ._cli_errors import FAILED, INTERRUPTED, short_errors
from ._command_tables import new_table
from ._doctor_command import doctor
from ._hertz_rows import hertz_area, hertz_rows
from ._result_commands import export, report

if TYPE_CHECKING:
    import xarray as xr

    from .cases import Case, TuggingCase

__all__ = ["main"]

MOST_FRAMES = 120  # of an animation


def _print_version(context: click.Context, _: click.Parameter, value: bool) -> None:
    if not value or context.resilient_parsing:
        return
    from samcontact import __version__

    click.echo(f"samcontact {__version__}")
    context.exit()


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.option(
    "--version",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_print_version,
    help="Print the version and exit.",
)
def main() -> None:
    """Semi-analytical elastic-plastic contact of two half-spaces."""


@main.command()
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
        from . import results
        from .cases import TuggingCase, load_case

        case = load_case(case_file)
        directory = case.output_directory if output is None else output
        console = Console(quiet=quiet)
        if isinstance(case, TuggingCase) or case.wear is not None:
            section = "tugging" if isinstance(case, TuggingCase) else "wear"
            if animate:
                raise ValueError(f"--animate is not for a case with [{section}]")
            # their checkpoints cost little
            checkpoints = _folder_of_checkpoints(directory, case)
            console.print(case.title, style="bold", markup=False, highlight=False)
            try:
                written = _solve_study(case, directory, checkpoints, console, not no_figures)
            except KeyboardInterrupt:
                _say_how_to_resume(directory)
            _finish(written, checkpoints)
            return
        if animate and not (case.moves and case.grid.nz > 0):
            raise ValueError("--animate needs a path that moves a body, and a grid with layers")
        simulation, path = case.build()
        # before the computation: a directory that cannot be made must not cost a run
        directory.mkdir(parents=True, exist_ok=True)
        console.print(case.title, style="bold", markup=False, highlight=False)
        kept = _folder_of_checkpoints(directory, case) if resume else None
        try:
            states = simulation.run(path, progress=not quiet, checkpoint=kept)
        except KeyboardInterrupt as stop:
            if kept is None:
                from ._interrupt import keep_states

                kept = _folder_of_checkpoints(directory, case)
                keep_states(kept, simulation, path, getattr(stop, "states", ()))
            _say_how_to_resume(directory)
        dataset = results.to_dataset(simulation, states, case)
        written = [results.save(dataset, directory / "results.nc")]
        console.print(_summary(dataset, case.output.body))
        peak = int(np.argmax(dataset["load"].values))
        load = float(dataset["load"].values[peak])
        reference = case.hertz(load) if load > 0.0 else None
        if reference is not None:
            console.print(_comparison(dataset, peak, reference, case.output.body))
        if case.output.figures and not no_figures:
            from .plotting import summary_figures

            written += summary_figures(
                simulation, states, directory, body=case.output.body, hertz=reference
            )
        if animate:
            from .animation import rolling_animation, save_animation

            shown = states[:: math.ceil(len(states) / MOST_FRAMES)]
            animation = rolling_animation(shown, body=case.output.body)
            written.append(save_animation(animation, directory / "rolling.gif"))
        _finish(written, kept)


def _folder_of_checkpoints(directory: Path, case: Case | TuggingCase) -> Path:
    from ._interrupt import remember_case

    return remember_case(directory, case)


def _say_how_to_resume(directory: Path) -> NoReturn:
    click.echo(f"interrupted: go on with\n  samcontact resume {directory}", err=True)
    raise SystemExit(INTERRUPTED)


@main.command()
@click.argument("directory", type=click.Path(path_type=Path))
@click.option("--no-figures", is_flag=True, help="Write no figures.")
@click.option("--quiet", is_flag=True, help="Print the paths of the results only.")
@click.pass_context
def resume(context: click.Context, directory: Path, no_figures: bool, quiet: bool) -> None:
    """Go on with a run that was interrupted, from the directory of its results."""
    with short_errors():
        from ._interrupt import interrupted_case

        file = interrupted_case(directory)
    context.invoke(
        run, case_file=file, output=directory, no_figures=no_figures, animate=False, resume=True,
        quiet=quiet,
    )  # fmt: skip


def _solve_study(
    case: Case | TuggingCase,
    directory: Path,
    checkpoints: Path | None,
    console: Console,
    figures: bool,
) -> list[Path]:
    """Tugging, or the cycles of wear."""
    from .cases import TuggingCase

    if isinstance(case, TuggingCase):
        from ._tugging_command import solve_tugging

        return solve_tugging(case, directory, checkpoints, console, figures)
    from ._wear_command import solve_wear

    return solve_wear(case, directory, checkpoints, console, figures)


@main.command("sweep")
@click.argument("case_file", metavar="CASE.toml", type=click.Path(path_type=Path))
@click.option(
    "--set",
    "settings",
    metavar="FIELD=VALUE,...",
    multiple=True,
    required=True,
    help="Values of a field, e.g. body2.yield_stress=1e9,2e9; once for each field.",
)
@click.option("--zip", "zipped", is_flag=True, help="First values, second ones, ... together.")
@click.option("--jobs", type=click.IntRange(min=1), help="Worker processes of one thread each.")
@click.option("--dask", "address", metavar="ADDRESS", help="Scheduler of a Dask cluster.")
@click.option("--output", type=click.Path(path_type=Path), help="Directory of the results.")
@click.option("--quiet", is_flag=True, help="Print the path of the results only.")
def sweep_command(case_file: Path, **options: Any) -> None:
    """Solve a case file for many values of its fields; write sweep.nc.

    The same command goes on with a sweep that was interrupted, and tries failed cases again.
    """
    with short_errors():
        from ._sweep_command import run_sweep

        code = run_sweep(case_file, **options)
    raise SystemExit(code)


def _finish(written: list[Path], checkpoints: Path | None) -> None:
    """The results are safe: no more checkpoints, and what was written to stdout."""
    if checkpoints is not None:
        shutil.rmtree(checkpoints)
    for file in written:
        click.echo(str(file))


def _summary(dataset: xr.Dataset, body: int) -> Table:
    """Table of all increments, in units that read well."""
    wanted: list[tuple[str, str, float, str]] = [
        ("load", "load\n[N]", 1.0, ".6g"),
        ("approach", "approach\n[µm]", 1e6, ".4f"),
        ("max_pressure", "p_max\n[MPa]", 1e-6, ".1f"),
        (f"max_von_mises_body{body}", "von Mises\n[MPa]", 1e-6, ".1f"),
        (f"max_equivalent_plastic_strain_body{body}", "plastic\nstrain [%]", 1e2, ".4f"),
        (f"max_temperature_body{body}", "heating\n[K]", 1.0, ".1f"),
        (f"travel_body{body}", "travel\n[µm]", 1e6, ".2f"),
        ("iterations", "itera-\ntions", 1, ".0f"),
    ]
    shown = [column for column in wanted if column[0] in dataset]
    table = new_table("Increments", "", *(heading for _, heading, _, _ in shown))
    for index, number in enumerate(dataset["increment"].values):
        values = [format(dataset[n].values[index] * f, form) for n, _, f, form in shown]
        table.add_row(str(number), *values)
    return table


def _comparison(
    dataset: xr.Dataset,
    peak: int,
    reference: _hertz.PointContact | _hertz.EllipticContact,
    body: int,
) -> Table:
    """Computed values at the peak load next to those of elastic Hertz contact."""
    table = new_table(
        f"Against elastic Hertz contact at {reference.load:.6g} N", "", "Hertz", "here"
    )
    unit, factor = ("mm²", 1e6) if hertz_area(reference) > 1e-8 else ("µm²", 1e12)
    shown = {
        "maximum pressure": ("p_max [MPa]", 1e-6),
        "approach": ("approach [µm]", 1e6),
        "contact area": (f"contact area [{unit}]", factor),
        "maximum von Mises stress": ("von Mises [MPa]", 1e-6),
    }
    for name, _, exact, here in hertz_rows(dataset, peak, reference, body):
        label, factor = shown[name]
        table.add_row(Text(label), f"{exact * factor:.6g}", f"{here * factor:.6g}")
    return table


@main.command()
@click.argument("names", metavar="[PART | FIGURE]...", nargs=-1)
@click.option("--quick", is_flag=True, help="Coarse grids: seconds for each part.")
@click.option("--list", "listing", is_flag=True, help="Print the parts and their figures.")
@click.option(
    "--output",
    type=click.Path(path_type=Path),
    default=Path("gallery"),
    show_default=True,
    help="Directory of the pages.",
)
def gallery(names: tuple[str, ...], quick: bool, listing: bool, output: Path) -> None:
    """Compute figures and stated values of Boucly's thesis (2008), all or those named.

    Exit code 1 when a value differs from what is stated.
    """
    with short_errors():
        from .gallery import parts

        if listing:
            for name in parts.PARTS:
                click.echo(f"{name:<22}{parts.figures_of(name)}")
            return
        chosen = dict.fromkeys(parts.part_of(name) for name in names) or parts.PARTS
        if parts.make(list(chosen), output, quick, click.echo):
            raise SystemExit(FAILED)


@main.command("hertz")
@click.option("--R", "radius", type=float, required=True, help="Equivalent radius (Rx) [m].")
@click.option("--Ry", "radius_y", type=float, help="Second equivalent radius [m]: elliptic.")
@click.option("--E-star", "modulus", type=float, required=True, help="Contact modulus [Pa].")
@click.option("--load", type=float, help="Normal load [N].")
@click.option("--approach", type=float, help="Rigid-body approach [m].")
@click.option("--p0", type=float, help="Maximum pressure [Pa].")
@click.option("--nu", type=float, help="Poisson's ratio: adds the largest von Mises stress.")
def hertz_command(
    radius: float,
    radius_y: float | None,
    modulus: float,
    load: float | None,
    approach: float | None,
    p0: float | None,
    nu: float | None,
) -> None:
    """Hertz point or elliptic contact from one of --load, --approach, --p0."""
    with short_errors():
        given: dict[str, Any] = {"load": load, "approach": approach, "p0": p0}
        contact: _hertz.PointContact | _hertz.EllipticContact
        rows: list[tuple[str, float]]
        if radius_y is None:
            contact = _hertz.point(radius, modulus, **given)
            rows = [("contact radius a [m]", contact.a)]
        else:
            contact = _hertz.elliptic(radius, radius_y, modulus, **given)
            rows = [
                ("semi-axis a_x [m]", contact.a_x),
                ("semi-axis a_y [m]", contact.a_y),
                ("ellipticity a_y/a_x [-]", contact.k),
            ]
        rows += [
            ("load [N]", contact.load),
            ("maximum pressure p0 [Pa]", contact.p0),
            ("approach [m]", contact.approach),
        ]
        if nu is not None:
            poisson_ratio("nu", nu)
            if not isinstance(contact, _hertz.PointContact):
                raise ValueError("nu is for point contacts: the elliptic axis stress is not built")
            stress, depth = contact.max_von_mises(nu)
            rows += [("maximum von Mises stress [Pa]", stress), ("its depth [m]", depth)]
        for label, value in rows:
            click.echo(f"{label:<32}{value:.9g}")


main.add_command(doctor)
main.add_command(export)
main.add_command(report)
