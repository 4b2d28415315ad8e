# SPDX-License-Identifier: GPL-3.0-or-later
"""Values that the thesis states (rows of `statements.toml`), and the computed values.

A row has the fields `quantity`, `thesis` (a number or words), `remark`, and `mesh` if all runs have
the same mesh. A row with a number also has `unit`, `tolerance` and `converged`. A row with words
also has `ours`, the format of the computed values, and `contradicted`. A field may be a table with
one value for each condition `at`, e.g. a load. Texts contain `str.format` placeholders, which the
gallery part fills.
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
    """A number stated in the thesis, and the computed number."""

    quantity: str
    thesis: float
    ours: float
    unit: str = ""
    mesh: str = ""
    tolerance: float = 0.05
    """Maximum relative difference for which the value holds [-]."""
    remark: str = ""
    """Remark, e.g. the value on a converged mesh if it differs from the value of the thesis."""
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
    """A trend stated in words in the thesis, and the computed values."""

    quantity: str
    thesis: str
    ours: str
    holds: bool
    mesh: str = ""
    remark: str = ""
    contradicted: bool = False
    """Whether a mesh study contradicts the thesis; `holds` then refers to the mesh study."""


class Listing(string.Formatter):
    """Formatter that applies a number format to each element of a list (default: `.3g`)."""

    def format_field(self, value: Any, format_spec: str) -> str:
        if isinstance(value, (list, tuple, np.ndarray)):
            return ", ".join(format(one, format_spec or ".3g") for one in value)
        return format(value, format_spec)


@cache
def table() -> dict[str, dict[str, dict[str, Any]]]:
    """Read `statements.toml`; return the rows by gallery part and name."""
    text = Path(__file__).with_name("statements.toml").read_text(encoding="utf-8")
    found: dict[str, dict[str, dict[str, Any]]] = tomllib.loads(text)
    return found


class Stated:
    """Rows of a gallery part; `fields` fill placeholders in the rows, or replace their fields."""

    def __init__(self, part: str, **fields: Any) -> None:
        self.part, self.fields = part, fields

    def on(self, mesh: str, **fields: Any) -> Stated:
        """Return these rows; rows without a mesh get `mesh`."""
        return Stated(self.part, **self.fields, mesh=mesh, **fields)

    def values(self, name: str) -> dict[Any, Any]:
        """Return the thesis's values in a row, as a dictionary by condition, e.g. by load."""
        found: dict[str, Any] = table()[self.part][name]["thesis"]
        return {_key(key): value for key, value in found.items()}

    def number(self, name: str, ours: float, **fields: Any) -> Number:
        """Return the row with this name; `ours`: the computed number, in the unit of the row."""
        return Number(**self._filled(name, (), fields), ours=ours)

    def trend(self, name: str, holds: bool, *ours: Any, **fields: Any) -> Statement:
        """Return the trend in the row with this name; `ours`: the computed values."""
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
