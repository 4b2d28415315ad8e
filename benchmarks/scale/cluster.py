# SPDX-License-Identifier: GPL-3.0-or-later
"""Data sent by transforms of a surface distributed over processes: counted, not measured.

Each process holds rows of the surface and transforms them. Every two processes then exchange a
block (a transpose), and each process transforms whole columns. After the product in wavenumbers
these steps are reversed, so that a displacement requires two transposes.
"""

from __future__ import annotations

from typing import Any, NamedTuple

SIDE = 65_536  # cells
RANKS = (64, 512, 4096)
RATE = 10e9  # bytes/s sent and received by a process; a network of 100 Gbit/s provides 12.5e9
COMPLEX = 16  # bytes
STRAINS, STRESSES = 5, 6  # number of components of plastic strain and of its stress
PERIODIC = ("rough", "zones")  # jobs
# Bands of zones that reach over all of the surface: nodes of 2 x 2 cells, and of 8 x 8 on a plane
# twice as wide of which the empty rows are not sent; in units of a plane of all cells.
BANDS = 1 / 2**2 + 2 / 8**2


class Count(NamedTuple):
    """Number of planes transformed forwards and backwards in a solution."""

    number: float
    padded: bool


def bytes_of_a_transpose(n: int, padded: bool) -> int:
    """Return the bytes of the half spectra of n rows, which are twice as long if padded."""
    return COMPLEX * n * ((2 * n if padded else n) // 2 + 1)


def bytes_of_a_rank(n: int, ranks: int, padded: bool) -> float:
    """Return the bytes that a process sends for one displacement, without its own block."""
    return 2 * bytes_of_a_transpose(n, padded) / ranks * (1 - 1 / ranks)


def message(n: int, ranks: int, padded: bool) -> float:
    """Return the bytes sent from one process to another in one transpose."""
    return bytes_of_a_transpose(n, padded) / ranks**2


def planes(job: str, largest: dict[str, dict[str, Any]]) -> Count:
    """Return the planes of a solution, from the counts of the largest measured solution.

    Larger rough surfaces are periodic; finer cells and partial slip of the ball require a padded
    plane. An iteration of the zones sends the strain of their layers forwards and the stress
    backwards, which each cost half a displacement. The contact of an increment is counted as an
    elastic contact.
    """
    row = largest[job]
    if job != "zones":
        return Count(row["transforms"], job not in PERIODIC)
    volumes = 0.5 * (STRAINS + STRESSES) * row["layers"] * BANDS * row["volume_applications"]
    return Count(volumes + largest["rough"]["transforms"] * row["increments"], False)
