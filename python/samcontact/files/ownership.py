# SPDX-License-Identifier: GPL-3.0-or-later
"""Which files this package has written: no other file is replaced or removed without being named.

HDF5 files carry a mark in their content. Files of other formats that a command, or a function that
chooses their names, writes into a folder are listed there in a record, with their digests.
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

from .checksum import SEALED

RECORD = ".samcontact-files"
_HEAD = "files that samcontact has written here, with their SHA-256\n"
_MARK = b"samcontact"
HDF5 = (".h5", ".nc", ".before")
"""Endings of files that carry the mark."""
PART = re.compile(r"\.(.+)\.samcontact-\w{8}\.part(\.\w+)?")
"""Names of files that are being written, or were when their process was killed."""

_recording: ContextVar[Record | None] = ContextVar("recording", default=None)


def is_regular(file: Path) -> bool:
    """Whether it is a file itself: no link, folder, pipe or device."""
    try:
        return stat.S_ISREG(file.lstat().st_mode)
    except OSError:
        return False


def is_marked(file: Path) -> bool:
    """Whether an HDF5 file is one of this package, whole or damaged, or has no content to lose."""
    if not is_regular(file):
        return False
    with file.open("rb") as opened:
        size = os.fstat(opened.fileno()).st_size
        if size == 0:
            return True
        opened.seek(max(0, size - SEALED))
        if _MARK in opened.read():
            return True
        with mmap.mmap(opened.fileno(), 0, access=mmap.ACCESS_READ) as content:
            return content.find(_MARK) >= 0


def require_marked(file: Path, remedy: str = "move it away, or choose another name") -> None:
    """Raise ValueError for an existing file that is none of this package, before it is lost."""
    if os.path.lexists(file) and not is_marked(file):
        raise ValueError(f"{file} {_kind(file)}: {remedy}")


def _kind(file: Path) -> str:
    if file.is_symlink():
        return "is a symbolic link, which would be replaced"
    if not is_regular(file):
        return f"is a {'folder' if file.is_dir() else 'device or pipe'}, not a file"
    return "was not written by samcontact, or has been changed since"


class Record:
    """The list of files without a mark of their own in a folder.

    A line is added before its file appears, so that none is taken for a foreign one after a kill.
    """

    def __init__(self, folder: Path) -> None:
        self.folder, self.file = folder, folder / RECORD
        self._known: set[tuple[str, str]] = set()
        self._begun = False
        if os.path.lexists(self.file):
            self._read()

    def _read(self) -> None:
        regular = is_regular(self.file)
        text = self.file.read_text(encoding="utf-8", errors="replace") if regular else ""
        self._begun = text.startswith(_HEAD)
        if not regular or not (self._begun or _HEAD.startswith(text)):  # cut by a full disk
            raise ValueError(
                f"{self.file} {_kind(self.file)}: move it away, or choose another folder"
            )
        for line in text.splitlines()[1:]:
            with contextlib.suppress(ValueError, TypeError):  # cut by a full disk
                digest, name = json.loads(line)
                self._known.add((str(digest), str(name)))

    def owns(self, file: Path) -> bool:
        """Whether a file in the folder was written by this package, and not changed since."""
        if file.suffix in HDF5:
            return is_marked(file)
        named = any(name == file.name for _, name in self._known)
        return named and is_regular(file) and (_digest(file), file.name) in self._known

    def require(self, file: Path) -> None:
        """Raise ValueError for an existing file that must not be replaced."""
        if os.path.lexists(file) and not self.owns(file):
            raise ValueError(
                f"{file} {_kind(file)}: move it away, or choose another folder of results"
            )

    def add(self, part: Path, name: str) -> None:
        """List a complete file that is about to get its name."""
        entry = (_digest(part), name)
        if Path(name).suffix in HDF5 or entry in self._known:
            return
        with self.file.open("a" if self._begun else "w", encoding="utf-8") as listed:
            listed.write(("\n" if self._begun else _HEAD) + json.dumps(entry) + "\n")
            listed.flush()
            os.fsync(listed.fileno())
        self._begun = True
        self._known.add(entry)

    def clear(self, *but: Path, marked: re.Pattern[str]) -> None:
        """Remove all listed files that are unchanged, and those with a mark by their names."""
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
def recording(folder: Path) -> Iterator[Record]:
    """List the files that are written into a folder meanwhile; foreign ones are not replaced."""
    if (record := record_of(folder)) is not None:  # the same list, which changes
        yield record
        return
    record = Record(folder)
    before = _recording.set(record)
    try:
        yield record
    finally:
        _recording.reset(before)


def record_of(folder: Path) -> Record | None:
    """The record that files written into a folder now go to, if there is one."""
    record = _recording.get()
    return record if record is not None and record.folder.resolve() == folder.resolve() else None


def remove_leftovers(folder: Path, name: str | None = None) -> None:
    """Remove what killed processes have left half written: all, or of the file of a name.

    A living process holds a lock on the file that it is writing.
    """
    for entry in os.listdir(folder):
        found = PART.fullmatch(entry) if entry.startswith(".") else None
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
