# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs that survive being killed: a checkpoint after each increment, and going on from them."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .._util.checks import file_path
from ..bodies.material import Material
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
    """Identify a run that is about to begin: its scene, and what is done with it, e.g. its path.

    Softening laws are parts of their own, so that messages name them.
    """
    scene = engine.setup.on_domain(engine.first, engine.heat)
    for number in (1, 2):
        body = scene[f"body{number}"]
        if isinstance(body, Material) and body.softening is not None:
            scene[f"body{number}"] = replace(body, softening=None)
            scene[f"softening law of body {number}"] = body.softening
    for name in ("eigenstrain1", "eigenstrain2"):
        if (given := getattr(engine.core.state, name)) is not None:
            what[name] = given
    return identity(**scene, **what)


@contextmanager
def journal_of(
    folder: str | os.PathLike[str] | None, engine: Engine, **what: Any
) -> Iterator[Journal | None]:
    """The journal of a run, in a folder that is its own meanwhile; None without a folder."""
    if folder is None:
        yield None
        return
    with locked(file_path("checkpoint", folder)):
        yield Journal(folder, engine, describe(engine, **what))


class Journal:
    """Checkpoints of the increments of one run, in a folder of their own.

    Going on from them gives the same bits as a run that was not interrupted.

    Parameters
    ----------
    folder : path
        Made when it is missing.
    engine : Engine
        The solver of the increments.
    who : Identity
        From `describe`, before the first increment: it tells this run from others, whose
        checkpoints are refused.

    Raises
    ------
    ValueError
        The folder holds something else, or checkpoints of another run or version; or the run
        cannot be identified, because a law has state that Python cannot read.
    """

    def __init__(self, folder: str | os.PathLike[str], engine: Engine, who: Identity) -> None:
        self.folder, self.engine = file_path("checkpoint", folder), engine
        require_identified(who)
        self.who = who
        self.count = 0
        """Increments so far, restored or new."""
        self.folder.mkdir(parents=True, exist_ok=True)
        files = sorted(self.folder.glob("*.h5"))
        for file in files:
            require_marked(file, "move it away, or choose another folder")
        for file in files:  # the first one that is whole tells
            with suppress(DamagedCheckpointError):
                require_same(self.folder, who, read(file, KIND))
                break

    def next(self) -> State | None:
        """The state after the next increment, where it was kept; the simulation stands there.

        A damaged checkpoint is none, with a warning: its increment follows from the one before.
        """
        if not (file := self._file(self.count + 1)).exists():
            return None
        try:
            self._restore(file)
        except DamagedCheckpointError as error:
            number = self.count + 1
            text = f"{error}: going on from the one before, increment {number} is solved again"
            warnings.warn(text, stacklevel=3)
            return None
        self.count += 1
        return self.engine.state

    def _restore(self, file: Path) -> None:
        bodies = self.engine.setup.bodies
        kept, tree = read_checkpoint(file, [body.softening for body in bodies])
        require_same(self.folder, self.who, tree)
        with readable(file):
            self.engine.restore(kept)

    def add(self, state: State | None = None) -> None:
        """Keep the simulation after a new increment: as it stands, or an earlier state of it."""
        kept = self.engine.snapshot(state)
        write_checkpoint(self._file(self.count + 1), kept, run=self.who)
        self.count += 1

    def add_all(self, states: Iterable[State]) -> None:
        """The same of the increments so far of a run that had no journal."""
        for state in states:
            self.add(state)

    def _file(self, number: int) -> Path:
        return self.folder / f"increment_{number:05d}.h5"
