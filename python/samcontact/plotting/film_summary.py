# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of a run with a lubricated contact."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from matplotlib.figure import Figure

from .._util.display import quantity
from ..lubrication import FilmSolution
from ..problem.grid import Grid
from ..results.films import films_of
from .film_courses import film_imprint, film_over_time, film_stress_figure
from .films import (
    film_map,
    film_profile,
    film_temperature,
    interferogram,
    regime_chart,
    stribeck_lines,
)
from .parts import new_figure

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import FilmCase

_TALL = 4.6, 4.2


class FilmFigure(NamedTuple):
    """Figure of a run: file name without suffix, caption, description, and the figure itself."""

    name: str
    caption: str
    description: str
    figure: Figure


def film_figures(dataset: xr.Dataset, case: FilmCase | None = None) -> Iterator[FilmFigure]:
    """Iterate over the figures of a run with a lubricated contact.

    Maps and profiles show one film. For films over time, this is the film with the largest
    pressure; otherwise it is the film at the last speed or load. dataset: dataset from
    `results.films_dataset`. case: case of the run; without a case, the chart of lubrication regimes
    is omitted.
    """
    films = films_of(dataset)
    chosen, when = _shown(dataset)
    film = films[chosen]
    if min(film.film.shape) > 1:
        figure = new_figure(*_TALL)
        film_map(film, figure.subplots())
        text = f"Map of the film thickness; minimum {quantity(film.minimum_film, 'm', 3)}."
        yield FilmFigure("film_map", f"Film thickness, {when}", text, figure)
    figure = new_figure()
    film_profile(film, figure.subplots())
    text = "Pressure and film thickness along x, through the smallest undeformed gap."
    yield FilmFigure("film_profile", f"Pressure and film along x, {when}", text, figure)
    if min(film.film.shape) > 1:
        figure = new_figure(*_TALL)
        interferogram(film, figure.subplots())
        text = "Interference fringes of the film in red light."
        yield FilmFigure("interferogram", f"Interferogram, {when}", text, figure)
    if film.heat is not None:
        figure = new_figure()
        film_temperature(film, figure.subplots())
        text = "Temperature rise of film and surfaces along x, through the smallest undeformed gap."
        yield FilmFigure("film_temperature", f"Temperature along x, {when}", text, figure)
    if case is not None and (chart := _chart(case, film.load)) is not None:
        text = "Lubrication regimes by load number and lubricant number; a dot marks the contact."
        yield FilmFigure("regime_chart", f"Regime of lubrication, {when}", text, chart)
    yield from _courses(dataset, film)
    over_speed = len(films) > 1 and "time" not in dataset and "imprint" not in dataset
    if over_speed and "boundary_share" in dataset:
        figure = new_figure()
        share, mu = (dataset[name].values for name in ("boundary_share", "friction_coefficient"))
        stribeck_lines(dataset["speed"].values, share, mu, figure.subplots())
        text = "Share of the load on the boundary layer, and friction, versus the mean speed."
        yield FilmFigure("stribeck", "Stribeck curve", text, figure)


def _shown(dataset: xr.Dataset) -> tuple[int, str]:
    """Return the index of the film that maps and profiles show, and its speed, load or time."""
    if "time" in dataset and dataset.sizes["increment"] > 1:
        chosen = int(np.argmax(dataset["max_pressure"].values))
        return chosen, f"after {quantity(float(dataset['time'][chosen]), 's')}"
    if "imprint" in dataset:
        return -1, quantity(float(dataset["load"][-1]), "N")
    return -1, f"{float(dataset['speed'][-1]):.4g} m/s"


def _courses(dataset: xr.Dataset, film: FilmSolution) -> Iterator[FilmFigure]:
    """Iterate over figures that only some runs have: film over time, and plastic deformation."""
    if "time" in dataset and dataset.sizes["increment"] > 1:
        figure = new_figure()
        film_over_time(dataset, figure.subplots())
        text = "Central and minimum film thickness, and maximum pressure, over time."
        yield FilmFigure("film_over_time", "Film over time", text, figure)
    if "imprint" in dataset:
        figure = film_stress_figure(dataset, _with_layers(dataset, film))
        text = "Stress, plastic strain and residual stress of the body with more plastic strain."
        yield FilmFigure("film_stress", "Stress and plastic strain", text, figure)
        figure = new_figure()
        film_imprint(dataset, figure.subplots())
        text = "Sum of the residual displacements of both surfaces along x, positive outwards."
        yield FilmFigure("film_imprint", "Imprint under the film", text, figure)


def _with_layers(dataset: xr.Dataset, film: FilmSolution) -> Grid:
    """Return the grid of a film, with the layers (dz) of the volume fields in the dataset."""
    z = dataset["z"].values
    return replace(film.grid, nz=z.size, dz=2.0 * float(z[0]))


def _chart(case: FilmCase, load: float) -> Figure | None:
    """Return the chart of lubrication regimes at a load [N].

    Return None if the bodies form no elliptic Hertz contact, or if no film formula applies.
    """
    ellipse, (first, second) = case.ellipse(load), case.velocities
    if ellipse is None or case.estimate(load, case.velocities) is None:
        return None
    figure = new_figure()
    regime_chart(ellipse, (first[0], second[0]), case.build_lubricant(), figure.subplots())
    return figure
