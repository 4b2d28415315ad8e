# SPDX-License-Identifier: GPL-3.0-or-later
"""One run at a time in a folder, or with a file."""

from __future__ import annotations

import fcntl
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

LOCK = ".samcontact.lock"


@contextmanager
def locked(
    directory: Path, remedy: str = "choose another folder", name: str = LOCK
) -> Iterator[None]:
    """Make the folder, and keep other runs out of it; a process that dies leaves no lock.

    Parameters
    ----------
    directory : Path
    remedy : str, optional
        What to do where another run has it, for the error.
    name : str, optional
        Of the file that is locked in it; one of a single file keeps others from that.

    Raises
    ------
    OSError
        Another run has it; or it cannot be made or written to.
    """
    try:
        directory.mkdir(parents=True, exist_ok=True)
    except (FileExistsError, NotADirectoryError):
        raise OSError(
            f"{directory} must be a directory, or free for one, but it or a part of it is a file: "
            f"{remedy}"
        ) from None
    handle = _take(directory, remedy, name)
    try:
        yield
    finally:
        (directory / name).unlink(missing_ok=True)
        os.close(handle)


def _take(directory: Path, remedy: str, name: str) -> int:
    """The opened lock file, with the number of this process in it."""
    path = directory / name
    while True:
        handle = os.open(path, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW, 0o666)
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            pid = os.read(handle, 20).decode("ascii", "replace").strip()
            os.close(handle)
            who = f", process {pid}" if pid else ""
            raise OSError(
                f"another run of samcontact writes to {directory}{who}: wait for its end, or "
                f"{remedy}"
            ) from None
        except OSError:  # a file system without locks
            return handle
        if _is(path, handle):
            os.truncate(handle, 0)
            os.write(handle, f"{os.getpid()}\n".encode())
            return handle
        os.close(handle)  # the one before has just removed it


def _is(path: Path, handle: int) -> bool:
    try:
        return os.path.samestat(os.stat(path), os.fstat(handle))
    except FileNotFoundError:
        return False
