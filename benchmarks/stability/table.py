# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of the page on stability: rows, a function that solves a row, and limits of columns."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

COUNT, VALUE, ROUNDING = "count", "value", "rounding"
"""Kinds of columns: iteration counts, results, and numbers that are zero in exact arithmetic."""


class Column(NamedTuple):
    key: str
    head: str
    kind: str = ROUNDING
    at_most: float | None = None

    def text(self, value: float | None) -> str:
        if value is None:
            return "–"
        return f"{value:.0f}" if self.kind == COUNT else f"{value:.1e}"

    def agree(self, value: float | None, stored: float | None) -> bool:
        """Return whether a value of a run on any machine agrees with the stored value."""
        if value is None or stored is None:
            return value is stored
        if self.kind == COUNT:
            return abs(value - stored) <= max(3, 0.2 * stored)
        return self.kind == ROUNDING or abs(value - stored) <= 1e-4 * abs(stored)


class Table(NamedTuple):
    """Table of the page; `solve` solves the row of a given name; a test repeats `retested_row`."""

    name: str
    head: str
    rows: tuple[str, ...]
    solve: Callable[[str], dict[str, Any]]
    columns: tuple[Column, ...]
    retested_row: str


def largest(field: Any) -> float:
    return float(np.abs(field).max())


def relative_difference(found: Any, expected: Any) -> float:
    """Return the maximum difference of two fields, relative to the maximum expected value."""
    difference = largest(np.asarray(found) - np.asarray(expected))
    return difference / largest(expected) if difference else 0.0


def trace(strain: Any) -> float:
    """Return the maximum trace of a strain field, relative to the largest strain component."""
    return largest(strain[:3].sum(axis=0)) / largest(strain) if np.any(strain) else 0.0
