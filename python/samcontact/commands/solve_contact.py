# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command does with a case of one contact: solve it, print and write results, figures."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from rich.console import Console
from rich.table import Table
from rich.text import Text

from .. import hertz, results
from ..results.against_hertz import hertz_area, hertz_rows
from .interrupted import forget_case, keep_states, remember_case
from .tables import contact_columns, new_table

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import Case

MOST_FRAMES = 120  # of an animation


def solve_contact(
    case: Case, directory: Path, console: Console, *, figures: bool, animate: bool, journal: bool
) -> list[Path]:
    """Write results.nc and figures; the files.

    With `journal`, each increment leaves a checkpoint, and those of an interrupted run are used.
    Without it, Ctrl-C leaves them all.
    """
    if animate and not (case.moves and case.grid.nz > 0):
        raise ValueError("--animate needs a path that moves a body, and a grid with layers")
    simulation, path = case.build()
    # before the computation: a directory that cannot be made must not cost a run
    directory.mkdir(parents=True, exist_ok=True)
    console.print(case.title, style="bold", markup=False, highlight=False)
    kept = remember_case(directory, case) if journal else None
    try:
        states = simulation.run(path, progress=not console.quiet, checkpoint=kept)
    except KeyboardInterrupt as stop:
        if kept is None:
            kept = remember_case(directory, case)
            keep_states(kept, simulation, path, getattr(stop, "states", ()))
        raise
    dataset = results.to_dataset(simulation, states, case)
    written = [results.save(dataset, directory / "results.nc")]
    body = case.output.body
    console.print(_summary(dataset, body))
    peak = int(np.argmax(dataset["load"].values))
    load = float(dataset["load"].values[peak])
    reference = case.hertz(load) if load > 0.0 else None
    if reference is not None:
        console.print(_comparison(dataset, peak, reference, body))
    if case.output.figures and figures:
        from ..plotting import summary_figures

        written += summary_figures(simulation, states, directory, body=body, hertz=reference)
    if animate:
        from ..plotting import rolling_animation, save_animation

        shown = states[:: math.ceil(len(states) / MOST_FRAMES)]
        animation = rolling_animation(shown, body=body)
        written.append(save_animation(animation, directory / "rolling.gif"))
    if kept is not None:
        forget_case(directory)
    return written


def _summary(dataset: xr.Dataset, body: int) -> Table:
    """Table of all increments, in units that read well."""
    wanted = [
        *contact_columns(body),
        (f"travel_body{body}", "travel\n[µm]", 1e6, ".2f"),
        ("iterations", "itera-\ntions", 1.0, ".0f"),
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
    reference: hertz.PointContact | hertz.EllipticContact,
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
