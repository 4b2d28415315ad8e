# SPDX-License-Identifier: GPL-3.0-or-later
"""Solution of a study (collision, film, sliding or wear), and output of tables, results, figures.

A checkpoint is written after each increment of a collision, cycle of wear or velocity of sliding.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from matplotlib.animation import FuncAnimation
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from .._util.film_quantities import FILMS
from .._util.quantities import ASPERITIES
from .._util.sliding_quantities import SLIDING
from .._util.wear_quantities import WEAR
from ..accuracy.outcome import AccuracyResult
from ..accuracy.prescribed import prepare_search, to_accuracy
from ..asperities.series import pass_results
from ..cases.film_studies import amount as film_amount
from ..files.atomic import replacing
from ..plotting import asperities, sliding, wear
from ..plotting.animation import save_animation
from ..plotting.film_animation import film_animation
from ..plotting.film_summary import film_figures
from ..plotting.parts import journal_column
from ..plotting.parts import save as save_figure
from ..results.dataset import completeness
from ..results.file import scalars
from ..results.films import films_dataset
from .error_sheet import errors_sheet
from .errors import StoppedEarlyError, with_resume_hint, write_partial_results
from .folder import publish, written_names
from .interrupted import checkpoints_of
from .tables import Sheet, values_sheet

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

    from ..asperities import CollisionResult
    from ..cases import Case
    from ..cases.asperities import AsperityCase
    from ..cases.films import FilmCase
    from ..cases.kinds import AnyCase
    from ..cases.sliding import SlidingCase
    from ..lubrication import FilmSolution
    from ..sliding import FrictionCurve
    from ..wear import FrettingResult, WearResult
    from .tables import Printer

_PASS_COLUMNS = (
    "max_force_x", "min_force_x", "max_force_z", "net_energy", "dissipation", "residual_energy",
)  # fmt: skip
_CYCLE_COLUMNS = (
    "volume", "depth", "max_pressure", "max_von_mises", "max_equivalent_plastic_strain",
    "slip_distance", "stick_area", "coating_worn_share",
)  # fmt: skip
MAX_FRAMES = 120  # maximum number of frames of an animation
MIN_CHANGE = 1e-4  # relative difference of loads or speeds below which their column is omitted
_FILM_COLUMNS = (
    "time", "speed", "load", "max_pressure", "central_film", "minimum_film", "lambda_ratio",
    "boundary_share", "friction_coefficient", "max_film_rise", "max_plastic_strain",
)  # fmt: skip
_VELOCITY_COLUMNS = (
    "velocity", "friction", "friction_force", "power", "contact_area", "contact_share",
    "max_pressure", "approach",
)  # fmt: skip


class _StudyKind(NamedTuple):
    """Functions that solve a study of one kind, e.g. wear, and convert its results for output."""

    file: str
    solve: Callable[[Path], Any]
    """Function that solves the case; its argument is the folder of the checkpoints."""
    dataset: Callable[[Any], xr.Dataset]
    amount: Callable[[Any], str]
    """Function that describes the results of a run that stopped early, e.g. "2 of 5 cycles"."""
    sheet: Callable[[xr.Dataset], Sheet]
    rows: Callable[[xr.Dataset], pd.DataFrame]
    """Function that returns the rows of the .csv file."""
    draw: Callable[[Any, xr.Dataset], dict[str, Figure]]
    animate: Callable[[Any], FuncAnimation] | None = None
    """Function that returns the animation for the option `--animate`, or None if there is none."""


def solve_study(
    case: AnyCase, directory: Path, console: Printer, *, figures: bool, animate: bool, resume: bool
) -> list[Path]:
    """Solve a study, write .nc and .csv files, figures and animation, and return their paths."""
    kind = _KINDS[case.study](case, not console.quiet)
    if animate and kind.animate is None:
        reason = ", except with film.transient" if case.study == "film" else ""
        raise ValueError(
            f"--animate cannot be combined with [{case.study}]{reason}: omit --animate"
        )
    kind = kind if animate else kind._replace(animate=None)
    return _solve(case, kind, directory, console, figures=figures, resume=resume)


def _asperities(case: AsperityCase, progress: bool) -> _StudyKind:
    """Return the functions that solve an asperity collision and provide its output.

    The output is series.nc, series.csv and figures of pass 1.
    """

    def amount(result: CollisionResult) -> str:
        passes = result.series.sizes["pass"]
        return f"{passes} of {case.asperities.passes} passes (the last incomplete)"

    return _StudyKind(
        "series",
        lambda folder: case.solve(progress=progress, checkpoint=folder),
        lambda result: result.series,
        amount,
        _passes_sheet,
        _increments,
        _draw_asperities,
    )


def _film(case: FilmCase, progress: bool) -> _StudyKind:
    """Return the functions that solve a lubricated contact and provide its output.

    The output is film.nc, film.csv and figures.
    """
    _ = case.standing_gap()  # errors of the case are raised before its folder is written
    return _StudyKind(
        "film",
        lambda folder: case.solve(progress=progress, checkpoint=folder),
        lambda films: films_dataset(films, case),
        lambda films: film_amount(case, len(films)),
        _films_sheet,
        scalars,
        lambda _, dataset: {one.name: one.figure for one in film_figures(dataset, case)},
        None if case.film.transient is None else _film_animation,
    )


def _film_animation(films: Sequence[FilmSolution]) -> FuncAnimation:
    return film_animation(films[:: math.ceil(len(films) / MAX_FRAMES)])


def _sliding(case: SlidingCase, progress: bool) -> _StudyKind:
    """Return the functions that solve steady sliding and provide its output.

    The output is sliding.nc, sliding.csv and figures of quantities versus velocity.
    """

    def amount(result: FrictionCurve) -> str:
        return f"{len(result.solutions)} of {len(case.sliding.speeds())} velocities"

    return _StudyKind(
        "sliding",
        lambda folder: case.solve(progress=progress, checkpoint=folder),
        lambda result: result.to_dataset(),
        amount,
        _velocities_sheet,
        _velocities,
        lambda _, dataset: sliding.figures(dataset),
    )


def _wear(case: Case, progress: bool) -> _StudyKind:
    """Return the functions that solve a wear study and provide wear.nc, wear.csv and figures.

    A case with a prescribed accuracy is solved on successively finer grids; the files contain the
    results of the finest grid.
    """
    settings = case.wear
    assert settings is not None

    def solved(folder: Path) -> AccuracyResult | WearResult | FrettingResult:
        if case.accuracy is not None:
            return to_accuracy(case, progress=progress, checkpoint=folder)
        return settings.solve(*case.build(), folder / "cycle.h5", progress)

    def amount(result: Any) -> str:
        if isinstance(result, AccuracyResult):
            return f"values of {len(result.runs)} grids"
        return f"{len(result.cycles)} of up to {settings.cycles} cycles"

    def draw(result: Any, dataset: xr.Dataset) -> dict[str, Figure]:
        accurate = isinstance(result, AccuracyResult)
        return _draw_wear(result.repeated if accurate else result, dataset)

    # errors of the case are raised before its folder is written
    _ = case.build() if case.accuracy is None else prepare_search(case)
    return _StudyKind(
        "wear", solved, lambda result: result.to_dataset(), amount, _cycles_sheet, _cycles, draw
    )


_KINDS: dict[str, Callable[[Any, bool], _StudyKind]] = {
    "asperities": _asperities,
    "film": _film,
    "sliding": _sliding,
    "wear": _wear,
}


def _solve(
    case: AnyCase,
    kind: _StudyKind,
    directory: Path,
    console: Printer,
    *,
    figures: bool,
    resume: bool,
) -> list[Path]:
    """Solve a study with the functions in `kind`, write all files, and return their paths."""

    def write(result: Any, stopped_by: str = "") -> list[Path]:
        words = {"title": case.title, "description": case.description, "case": case.text}
        attributes = {**words, **completeness(stopped_by)}
        dataset = kind.dataset(result).assign_attrs(attributes)
        written = [publish(dataset, directory / f"{kind.file}.nc"), directory / f"{kind.file}.csv"]
        console.print(kind.sheet(dataset))
        if note := dataset.attrs.get("friction_note", ""):
            console.print(note, markup=False, highlight=False)
        if (errors := errors_sheet(dataset)) is not None:
            console.print(errors)
        if dataset.attrs.get("stopped", 1) == 0 and not stopped_by:
            cycles = dataset.sizes["cycle"]
            console.print(f"wear has not ceased after {cycles} cycles", highlight=False)
        with replacing(written[-1]) as part:
            kind.rows(dataset).to_csv(part)
        if case.output.figures and figures:
            with journal_column(case.output.column):
                for name, figure in kind.draw(result, dataset).items():
                    written.append(save_figure(figure, directory / f"{name}.{case.output.format}"))
        if kind.animate is not None:
            written.append(save_animation(kind.animate(result), directory / f"{kind.file}.gif"))
        return written

    names = written_names(case, kind.file, figures, kind.animate is not None)
    with checkpoints_of(directory, case, names) as checkpoints:
        checkpoints.claim(resume)
        console.print(case.title, style="bold", markup=False, highlight=False)
        try:
            with checkpoints.used() as folder:
                result = kind.solve(folder)
        except Exception as error:
            done = getattr(error, "result", None)
            if done is None:
                raise
            what = kind.amount(done)
            text = write_partial_results(lambda reason: write(done, reason), error, what, directory)
            raise StoppedEarlyError(with_resume_hint(text, directory)) from error
        return write(result)


def _increments(series: xr.Dataset) -> pd.DataFrame:
    of_a_pass = [name for name, field in series.data_vars.items() if field.dims == ("pass",)]
    by_increment = series.drop_dims("body").drop_vars(of_a_pass)
    return by_increment.to_dataframe().dropna(how="all")


def _passes_sheet(series: xr.Dataset) -> Sheet:
    passes = pass_results(series)
    columns = [(ASPERITIES[name], passes[name].values, None) for name in _PASS_COLUMNS]
    name = "residual_displacement"
    prints = [(ASPERITIES[name], passes[name].sel(body=b).values, b) for b in (1, 2)]
    return values_sheet("Passes", passes["pass"].values, [*columns, *prints])


def _velocities(dataset: xr.Dataset) -> pd.DataFrame:
    return dataset[[n for n, field in dataset.items() if field.dims == ("point",)]].to_dataframe()


def _velocities_sheet(dataset: xr.Dataset) -> Sheet:
    columns = [
        (SLIDING[name].fitting(float(dataset[name].max())), dataset[name].values, None)
        for name in _VELOCITY_COLUMNS
        if name in dataset
    ]
    return values_sheet("Velocities", dataset["point"].values, columns)


def _draw_asperities(_: CollisionResult, series: xr.Dataset) -> dict[str, Figure]:
    """Draw the forces and the load ratio force_x/force_z in the first pass."""
    return {
        "force_x": _figure(asperities.force([series], component="x")),
        "force_z": _figure(asperities.force([series], component="z")),
        "load_ratio": _figure(asperities.load_ratio([series])),
    }


def _cycles(dataset: xr.Dataset) -> pd.DataFrame:
    return dataset[[n for n, field in dataset.items() if field.dims == ("cycle",)]].to_dataframe()


def _cycles_sheet(dataset: xr.Dataset) -> Sheet:
    """Return the table of wear cycles.

    Worn volumes are sums over both bodies; all other quantities are maxima of both bodies.
    """
    columns = []
    for name in (name for name in _CYCLE_COLUMNS if name in dataset):
        values = dataset[name]
        if "body" in values.dims:
            values = values.sum("body") if name == "volume" else values.max("body")
        columns.append((WEAR[name], values.values, None))
    return values_sheet("Cycles", dataset["cycle"].values, columns)


def _draw_wear(result: WearResult | FrettingResult, dataset: xr.Dataset) -> dict[str, Figure]:
    figures = {}
    for body in result.worn:
        figures[f"profile_body{body}"] = _figure(wear.worn_profile(dataset, body=body))
        figures[f"surface_body{body}"] = _figure(wear.surface_map(dataset, body=body))
    for name in ("first", "last") if "slip_distance" not in dataset else ():
        for body in result.worn:
            panels = wear.cycle_panels(getattr(result, name), body=body)
            figures[f"{name}_cycle_body{body}"] = panels
    if "slip_distance" in dataset:
        figures["fretting"] = wear.fretting_panels(result.first, result.last)
    figures["wear_rate"] = _figure(wear.wear_rate(dataset))
    return figures


def _figure(ax: Axes) -> Figure:
    figure = ax.figure
    assert isinstance(figure, Figure)  # created by `new_figure`
    return figure


def _films_sheet(dataset: xr.Dataset) -> Sheet:
    shown = [name for name in _FILM_COLUMNS if name in dataset]
    for name in ("load", *(["speed"] if "time" in dataset else [])):
        if np.ptp(dataset[name].values) <= MIN_CHANGE * float(dataset[name].max()):
            shown.remove(name)
    columns = [(FILMS[name], dataset[name].values, None) for name in shown]
    return values_sheet("Films", dataset["increment"].values, columns)
