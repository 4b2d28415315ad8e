# SPDX-License-Identifier: GPL-3.0-or-later
"""The command ``samcontact``: run case files, one or many of a kind, print Hertz values.

Exit codes: 0 success, 1 the computation or writing its results failed, 2 bad input, 130 a sweep was
interrupted.
"""

from __future__ import annotations

import math
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np
from rich.console import Console
from rich.table import Table
from rich.text import Text

from . import hertz as _hertz
from ._checks import poisson_ratio

if TYPE_CHECKING:
    import xarray as xr

    from .cases import Case

__all__ = ["main"]

BAD_INPUT = 2
FAILED = 1
MOST_FRAMES = 120  # of an animation


def _print_version(context: click.Context, _: click.Parameter, value: bool) -> None:
    if not value or context.resilient_parsing:
        return
    from samcontact import __version__

    click.echo(f"samcontact {__version__}")
    context.exit()


@contextmanager
def _short_errors() -> Iterator[None]:
    """Turn the errors a user can cause into one message on stderr, without a traceback."""
    from samcontact import ConvergenceError

    code = BAD_INPUT
    try:
        yield
        return
    except ConvergenceError as error:
        message, code = f"no convergence: {error}", FAILED
    except ValueError as error:
        message = str(error)
    except BrokenPipeError:  # the reader of our output has left: click ends quietly
        raise
    except OSError as error:
        message, code = str(error), FAILED
    click.echo(f"error: {message}", err=True)
    raise SystemExit(code)


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
    with _short_errors():
        from . import results
        from .cases import TuggingCase, load_case

        case = load_case(case_file)
        directory = case.output_directory if output is None else output
        checkpoints = directory / "checkpoints" if resume else None
        console = Console(quiet=quiet)
        if isinstance(case, TuggingCase):
            if animate:
                raise ValueError("--animate is not for a case with [tugging]")
            from ._tugging_command import solve_tugging

            directory.mkdir(parents=True, exist_ok=True)
            console.print(case.title, style="bold", markup=False, highlight=False)
            written = solve_tugging(case, directory, checkpoints, console, not no_figures)
            _finish(written, checkpoints)
            return
        if animate and not (case.moves and case.grid.nz > 0):
            raise ValueError("--animate needs a path that moves a body, and a grid with layers")
        simulation, path = case.build()
        # before the computation: a directory that cannot be made must not cost a run
        directory.mkdir(parents=True, exist_ok=True)
        console.print(case.title, style="bold", markup=False, highlight=False)
        states = simulation.run(path, progress=not quiet, checkpoint=checkpoints)
        dataset = results.to_dataset(simulation, states, case)
        written = [results.save(dataset, directory / "results.nc")]
        console.print(_summary(dataset, case.output.body))
        peak = int(np.argmax(dataset["load"].values))
        load = float(dataset["load"].values[peak])
        reference = case.hertz(load) if load > 0.0 else None
        if reference is not None:
            console.print(_comparison(dataset, peak, reference, case))
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
        _finish(written, checkpoints)


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
    with _short_errors():
        from ._sweep_command import run_sweep

        code = run_sweep(case_file, **options)
    raise SystemExit(code)


def _finish(written: list[Path], checkpoints: Path | None) -> None:
    """The results are safe: no more checkpoints, and what was written to stdout."""
    if checkpoints is not None:
        shutil.rmtree(checkpoints)
    for file in written:
        click.echo(str(file))


def _table(title: str, *columns: str) -> Table:
    table = Table(title=title, title_justify="left")
    for index, column in enumerate(columns):
        # Text: "[mm²]" in a plain string would be read as markup
        table.add_column(Text(column), justify="right" if index else "left")
    return table


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
    table = _table("Increments", "", *(heading for _, heading, _, _ in shown))
    for index, number in enumerate(dataset["increment"].values):
        values = [format(dataset[n].values[index] * f, form) for n, _, f, form in shown]
        table.add_row(str(number), *values)
    return table


def _comparison(
    dataset: xr.Dataset,
    peak: int,
    reference: _hertz.PointContact | _hertz.EllipticContact,
    case: Case,
) -> Table:
    """Computed values at the peak load next to those of elastic Hertz contact."""
    table = _table(f"Against elastic Hertz contact at {reference.load:.6g} N", "", "Hertz", "here")
    area = _area(reference)
    unit, factor = ("mm²", 1e6) if area > 1e-8 else ("µm²", 1e12)
    rows: list[tuple[str, float, str, float]] = [
        ("p_max [MPa]", reference.p0, "max_pressure", 1e-6),
        ("approach [µm]", reference.approach, "approach", 1e6),
        (f"contact area [{unit}]", area, "contact_area", factor),
    ]
    material = case.body2 if case.output.body == 2 else case.body1
    nu = getattr(material, "nu", None)
    if isinstance(reference, _hertz.PointContact) and nu is not None:
        name = f"max_von_mises_body{case.output.body}"
        rows.append(("von Mises [MPa]", reference.max_von_mises(nu)[0], name, 1e-6))
    for label, exact, name, factor in rows:
        if name in dataset:
            here = float(dataset[name].values[peak])
            table.add_row(Text(label), f"{exact * factor:.6g}", f"{here * factor:.6g}")
    return table


def _area(contact: _hertz.PointContact | _hertz.EllipticContact) -> float:
    if isinstance(contact, _hertz.PointContact):
        return math.pi * contact.a**2
    return math.pi * contact.a_x * contact.a_y


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
    with _short_errors():
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
