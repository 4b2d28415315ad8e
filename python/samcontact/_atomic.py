# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that appear under their name only when they are complete."""

from __future__ import annotations

import errno
import os
import signal
import tempfile
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

from ._memory import HDF5_FILE, require_address_space
from ._seal import seal

ENDING = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
"""Ctrl-C, what a batch system or a shutdown sends, and a terminal that is closed."""


@contextmanager
def replacing(path: str | os.PathLike[str]) -> Iterator[Path]:
    """A new file beside `path` to write, which takes its place in the end.

    When something fails the new file is removed, and an old one stays as it is.
    """
    target = Path(path)
    if not target.parent.is_dir():
        raise FileNotFoundError(errno.ENOENT, "there is no folder for", str(target))
    handle, name = tempfile.mkstemp(prefix=f".{target.name}.", suffix=".part", dir=target.parent)
    os.close(handle)
    temporary = Path(name)
    try:
        yield temporary
        # mkstemp makes the file private; give it what a plain open() would
        mask = os.umask(0)
        os.umask(mask)
        temporary.chmod(0o666 & ~mask)
        with open(temporary, "rb") as written:
            os.fsync(written.fileno())
        os.replace(temporary, target)
    except BaseException as error:
        temporary.unlink(missing_ok=True)
        # a full disk is told without a name, others with that of the new file
        if isinstance(error, OSError) and error.errno and error.filename in (None, name):
            raise _about(target, error) from error
        raise


@contextmanager
def replacing_hdf5(path: str | os.PathLike[str]) -> Iterator[BinaryIO]:
    """The same for HDF5: a file object to write, which gets the digest of `_seal` in the end.

    Ctrl-C waits until the file is complete. Errors of the disk are OSErrors that name `path`; where
    HDF5 would have too little memory, a MemoryError comes before.
    """
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
