# SPDX-License-Identifier: GPL-3.0-or-later
"""Page on cost and accuracy of extreme cases, with its tables."""

from __future__ import annotations

from pathlib import Path

from ..study import Record, Study, by_group, table
from . import cells, coatings, cycles, friction, materials, units
from .table import Table

TEXT = Path(__file__).with_name("template.md")
TABLES = (
    units.TABLE, cycles.TABLE, materials.POISSON, cells.SURFACE, cells.VOLUME, materials.HARDENING,
    friction.SLIDING, friction.SLIPPING, coatings.ELASTIC, coatings.YIELDING,
)  # fmt: skip


def points(quick: bool) -> list[Record]:
    return [{"of": known.name, "row": row} for known in TABLES
            for row in ((known.retested_row,) if quick else known.rows)]  # fmt: skip


def run(of: str, row: str) -> Record:
    (known,) = (known for known in TABLES if known.name == of)
    return {
        name: value if value is None else float(f"{value:.6g}")
        for name, value in known.solve(row).items()
    }


def lines_of(known: Table, rows: list[Record]) -> str:
    """Return a Markdown table of these rows; the last line contains limits of columns, if any."""
    lines = [
        [row["row"], *(column.text(row.get(column.key)) for column in known.columns)]
        for row in rows
    ]
    if any(column.at_most is not None for column in known.columns):
        lines.append(["**limit**", *("" if column.at_most is None else column.text(column.at_most)
                                       for column in known.columns)])  # fmt: skip
    return table([known.head, *(column.head for column in known.columns)], lines)


def page(records: list[Record]) -> str:
    """Return the text of the page."""
    rows = by_group(records)
    tables = {known.name: lines_of(known, rows[known.name]) for known in TABLES}
    systems = "\n".join(f"{n}. {name}" for n, name in enumerate(units.UNITS, 1))
    return TEXT.read_text(encoding="utf-8").format(
        systems=systems, cycles_number=cycles.CYCLES, settled=cycles.SETTLED, **tables
    )


STUDY = Study("stability", "Accuracy and iterations of extreme cases.", points, run, page)
