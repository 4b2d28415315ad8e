# SPDX-License-Identifier: GPL-3.0-or-later
"""State of a wear computation between two cycles, in memory and in a checkpoint file (HDF5)."""

from __future__ import annotations

import dataclasses
import os
import shutil
import warnings
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

import numpy as np

from .._util.checks import file_path
from ..bodies.layered import backstresses_of
from ..files.atomic import replacing
from ..files.checksum import check_seal
from ..files.ownership import require_marked
from ..restart.file import READ_ERRORS, DamagedCheckpointError, damaged, require_same
from ..restart.file import read as read_file
from ..restart.file import write as write_file
from ..restart.identity import Identity, identity, require_identified
from ..restart.lock import locked
from ..restart.tree import Tree, array
from .problem import BodyStrain, WearProblem, WearProgress
from .results import AnyCycle

_KIND = "wear"
_HISTORIES = ("heat", "creep")
"""Histories of `WearProgress` that are stored if they are not empty."""


def _identity(problem: WearProblem) -> Identity:
    return identity(**problem.arguments)


def alone(path: str | os.PathLike[str]) -> AbstractContextManager[None]:
    """Context manager that keeps other runs from writing to a checkpoint file."""
    file = file_path("checkpoint", path)
    return locked(file.parent, "choose another checkpoint", f".{file.name}.lock")


def _before(path: str | os.PathLike[str]) -> Path:
    """Path of the checkpoint of the preceding cycle."""
    return Path(f"{os.fspath(path)}.before")


def require_own(path: str | os.PathLike[str] | None) -> None:
    """Raise ValueError if a checkpoint would replace a file that samcontact did not write."""
    if path is not None:
        for file in (file_path("checkpoint", path), _before(path)):
            require_marked(file)


def write(path: str | os.PathLike[str], problem: WearProblem, standing: WearProgress) -> None:
    """Write a checkpoint file.

    An undamaged old file is copied to `_before(path)`. If writing fails, the old file remains.
    """
    if _is_whole(path):
        with replacing(_before(path)) as part:
            shutil.copyfile(path, part)
    records = {
        item.name: np.array([getattr(one, item.name) for one in standing.cycles])
        for item in dataclasses.fields(problem.record)
    }
    tree: Tree = {f"heights{body}": np.stack(rows) for body, rows in standing.heights.items()}
    tree["cells"] = np.array(standing.grid.surface_shape)
    tree |= {f"strain{body}": vars(kept) for body, kept in standing.strains.items()}
    tree |= {name: part for name in _HISTORIES if (part := getattr(standing, name))}
    write_file(path, _KIND, {"run": _identity(problem), **tree, "cycles": records})


def _is_whole(path: str | os.PathLike[str]) -> bool:
    try:
        return Path(path).exists() and check_seal(path)
    except ValueError:
        return False


def latest(path: str | os.PathLike[str], problem: WearProblem) -> WearProgress | None:
    """Read a checkpoint file; if it is damaged, warn and read the file of the preceding cycle."""
    require_identified(_identity(problem))
    try:
        return read(path, problem)
    except DamagedCheckpointError as error:
        if not _before(path).exists():
            raise DamagedCheckpointError(
                f"{error}: delete the file {os.fspath(path)} to start again"
            ) from error
        warnings.warn(
            f"{error}: the run continues from the checkpoint of the preceding cycle", stacklevel=3
        )
        return read(_before(path), problem)


def read(path: str | os.PathLike[str], problem: WearProblem) -> WearProgress | None:
    """Return the state read from a checkpoint file, or None if there is no file.

    Raises CheckpointError if the file is damaged, is not a checkpoint of a wear computation, or was
    written by a run with different arguments.
    """
    if not Path(path).exists():
        return None
    tree = read_file(path, _KIND)
    require_same(path, _identity(problem), tree)
    try:
        return _standing(tree, problem)
    except READ_ERRORS as error:
        raise damaged(path, error) from error


def _standing(tree: Tree, problem: WearProblem) -> WearProgress:
    cycles = _cycles(tree["cycles"], problem)
    nx, ny = tree["cells"].tolist()
    problem = problem.over(dataclasses.replace(problem.grid, nx=nx, ny=ny))
    standing = WearProgress(
        problem.grid, {}, {}, cycles, **{n: tree.get(n, {}) for n in _HISTORIES}
    )
    for body in problem.worn:
        _, rows = problem.rows(body)
        shape = (len(cycles) + 1, rows, problem.grid.ny)
        standing.heights[body] = list(array(tree, f"heights{body}", shape))
    for body in (1, 2):
        if f"strain{body}" in tree:
            part, back = tree[f"strain{body}"], None
            ny, layers = problem.grid.ny, problem.grid.nz or None
            equivalent = array(part, "equivalent", (None, ny, layers))
            strain = array(part, "strain", (6, *equivalent.shape))
            if "backstress" in part:
                terms = backstresses_of(problem.bodies[body - 1])
                back = array(part, "backstress", (terms, *strain.shape))
            standing.strains[body] = BodyStrain(int(part["first"]), strain, equivalent, back)
    return standing


def _cycles(records: Tree, problem: WearProblem) -> list[AnyCycle]:
    count, worn = len(records["number"]), len(problem.worn)
    for item in dataclasses.fields(problem.record):
        per_body = item.name in problem.record.PER_BODY
        shape: tuple[int, ...] = (count, worn) if per_body else (count,)
        if np.shape(records[item.name]) != shape:
            raise ValueError(f"{item.name} must be an array of finite numbers of shape {shape}")
    if list(records["number"]) != list(range(1, count + 1)):
        raise ValueError("the cycles must be numbered consecutively")
    return [problem.record(**{k: _plain(v[n]) for k, v in records.items()}) for n in range(count)]


def _plain(value: Any) -> Any:
    return tuple(value.tolist()) if isinstance(value, np.ndarray) else value.item()
