# SPDX-License-Identifier: GPL-3.0-or-later
"""Checkpoints after each increment of a run, from which a killed run is resumed."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .._util.checks import file_path
from ..bodies.layered import without_softening
from ..files.ownership import require_marked
from ..restart.file import (
    DamagedCheckpointError,
    read,
    readable,
    require_same,
)
from ..restart.identity import Identity, identity, require_identified
from ..restart.lock import locked
from .checkpoint import KIND, read_checkpoint, write_checkpoint
from .engine import Engine

if TYPE_CHECKING:
    from ..solutions.state import State


def describe(engine: Engine, **what: Any) -> Identity:
    """Return data that identify a run before it begins: the setup and `what`, e.g. the path.

    Softening laws are listed separately, so that an error message can name them.
    """
    arguments = engine.setup.on_domain(engine.first, engine.heat)
    for number in (1, 2):
        body = arguments[f"body{number}"]
        if body.softening is not None:
            arguments[f"body{number}"] = without_softening(body)
            arguments[f"softening law of body {number}"] = body.softening
    for name in ("eigenstrain1", "eigenstrain2"):
        if (given := getattr(engine.core.state, name)) is not None:
            what[name] = given
    if engine.preparation is not None:
        what["preparation"] = engine.preparation
    return identity(**arguments, **what)


@contextmanager
def journal_of(
    folder: str | os.PathLike[str] | None, engine: Engine, **what: Any
) -> Iterator[Journal | None]:
    """Context manager: lock a folder and provide the journal of the run; None without a folder."""
    if folder is None:
        yield None
        return
    with locked(file_path("checkpoint", folder)):
        yield Journal(folder, engine, describe(engine, **what))


class Journal:
    """Checkpoints of the increments of one run, in a folder used only for this run.

    A resumed run gives bit-identical results to an uninterrupted one.

    Parameters
    ----------
    folder : path
        Created if missing.
    engine : Engine
        Solver of the increments.
    run_identity : Identity
        Identity of the run, from `describe` before the first increment. Checkpoints of another run
        are rejected.

    Raises
    ------
    ValueError
        The folder contains other files, or checkpoints of another run or version; or the run cannot
        be identified, because a softening law has data that Python cannot read.
    """

    def __init__(
        self, folder: str | os.PathLike[str], engine: Engine, run_identity: Identity
    ) -> None:
        self.folder, self.engine = file_path("checkpoint", folder), engine
        require_identified(run_identity)
        self.run_identity = run_identity
        self.count = 0
        """Number of increments so far, both restored and newly solved."""
        self.folder.mkdir(parents=True, exist_ok=True)
        files = sorted(self.folder.glob("*.h5"))
        for file in files:
            require_marked(file, "move this file, or choose another folder")
        for file in files:  # the first intact one identifies the run
            with suppress(DamagedCheckpointError):
                require_same(self.folder, run_identity, read(file, KIND))
                break

    def next(self) -> State | None:
        """Restore the next increment and return its state; None if there is no checkpoint of it.

        A damaged checkpoint is ignored with a warning; the increment is then solved again.
        """
        if not (file := self._file(self.count + 1)).exists():
            return None
        try:
            self._restore(file)
        except DamagedCheckpointError as error:
            number = self.count + 1
            text = f"{error}; therefore, increment {number} is solved again"
            warnings.warn(text, stacklevel=3)
            return None
        self.count += 1
        return self.engine.state

    def _restore(self, file: Path) -> None:
        bodies = self.engine.setup.bodies
        kept, tree = read_checkpoint(file, [body.softening for body in bodies])
        require_same(self.folder, self.run_identity, tree)
        with readable(file):
            self.engine.restore(kept)

    def add(self, state: State | None = None) -> None:
        """Store a checkpoint after a new increment, of the current state or of `state`."""
        kept = self.engine.snapshot(state)
        write_checkpoint(self._file(self.count + 1), kept, run=self.run_identity)
        self.count += 1

    def add_all(self, states: Iterable[State]) -> None:
        """Store checkpoints of all previous increments, for a run that starts a journal later."""
        for state in states:
            self.add(state)

    def _file(self, number: int) -> Path:
        return self.folder / f"increment_{number:05d}.h5"
