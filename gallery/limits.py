# SPDX-License-Identifier: GPL-3.0-or-later
"""Limits of infinitely fine meshes and increments, extrapolated from a few finite ones."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise


@dataclass(frozen=True)
class Limit:
    """Value extrapolated to infinitely fine cells or increments, and its estimated error."""

    value: float
    error: float
    """Difference between the extrapolations from the finest pair and from the next coarser pair."""
    text: str
    """Text that lists the values from which the limit is extrapolated."""


def first_order(counts: Sequence[float], values: Sequence[float], what: str) -> Limit:
    """Return the limit v of values, fitted by v + c/count at three or more increasing counts."""
    pairs = list(zip(counts, values, strict=True))
    *_, coarse, fine = ((m * v - n * u) / (m - n) for (n, u), (m, v) in pairwise(pairs))
    listed = (", ".join(f"{x:.4g}" for x in row) for row in (values, counts))
    return Limit(fine, abs(fine - coarse), f"{next(listed)} with {next(listed)} {what}")
