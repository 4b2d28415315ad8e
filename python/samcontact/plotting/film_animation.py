# SPDX-License-Identifier: GPL-3.0-or-later
"""Animation of a lubricated contact in time: map of the film, pressure and film along x."""

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
    """Animate a lubricated contact in time: map of the film, and pressure and film along x.

    There is no map for a line contact. All frames have equal scales.

    Parameters
    ----------
    films : sequence of FilmSolution
        Films in the order of time, from `lubrication.transient`; ``films[::2]`` halves the
        computing time.
    interval : float, optional
        Interval between frames during playback [ms], > 0.

    Returns
    -------
    matplotlib.animation.FuncAnimation
        Animation for `save_animation`, or ``to_jshtml()`` in a notebook. Assign it to a variable.

    Raises
    ------
    ValueError, TypeError
        There are no films, or other objects; the interval is not positive.
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
