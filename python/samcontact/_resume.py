# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs that survive being killed: a checkpoint after each increment, and going on from them."""

from __future__ import annotations

import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from tqdm.auto import tqdm

from ._heating import pair
from .checkpoint import read_checkpoint

if TYPE_CHECKING:
    from .cases import Case
    from .simulation import Simulation
    from .state import State

FOLDER = "checkpoints"


def run_with_checkpoints(
    simulation: Simulation, path: list[dict[str, Any]], case: Case, directory: Path, progress: bool
) -> list[State]:
    """All states of a path, the first ones from the checkpoints that an earlier call has left.

    Checkpoints are in a folder of `directory`; `remove_checkpoints` removes it. Going on gives the
    same bits as a run that was not interrupted. Raises ValueError for checkpoints of another case.
    """
    folder = directory / FOLDER
    folder.mkdir(parents=True, exist_ok=True)
    _claim(folder, case)
    states: list[State] = []
    for number in range(1, len(path) + 1):
        if not (file := _file(folder, number)).exists():
            break
        states.append(_restored(simulation, file))
    with tqdm(total=len(path), initial=len(states), disable=not progress, unit="increment") as bar:
        for number in range(len(states) + 1, len(path) + 1):
            states.append(simulation.step(**path[number - 1]))
            simulation.save(_file(folder, number))
            bar.update()
    return states


def remove_checkpoints(directory: Path) -> None:
    """Remove the folder of checkpoints, when the results are safe."""
    shutil.rmtree(directory / FOLDER)


def _file(folder: Path, number: int) -> Path:
    return folder / f"increment_{number:05d}.h5"


def _foreign(folder: Path) -> ValueError:
    return ValueError(
        f"{folder} holds checkpoints of another case: remove it, or choose another --output"
    )


def _claim(folder: Path, case: Case) -> None:
    """Leave the text of the case beside its checkpoints, or compare it with what is there."""
    mark = folder / "case.toml"
    if mark.exists():
        if mark.read_text(encoding="utf-8") != case.text:
            raise _foreign(folder)
    elif any(folder.iterdir()):
        raise _foreign(folder)
    else:
        part = folder.parent / f".{folder.name}.part"
        part.write_text(case.text, encoding="utf-8")
        part.replace(mark)


def _restored(simulation: Simulation, file: Path) -> State:
    arguments, saved = read_checkpoint(file, (None, None))
    if not _same_surfaces(simulation, arguments):  # the case may read them from other files
        raise _foreign(file.parent)
    try:
        simulation._core.restore(saved)
    except (ValueError, TypeError) as error:
        raise ValueError(f"{file} is damaged: {error}") from error
    simulation.heat_factor = pair(arguments["heat_factor"])
    return simulation.state


def _same_surfaces(simulation: Simulation, arguments: Mapping[str, Any]) -> bool:
    if not np.array_equal(arguments["gap"], simulation.initial_gap):
        return False
    for name in ("relief1", "relief2"):
        old, new = arguments.get(name), getattr(simulation, name)
        if old is None or new is None:
            if old is not new:
                return False
        elif not np.array_equal(old.heights, new.heights):
            return False
    return True
