# SPDX-License-Identifier: GPL-3.0-or-later
"""The folder of results: one run at a time, and no file of another run beside those of this one."""

from __future__ import annotations

import fcntl
import os
import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from .. import results
from .._atomic import undisturbed

if TYPE_CHECKING:
    import xarray as xr

LOCK = ".samcontact.lock"
_FIGURES = (
    "pressure", "pressure_map", "gap_map", "load_approach", "axis_stress", "sections", "print",
    "print_map", "residual",
    "flash_temperature", "temperature", "track_print", "track_sections", "force_x", "force_z",
    "load_ratio", "wear_rate", "profile_body[12]", "surface_body[12]", "first_cycle_body[12]",
    "last_cycle_body[12]",
)  # fmt: skip
_OWN = re.compile(
    r"(results|series|wear)\.nc|(series|wear)\.csv|report\.html|rolling\.gif"
    r"|results(_\d{5,})?(_track)?(_surface)?\.vtr|results(_surface)?\.pvd"
    rf"|({'|'.join(_FIGURES)})\.png"
)
"""Names of the files that runs, reports and exports write into the folder of a run."""


def is_own(file: Path) -> bool:
    """Whether it has a name that a run, its report or its export gives."""
    return _OWN.fullmatch(file.name) is not None


def publish(dataset: xr.Dataset, file: Path) -> Path:
    """Write the results of a run; what an earlier one has left beside them goes now.

    Not before, so that a run that fails costs nothing, and not later, so that no figure or report
    stands beside results that it does not show.
    """
    with undisturbed():
        results.save(dataset, file)
        for other in file.parent.iterdir():
            if other != file and is_own(other) and other.is_file():
                other.unlink()
    return file


@contextmanager
def locked(directory: Path) -> Iterator[None]:
    """Make the folder, and keep other runs out of it; a process that dies leaves no lock.

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
            "give another --output"
        ) from None
    handle = _take(directory)
    try:
        yield
    finally:
        (directory / LOCK).unlink(missing_ok=True)
        os.close(handle)


def _take(directory: Path) -> int:
    """The opened lock file, with the number of this process in it."""
    path = directory / LOCK
    while True:
        handle = os.open(path, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW, 0o666)
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            pid = os.read(handle, 20).decode("ascii", "replace").strip()
            os.close(handle)
            who = f", process {pid}" if pid else ""
            raise OSError(
                f"another run of samcontact writes to {directory}{who}: wait for its end, or give "
                "another --output"
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
