# SPDX-License-Identifier: GPL-3.0-or-later
"""Locks, by which only one run at a time can write to a folder or file."""

from __future__ import annotations

import errno
import fcntl
import os
import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..files.ownership import is_regular, remove_leftovers

LOCK_FILE = ".samcontact.lock"
LOCK_FILES = (LOCK_FILE, ".cycle.h5.lock")
"""Names of the lock files in a checkpoint folder: lock of the folder, lock of a wear checkpoint."""


@contextmanager
def locked(
    directory: Path, remedy: str = "use another folder", name: str = LOCK_FILE
) -> Iterator[None]:
    """Context manager that creates a folder and locks it against other runs.

    The lock ends with the process, even if the process is killed.

    Parameters
    ----------
    directory : Path
        Folder to create and lock.
    remedy : str, optional
        Remedy that the error message suggests if the folder cannot be used.
    name : str, optional
        Name of the lock file. The default name locks the folder; another name can be used to lock
        a single file in the folder.

    Raises
    ------
    OSError
        Another run holds the lock, the folder cannot be created or written, or a file of another
        program has the name of the lock file.
    """
    try:
        directory.mkdir(parents=True, exist_ok=True)
    except (FileExistsError, NotADirectoryError):
        raise OSError(
            f"{directory} must be a folder or must not exist, but the path or part of it is a "
            f"file: {remedy}"
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
    """Lock the lock file, write the process id to it, and return the open file handle."""
    path = directory / name
    while True:
        if os.path.lexists(path) and not is_regular(path):
            raise _foreign_lock(path, remedy)
        try:
            handle = os.open(path, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW, 0o666)
        except OSError as error:
            raise _unusable(directory, error, remedy) from error
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            pid = os.read(handle, 20).decode("ascii", "replace").strip()
            os.close(handle)
            holder = f", process {pid}" if pid else ""
            raise OSError(
                f"another run of samcontact writes to {directory}{holder}: wait until it ends, or "
                f"{remedy}"
            ) from None
        except OSError:  # a file system without locks
            return handle
        if _is(path, handle):
            if not re.fullmatch(rb"\d*\s*", os.read(handle, 20)):
                os.close(handle)
                raise _foreign_lock(path, remedy)
            try:
                os.truncate(handle, 0)
                os.lseek(handle, 0, os.SEEK_SET)
                os.write(handle, f"{os.getpid()}\n".encode())
            except OSError as error:  # full disk, or file size limit
                path.unlink()
                os.close(handle)
                raise _unusable(directory, error, remedy) from error
            return handle
        os.close(handle)  # the previous owner has just removed it


def _is(path: Path, handle: int) -> bool:
    try:
        return os.path.samestat(os.stat(path), os.fstat(handle))
    except FileNotFoundError:
        return False


def _foreign_lock(path: Path, remedy: str) -> OSError:
    return OSError(f"{path} is not a lock file of samcontact: move this file, or {remedy}")


def _unusable(directory: Path, error: OSError, remedy: str) -> OSError:
    """Return the error for a folder to which files cannot be written."""
    readable = {errno.EACCES: "permission denied", errno.EROFS: "read-only file system"}
    reason = readable.get(error.errno or 0, error.strerror or "it cannot be used")
    return OSError(f"cannot write to the folder {directory}: {reason}: {remedy}")
