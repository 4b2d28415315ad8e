# SPDX-License-Identifier: GPL-3.0-or-later
"""Storage of the results of several solutions, and of the increments of the latest solutions."""

from __future__ import annotations

import os
import warnings
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from .._util.checks import file_path
from .._util.version import version
from ..files.ownership import require_marked
from ..restart.checkpoint_files import remove_checkpoints
from ..restart.file import DamagedCheckpointError, read, require_same, write
from ..restart.identity import Identity, identity, require_identified
from ..restart.lock import locked
from ..restart.tree import Tree
from ..simulation.journal import Journal, describe
from ..simulation.run import run_into
from ..solutions.state import on_common_grid

if TYPE_CHECKING:
    from ..simulation.simulation import Simulation
    from ..solutions.state import State

_KIND = "solve"


class _Solve(NamedTuple):
    """Simulation with its identity, and the states of the increments solved so far."""

    simulation: Simulation
    run_identity: Identity
    states: list[State]


class Solves:
    """Results of all solutions of one task, by name, and the increments that are still needed.

    Parameters
    ----------
    run_identity : Identity
        Identity of the task; files of another task are refused.
    """

    def __init__(self, run_identity: Identity) -> None:
        self.run_identity = run_identity | identity(version=version)
        self.given: dict[str, Tree] = {}
        """Results of each solution, as passed to `add`."""
        self._folder: Path | None = None
        self._solves: dict[str, _Solve] = {}

    @contextmanager
    def kept_in(self, folder: str | os.PathLike[str] | None) -> Iterator[None]:
        """Use a folder to read stored results and to write new results; None: store nothing."""
        if folder is None:
            yield
            return
        require_identified(self.run_identity)
        self._folder = file_path("checkpoint", folder)
        with locked(self._folder):
            for file in sorted(self._folder.glob("*.h5")):
                require_marked(file, "move this file, or use another folder")
                self._take(file)
            yield

    def _take(self, file: Path) -> None:
        try:
            tree = read(file, _KIND)
        except DamagedCheckpointError as error:
            warnings.warn(
                f"{error}: this checkpoint is not used, and the case is solved again", stacklevel=4
            )
            return
        require_same(file.parent, self.run_identity, tree)
        self.given[file.stem] = tree["given"]

    def run(
        self,
        name: str,
        simulation: Simulation,
        path: Sequence[Mapping[str, Any]],
        *,
        progress: bool = False,
    ) -> list[State]:
        """Solve those increments of a path that are not stored; return all states on one grid."""
        solve = self._solves[name] = _Solve(simulation, describe(simulation.engine, path=path), [])
        folder = None if self._folder is None else self._folder / name
        engine, monitor, step = simulation.engine, simulation.monitor, simulation.step
        run_into(solve.states, engine, monitor, step, path, progress, folder, leave=False)
        return on_common_grid(solve.states)

    def file(self, name: str, file: str) -> Path | None:
        """Return the path of a checkpoint file of the solution `name`, or None without a folder."""
        if self._folder is None:
            return None
        folder = self._folder / name
        folder.mkdir(exist_ok=True)
        return folder / file

    def add(self, name: str, given: Tree) -> None:
        """Store the results (numbers, texts, arrays) of the solution `name`."""
        self.given[name] = given
        if self._folder is not None:
            self._write(self._folder, name)

    def forget_increments(self, but: Collection[str]) -> None:
        """Remove the stored increments of all solutions except those named in `but`."""
        for name in {*self.given, *self._solves}.difference(but):
            self._solves.pop(name, None)
            if self._folder is not None:
                remove_checkpoints(self._folder / name)

    @property
    def increments(self) -> int:
        """Number of increments to store."""
        return sum(len(solve.states) for solve in self._solves.values())

    def keep(self, folder: Path) -> None:
        """Write all results and increments to a folder, from which the task can be continued."""
        folder.mkdir(parents=True, exist_ok=True)
        for name in self.given:
            self._write(folder, name)
        for name, solve in self._solves.items():
            Journal(folder / name, solve.simulation.engine, solve.run_identity).add_all(
                solve.states
            )

    def _write(self, folder: Path, name: str) -> None:
        write(folder / f"{name}.h5", _KIND, {"run": self.run_identity, "given": self.given[name]})
