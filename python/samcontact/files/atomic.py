# SPDX-License-Identifier: GPL-3.0-or-later
"""Atomic writing: files appear under their name only when they are complete."""

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

from .._util.memory import HDF5_FILE_BYTES, require_address_space
from .._util.short_text import in_short
from .checksum import seal
from .ownership import is_regular, record_of, remove_leftovers, require_marked

TERMINATION_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
"""Signals that are sent by Ctrl-C, by batch systems or at shutdown, and by a closed terminal."""


@contextmanager
def replacing(path: str | os.PathLike[str], ending: str = "") -> Iterator[Path]:
    """Context manager that provides a temporary file, which finally replaces the file at `path`.

    The temporary file is in the folder of `path`. After an error, the temporary file is removed and
    an existing file at `path` is kept. If `path` is a symbolic link, the target of the link is
    replaced. While `recording` is active for this folder, only files that this package wrote are
    replaced.

    Parameters
    ----------
    path : str or path
        File to write, in an existing folder.
    ending : str, optional
        Suffix of the temporary file, for writers that choose the format by the suffix.

    Raises
    ------
    OSError
        The folder is missing or cannot be written, or `path` is a folder, device or pipe.
    ValueError
        `recording` is active for the folder, and this package did not write the existing file.
    """
    record = record_of(Path(path).parent)
    if record is not None:
        record.require(Path(path))
    target = _checked(Path(path))
    remove_leftovers(target.parent, target.name)
    handle, temporary = _part(target, ending)
    try:
        yield temporary
        # mkstemp creates a private file: set the permissions of a plain open()
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
        # in errors that name no file, or the temporary file, give the name of the target
        if isinstance(error, OSError) and error.errno and error.filename in (None, str(temporary)):
            raise _about(target, error) from error
        raise
    finally:
        os.close(handle)


def with_ending(path: str | os.PathLike[str], ending: str) -> Path:
    """Return a path with a suffix such as ".vtr", which is added if missing.

    Raises ValueError if the path has no file name.
    """
    target = Path(path)
    if target.name in ("", ".."):
        raise ValueError(f"path must be the name of a file, got {in_short(str(path))}, a folder")
    return target if target.suffix == ending else target.with_name(target.name + ending)


def _checked(path: Path) -> Path:
    """Return the file to replace: `path`, or the target if `path` is a symbolic link.

    Raises OSError if the folder is missing, or if `path` is a folder, device or pipe.
    """
    target = Path(os.path.realpath(path)) if path.is_symlink() else path
    if not target.parent.is_dir():
        raise FileNotFoundError(errno.ENOENT, "the folder does not exist", str(path))
    if os.path.lexists(target) and not is_regular(target):
        kind = "folder" if target.is_dir() else "device or pipe"
        raise OSError(errno.EINVAL, f"must be a file, but is a {kind}", str(path))
    return target


def _part(target: Path, ending: str) -> tuple[int, Path]:
    """Create a temporary file next to the target; return its open handle and its path.

    The file is locked, which shows other processes that it is being written.
    """
    prefix = f".{target.name}.samcontact-"
    while True:
        handle, name = tempfile.mkstemp(f".part{ending}", prefix, target.parent)
        with suppress(OSError):  # some file systems have no locks
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        if os.path.exists(name):  # False if removed as a leftover before it was locked
            return handle, Path(name)
        os.close(handle)


@contextmanager
def replacing_hdf5(path: str | os.PathLike[str]) -> Iterator[BinaryIO]:
    """Context manager that provides a file object for HDF5; the file finally replaces `path`.

    At the end, a digest is appended to the file. Ctrl-C is delayed until the file is complete. Disk
    errors are raised as OSError with the name `path`. A MemoryError is raised in advance if HDF5
    would run out of memory. A ValueError is raised for an existing file that this package did not
    write.
    """
    require_marked(_checked(Path(path)))
    require_address_space(f"writing {os.fspath(path)!r}", HDF5_FILE_BYTES)
    with undisturbed(), replacing(path) as part:
        with open(part, "w+b", buffering=0) as opened:
            file = _ErrorHoldingFile(opened)
            try:
                yield file  # type: ignore[misc]
            except Exception:
                if file.error is None:
                    raise
            if file.error is not None:
                raise file.error
        seal(part)


class _ErrorHoldingFile:
    """File that stores its first write error and ignores later writes.

    HDF5 cannot handle a full disk: it raises many kinds of errors, raises them again when objects
    are freed, and may crash the process at exit.
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
        """Do nothing, because the file is not buffered."""


@contextmanager
def undisturbed() -> Iterator[None]:
    """Context manager that delays Ctrl-C and other termination signals until its end."""
    if threading.current_thread() is not threading.main_thread():
        yield  # signals are handled by the main thread
        return
    waiting: list[int] = []
    before = {number: signal.getsignal(number) for number in TERMINATION_SIGNALS}
    # None: handler not set by Python
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
    """Return a copy of an OSError that names `path`, the file that the user has specified."""
    return OSError(error.errno, error.strerror or str(error), str(path))
