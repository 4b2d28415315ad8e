# SPDX-License-Identifier: GPL-3.0-or-later
"""Solution of film cases: steady or transient, at several speeds, or on elastic-plastic bodies."""

from __future__ import annotations

import os
import warnings
from typing import TYPE_CHECKING, Any

import numpy as np

from .._util.errors import ResolutionWarning, attach
from ..lubrication import FilmSolution, press_loads, steady, stribeck, transient
from ..lubrication.transient import standing_on
from ..simulation.simulation import Simulation
from .film_transient import moving_heights

if TYPE_CHECKING:
    from .film_description import FilmDescription
    from .film_transient import Vectors

Checkpoint = str | os.PathLike[str] | None
Films = tuple[FilmSolution, ...]
MAX_CELLS = 1.01
"""Largest travel of a relief per step without a warning, in cells."""


def solved(case: FilmDescription, progress: bool, checkpoint: Checkpoint) -> Films:
    """Return the films of a case; `result` of an error contains the films solved before it."""
    if case.film.speeds is not None:
        return _over_speeds(case, case.film.speeds)
    if case.yields:
        return _pressed(case, progress, checkpoint)
    if case.film.transient is not None:
        return _in_time(case, progress, checkpoint)
    return (_steady(case, case.standing_gap()),)


def amount(case: FilmDescription, count: int) -> str:
    """Return how many of the films have been solved, as text, e.g. "2 of 5 speeds"."""
    film = case.film
    if film.transient is not None:
        return f"{count - 1} of {film.transient.count(case.cells, case.velocities)} steps"
    if case.yields:
        return f"{count} of {film.increments} increments"
    return f"{count} of {len(film.speeds or [0.0])} speeds"


def _over_speeds(case: FilmDescription, speeds: list[float]) -> Films:
    film, grid = case.film, case.cells
    try:
        curve = stribeck(
            grid, *case.bodies, case.standing_gap(), load=case.load_on(grid), speeds=speeds,
            slide_to_roll=film.slide_to_roll, lubricant=case.build_lubricant(), **film.settings(),
        )  # fmt: skip
    except RuntimeError as error:
        if (done := getattr(error, "curve", None)) is not None:
            attach(error, result=done.solutions)
        raise
    return curve.solutions


def _steady(case: FilmDescription, gap: Any) -> FilmSolution:
    film, grid = case.film, case.cells
    load_factor, speed_factor = 1.0, 1.0
    if film.transient is not None:
        load_factor, speed_factor = film.transient.load_factor(0), film.transient.speed_factor(0)
    load = None if film.approach is not None else load_factor * case.load_on(grid)
    speed = _scaled(case.velocities, speed_factor)
    return steady(
        grid, *case.bodies, gap, load=load, approach=film.approach, speed=speed, spin=film.spin,
        lubricant=case.build_lubricant(), supply=film.supply, **film.settings(),
    )  # fmt: skip


def _scaled(velocities: Vectors, factor: float) -> list[list[float]]:
    """Return velocities times a factor [m/s]."""
    return [[factor * v for v in pair] for pair in velocities]


def _pressed(case: FilmDescription, progress: bool, checkpoint: Checkpoint) -> Films:
    film, grid, settings = case.film, case.cells, case.film.settings()
    del settings["tol"]  # the tolerance of the film follows from that of plastic flow
    simulation = Simulation(grid, *case.bodies, case.standing_gap(), on_border="warn")
    load = case.load_on(grid)
    parts = np.arange(1, film.increments + 1) / film.increments
    return press_loads(
        simulation, loads=(load * parts).tolist(), speed=case.velocities,
        lubricant=case.build_lubricant(), checkpoint=checkpoint, progress=progress, **settings,
    )  # fmt: skip


def _in_time(case: FilmDescription, progress: bool, checkpoint: Checkpoint) -> Films:
    film, grid, course = case.film, case.cells, case.film.transient
    assert course is not None
    smooth, velocities = case.gap(), case.velocities
    reliefs = {
        name: moving_heights(section, grid, case.shift, case.source.parent)
        for name in ("relief1", "relief2")
        if (section := getattr(case, name)) is not None
    }
    steps = course.count(grid, velocities)
    for name, pair in zip(("relief1", "relief2"), velocities, strict=True):
        travel = abs(pair[0]) * course.duration / (steps * grid.dx)
        if name in reliefs and travel > MAX_CELLS:
            warnings.warn(
                f"{name} should move by at most one cell per step, got {travel:.3g} cells: "
                "increase film.transient.steps",
                ResolutionWarning,
                stacklevel=3,
            )
    start = standing_on(_steady(case, case.standing_gap()), smooth)
    load, settings = case.load_on(grid), film.settings()
    try:
        history = transient(
            start, duration=course.duration, steps=steps,
            load=lambda time: load * course.load_factor(time),
            speed=lambda time: _scaled(velocities, course.speed_factor(time)),
            order=film.order, tol=film.tol, max_iterations=settings["max_iterations"],
            checkpoint=checkpoint, progress=progress, **reliefs,
        )  # fmt: skip
    except Exception as error:
        if (done := getattr(error, "history", None)) is not None:
            attach(error, result=(start, *done.solutions))
        raise
    return (start, *history.solutions)
