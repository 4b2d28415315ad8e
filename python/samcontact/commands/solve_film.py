# SPDX-License-Identifier: GPL-3.0-or-later
"""Solution of a case of a lubricated contact: table, results and figures."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from rich.console import Console

from .._util.film_quantities import FILMS
from ..plotting.film_summary import film_figures
from ..results.file import scalars
from ..results.films import films_dataset
from .solve_study import StudyKind, solve_kind
from .tables import Sheet, values_sheet

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import FilmCase

_COLUMNS = (
    "speed", "max_pressure", "central_film", "minimum_film", "lambda_ratio", "boundary_share",
    "friction_coefficient",
)  # fmt: skip


def solve_film(
    case: FilmCase, directory: Path, console: Console, *, figures: bool, resume: bool
) -> list[Path]:
    """Solve a lubricated contact, write film.nc, film.csv and figures, and return the files."""
    _ = case.gap()  # errors of the case are raised before its folder is written
    kind = StudyKind(
        "film",
        lambda _: case.solve(),
        lambda films: films_dataset(films, case),
        lambda films: f"{len(films)} of {len(case.film.speeds or [0.0])} speeds",
        _sheet,
        scalars,
        lambda _, dataset: {one.name: one.figure for one in film_figures(dataset, case)},
    )
    return solve_kind(case, kind, directory, console, figures=figures, resume=resume)


def _sheet(dataset: xr.Dataset) -> Sheet:
    columns = [(FILMS[name], dataset[name].values, None) for name in _COLUMNS if name in dataset]
    return values_sheet("Films", dataset["increment"].values, columns)
