# SPDX-License-Identifier: GPL-3.0-or-later
"""Estimates of required and available memory, to refuse calculations that would not fit.

The constants are bytes per cell, measured in tests/faults/test_out_of_memory.py.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Protocol

CACHE_RELEASERS: list[Callable[[], bool]] = []
"""Functions that release cached data, and return whether any memory was released."""
_MAX_UNCHECKED_BYTES = 64e6  # memory [bytes] below which no check is made
MOVING_CONTACT_BYTES = 650.0
"""Maximum memory of a steady viscoelastic contact per surface cell [bytes]."""
CONTACT_BYTES, COUPLED_CONTACT_BYTES, COUPLED_PARTIAL_SLIP_BYTES, HEATED_CONTACT_BYTES = (
    125.0,
    215.0,
    290.0,
    185.0,
)
"""Bytes per surface cell of an elastic contact, in this order: without friction; with coupled
shear, which also displaces the surfaces normally; with coupled shear in partial slip, not including
the memory that the compiled core requests for contact cells; with heating."""
SIMULATION_BYTES, PARTIAL_SLIP_SIMULATION_BYTES, YIELD_SCAN_BYTES = 75.0, 275.0, 450.0
"""Bytes per surface cell in addition to the contact solution, in this order: for an increment; for
an increment with partial slip; for the search for first yield."""
SURFACE_BYTES = 48.0
"""Bytes per surface cell for heights, including Fourier modes while roughness is generated."""
DISPLACEMENT_BYTES = 65.0
"""Bytes per surface cell for a displacement field."""
TRACTION_STRESS_BYTES, TEMPERATURE_BYTES = 56.0, 35.0
"""Bytes per volume cell for the stress due to tractions, and for the temperature."""
FAST_RESIDUAL_BYTES, EXACT_RESIDUAL_BYTES = 350.0, 1200.0
"""Bytes per volume cell for residual stress and displacement due to plastic strain, with the
methods "fast" and "exact"."""
ZONE_FIELD_BYTES = 200.0
"""Bytes per cell of a box of cells with plastic strain, for the stress in this box."""
LIBRARY_BYTES, BLAS_BUFFER_BYTES, HDF5_FILE_BYTES = 400e6, 45e6, 64e6
"""Address space [bytes], in this order: for all libraries of a run with one thread of linear
algebra, including the first block of the compiled core (128 MB); for each further thread of NumPy
or of SciPy; for an HDF5 file while it is written."""
VOLUME_FIELD_BYTES = 300.0
"""Bytes per volume cell for one field of a state, except residual stress with the method "exact",
which requires `EXACT_RESIDUAL_BYTES`."""


class CellCounts(Protocol):
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


def require(what: str, needed: float, remedy: str = "use fewer cells") -> None:
    """Raise MemoryError unless `needed` bytes are available."""
    if needed < _MAX_UNCHECKED_BYTES:
        return
    there = available()
    if there is not None and needed > there and any([give() for give in CACHE_RELEASERS]):
        there = available()
    if there is not None and needed > there:
        raise MemoryError(
            f"{what} requires about {needed / 1e9:.3g} GB of memory, {there / 1e9:.3g} GB "
            f"available: {remedy}"
        )


def blas_threads() -> int:
    """Return the number of threads of OpenBLAS (NumPy, SciPy), each of which has a buffer."""
    processors = os.cpu_count() or 1
    for name in ("OPENBLAS_NUM_THREADS", "GOTO_NUM_THREADS", "OMP_NUM_THREADS"):
        given = os.environ.get(name, "")
        if given.isdecimal() and int(given) > 0:
            return min(int(given), processors)
    return processors


def require_address_space(what: str, needed: float) -> None:
    """Raise MemoryError unless the process may allocate `needed` more bytes (``ulimit -v``).

    Call this before loading libraries that do not survive a failed allocation: some versions of
    OpenBLAS retry indefinitely until SIGKILL, and HDF5 crashes.
    """
    there = _process_memory()
    if there is not None and needed > there:
        raise MemoryError(
            f"not enough memory: {what} requires about {needed / 1e6:.0f} MB more address space, "
            f"{there / 1e6:.0f} MB available under the limit of the process (ulimit -v): raise the "
            "limit"
        )


def require_for_grid(what: str, grid: CellCounts, needed: float) -> None:
    """Raise MemoryError, stating the numbers of cells, unless `needed` bytes are available."""
    if needed < _MAX_UNCHECKED_BYTES:
        return
    cells = f"nx = {grid.nx}, ny = {grid.ny}" + (f", nz = {grid.nz}" if grid.nz else "")
    require(f"{what} on a grid of {cells}", needed)


def of_contact(*, coupled: bool, sticks: bool, heated: bool) -> float:
    """Return the memory of a contact solution per surface cell [bytes].

    coupled: shear displaces the surfaces normally (dissimilar materials); sticks: partial slip;
    heated: frictional heating.
    """
    smooth = COUPLED_PARTIAL_SLIP_BYTES if sticks else COUPLED_CONTACT_BYTES
    return max(smooth if coupled else CONTACT_BYTES, HEATED_CONTACT_BYTES if heated else 0.0)


def surface(grid: CellCounts, bytes_a_cell: float) -> float:
    """Return the memory of all surface cells of a grid [bytes]."""
    return bytes_a_cell * grid.nx * grid.ny


def volume(grid: CellCounts, bytes_a_cell: float, layers: int | None = None) -> float:
    """Return the memory of all volume cells [bytes] of a grid, with grid.nz or `layers` layers."""
    return surface(grid, bytes_a_cell) * (grid.nz if layers is None else layers)


def available() -> float | None:
    """Return the available memory [bytes]; None if it is unknown.

    This is the smallest of the amounts that are available to machine, container and process.
    """
    known = [
        amount for amount in (_machine_memory(), _container_memory(), _process_memory()) if amount
    ]
    return min(known, default=None)


def _machine_memory() -> float | None:
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


def _container_memory() -> float | None:
    for limit, used in (("memory.max", "memory.current"), (
        "memory/memory.limit_in_bytes", "memory/memory.usage_in_bytes"
    )):  # fmt: skip
        try:
            top = Path("/sys/fs/cgroup")
            return float((top / limit).read_text()) - float((top / used).read_text())
        except (OSError, ValueError):  # no such control group, or no limit ("max")
            continue
    return None


def _process_memory() -> float | None:
    if not sys.platform.startswith("linux"):
        return None
    import resource

    limit, _ = resource.getrlimit(resource.RLIMIT_AS)
    if limit == resource.RLIM_INFINITY:
        return None
    pages = Path("/proc/self/statm").read_text(encoding="ascii").split()[0]
    return max(1.0, float(limit) - float(pages) * resource.getpagesize())
