# SPDX-License-Identifier: GPL-3.0-or-later
"""Checkpoints of friction versus velocity: a file for each solved velocity."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import numpy as np

from .._util.checks import file_path
from .._util.frozen import read_only
from ..files.ownership import require_marked
from ..problem.grid import Grid
from ..restart.file import DamagedCheckpointError, read, readable, require_same, write
from ..restart.identity import Identity, identity, require_identified
from ..restart.lock import locked
from ..restart.tree import array
from ..solutions.moving_solution import SlidingSolution

_KIND = "sliding"


class Kept:
    """Solutions of one run that are stored in a folder.

    Parameters
    ----------
    folder : Path
    run : Identity
        Identity of the run. Files that were written by another run raise CheckpointError.
    grid : Grid
        Grid of the run.
    """

    def __init__(self, folder: Path, run: Identity, grid: Grid) -> None:
        require_identified(run)
        self.folder, self.run, self.grid = folder, run, grid

    def _file(self, index: int) -> Path:
        return self.folder / f"velocity{index + 1:05d}.h5"

    def add(self, index: int, solution: SlidingSolution) -> None:
        """Write the solution at the velocity with this index."""
        values = {item.name: getattr(solution, item.name) for item in fields(solution)}
        del values["grid"]
        cells = np.array(solution.grid.surface_shape)
        write(self._file(index), _KIND, {"run": self.run, "cells": cells, **values})

    def solution(self, index: int) -> SlidingSolution | None:
        """Solution at the velocity with this index; None if it has not been written.

        A damaged file is ignored with a warning. Raises CheckpointError if the file was written by
        another run.
        """
        file = self._file(index)
        require_marked(file)
        if not file.exists():
            return None
        try:
            return self._read(file)
        except DamagedCheckpointError as error:
            warnings.warn(f"{error}: this velocity is solved again", stacklevel=4)
            return None

    def _read(self, file: Path) -> SlidingSolution:
        tree = read(file, _KIND)
        require_same(file, self.run, tree)
        with readable(file):
            nx, ny = np.asarray(tree.pop("cells")).tolist()
            grid = replace(self.grid, nx=nx, ny=ny)
            found: dict[str, Any] = {}
            for item in fields(SlidingSolution):
                if item.name != "grid":
                    found[item.name] = tree[item.name]
            for name in ("pressure", "repulsion", "gap"):
                may_end = name == "gap"
                found[name] = read_only(array(tree, name, (nx, ny), may_end=may_end))
            for name in ("tilt", "moment", "tangential_load"):
                found[name] = read_only(array(tree, name, (2,)))
            return SlidingSolution(grid=grid, **found)


@contextmanager
def kept_in(
    folder: str | os.PathLike[str] | None, grid: Grid, **arguments: Any
) -> Iterator[Kept | None]:
    """Context manager that locks a folder and provides its solutions; None without a folder."""
    if folder is None:
        yield None
        return
    place = file_path("checkpoint", folder)
    with locked(place):
        yield Kept(place, identity(grid=grid, **arguments), grid)
