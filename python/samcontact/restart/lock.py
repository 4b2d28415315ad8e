# SPDX-License-Identifier: GPL-3.0-or-later
"""One run at a time in a folder, or with a file."""

from __future__ import annotations

import errno
import fcntl
import os
import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..files.ownership import is_regular, remove_leftovers

LOCK = ".samcontact.lock"
LOCKS = (LOCK, ".cycle.h5.lock")
"""Locks in folders of checkpoints: of the folder, and of the file of a computation of wear."""


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
        Another run has it; it cannot be made or written to; or the name of the lock belongs to
        something else.
    """
    try:
        directory.mkdir(parents=True, exist_ok=True)
    except (FileExistsError, NotADirectoryError):
        raise OSError(
            f"{directory} must be a directory, or free for one, but it or a part of it is a file: "
            f"{remedy}"
        ) from None
    except OSError as error:
        raise _unusable(directory, error, remedy) from error
    handle = _take(directory, remedy, name)
    try:
        remove_leftovers(directory)
        yield
    finally:
        (directory / name).unlink(missing_ok=True)
        os.close(handle)


def _take(directory: Path, remedy: str, name: str) -> int:
    """The opened lock file, with the number of this process in it."""
    path = directory / name
    while True:
        if os.path.lexists(path) and not is_regular(path):
            raise _of_others(path, remedy)
        try:
            handle = os.open(path, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW, 0o666)
        except OSError as error:
            raise _unusable(directory, error, remedy) from error
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
            if not re.fullmatch(rb"\d*\s*", os.read(handle, 20)):
                os.close(handle)
                raise _of_others(path, remedy)
            try:
                os.truncate(handle, 0)
                os.lseek(handle, 0, os.SEEK_SET)
                os.write(handle, f"{os.getpid()}\n".encode())
            except OSError as error:  # a full disk, a limit of file sizes
                path.unlink()
                os.close(handle)
                raise _unusable(directory, error, remedy) from error
            return handle
        os.close(handle)  # the one before has just removed it


def _is(path: Path, handle: int) -> bool:
    try:
        return os.path.samestat(os.stat(path), os.fstat(handle))
    except FileNotFoundError:
        return False


def _of_others(path: Path, remedy: str) -> OSError:
    return OSError(f"{path} is not a lock of samcontact: move it away, or {remedy}")


def _unusable(directory: Path, error: OSError, remedy: str) -> OSError:
    """The error of a folder in which nothing can be written."""
    readable = {errno.EACCES: "permission denied", errno.EROFS: "it is on a read-only disk"}
    reason = readable.get(error.errno or 0, error.strerror or "it cannot be used")
    return OSError(f"cannot write to the folder {directory}: {reason}: {remedy}")
