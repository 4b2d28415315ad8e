# SPDX-License-Identifier: GPL-3.0-or-later
"""Solution of a case with one contact, and output of its tables, results and figures."""

from __future__ import annotations

import math
from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import click
import numpy as np

from .. import hertz, results
from ..accuracy.grid_errors import (
    GridErrors,
    estimate_errors,
    increments_note,
    slope_note,
)
from ..results.against_hertz import hertz_rows
from ..results.dataset import completeness
from ..results.slipping import moved_along, without_rounding
from ..simulation.increment_errors import check_errors
from ..simulation.journal import Journal, describe
from ..simulation.restoring import repeat_with
from ..simulation.run import run_into
from ..simulation.unfolding import count_text
from ..solutions.peak import peak_of_dataset
from ..solutions.state import on_common_grid
from .error_sheet import errors_sheet
from .errors import StoppedEarlyError, with_resume_hint, write_partial_results
from .folder import publish, written_names
from .interrupted import Checkpoints, checkpoints_of
from .tables import CONTACT_COLUMNS, Sheet, contact_columns, numbers, values_sheet

if TYPE_CHECKING:
    import xarray as xr

    from ..accuracy.outcome import AccuracyResult
    from ..cases import Case
    from ..simulation.simulation import Simulation
    from ..solutions.state import State
    from .tables import Printer

MAX_FRAMES = 120  # maximum number of frames of an animation


def solve_contact(
    case: Case, directory: Path, console: Printer, *, figures: bool, animate: bool, resume: bool
) -> list[Path]:
    """Solve a case with one contact, write results.nc and figures, and return their paths.

    With `resume`, a checkpoint is written after each increment. Otherwise, the checkpoints of all
    solved increments are written only if the run stops before all files are written. If an error
    stops the run, results of the solved increments are also written.
    """
    if animate and not (case.sticks or (case.moves and case.has_volume)):
        raise ValueError(
            "--animate requires Coulomb friction, or bodies that move on a grid with dz: omit "
            "--animate"
        )
    simulation, path = case.build()
    run_identity = describe(simulation.engine, path=path)
    # check the folder before the computation, not after it
    written = written_names(case, "results", figures, animate)
    with checkpoints_of(directory, case, written) as checkpoints:
        journal = checkpoints.claim(resume)
        console.print(case.title, style="bold", markup=False, highlight=False)
        states: list[State] = []

        def write(folder: Path) -> None:
            Journal(folder, simulation.engine, run_identity).add_all(states)

        try:
            with checkpoints.used() if journal else nullcontext() as kept:
                error = None
                try:
                    engine, monitor, step = simulation.engine, simulation.monitor, simulation.step
                    run_into(states, engine, monitor, step, path, not console.quiet, kept)
                except Exception as stop:
                    if not states:
                        raise
                    error = stop
            run = _ContactRun(case, checkpoints, console, simulation, on_common_grid(states))
            if error is not None:
                text = run.partial(
                    error, f"{len(states)} of {count_text(path)} increments", figures
                )
                raise StoppedEarlyError(with_resume_hint(text, directory)) from error
            return run.write(figures=figures, animate=animate)
        except BaseException:
            if states and not journal:
                checkpoints.keep(write, len(states))
            raise


def solve_to_accuracy(
    case: Case, directory: Path, console: Printer, *, figures: bool, resume: bool
) -> list[Path]:
    """Solve a case to the prescribed accuracy, write results and figures, and return their paths.

    The results are those of the finest grid. After an error or an interruption, the best results
    obtained so far are written.
    """
    from ..accuracy.prescribed import prepare_search  # not needed by other cases

    search = prepare_search(case, progress=not console.quiet)
    written = written_names(case, "results", figures, False)
    with checkpoints_of(directory, case, written) as checkpoints:
        journal = checkpoints.claim(resume)
        console.print(case.title, style="bold", markup=False, highlight=False)
        try:
            error: BaseException | None = None
            found: AccuracyResult | None = None
            with (
                checkpoints.used() if journal else nullcontext() as kept,
                search.solves.kept_in(kept),
            ):
                try:
                    found = search.search()
                except (Exception, KeyboardInterrupt) as stop:
                    error, found = stop, search.best()
                    if found is None:
                        raise
            run = _ContactRun(
                found.case, checkpoints, console, found.simulation, found.states, found
            )
            if error is None:
                return run.write(figures=figures)
            text = run.partial(error, f"values of {len(search.grids)} grids", figures)
            if isinstance(error, Exception):
                raise StoppedEarlyError(with_resume_hint(text, directory)) from error
            click.echo(text, err=True)
            raise error
        except BaseException:
            if not journal and search.solves.increments:
                checkpoints.keep(search.solves.keep, search.solves.increments)
            raise


