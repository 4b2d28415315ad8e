# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command keeps of a run that does not reach its end, and finds again to go on."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING

import click

from .._atomic import replacing, undisturbed
from ..runs.file import ForeignCheckpointError
from ..runs.lock import locked

if TYPE_CHECKING:
    from ..cases.base import CaseFile

FOLDER = "checkpoints"
OLD = "checkpoints.old"
DONE = ".checkpoints.done"
CASE = "case.txt"
KEY = "key.txt"
MANY = 20
"""Increments whose checkpoints may take long to write, during which Ctrl-C does nothing."""


class Checkpoints:
    """Those of a run, in the folder of its results.

    Parameters
    ----------
    directory : Path
    case : CaseFile
    """

    def __init__(self, directory: Path, case: CaseFile) -> None:
        from ..sweeps.worker import case_key

        self.directory, self.case = directory, case
        self.folder = directory / FOLDER
        self.key = case_key(case, {})

    def claim(self, resume: bool) -> bool:
        """Whether to go on from checkpoints that are there; those of another run are set aside.

        With `resume` they are not: whether they fit is for those who read them to say.
        """
        if (self.directory / DONE).exists():
            shutil.rmtree(self.directory / DONE)
        if not self.folder.exists() or resume:
            return resume
        if _text(self.folder / KEY) == self.key:
            told = f"going on from the checkpoints of an interrupted run: {self.folder}"
        else:
            shutil.rmtree(self.directory / OLD, ignore_errors=True)
            self.folder.rename(self.directory / OLD)
            told = f"checkpoints of another run, set aside: {self.directory / OLD}"
        click.echo(told, err=True)
        return self.folder.exists()

    def remember(self) -> Path:
        """Leave where the case came from, and its text, beside the checkpoints; their folder."""
        self.folder.mkdir(parents=True, exist_ok=True)
        texts = {CASE: f"{self.case.source.resolve()}\n{self.case.text}", KEY: self.key}
        for name, text in texts.items():
            with replacing(self.folder / name) as part:
                part.write_text(text, encoding="utf-8")
        return self.folder

    @contextmanager
    def used(self) -> Iterator[Path]:
        """Their folder, to which each increment goes as it is done.

        It belongs to this case from here on, unless what is there turns out to be of another run.
        """
        before = {name: _text(self.folder / name) for name in (CASE, KEY)}
        folder = self.remember()
        try:
            yield folder
        except Exception as error:
            if not any(folder.rglob("*.h5")):  # nothing to go on from
                shutil.rmtree(folder)
            elif isinstance(error, ForeignCheckpointError):
                self._give_back(before)
            raise

    def _give_back(self, before: dict[str, str | None]) -> None:
        """The marks of the run that the checkpoints belong to."""
        for name, text in before.items():
            if text is None:
                (self.folder / name).unlink(missing_ok=True)
            else:
                (self.folder / name).write_text(text, encoding="utf-8")

    def keep(self, write: Callable[[Path], None], increments: int) -> None:
        """Have the increments written that a run without a journal has done, if there is room."""
        if increments > MANY:
            click.echo(f"writing checkpoints of {increments} increments", err=True)
        try:
            with undisturbed():
                write(self.remember())
        except OSError as error:
            click.echo(f"not all increments could be kept to go on from: {error}", err=True)

    def forget(self) -> None:
        """Remove them, since the results are safe: all at once, whatever happens meanwhile."""
        with undisturbed(), suppress(OSError):
            for name in (FOLDER, OLD):
                if (self.directory / name).exists():
                    (self.directory / name).rename(self.directory / DONE)
                    shutil.rmtree(self.directory / DONE)


@contextmanager
def checkpoints_of(directory: Path, case: CaseFile) -> Iterator[Checkpoints]:
    """The folder of a run, locked; its checkpoints are forgotten when the run reaches its end."""
    with locked(directory, "give another --output"):
        checkpoints = Checkpoints(directory, case)
        yield checkpoints
        checkpoints.forget()


def is_interrupted(directory: Path) -> bool:
    """Whether there is what `interrupted_case` reads."""
    return (directory / FOLDER / CASE).is_file()


def interrupted_case(directory: Path) -> Path:
    """The case file of the run that was interrupted in a directory.

    Raises ValueError when there is none, or when the case file is no longer what it was.
    """
    from ..cases import load_case

    mark = directory / FOLDER / CASE
    if not is_interrupted(directory):
        raise ValueError(f"{directory} has no interrupted run: there is no {mark}")
    name, _, text = (_text(mark) or "").partition("\n")
    if not name or "\ufffd" in name:
        raise ValueError(
            f"{mark} is damaged and does not name its case file: go on with\n"
            f"  samcontact run CASE.toml --output {directory} --resume"
        )
    file = Path(name)
    if not file.exists() or load_case(file).text != text:
        raise ValueError(
            f"{file} is not the case file that was interrupted any more: run it anew, or restore it"
        )
    return file


def _text(file: Path) -> str | None:
    return file.read_text(encoding="utf-8", errors="replace") if file.exists() else None
