# SPDX-License-Identifier: GPL-3.0-or-later
"""Checkpoints of an interrupted run: written by `run`, read by `resume`."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import click

from ..files.atomic import replacing, undisturbed
from ..files.ownership import OwnershipRecord, recording
from ..restart.checkpoint_files import CASE_FILE, CASE_MARK, foreign, remove_checkpoints
from ..restart.file import ForeignCheckpointError
from ..restart.lock import locked

if TYPE_CHECKING:
    from ..cases.base import CaseFile

CHECKPOINT_FOLDER = "checkpoints"
FOREIGN_FOLDER = "checkpoints.old"
FINISHED_MARK = ".checkpoints.done"
REMEDY = "use another --output"
MAX_INTERRUPT_DELAY = 20
"""Number of increments above which a message announces that checkpoints are written, because
Ctrl-C has no effect during this time."""


class Checkpoints:
    """Checkpoints of a run, stored in a subfolder of the results folder.

    Parameters
    ----------
    directory : Path
        Folder of the results.
    case : CaseFile
        Case that is solved.
    """

    def __init__(self, directory: Path, case: CaseFile) -> None:
        from ..sweeps.worker import case_key

        self.directory, self.case = directory, case
        self.folder = directory / CHECKPOINT_FOLDER
        self.key = case_key(case, {})

    def claim(self, resume: bool) -> bool:
        """Return whether the run uses existing checkpoints and writes one after each increment.

        The result is True with `resume`, or if the folder contains checkpoints of the same case.
        Without `resume`, checkpoints of another case are moved to `FOREIGN_FOLDER`. With `resume`,
        checkpoints of another case are kept, and reading them fails later.
        """
        remove_checkpoints(self.directory / FINISHED_MARK)
        if not self.folder.exists() or resume:
            return resume
        if _read(self.folder / CASE_FILE).key == self.key:
            text = f"continuing from the checkpoints of an interrupted run: {self.folder}"
        else:
            remove_checkpoints(self.directory / FOREIGN_FOLDER)
            self.folder.rename(self.directory / FOREIGN_FOLDER)
            text = f"checkpoints of a different run were moved to {self.directory / FOREIGN_FOLDER}"
        click.echo(text, err=True)
        return self.folder.exists()

    def remember(self) -> Path:
        """Store path and text of the case file in the checkpoint folder; return the folder."""
        self.folder.mkdir(parents=True, exist_ok=True)
        self._write(f"{CASE_MARK}{self.key}\n{self.case.source.resolve()}\n{self.case.text}")
        return self.folder

    def _write(self, text: str) -> None:
        with replacing(self.folder / CASE_FILE) as part:
            part.write_text(text, encoding="utf-8")

    @contextmanager
    def used(self) -> Iterator[Path]:
        """Context manager that provides the checkpoint folder to a run, and marks it with the case.

        The mark is the file `CASE_FILE`. If the run fails because the checkpoints in the folder
        belong to another run, the previous mark is restored. If the run fails before it has written
        a checkpoint, the folder is removed.
        """
        before = _text(self.folder / CASE_FILE)
        folder = self.remember()
        try:
            yield folder
        except Exception as error:
            if not any(folder.rglob("*.h5")):  # nothing to continue from
                remove_checkpoints(folder)
            elif isinstance(error, ForeignCheckpointError):  # checkpoints of another run
                if before is None:
                    (folder / CASE_FILE).unlink(missing_ok=True)
                else:
                    self._write(before)
            raise

    def keep(self, write: Callable[[Path], None], increments: int) -> None:
        """Write checkpoints of all solved increments of a run that was stopped.

        write: function that writes them to a folder. increments: number of solved increments. An
        OSError, e.g. due to a full disk, is printed as a message and not raised.
        """
        if increments > MAX_INTERRUPT_DELAY:
            click.echo(f"writing checkpoints of {increments} increments", err=True)
        try:
            with undisturbed():
                write(self.remember())
        except OSError as error:
            click.echo(f"could not write all checkpoints: {error}", err=True)

    def forget(self) -> None:
        """Remove the checkpoints of a complete run; termination signals are delayed meanwhile."""
        with undisturbed(), suppress(OSError):
            for name in (CHECKPOINT_FOLDER, FOREIGN_FOLDER):
                if (self.directory / name).exists():
                    (self.directory / name).rename(self.directory / FINISHED_MARK)
                    remove_checkpoints(self.directory / FINISHED_MARK)


@contextmanager
def checkpoints_of(
    directory: Path, case: CaseFile, written: re.Pattern[str]
) -> Iterator[Checkpoints]:
    """Context manager that locks the folder of a run, and finally removes its checkpoints.

    After an error, the checkpoints are kept.

    Parameters
    ----------
    directory : Path
        Folder of the results.
    case : CaseFile
        Case that is solved.
    written : re.Pattern
        Pattern for the names of the files that the run may write.

    Raises
    ------
    ValueError
        The run would replace a file in the folder that this package did not write.
    """
    with locked(directory, REMEDY), recording(directory) as record:
        for name in (CHECKPOINT_FOLDER, FOREIGN_FOLDER, FINISHED_MARK):
            if (found := foreign(directory / name)) is not None:
                raise ValueError(
                    f"{found} was not written by samcontact, but the run stores checkpoints in "
                    f"{directory / name} and removes them at its end: move the file, or {REMEDY}"
                )
        for file in sorted(directory.iterdir()):
            if written.fullmatch(file.name):
                _require_own(file, record, case)
        checkpoints = Checkpoints(directory, case)
        yield checkpoints
        checkpoints.forget()


def _require_own(file: Path, record: OwnershipRecord, case: CaseFile) -> None:
    if file.exists() and case.source.exists() and file.samefile(case.source):
        raise ValueError(
            f"the case file {case.source} has the name of a file that the run may write: rename "
            f"it, or {REMEDY}"
        )
    record.require(file)


def is_interrupted(directory: Path) -> bool:
    """Whether a results folder contains the checkpoints of an interrupted run."""
    return (directory / CHECKPOINT_FOLDER / CASE_FILE).is_file()


def interrupted_case(directory: Path) -> Path:
    """Return the path of the case file of the interrupted run in a results folder.

    Raises ValueError if there is no interrupted run, or if the case file has changed.
    """
    from ..cases import load_case

    mark = directory / CHECKPOINT_FOLDER / CASE_FILE
    if not is_interrupted(directory):
        raise ValueError(f"no interrupted run found in {directory} (missing {mark})")
    _, name, text = _read(mark)
    if not name or "\ufffd" in name:
        raise ValueError(
            f"{mark} is damaged and does not contain the path of the case file: resume with\n"
            f"  samcontact run CASE.toml --output {directory} --resume"
        )
    file = Path(name)
    if not file.exists() or load_case(file).text != text:
        raise ValueError(
            f"{file} has changed since the interruption: start a new run, or restore the file"
        )
    return file


class _CheckpointMark(NamedTuple):
    """Content of the file `CASE_FILE` in a checkpoint folder: hash, path and text of the case."""

    key: str
    source: str
    text: str


def _read(mark: Path) -> _CheckpointMark:
    first, _, rest = (_text(mark) or "").partition("\n")
    if not first.startswith(CASE_MARK):
        return _CheckpointMark("", "", "")
    source, _, text = rest.partition("\n")
    return _CheckpointMark(first.removeprefix(CASE_MARK), source, text)


def _text(file: Path) -> str | None:
    return file.read_text(encoding="utf-8", errors="replace") if file.exists() else None
