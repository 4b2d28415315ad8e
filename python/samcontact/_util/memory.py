# SPDX-License-Identifier: GPL-3.0-or-later
"""How much memory a scene needs, and how much there is: what cannot be had is refused beforehand.

The numbers are bytes a cell, all included, as measured (tests/faults/test_out_of_memory.py).
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Protocol

GIVING: list[Callable[[], bool]] = []
"""What gives back memory that others need; whether there was some."""
_SMALL = 64e6  # below this nobody needs to ask
CONTACT, COUPLED_CONTACT, COUPLED_STICK_SLIP, HEATED_CONTACT = 125.0, 215.0, 290.0, 185.0
"""Of a surface cell of an elastic contact: smooth; with shear that displaces; which sticks and
slips, besides what the core asks for where there is contact; heated."""
SIMULATION, STICK_SLIP_SIMULATION, YIELD_SCAN = 75.0, 275.0, 450.0
"""Of a surface cell, besides the contact: of increments; of those that stick and slip; and of
finding where a body yields first."""
SURFACE = 48.0
"""Of a surface cell: heights, and the waves of a rough one while they are made."""
DISPLACEMENT = 65.0
"""Of a surface cell."""
STRESS_OF_TRACTIONS, TEMPERATURE = 56.0, 35.0
"""Of a cell of a layer."""
FAST_RESIDUAL, EXACT_RESIDUAL = 350.0, 1200.0
"""Of a cell of the volume: stress of a strain of six components, its print."""
ZONE_FIELD = 200.0
"""Of a cell of a zone: stress."""
LIBRARIES, BLAS_BUFFER, HDF5_FILE = 400e6, 45e6, 64e6
"""Address space [bytes]: of all libraries of a run, the core's first block (128 MB) included, with
one thread of linear algebra; of each more of them, in a library; of a file while it is written."""
VOLUME_FIELD = 300.0
"""Of a cell of the volume: a field of a state; where the residual stress is exact, as that."""


class Cells(Protocol):
    """Numbers of cells of a grid along x, y and z."""

    @property
    def nx(self) -> int:
        """Number of cells along x."""

    @property
    def ny(self) -> int:
        """Number of cells along y."""

    @property
    def nz(self) -> int:
        """Number of cells along z."""


def require(what: str, needed: float, remedy: str = "take fewer cells") -> None:
    """Raise MemoryError unless this many bytes are available."""
    if needed < _SMALL:
        return
    there = available()
    if there is not None and needed > there and any([give() for give in GIVING]):
        there = available()
    if there is not None and needed > there:
        raise MemoryError(
            f"{what} needs about {needed / 1e9:.3g} GB of memory, and {there / 1e9:.3g} GB are "
            f"available: {remedy}"
        )


def blas_threads() -> int:
    """How many threads the linear algebra (OpenBLAS) of NumPy and SciPy has, a buffer for each."""
    processors = os.cpu_count() or 1
    for name in ("OPENBLAS_NUM_THREADS", "GOTO_NUM_THREADS", "OMP_NUM_THREADS"):
        given = os.environ.get(name, "")
        if given.isdecimal() and int(given) > 0:
            return min(int(given), processors)
    return processors


def require_address_space(what: str, needed: float) -> None:
    """Raise MemoryError unless the process may have so many bytes more (``ulimit -v``).

    For libraries that do not survive a failed allocation: OpenBLAS, as it is loaded, asks again
    for ever in some versions, which only SIGKILL ends, and HDF5 crashes.
    """
    there = _of_process()
    if there is not None and needed > there:
        raise MemoryError(
            f"not enough memory: {what} needs about {needed / 1e6:.0f} MB more address space, and "
            f"the limit of the process (ulimit -v) leaves {there / 1e6:.0f} MB: raise the limit"
        )


def require_for_grid(what: str, grid: Cells, needed: float) -> None:
    """The same with the counts that make it so much."""
    if needed < _SMALL:
        return
    cells = f"nx = {grid.nx}, ny = {grid.ny}" + (f", nz = {grid.nz}" if grid.nz else "")
    require(f"{what} on a grid of {cells}", needed)


def of_contact(*, coupled: bool, sticks: bool, heated: bool) -> float:
    """Bytes of a surface cell of a contact: shear displaces unlike bodies, sticks, is heated."""
    smooth = COUPLED_STICK_SLIP if sticks else COUPLED_CONTACT
    return max(smooth if coupled else CONTACT, HEATED_CONTACT if heated else 0.0)


def surface(grid: Cells, bytes_a_cell: float) -> float:
    """Of a grid's surface."""
    return bytes_a_cell * grid.nx * grid.ny


def volume(grid: Cells, bytes_a_cell: float, layers: int | None = None) -> float:
    """Of a grid's layers, or of others in their place."""
    return surface(grid, bytes_a_cell) * (grid.nz if layers is None else layers)


def available() -> float | None:
    """What can still be had [bytes]: by the machine, its container, the limits of the process.

    None where the system does not tell.
    """
    known = [amount for amount in (_of_machine(), _of_container(), _of_process()) if amount]
    return min(known, default=None)


def _of_machine() -> float | None:
    try:
        lines = Path("/proc/meminfo").read_text(encoding="ascii").splitlines()
        amounts = {line.partition(":")[0]: 1024.0 * float(line.split()[1]) for line in lines}
        return amounts["MemAvailable"] + amounts["SwapFree"]
    except (OSError, LookupError, ValueError):  # not Linux
        pass
    try:
        return float(os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE"))
    except (OSError, ValueError, AttributeError):
        return None


def _of_container() -> float | None:
    for limit, used in (("memory.max", "memory.current"), (
        "memory/memory.limit_in_bytes", "memory/memory.usage_in_bytes"
    )):  # fmt: skip
        try:
            top = Path("/sys/fs/cgroup")
            return float((top / limit).read_text()) - float((top / used).read_text())
        except (OSError, ValueError):  # no such group, or "max"
            continue
    return None


def _of_process() -> float | None:
    if not sys.platform.startswith("linux"):
        return None
    import resource

    limit, _ = resource.getrlimit(resource.RLIMIT_AS)
    if limit == resource.RLIM_INFINITY:
        return None
    pages = Path("/proc/self/statm").read_text(encoding="ascii").split()[0]
    return max(1.0, float(limit) - float(pages) * resource.getpagesize())
