# SPDX-License-Identifier: GPL-3.0-or-later
"""Removal of checkpoints from a folder, in which files of other programs are kept."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

from ..files.ownership import PARTIAL_FILE_NAME, SEALED_SUFFIXES, is_marked, is_regular
from .lock import LOCK_FILES

CASE_FILE = "case.txt"
"""Name of the file in a checkpoint folder that identifies the case."""
CASE_MARK = "samcontact run "
"""First words of the file `CASE_FILE`."""


def foreign(folder: Path) -> Path | None:
    """Return a file of another program in a folder of checkpoints, or None if there is none.

    If `folder` is not a folder, it is returned itself.
    """
    if not os.path.lexists(folder):
        return None
    if folder.is_symlink() or not folder.is_dir():
        return folder
    return next((file for file in _files(folder) if not _is_own(file)), None)


def remove_checkpoints(folder: Path) -> None:
    """Remove a folder of checkpoints; files of other programs, and their folders, are kept."""
    if folder.is_symlink() or not folder.is_dir():
        return
    for file in _files(folder):
        if _is_own(file):
            file.unlink(missing_ok=True)
    for path, _, _ in os.walk(folder, topdown=False):
        with suppress(OSError):  # not empty
            os.rmdir(path)


def _files(folder: Path) -> Iterator[Path]:
    """Iterate over all files and links below a folder, at any depth; links are not followed."""
    for path, folders, files in os.walk(folder):
        yield from (Path(path, name) for name in sorted(files))
        yield from (Path(path, name) for name in folders if Path(path, name).is_symlink())


def _is_own(file: Path) -> bool:
    if not is_regular(file):
        return False
    if file.name == CASE_FILE:
        with file.open("rb") as opened:
            return opened.read(len(CASE_MARK)) == CASE_MARK.encode()
    if file.name in LOCK_FILES or PARTIAL_FILE_NAME.fullmatch(file.name):
        return True
    return file.suffix in SEALED_SUFFIXES and is_marked(file)
