# SPDX-License-Identifier: GPL-3.0-or-later
"""Trial reading of a file of unknown origin, in a separate process.

HDF5 may crash on damaged metadata, or not terminate. A file without a digest was modified or
written by another program, so it is first read completely by a separate process. The processor time
of each HDF5 call in the separate process is limited.
"""

from __future__ import annotations

import json
import math
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import h5py

Begin = Callable[..., None]
"""Function that starts the time limit of a call of HDF5; argument: number of bytes to be read."""

CALL_TIME = 2.0
"""Limit of the processor time of one HDF5 call [s], without the time allowed for reading values."""
MIN_BYTES_PER_SECOND = 2e7
"""Number of bytes per second that a slow machine decompresses; sets the time limit for reading."""
BLOCK_BYTES = 1 << 24
"""Number of bytes that are read in one call from variables without chunks."""
MAX_COMPRESSION_RATIO = 2000
"""Compression ratio above which a file counts as damaged; deflate reaches at most 1032."""

_READER_PROGRAM = """
import json, runpy, sys
sys.path[:] = json.loads(sys.argv[1])
runpy.run_path(sys.argv[2])["read_all"](sys.argv[3], float(sys.argv[4]))
"""


def try_to_read(path: Path, call: float = CALL_TIME) -> None:
    """Raise ValueError for an HDF5 file that cannot be read as a whole.

    Parameters
    ----------
    path : Path
        File to read.
    call : float, optional
        Maximum processor time of a call of HDF5 [s].
    """
    if not sys.executable:
        raise ValueError(
            "the file has no digest and cannot be checked: no Python interpreter was found that "
            "could read it in a separate process"
        )
    here = [json.dumps(sys.path), __file__, str(path), repr(call)]
    command = [sys.executable, "-I", "-c", _READER_PROGRAM, *here]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, check=False)
    if done.returncode == -signal.SIGVTALRM:
        raise ValueError("the file is damaged: reading it does not terminate")
    if done.returncode < 0:
        raise ValueError(
            f"the file is damaged: reading it ends with {signal.Signals(-done.returncode).name}"
        )
    if done.returncode:
        lines = done.stderr.decode(errors="replace").strip().splitlines()
        raise ValueError(lines[-1] if lines else "the file cannot be read")


def read_all(path: str, call: float) -> None:
    """Read all attributes, dimension scales and values of a file; runs in a separate process.

    A signal ends the process if an HDF5 call takes more than `call` seconds. If reading fails, the
    exit code is not 0 and the last line of stderr is the error message.
    """
    try:
        _read_all(Path(path), call)
    except Exception as error:
        sys.stderr.write(f"\n{' '.join(str(error).split())}\n")
        sys.exit(1)


def _read_all(path: Path, call: float) -> None:
    size = path.stat().st_size

    def begin(number_of_bytes: float = 0.0) -> None:
        signal.setitimer(signal.ITIMER_VIRTUAL, call + number_of_bytes / MIN_BYTES_PER_SECOND)

    def visit(name: str, part: h5py.Group | h5py.Dataset) -> None:
        for attribute in range(h5py.h5a.get_num_attrs(part.id)):
            begin()
            found = h5py.h5a.open(part.id, index=attribute)
            part.attrs.get(found.name)
        if isinstance(part, h5py.Dataset):
            if part.nbytes > MAX_COMPRESSION_RATIO * size:
                raise ValueError(
                    f"{name} has {part.nbytes} bytes, too many for a file of {size} bytes"
                )
            for dimension in part.dims:
                begin()
                len(dimension)
            if not (part.external or part.is_virtual):  # values in other files are refused later
                _read_values(part, begin)

    begin()
    with h5py.File(path, "r") as file:
        visit("/", file)
        names: list[str] = []
        file.visit(names.append)
        for name in names:
            begin()
            visit(name, file[name])


def _read_values(part: h5py.Dataset, begin: Begin) -> None:
    """Read all values of a variable chunk by chunk, or in blocks of rows if it has no chunks."""
    if part.ndim == 0 or part.size == 0:
        part[()]
        return
    if part.chunks is None:
        rows = max(1, BLOCK_BYTES * len(part) // max(1, part.nbytes))
        for first in range(0, len(part), rows):
            begin(max(BLOCK_BYTES, part.nbytes // len(part)))
            part[first : first + rows]
        return
    each = math.prod(part.chunks) * part.dtype.itemsize
    begin()
    for chunk in part.iter_chunks():
        begin(each)
        part[chunk]
