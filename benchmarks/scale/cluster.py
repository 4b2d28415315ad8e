# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of bytes sent by transforms of a surface that is distributed over processes.

The bytes are counted, not measured. Each process holds rows of the surface and transforms them.
Every two processes then exchange a block (a transpose), and each process transforms whole columns.
After the product with the influence coefficients in wavenumber space, these steps are reversed, so
that a displacement requires two transposes.
"""

from __future__ import annotations

from typing import Any, NamedTuple

SIDE = 65_536  # cells
RANKS = (64, 512, 4096)
RATE = 10e9  # bytes/s sent and received by a process; a network of 100 Gbit/s provides 12.5e9
COMPLEX = 16  # bytes
STRAINS, STRESSES = 5, 6  # numbers of components of plastic strain, and of the stress due to it
PERIODIC = ("rough", "zones")  # jobs
JOBS = ("finer", "slipping", "slipping_fine", *PERIODIC)
# Size of the coarse fields by which zones act on each other across the whole surface, relative to
# the number of surface cells: nodes of 2 x 2 cells, and nodes of 8 x 8 cells on a plane twice as
# wide, of which the empty rows are not sent.
BANDS = 1 / 2**2 + 2 / 8**2


class Count(NamedTuple):
    """Number of planes (fields of all surface cells) transformed in a solution, there and back."""

    number: float
    padded: bool


def bytes_of_a_transpose(n: int, padded: bool) -> int:
    """Return the size of the half spectra of n rows [bytes]; rows are twice as long if padded."""
    return COMPLEX * n * ((2 * n if padded else n) // 2 + 1)


def bytes_of_a_rank(n: int, ranks: int, padded: bool) -> float:
    """Return the bytes that a process sends to all other processes for one displacement."""
    return 2 * bytes_of_a_transpose(n, padded) / ranks * (1 - 1 / ranks)


def message(n: int, ranks: int, padded: bool) -> float:
    """Return the bytes sent from one process to another in one transpose."""
    return bytes_of_a_transpose(n, padded) / ranks**2


def planes(job: str, largest: dict[str, dict[str, Any]]) -> Count:
    """Return the number of planes transformed in a solution, from the largest measured solution.

    The jobs with larger rough surfaces are periodic; the other jobs require padded planes. In each
    iteration for plastic zones, the strain components of all layers are transformed forwards and
    the stress components backwards; a transform of each component costs half a displacement. The
    contact solution in each increment is counted as an elastic contact.
    """
    row = largest[job]
    if job != "zones":
        return Count(row["transforms"], job not in PERIODIC)
    volumes = 0.5 * (STRAINS + STRESSES) * row["layers"] * BANDS * row["volume_applications"]
    return Count(volumes + largest["rough"]["transforms"] * row["increments"], False)