@dataclass
class _ContactRun:
    """Simulation of a case, with all increments or, after an error, those solved before it.

    accurate: if an accuracy is prescribed, the result of the search for the grid that reaches it.
    """

    case: Case
    checkpoints: Checkpoints
    console: Printer
    simulation: Simulation
    states: list[State]
    accurate: AccuracyResult | None = None

    @property
    def directory(self) -> Path:
        return self.checkpoints.directory

    def write(self, *, figures: bool, animate: bool = False, stopped_by: str = "") -> list[Path]:
        """Write results and figures, print tables, and return the paths of the files.

        stopped_by: error that stopped the run, or "" for a complete run.
        """
        case, console, states = self.case, self.console, self.states
        if self.accurate is not None:
            dataset = self.accurate.to_dataset().assign_attrs(completeness(stopped_by))
        else:
            dataset = results.to_dataset(self.simulation, states, case, stopped_by=stopped_by)
        errors = None if stopped_by or self.accurate is not None else self._errors()
        if errors is not None:
            errors.add_to(dataset)
        written = [publish(dataset, self.directory / "results.nc")]
        body = case.output.body
        console.print(_summary(dataset, body))
        if (sheet := errors_sheet(dataset)) is not None:
            console.print(sheet)
        if text := increments_note(dataset.attrs):
            console.print(text, markup=False, highlight=False)
        if text := dataset.attrs.get("accuracy_surface", ""):
            console.print(text, markup=False, highlight=False)
        if text := slope_note(dataset.attrs.get("slope_beyond", math.nan)):
            console.print(text, markup=False, highlight=False)
        if self.accurate is None and (text := self.simulation.engine.enlargement):
            text += "; [grid] specifies the initial grid"
            console.print(text, markup=False, highlight=False)
        peak = peak_of_dataset(dataset)
        load = float(dataset["load"].values[peak])
        reference = case.hertz(load) if load > 0.0 else None
        if reference is not None:
            moduli = ", instantaneous moduli" if case.relaxes else ""
            console.print(_comparison(dataset, peak, reference, body, moduli))
        if case.fatigue is not None and not stopped_by:
            from .fatigue import write_fatigue

            shown = case.output.figures and figures
            written += write_fatigue(case, states, self.directory, console, figures=shown)
        if case.output.figures and figures:
            from ..plotting import journal_column, summary_figures

            with journal_column(case.output.column):
                written += summary_figures(
                    self._with_figure_fields(dataset),
                    self.directory,
                    body=body,
                    hertz=reference,
                    format=case.output.format,
                )
        if case.shakedown is not None and not stopped_by:
            from .shakedown import write_shakedown

            shown = case.output.figures and figures
            repeated = None if self.accurate is None else self.accurate.shakedown
            written += write_shakedown(
                case, self.checkpoints, console, figures=shown, found=repeated
            )
        return written + (self._animations() if animate else [])

    def _animations(self) -> list[Path]:
        from ..plotting import partial_slip_animation, rolling_animation, save_animation

        shown = self.states[:: math.ceil(len(self.states) / MAX_FRAMES)]
        made = {}
        if self.case.moves and self.case.has_volume:
            made["rolling"] = rolling_animation(shown, body=self.case.output.body)
        if self.case.sticks and any(state.in_contact.any() for state in shown):
            made["partial_slip"] = partial_slip_animation(shown)
        return [save_animation(one, self.directory / f"{name}.gif") for name, one in made.items()]

    def _errors(self) -> GridErrors | None:
        """Return the grid errors estimated from a run on a coarsened grid.

        Return None if the case does not request them or the estimate fails.
        """
        if not self.case.estimate_error:
            run = self.simulation
            repeat = repeat_with(type(run), run.engine.preparation)
            check_errors(run.engine, run.monitor, self.states, 1, repeat, stacklevel=3)
            return None
        try:
            text = "repeating the run on a coarsened grid"
            with self.console.status(text):
                return estimate_errors(self.simulation, self.case.steps(), self.states)
        except Exception as error:
            text = f"could not estimate the grid errors: {error}"
            self.console.print(text, markup=False, highlight=False)
            return None

    def _with_figure_fields(self, dataset: xr.Dataset) -> xr.Dataset:
        """Return a dataset with the volume fields of all increments that the figures show."""
        from ..plotting.summary import increments_shown

        shown = increments_shown(dataset, self.case.output.body)
        there = dataset.get("output_increment", ())
        if not self.simulation.grid.has_volume or shown <= set(np.asarray(there).tolist()):
            return dataset
        return results.to_dataset(self.simulation, self.states, self.case, volume=sorted(shown))

    def partial(self, error: BaseException, what: str, figures: bool) -> str:
        """Write the results obtained before an error, and return a message for the user.

        what: description of these results, e.g. "3 of 12 increments".
        """
        return write_partial_results(
            lambda reason: self.write(figures=figures, stopped_by=reason),
            error,
            what,
            self.directory,
        )


def _summary(dataset: xr.Dataset, body: int) -> Sheet:
    """Return the table of the main quantities at all increments, in the units for display."""
    along = moved_along(dataset)
    names = (*CONTACT_COLUMNS, "imprint_depth", "travel", "lateral_travel", *along, "iterations")
    shown = contact_columns(dataset, names, body)
    columns = [
        (quantity, without_rounding(dataset[name].values) if name in along
         else dataset[name].values, None)
        for name, quantity in shown.items()
    ]  # fmt: skip
    finest = " (finest grid)" if "accuracy_reached" in dataset.attrs else ""
    return values_sheet(f"Increments{finest}", dataset["increment"].values, columns)


def _comparison(
    dataset: xr.Dataset,
    peak: int,
    reference: hertz.PointContact | hertz.EllipticContact,
    body: int,
    moduli: str = "",
) -> Sheet:
    """Return the table that compares the results at an increment with the Hertz contact.

    peak: index of the increment, from 0. moduli: note on the moduli of the Hertz contact.
    """
    number = int(dataset["increment"][peak])
    rows = []
    for quantity, exact, here in hertz_rows(dataset, peak, reference, body):
        shown = quantity.fitting(exact)
        label = shown.column().replace("\n", " ")
        rows.append((label, *numbers([exact * shown.factor, here * shown.factor], 6)))
    labels, elastic, computed = zip(*rows, strict=True)
    where = f"increment {number}, {reference.load:.6g} N{moduli}"
    sheet = Sheet(f"Comparison with elastic Hertz contact, {where}")
    sheet.add("", labels)
    sheet.add("Hertz", elastic)
    sheet.add("simulation", computed)
    return sheet
