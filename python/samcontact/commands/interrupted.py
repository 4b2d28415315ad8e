# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command keeps of a run that is interrupted, and finds again to go on."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .._atomic import replacing
from .._journal import Journal

if TYPE_CHECKING:
    from ..cases.base import CaseFile
    from ..simulation import Simulation
    from ..state import State

FOLDER = "checkpoints"
CASE = "case.txt"


def remember_case(directory: Path, case: CaseFile) -> Path:
    """Leave where the case came from, and its text, beside its checkpoints; their folder."""
    folder = directory / FOLDER
    folder.mkdir(parents=True, exist_ok=True)
    text = f"{case.source.resolve()}\n{case.text}"
    with replacing(folder / CASE) as part:
        part.write_text(text, encoding="utf-8")
    return folder


def forget_case(directory: Path) -> None:
    """Remove the checkpoints of a run whose results are safe."""
    shutil.rmtree(directory / FOLDER)


def is_interrupted(directory: Path) -> bool:
    """Whether there is what `interrupted_case` reads."""
    return (directory / FOLDER / CASE).exists()


def keep_states(
    folder: Path, simulation: Simulation, path: list[dict[str, Any]], states: Sequence[State]
) -> None:
    """Write the increments that a run had done, where a journal has not."""
    journal = Journal(folder, simulation, path)
    for state in states:
        journal.add(state)


def interrupted_case(directory: Path) -> Path:
    """The case file of the run that was interrupted in a directory.

    Raises ValueError when there is none, or when the case file is no longer what it was.
    """
    mark = directory / FOLDER / CASE
    if not is_interrupted(directory):
        raise ValueError(f"{directory} has no interrupted run: there is no {mark}")
    name, _, text = mark.read_text(encoding="utf-8").partition("\n")
    file = Path(name)
    if not file.exists() or file.read_text(encoding="utf-8") != text:
        raise ValueError(
            f"{file} is not the case file that was interrupted any more: run it anew, or restore it"
        )
    return file
