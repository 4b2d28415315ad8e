# SPDX-License-Identifier: GPL-3.0-or-later
"""Animation of a lubricated contact in time: map of the film thickness, and profiles along x."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from matplotlib.animation import FuncAnimation

from .._util.checks import positive, require_type
from .._util.display import quantity
from ..lubrication import FilmSolution
from .films import MAX_SHOWN_FILM, film_map, film_profile
from .parts import new_figure


def film_animation(films: Sequence[FilmSolution], *, interval: float = 100.0) -> FuncAnimation:
    """Animate a lubricated contact in time: map of the film thickness, and profiles along x.

    The profiles show pressure and film thickness.

    There is no map for a line contact. The scales are the same in all frames.

    Parameters
    ----------
    films : sequence of FilmSolution
        Films in the order of time, from `lubrication.transient`. To halve the computing time, pass
        ``films[::2]``.
    interval : float, optional
        Interval between frames during playback [ms], > 0.

    Returns
    -------
    matplotlib.animation.FuncAnimation
        Animation for `save_animation`, or ``to_jshtml()`` in a notebook. Assign it to a variable:
        Matplotlib deletes animations that no variable refers to.

    Raises
    ------
    ValueError
        `films` is empty, or `interval` is not positive.
    TypeError
        `films` contains an object that is not a film.
    """
    if len(films) == 0:
        raise ValueError("films must contain at least one film, got none")
    for film in films:
        require_type("films", film, FilmSolution)
    positive("interval", interval)
    has_map = min(films[0].film.shape) > 1
    thickest = MAX_SHOWN_FILM * max(film.central_film for film in films)
    highest = max(float(film.pressure.max()) for film in films)
    figure = new_figure(9.0, 3.9) if has_map else new_figure()

    def draw(number: int) -> list[Any]:
        film = films[number]
        figure.clear()
        panels = figure.subplots(1, 2) if has_map else [figure.subplots()]
        film_profile(film, panels[-1], max_film=thickest, max_pressure=highest)
        if has_map:
            film_map(film, panels[0], max_film=thickest)
            panels[-1].set_title("")
        figure.suptitle(f"time {quantity(film.time, 's', 3)}", fontsize="medium")
        return list(panels)

    draw(0)
    return FuncAnimation(
        figure, draw, frames=len(films), interval=interval, cache_frame_data=False, blit=False
    )
