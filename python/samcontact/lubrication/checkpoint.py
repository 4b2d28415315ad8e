# SPDX-License-Identifier: GPL-3.0-or-later
"""Checkpoints of lubricated contacts: one file for each time step, or for each load."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import numpy as np

from .._util.checks import FloatArray, file_path
from .._util.frozen import read_only
from ..files.ownership import require_marked
from ..restart.file import DamagedCheckpointError, read, readable, require_same, write
from ..restart.identity import Identity, require_identified
from ..restart.lock import locked
from ..restart.tree import Tree, array
from .film_heat import FilmHeat
from .film_plasticity import FilmPlasticity
from .film_solution import FilmLevel, FilmPast, FilmSolution

_KIND = "film"
_FIELDS = "gap", "fluid_pressure", "boundary_pressure", "film", "filling"
_HEAT_SHAPES: dict[str, tuple[int, ...]] = {
    "surface_rise": (2,), "flux": (2,), "depth": (), "middle_rise": (),
}  # fmt: skip
_NUMBERS = "approach", "load", "residual"


class Kept:
    """Stored films of one run, in a folder.

    Parameters
    ----------
    folder : Path
    run : Identity
        Identity of the run. Files that were written by another run raise CheckpointError.
    """

    def __init__(self, folder: Path, run: Identity) -> None:
        require_identified(run)
        self.folder, self.run = folder, run

    def _file(self, index: int) -> Path:
        return self.folder / f"film_{index + 1:05d}.h5"

    def add(self, index: int, film: FilmSolution) -> None:
        """Write the film of the step with this index."""
        tree: Tree = {name: np.asarray(getattr(film, name)) for name in _FIELDS}
        tree |= {name: getattr(film, name) for name in _NUMBERS}
        tree["velocities"] = np.asarray(film.velocities)
        tree["levels"] = np.array([[*one.cells, *one[1:]] for one in film.levels], dtype=float)
        if film.past is not None:
            tree["past"] = {n: _plain(getattr(film.past, n)) for n in _names(FilmPast)}
        if film.heat is not None:
            tree["heat"] = {name: getattr(film.heat, name) for name in _HEAT_SHAPES}
        if film.plasticity is not None:
            tree["plasticity"] = {
                name: getattr(film.plasticity, name) for name in _names(FilmPlasticity)
            }
        write(self._file(index), _KIND, {"run": self.run, **tree})

    def film(self, index: int, like: FilmSolution) -> FilmSolution | None:
        """Film of the step with this index; None if it has not been written.

        like: any film of the same run; the data that are common to all films of the run are taken
        from it. A damaged file is ignored with a warning. Raises CheckpointError if the file was
        written by another run.
        """
        file = self._file(index)
        require_marked(file)
        if not file.exists():
            return None
        try:
            tree = read(file, _KIND)
            require_same(file, self.run, tree)
            with readable(file):
                return _film(tree, like)
        except DamagedCheckpointError as error:
            warnings.warn(f"{error}: this film is solved again", stacklevel=4)
            return None


def _film(tree: Tree, like: FilmSolution) -> FilmSolution:
    cells = like.grid.surface_shape
    found: dict[str, Any] = {name: read_only(array(tree, name, cells)) for name in _FIELDS}
    found |= {name: float(tree[name]) for name in _NUMBERS}
    levels = [
        FilmLevel((int(nx), int(ny)), int(newton), int(krylov), *others)
        for nx, ny, newton, krylov, *others in array(tree, "levels", (None, 7)).tolist()
    ]
    return replace(
        like, velocities=read_only(array(tree, "velocities", (2, 2))), levels=tuple(levels),
        past=_past(tree, cells), heat=_heat(tree, like), plasticity=_plasticity(tree, cells),
        **found,
    )  # fmt: skip


def _heat(tree: Tree, like: FilmSolution) -> FilmHeat | None:
    if "heat" not in tree:
        return None
    constants, cells = like.lubricant.heat, like.grid.surface_shape
    assert constants is not None
    found = {
        name: read_only(array(tree["heat"], name, (*first, *cells)))
        for name, first in _HEAT_SHAPES.items()
    }
    return FilmHeat(constants=constants, cell_area=like.grid.cell_area, **found)


def _past(tree: Tree, cells: tuple[int, int]) -> FilmPast | None:
    if "past" not in tree:
        return None
    given = tree["past"]
    content, gap = (read_only(array(given, name, cells)) for name in ("content", "gap"))
    ways = read_only(array(given, "ways", (2, 2)))
    return FilmPast(float(given["time"]), ways, content, gap, float(given["peak"]))


def _plasticity(tree: Tree, cells: tuple[int, int]) -> FilmPlasticity | None:
    if "plasticity" not in tree:
        return None
    given, volume = tree["plasticity"], (2, *cells, None)
    shapes: dict[str, tuple[int | None, ...]] = {
        "initial_gap": cells, "residual_displacement": (2, *cells), "z": (None,),
    }  # fmt: skip
    made = {
        name: read_only(array(given, name, shapes.get(name, volume)))
        for name in _names(FilmPlasticity)
    }
    return FilmPlasticity(**made)


def _names(kind: type[Any]) -> list[str]:
    return [item.name for item in fields(kind)]


def _plain(value: FloatArray | float) -> Any:
    return np.asarray(value) if isinstance(value, np.ndarray) else value


@contextmanager
def kept_in(folder: str | os.PathLike[str] | None, run: Identity) -> Iterator[Kept | None]:
    """Context manager: lock a folder and provide its stored films, or None if `folder` is None."""
    if folder is None:
        yield None
        return
    place = file_path("checkpoint", folder)
    with locked(place):
        yield Kept(place, run)
