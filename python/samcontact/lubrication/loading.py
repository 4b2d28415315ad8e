# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic-plastic bodies under a lubricant film that carries several loads in turn."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from .._util.checks import boolean, file_path, finite_array, require_type
from .._util.errors import attach
from .._util.frozen import read_only
from .._util.progress import progress_bar
from .._util.short_text import in_short
from .._util.tensors import von_mises
from ..lubricants.lubricant import Lubricant
from ..restart.identity import Identity
from ..restart.lock import locked
from ..simulation.journal import Journal, describe
from ..simulation.simulation import Simulation
from ..solutions.state import State
from .boundary import Boundary
from .checkpoint import Kept
from .film_plasticity import FilmPlasticity
from .film_solution import FilmSolution
from .steady import velocities_of
from .yielding import press

_FILMS = "films"  # folder within that of the states


def press_loads(
    simulation: Simulation,
    *,
    loads: Sequence[float],
    speed: Sequence[float | Sequence[float]],
    lubricant: Lubricant,
    boundary: Boundary | None = None,
    order: int = 3,
    shear_thinning: bool = False,
    thermal: bool = False,
    tol: float = 1e-4,
    max_iterations: int = 40,
    checkpoint: str | os.PathLike[str] | None = None,
    progress: bool = False,
) -> tuple[FilmSolution, ...]:
    """Advance a simulation through several loads, each carried by a steady film.

    Parameters
    ----------
    simulation : Simulation
        As for `press`, but the grid must have cells over depth (dz).
    loads : sequence of float
        Normal load of each increment [N], > 0.
    speed, lubricant, boundary, order, shear_thinning, thermal, tol, max_iterations
        As for `press`.
    checkpoint : path, optional
        Folder in which film and state of each increment are stored. Repeating the call resumes from
        this folder, with bit-identical results.
    progress : bool, optional
        Whether to show the progress.

    Returns
    -------
    tuple of FilmSolution
        Film under each load; its attribute `plasticity` contains stress and plastic strain of the
        bodies. The simulation is left in the state under the last load.

    Raises
    ------
    ValueError, TypeError
        As for `press`, or if loads is not a list of positive numbers, or if the grid has no dz.
    CheckpointError
        `checkpoint` contains files of another run.
    ConvergenceError
        As for `press`; the attribute `result` contains the films under the preceding loads.
    """
    require_type("simulation", simulation, Simulation)
    boolean("progress", progress)
    given = finite_array("loads", loads)
    if given.ndim != 1 or not given.size or given.min() <= 0.0:
        raise ValueError(f"loads must be a list of positive numbers [N], got {in_short(loads)}")
    if not simulation.grid.has_volume:
        raise ValueError(
            "the grid of simulation must have layers over depth, on which plastic strain is "
            "stored, got a grid without layers: give dz"
        )
    arguments: dict[str, Any] = {
        "speed": speed, "lubricant": lubricant, "boundary": boundary, "order": order,
        "shear_thinning": shear_thinning, "thermal": thermal, "tol": tol,
        "max_iterations": max_iterations,
    }  # fmt: skip
    films: list[FilmSolution] = []
    with (
        _kept_in(checkpoint, simulation, loads=given.tolist(), **arguments) as kept,
        progress_bar(given.size, "increment", shown=progress) as bar,
    ):
        for index, load in enumerate(given.tolist()):
            try:
                film = None if kept is None else kept.film(index)
                if film is None:
                    pressed = press(simulation, load=load, **arguments)
                    film = replace(pressed.film, plasticity=_plasticity(simulation, pressed.state))
                    if kept is not None:
                        kept.add(index, film)
            except Exception as error:
                if films:
                    attach(error, result=tuple(films))
                raise
            films.append(film)
            bar.update()
    return tuple(films)


def _plasticity(simulation: Simulation, state: State) -> FilmPlasticity:
    """Return stress and plastic strain of both bodies; 0 for a rigid body."""
    layers = state.grid.surface_shape, (*state.grid.surface_shape, state.depths.size)
    found = {
        name: np.zeros((2, *layers[name != "residual_displacement"]))
        for name in (
            "residual_displacement", "von_mises", "residual_von_mises",
            "equivalent_plastic_strain",
        )
    }  # fmt: skip
    for body, material in enumerate(state.setup.bodies, 1):
        if material.is_rigid:
            continue
        found["von_mises"][body - 1] = state.von_mises(body)
        if material.is_plastic:
            found["residual_displacement"][body - 1] = state.residual_displacement(body)
            found["residual_von_mises"][body - 1] = von_mises(state.residual_stress(body))
            found["equivalent_plastic_strain"][body - 1] = state.equivalent_plastic_strain(body)
    fixed = {name: read_only(values) for name, values in found.items()}
    return FilmPlasticity(initial_gap=simulation.initial_gap, z=state.depths, **fixed)


class _KeptLoads:
    """Stored films and states of one run, in a folder."""

    def __init__(
        self, folder: Path, simulation: Simulation, run: Identity, like: FilmSolution
    ) -> None:
        self._journal = Journal(folder, simulation.engine, run)
        self._films, self._like = Kept(folder / _FILMS, run), like

    def film(self, index: int) -> FilmSolution | None:
        """Restore the stored increment with this index; return its film, or None if not stored."""
        film = self._films.film(index, self._like)
        return None if film is None or self._journal.next() is None else film

    def add(self, index: int, film: FilmSolution) -> None:
        """Write the film of the increment with this index, and the state of the simulation."""
        self._films.folder.mkdir(exist_ok=True)
        self._films.add(index, film)
        self._journal.add()


@contextmanager
def _kept_in(
    folder: str | os.PathLike[str] | None, simulation: Simulation, **arguments: Any
) -> Iterator[_KeptLoads | None]:
    """Context manager: lock a folder and provide its increments, or None if `folder` is None."""
    if folder is None:
        yield None
        return
    none = np.zeros(simulation.grid.surface_shape)
    like = FilmSolution(
        grid=simulation.grid, lubricant=arguments["lubricant"],
        velocities=velocities_of(arguments["speed"]), gap=none, fluid_pressure=none,
        boundary_pressure=none, film=none, filling=none, approach=0.0, load=0.0, residual=0.0,
        levels=(), boundary=arguments["boundary"], order=arguments["order"],
        shear_thinning=arguments["shear_thinning"],
        bodies=(simulation.body1, simulation.body2),
    )  # fmt: skip
    place = file_path("checkpoint", folder)
    with locked(place):
        yield _KeptLoads(place, simulation, describe(simulation.engine, film=arguments), like)
