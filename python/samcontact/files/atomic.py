# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that appear under their name only when they are complete."""

from __future__ import annotations

import errno
import fcntl
import os
import signal
import tempfile
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO

from .._util.memory import HDF5_FILE, require_address_space
from .._util.short_text import in_short
from .checksum import seal
from .ownership import is_regular, record_of, remove_leftovers, require_marked

ENDING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
"""Ctrl-C, what a batch system or a shutdown sends, and a terminal that is closed."""


@contextmanager
def replacing(path: str | os.PathLike[str], ending: str = "") -> Iterator[Path]:
    """Yield a new file beside `path` to write, which takes its place in the end.

    When something fails the new file is removed, and an old one stays as it is. Of a symbolic link
    the file behind it is replaced. In a folder under `recording` only files of this package
    are.

    Parameters
    ----------
    path : path
        The file; its folder must exist.
    ending : str, optional
        Of the name of the new file, for writers that choose a format by it.

    Raises
    ------
    OSError
        The folder is missing or cannot be written, or `path` is a folder, device or pipe.
    ValueError
        The folder is recorded, and `path` is a file of others.
    """
    record = record_of(Path(path).parent)
    if record is not None:
        record.require(Path(path))
    target = _checked(Path(path))
    remove_leftovers(target.parent, target.name)
    handle, temporary = _part(target, ending)
    try:
        yield temporary
        # mkstemp makes the file private; give it what a plain open() would
        mask = os.umask(0)
        os.umask(mask)
        temporary.chmod(0o666 & ~mask)
        with open(temporary, "rb") as written:
            os.fsync(written.fileno())
        if record is not None:
            record.require(target)
            record.add(temporary, target.name)
        os.replace(temporary, target)
    except BaseException as error:
        temporary.unlink(missing_ok=True)
        # a full disk is told without a name, others with that of the new file
        if isinstance(error, OSError) and error.errno and error.filename in (None, str(temporary)):
            raise _about(target, error) from error
        raise
    finally:
        os.close(handle)


def with_ending(path: str | os.PathLike[str], ending: str) -> Path:
    """The path with an ending, which is added where it is missing; ValueError without a name."""
    target = Path(path)
    if target.name in ("", ".."):
        raise ValueError(f"path must be the name of a file, got {in_short(str(path))}, a folder")
    return target if target.suffix == ending else target.with_name(target.name + ending)


def _checked(path: Path) -> Path:
    """The file that a path leads to, which may be missing; its folder must be there."""
    target = Path(os.path.realpath(path)) if path.is_symlink() else path
    if not target.parent.is_dir():
        raise FileNotFoundError(errno.ENOENT, "there is no folder for", str(path))
    if os.path.lexists(target) and not is_regular(target):
        kind = "folder" if target.is_dir() else "device or pipe"
        raise OSError(errno.EINVAL, f"a file must be written, but there is a {kind}", str(path))
    return target


def _part(target: Path, ending: str) -> tuple[int, Path]:
    """A new file beside the target, with the lock that tells it from those of killed processes."""
    prefix = f".{target.name}.samcontact-"
    while True:
        handle, name = tempfile.mkstemp(f".part{ending}", prefix, target.parent)
        with suppress(OSError):  # a file system without locks
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        if os.path.exists(name):  # nobody took it for a leftover before it had its lock
            return handle, Path(name)
        os.close(handle)


@contextmanager
def replacing_hdf5(path: str | os.PathLike[str]) -> Iterator[BinaryIO]:
    """The same for HDF5: a file object to write, which gets the digest of `checksum` in the end.

    Ctrl-C waits until the file is complete. Errors of the disk are OSErrors that name `path`; where
    HDF5 would have too little memory, a MemoryError comes before. An existing file that is none of
    this package is refused with a ValueError.
    """
    require_marked(_checked(Path(path)))
    require_address_space(f"writing {os.fspath(path)!r}", HDF5_FILE)
    with undisturbed(), replacing(path) as part:
        with open(part, "w+b", buffering=0) as opened:
            file = _Patient(opened)
            try:
                yield file  # type: ignore[misc]
            except Exception:
                if file.error is None:
                    raise
            if file.error is not None:
                raise file.error
        seal(part)


class _Patient:
    """A file that keeps its first error of writing to itself, and takes what comes later.

    HDF5 does not survive a disk that is full: its errors are of many kinds, come back when objects
    are freed, and the process may crash when it ends.
    """

    def __init__(self, file: BinaryIO) -> None:
        self.file = file
        self.error: OSError | None = None
        for name in ("read", "readinto", "seek", "tell"):
            setattr(self, name, getattr(file, name))

    def write(self, data: bytes) -> int:
        rest = memoryview(data).cast("B")
        length = len(rest)
        try:
            while self.error is None and rest:
                rest = rest[self.file.write(rest) :]
        except OSError as error:
            self.error = error
        return length

    def truncate(self, size: int | None = None) -> int:
        try:
            return self.file.truncate(size)
        except OSError as error:
            self.error = self.error or error
            return size or 0

    def flush(self) -> None:
        """Nothing is kept back."""


@contextmanager
def undisturbed() -> Iterator[None]:
    """Keep Ctrl-C and other wishes to end waiting: what is finished must not be lost meanwhile."""
    if threading.current_thread() is not threading.main_thread():
        yield  # signals go elsewhere
        return
    waiting: list[int] = []
    before = {number: signal.getsignal(number) for number in ENDING}
    # None: not set by Python
    held = [number for number, old in before.items() if old not in (None, signal.SIG_IGN)]
    for number in held:
        signal.signal(number, lambda number, _: waiting.append(number))
    try:
        yield
    finally:
        for number in held:
            signal.signal(number, before[number])
        if waiting:
            signal.raise_signal(waiting[0])


def _about(path: Path, error: OSError) -> OSError:
    """The same error with the name of the file that the user knows."""
    return OSError(error.errno, error.strerror or str(error), str(path))
