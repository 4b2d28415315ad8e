# SPDX-License-Identifier: GPL-3.0-or-later
"""Table of the page: its rows, the function that solves a row, and the limits of columns."""

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
        """Return whether a run, possibly on another machine, reproduces the stored number."""
        if value is None or stored is None:
            return value is stored
        if self.kind == COUNT:
            return abs(value - stored) <= max(3, 0.2 * stored)
        return self.kind == ROUNDING or abs(value - stored) <= 1e-4 * abs(stored)


class Table(NamedTuple):
    """Table of a stability page; `solve` takes a row name; a test solves `retested_row` again."""

    name: str
    head: str
    rows: tuple[str, ...]
    solve: Callable[[str], dict[str, Any]]
    columns: tuple[Column, ...]
    retested_row: str


def largest(field: Any) -> float:
    return float(np.abs(field).max())


def apart(found: Any, expected: Any) -> float:
    """Return the largest difference over the largest value."""
    difference = largest(np.asarray(found) - np.asarray(expected))
    return difference / largest(expected) if difference else 0.0


def trace(strain: Any) -> float:
    """Return the largest trace of the plastic strain over its largest component."""
    return largest(strain[:3].sum(axis=0)) / largest(strain) if np.any(strain) else 0.0
