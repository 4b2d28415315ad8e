# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs that survive being killed: a checkpoint after each increment, and going on from them."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from ._atomic import replacing
from ._checks import file_path
from ._copies import Standing, laws, resume, snapshot
from .checkpoint import (
    DAMAGED,
    DamagedCheckpointError,
    ForeignCheckpointError,
    damaged,
    read_checkpoint,
    write_checkpoint,
)

if TYPE_CHECKING:
    from .state import State


class Resumed(Standing, Protocol):
    """A simulation, as far as a journal knows it."""

    @property
    def state(self) -> State: ...


def describe(simulation: object, what: object) -> str:
    """A run that is about to begin; the repr of `what`, e.g. its path, is part of it."""
    return f"{simulation!r}\n{what!r}\n"


class Journal:
    """Checkpoints of the increments of one run, in a folder of their own.

    Going on from them gives the same bits as a run that was not interrupted.

    Parameters
    ----------
    folder : path
        Made when it is missing.
    simulation : Simulation
        That makes the increments.
    description : str
        From `describe`, before the first increment: it tells this run from others, whose
        checkpoints are refused.

    Raises
    ------
    ValueError
        The folder holds something else, or checkpoints of another run.
    """

    def __init__(
        self, folder: str | os.PathLike[str], simulation: Resumed, description: str
    ) -> None:
        self.folder, self.simulation = file_path("checkpoint", folder), simulation
        self.count = 0
        """Increments so far, restored or new."""
        self.folder.mkdir(parents=True, exist_ok=True)
        self._claim(description)

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
        return self.simulation.state

    def _restore(self, file: Path) -> None:
        kept = read_checkpoint(file, laws(self.simulation))
        if not _same_surfaces(snapshot(self.simulation).arguments, kept[0]):
            raise self._foreign()  # they may come from other files
        try:
            resume(self.simulation, kept)
        except DAMAGED as error:
            raise damaged(file, error) from error

    def add(self, state: State | None = None) -> None:
        """Keep the simulation after a new increment: as it stands, or an earlier state of it."""
        write_checkpoint(self._file(self.count + 1), snapshot(self.simulation, state))
        self.count += 1

    def _file(self, number: int) -> Path:
        return self.folder / f"increment_{number:05d}.h5"

    def _foreign(self) -> ForeignCheckpointError:
        return ForeignCheckpointError(
            f"{self.folder} holds checkpoints of another run: remove it, or choose another folder"
        )

    def _claim(self, description: str) -> None:
        """Leave the description beside the checkpoints, or compare it with what is there."""
        mark = self.folder / "run.txt"
        if mark.exists():
            if mark.read_bytes() != description.encode():
                raise self._foreign()
        elif any(self.folder.glob("*.h5")):
            raise self._foreign()
        else:
            with replacing(mark) as part:
                part.write_text(description, encoding="utf-8")


def _same_surfaces(now: Mapping[str, Any], before: Mapping[str, Any]) -> bool:
    if not np.array_equal(before["gap"], now["gap"]):
        return False
    for name in ("relief1", "relief2"):
        old, new = before.get(name), now[name]
        if old is None or new is None:
            if old is not new:
                return False
        elif not np.array_equal(old.heights, new.heights):
            return False
    return True
