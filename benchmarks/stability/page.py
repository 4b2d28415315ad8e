# SPDX-License-Identifier: GPL-3.0-or-later
"""The page, of the rows that are kept."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from ..finite_elements.tables import table
from . import cells, coatings, cycles, friction, materials, units
from .table import Table

KEPT = Path(__file__).with_name("results.json")
TEXT = Path(__file__).with_name("template.md")
TABLES = (
    units.TABLE, cycles.TABLE, materials.POISSON, cells.SURFACE, cells.VOLUME, materials.HARDENING,
    friction.SLIDING, friction.SLIPPING, coatings.ELASTIC, coatings.YIELDING,
)  # fmt: skip
Results = dict[str, dict[str, dict[str, Any]]]


def kept() -> Results:
    """Values of each column, by table and row."""
    found: Results = json.loads(KEPT.read_text(encoding="utf-8")) if KEPT.exists() else {}
    return found


def keep(results: Results) -> None:
    """One line a row, in the order of the page."""
    parts = []
    for known in (known for known in TABLES if known.name in results):
        name, solved = known.name, results[known.name]
        rows = {row: solved[row] for row in known.rows if row in solved}
        lines = (f"{json.dumps(row, ensure_ascii=False)}: {json.dumps(found, ensure_ascii=False)}"
                 for row, found in rows.items())  # fmt: skip
        parts.append(f"{json.dumps(name)}: {{\n  " + ",\n  ".join(lines) + "\n}")
    KEPT.write_text("{\n" + ",\n".join(parts) + "\n}\n", encoding="utf-8")


def lines_of(known: Table, rows: dict[str, dict[str, Any]]) -> str:
    """With what no row is beyond as the last line."""
    lines = [
        [row, *(column.text(rows[row].get(column.key)) for column in known.columns)]
        for row in known.rows
    ]
    if any(column.at_most is not None for column in known.columns):
        lines.append(["**at most**", *("" if column.at_most is None else column.text(column.at_most)
                                       for column in known.columns)])  # fmt: skip
    return table([known.head, *(column.head for column in known.columns)], lines)


def page(results: Results) -> str:
    """All of it."""
    tables = {known.name: lines_of(known, results[known.name]) for known in TABLES}
    systems = "\n".join(f"{n}. {name}" for n, name in enumerate(units.UNITS, 1))
    return TEXT.read_text(encoding="utf-8").format(
        systems=systems, cycles_number=cycles.CYCLES, settled=cycles.SETTLED, **tables
    )
