# SPDX-License-Identifier: GPL-3.0-or-later
"""Read a file whose bytes nobody vouches for, in a process of its own.

HDF5 may crash on damaged metadata, or never come back. A file without a digest, as other programs
write it, is therefore read as a whole by another process first, in which no single call may take
long.
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
"""Starts the time of a call over again; of one that reads so many bytes."""

CALL = 2.0
"""Processor time of one call of HDF5 [s], besides that of the values it reads."""
SLOWEST = 2e7
"""Bytes of values that are decompressed in a second on the slowest machine."""
BLOCK = 1 << 24
"""Bytes of values without chunks that are read at once."""
MOST_PACKED = 2000
"""Largest ratio of values to the bytes that hold them: deflate reaches 1032."""

_START = """
import json, runpy, sys
sys.path[:] = json.loads(sys.argv[1])
runpy.run_path(sys.argv[2])["read_all"](sys.argv[3], float(sys.argv[4]))
"""


def try_to_read(path: Path, call: float = CALL) -> None:
    """Raise ValueError for an HDF5 file that cannot be read as a whole.

    Parameters
    ----------
    path : Path
    call : float, optional
        Processor time that a call may take [s].
    """
    if not sys.executable:
        raise ValueError("it has no digest, and there is no Python interpreter to try it with")
    here = [json.dumps(sys.path), __file__, str(path), repr(call)]
    command = [sys.executable, "-I", "-c", _START, *here]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, check=False)
    if done.returncode == -signal.SIGVTALRM:
        raise ValueError("it is damaged: reading it does not end")
    if done.returncode < 0:
        raise ValueError(
            f"it is damaged: reading it ends by {signal.Signals(-done.returncode).name}"
        )
    if done.returncode:
        lines = done.stderr.decode(errors="replace").strip().splitlines()
        raise ValueError(lines[-1] if lines else "it cannot be read")


def read_all(path: str, call: float) -> None:
    """Read all attributes, dimension scales and values of a file; the process ends where a call
    takes too long, or with an exit code that is not 0, and what is wrong as the last line of
    stderr."""
    try:
        _read_all(Path(path), call)
    except Exception as error:
        sys.stderr.write(f"\n{' '.join(str(error).split())}\n")
        sys.exit(1)


def _read_all(path: Path, call: float) -> None:
    size = path.stat().st_size

    def begin(number_of_bytes: float = 0.0) -> None:
        signal.setitimer(signal.ITIMER_VIRTUAL, call + number_of_bytes / SLOWEST)

    def visit(name: str, part: h5py.Group | h5py.Dataset) -> None:
        for attribute in range(h5py.h5a.get_num_attrs(part.id)):
            begin()
            found = h5py.h5a.open(part.id, index=attribute)
            part.attrs.get(found.name)
        if isinstance(part, h5py.Dataset):
            if part.nbytes > MOST_PACKED * size:
                raise ValueError(f"{name} claims {part.nbytes} bytes, more than a file of {size}")
            for dimension in part.dims:
                begin()
                len(dimension)
            if not (part.external or part.is_virtual):  # refused later
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
    """Read one chunk after the other, or blocks of rows."""
    if part.ndim == 0 or part.size == 0:
        part[()]
        return
    if part.chunks is None:
        rows = max(1, BLOCK * len(part) // max(1, part.nbytes))
        for first in range(0, len(part), rows):
            begin(max(BLOCK, part.nbytes // len(part)))
            part[first : first + rows]
        return
    each = math.prod(part.chunks) * part.dtype.itemsize
    begin()
    for chunk in part.iter_chunks():
        begin(each)
        part[chunk]
