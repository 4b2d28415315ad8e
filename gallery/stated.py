# SPDX-License-Identifier: GPL-3.0-or-later
"""Values stated in the thesis, one row of `statements.toml` each, and the computed ones.

Fields of a row: `quantity`; `thesis`, a number or words; of numbers `unit`, `tolerance` and
`converged`; of words `ours`, the form of what was computed, and `contradicted`; `mesh`, where it is
the same in every run; `remark`. What is a table instead depends on `at`, e.g. a load: such a row
states many values. Texts have fields of `str.format`, which the part fills.
"""

from __future__ import annotations

import string
import sys
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib


@dataclass(frozen=True)
class Number:
    """A number that the thesis states."""

    quantity: str
    thesis: float
    ours: float
    unit: str = ""
    mesh: str = ""
    tolerance: float = 0.05
    """Largest relative difference."""
    remark: str = ""
    """Remark, e.g. the value on a converged mesh if it differs from that of the thesis."""
    converged: float | None = None
    """Value of a mesh study that contradicts the thesis; `holds` then compares with it."""

    @property
    def difference(self) -> float:
        """Difference relative to the thesis [-]."""
        return self.ours / self.thesis - 1

    @property
    def holds(self) -> bool:
        expected = self.thesis if self.converged is None else self.converged
        return abs(self.ours / expected - 1) <= self.tolerance


@dataclass(frozen=True)
class Statement:
    """A trend that the thesis states in words."""

    quantity: str
    thesis: str
    ours: str
    holds: bool
    mesh: str = ""
    remark: str = ""
    contradicted: bool = False
    """Whether a mesh study contradicts the thesis; `holds` is then about what that found."""


class Listing(string.Formatter):
    """Formats of numbers apply to each of a list; three digits where none is given."""

    def format_field(self, value: Any, format_spec: str) -> str:
        if isinstance(value, (list, tuple, np.ndarray)):
            return ", ".join(format(one, format_spec or ".3g") for one in value)
        return format(value, format_spec)


@cache
def table() -> dict[str, dict[str, dict[str, Any]]]:
    """The rows of each part, by name."""
    text = Path(__file__).with_name("statements.toml").read_text(encoding="utf-8")
    found: dict[str, dict[str, dict[str, Any]]] = tomllib.loads(text)
    return found


class Stated:
    """The rows of a part; `fields` fill their texts or replace them."""

    def __init__(self, part: str, **fields: Any) -> None:
        self.part, self.fields = part, fields

    def on(self, mesh: str, **fields: Any) -> Stated:
        """Rows with this mesh where they have none of their own."""
        return Stated(self.part, **self.fields, mesh=mesh, **fields)

    def values(self, name: str) -> dict[Any, Any]:
        """Stated values of a row that has many, by their conditions."""
        found: dict[str, Any] = table()[self.part][name]["thesis"]
        return {_key(key): value for key, value in found.items()}

    def number(self, name: str, ours: float, **fields: Any) -> Number:
        """The row of this name, and the number that was computed in its unit."""
        return Number(**self._filled(name, (), fields), ours=ours)

    def trend(self, name: str, holds: bool, *ours: Any, **fields: Any) -> Statement:
        """The row of this name, whether it holds, and the values that its `ours` shows."""
        return Statement(**self._filled(name, ours, fields), holds=bool(holds))

    def _filled(self, name: str, ours: tuple[Any, ...], fields: dict[str, Any]) -> dict[str, Any]:
        given = self.fields | fields
        at = given.get("at", "")
        at = f"{at:g}" if isinstance(at, float) else str(at)
        row: dict[str, Any] = {}
        for key, value in table()[self.part][name].items():
            one = value.get(at) if isinstance(value, dict) else value
            if one is not None:
                row[key] = Listing().vformat(one, ours, given) if isinstance(one, str) else one
        known = (Statement if "ours" in row else Number).__dataclass_fields__
        return {key: value for key, value in (self.fields | row | fields).items() if key in known}


def _key(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text
