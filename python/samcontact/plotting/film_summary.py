# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of a run with a lubricated contact."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from matplotlib.figure import Figure

from .._util.display import quantity
from ..results.films import films_of
from .films import film_map, film_profile, interferogram, regime_chart, stribeck_lines
from .parts import new_figure

if TYPE_CHECKING:
    import xarray as xr

    from ..cases import FilmCase

_TALL = 4.6, 4.2


class FilmFigure(NamedTuple):
    """Figure of a run, with the name of its file, its caption and its description."""

    name: str
    caption: str
    description: str
    figure: Figure


def film_figures(dataset: xr.Dataset, case: FilmCase | None = None) -> Iterator[FilmFigure]:
    """Iterate over the figures of a run; maps and profile are those at the highest speed.

    dataset: from `results.films_dataset`. case: case of the run, for the chart of regimes.
    """
    films = films_of(dataset)
    film = films[-1]
    when = f"{float(dataset['speed'][-1]):.4g} m/s"
    if min(film.film.shape) > 1:
        figure = new_figure(*_TALL)
        film_map(film, figure.subplots())
        text = f"Map of the film; minimum {quantity(film.minimum_film, 'm', 3)}."
        yield FilmFigure("film_map", f"Film thickness, {when}", text, figure)
    figure = new_figure()
    film_profile(film, figure.subplots())
    text = "Pressure and film along x through the smallest undeformed gap."
    yield FilmFigure("film_profile", f"Pressure and film along x, {when}", text, figure)
    if min(film.film.shape) > 1:
        figure = new_figure(*_TALL)
        interferogram(film, figure.subplots())
        text = "Interference fringes of the film in red light."
        yield FilmFigure("interferogram", f"Interferogram, {when}", text, figure)
    if case is not None and (chart := _chart(case, film.load)) is not None:
        text = "Regimes of lubrication over load and lubricant, with the place of the contact."
        yield FilmFigure("regime_chart", f"Regime of lubrication, {when}", text, chart)
    if len(films) > 1 and "boundary_share" in dataset:
        figure = new_figure()
        share, mu = (dataset[name].values for name in ("boundary_share", "friction_coefficient"))
        stribeck_lines(dataset["speed"].values, share, mu, figure.subplots())
        text = "Share of the load on the boundary layer, and friction, over the mean speed."
        yield FilmFigure("stribeck", "Stribeck curve", text, figure)


def _chart(case: FilmCase, load: float) -> Figure | None:
    """Return the chart of regimes; None without an elliptic Hertz contact and a formula."""
    ellipse, (first, second) = case.ellipse(load), case.velocities
    if ellipse is None or case.estimate(load, case.velocities) is None:
        return None
    figure = new_figure()
    regime_chart(ellipse, (first[0], second[0]), case.build_lubricant(), figure.subplots())
    return figure
