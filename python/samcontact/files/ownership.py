# SPDX-License-Identifier: GPL-3.0-or-later
"""Identification of files written by this package, so that no other files are replaced.

HDF5 files of this package contain a mark. Files of other formats contain none. If the package
chooses the name of such a file, the file is listed with its digest in a record in its folder. If
the user chooses the name, an existing file is replaced without a check.
"""

from __future__ import annotations

import contextlib
import fcntl
import hashlib
import json
import mmap
import os
import re
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path

from .checksum import SEAL_BYTES

RECORD_FILE = ".samcontact-files"
_HEAD = "files that samcontact has written here, with their SHA-256\n"
_MARK = b"samcontact"
SEALED_SUFFIXES = (".h5", ".nc", ".before")
"""Suffixes of the HDF5 files of this package, which contain its mark."""
PARTIAL_FILE_NAME = re.compile(r"\.(.+)\.samcontact-\w{8}\.part(\.\w+)?")
"""Pattern for the names of temporary files, which are in use or were left by a killed process."""

_recording: ContextVar[OwnershipRecord | None] = ContextVar("recording", default=None)


def is_regular(file: Path) -> bool:
    """Whether a path is a regular file, not a link, folder, pipe or device."""
    try:
        return stat.S_ISREG(file.lstat().st_mode)
    except OSError:
        return False


def is_marked(file: Path) -> bool:
    """Whether a file is empty, or is an HDF5 file (intact or damaged) that this package wrote."""
    if not is_regular(file):
        return False
    with file.open("rb") as opened:
        size = os.fstat(opened.fileno()).st_size
        if size == 0:
            return True
        opened.seek(max(0, size - SEAL_BYTES))
        if _MARK in opened.read():
            return True
        with mmap.mmap(opened.fileno(), 0, access=mmap.ACCESS_READ) as content:
            return content.find(_MARK) >= 0


def require_marked(file: Path, remedy: str = "move this file, or use another name") -> None:
    """Raise ValueError if the file exists and has no mark of this package."""
    if os.path.lexists(file) and not is_marked(file):
        raise ValueError(f"{file} {_kind(file)}: {remedy}")


def _kind(file: Path) -> str:
    if file.is_symlink():
        return "is a symbolic link, which would be replaced"
    if not is_regular(file):
        return f"is a {'folder' if file.is_dir() else 'device or pipe'}, not a file"
    return "was not written by samcontact, or has changed since"


class OwnershipRecord:
    """Record of the files that this package has written to a folder and that contain no mark.

    A file is recorded before it gets its final name, so that it is recognised even if the process
    is killed.
    """

    def __init__(self, folder: Path) -> None:
        self.folder, self.file = folder, folder / RECORD_FILE
        self._known: set[tuple[str, str]] = set()
        self._begun = False
        if os.path.lexists(self.file):
            self._read()

    def _read(self) -> None:
        regular = is_regular(self.file)
        text = self.file.read_text(encoding="utf-8", errors="replace") if regular else ""
        self._begun = text.startswith(_HEAD)
        if not regular or not (self._begun or _HEAD.startswith(text)):  # head cut by a full disk
            raise ValueError(
                f"{self.file} {_kind(self.file)}: move this file, or use another folder"
            )
        for line in text.splitlines()[1:]:
            with contextlib.suppress(ValueError, TypeError):  # entry cut by a full disk
                digest, name = json.loads(line)
                self._known.add((str(digest), str(name)))

    def owns(self, file: Path) -> bool:
        """Whether a file in the folder was written by this package and has not changed since."""
        if file.suffix in SEALED_SUFFIXES:
            return is_marked(file)
        named = any(name == file.name for _, name in self._known)
        return named and is_regular(file) and (_digest(file), file.name) in self._known

    def require(self, file: Path) -> None:
        """Raise ValueError if the file exists and this package did not write it."""
        if os.path.lexists(file) and not self.owns(file):
            raise ValueError(
                f"{file} {_kind(file)}: move this file, or use another folder for the results"
            )

    def add(self, part: Path, name: str) -> None:
        """Record a complete temporary file under its final name, before it is renamed."""
        entry = (_digest(part), name)
        if Path(name).suffix in SEALED_SUFFIXES or entry in self._known:
            return
        with self.file.open("a" if self._begun else "w", encoding="utf-8") as listed:
            listed.write(("\n" if self._begun else _HEAD) + json.dumps(entry) + "\n")
            listed.flush()
            os.fsync(listed.fileno())
        self._begun = True
        self._known.add(entry)

    def clear(self, *but: Path, marked: re.Pattern[str]) -> None:
        """Remove all recorded files, and HDF5 files of this package whose names match `marked`.

        Files in `but`, recorded files that have changed since, and files that this package did not
        write are kept. The record is removed too.
        """
        names = {name for _, name in self._known}
        for file in list(self.folder.iterdir()):
            listed = file.name in names or marked.fullmatch(file.name)
            if listed and file not in but and self.owns(file):
                file.unlink()
        self.file.unlink(missing_ok=True)
        self._known.clear()
        self._begun = False


def _digest(file: Path) -> str:
    with file.open("rb") as opened:
        digest = hashlib.sha256()
        while block := opened.read(1 << 20):
            digest.update(block)
    return digest.hexdigest()


@contextmanager
def recording(folder: Path) -> Iterator[OwnershipRecord]:
    """Context manager that records files written to a folder, and protects all other files.

    A file that this package did not write is not replaced; see `OwnershipRecord.require`.
    """
    if (record := record_of(folder)) is not None:  # one shared list per folder
        yield record
        return
    record = OwnershipRecord(folder)
    before = _recording.set(record)
    try:
        yield record
    finally:
        _recording.reset(before)


def record_of(folder: Path) -> OwnershipRecord | None:
    """Return the record of a folder if `recording` is active for it, otherwise None."""
    record = _recording.get()
    return record if record is not None and record.folder.resolve() == folder.resolve() else None


def remove_leftovers(folder: Path, name: str | None = None) -> None:
    """Remove the temporary files that killed processes have left in a folder.

    With `name`, only the temporary files of the file with this name are removed. Temporary files
    that another process is writing are locked, and are kept.
    """
    for entry in os.listdir(folder):
        found = PARTIAL_FILE_NAME.fullmatch(entry) if entry.startswith(".") else None
        if found and name in (None, found[1]):
            path = folder / entry
            with contextlib.suppress(OSError), _opened(path) as handle:
                fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
                if is_regular(path):
                    path.unlink()


@contextmanager
def _opened(path: Path) -> Iterator[int]:
    handle = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    try:
        yield handle
    finally:
        os.close(handle)
