# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers measured by validation tests, their storage, and the page generated from them.

``python tests/validation_page.py`` rewrites the page from the stored numbers, which is enough
after a change of its text (docs/validation.md.jinja).
"""

from __future__ import annotations

import dataclasses
import json
import math
from pathlib import Path

import jinja2

DOCS = Path(__file__).parents[1] / "docs"
STORE, TEXT = DOCS / "validation.json", DOCS / "validation.md.jinja"
PAGE = DOCS / "validation.md"
# Processors round differently, and an iteration may end one step earlier: this part of the
# allowed difference is left to them.
REPEATS = 0.05
SYMBOLS = {
    "sqrt(R ω)": r"$\sqrt{R \omega}$",
    "ω/ω_c": r"$\omega/\omega_c$",
    "p_max": r"$p_{\max}$",
    "u_z": "$u_z$",
    "Q_f": "$Q_f$",
}
"""Symbols in quantities and meshes, as the page typesets them."""


@dataclasses.dataclass(frozen=True)
class Row:
    """A number and its reference, both in `unit`."""

    table: str
    quantity: str
    mesh: str
    source: str
    """Origin of the reference, if the table has more than one."""
    ours: float
    reference: float
    """Zero if `ours` is itself a difference."""
    unit: str
    allowed: float
    relative: bool
    """Whether `allowed` is a part of the reference, or in `unit`."""
    test: str

    @property
    def key(self) -> tuple[str, str, str, str]:
        return self.table, self.quantity, self.mesh, self.source

    @property
    def limit(self) -> float:
        """Return the largest permitted difference, in `unit`."""
        return self.allowed * abs(self.reference) if self.relative else self.allowed

    @property
    def holds(self) -> bool:
        return abs(self.ours - self.reference) <= self.limit

    def repeats(self, stored: Row) -> bool:
        """Return whether the stored row has the same reference and number, except for rounding."""
        same = dataclasses.replace(self, ours=stored.ours) == stored
        return same and abs(self.ours - stored.ours) <= REPEATS * self.limit

    def cells(self) -> list[str]:
        """Return the cells of the row on the page, each value with its unit."""
        unit = f" {self.unit}" if self.unit else ""
        difference, scale = self.ours - self.reference, 1.0
        if self.relative:
            difference, scale = 100 * difference / self.reference, 100.0
        of = " %" if self.relative else unit
        ours, reference = f"{self.ours:.5g}{unit}", f"{self.reference:.5g}{unit}"
        if self.reference == 0:
            ours = reference = ""
        elif self.source:
            reference += f" ({self.source})"
        measured_by = self.test.partition("::")[2].partition("[")[0]
        return [
            typeset(self.quantity),
            typeset(self.mesh),
            ours,
            reference,
            f"{difference:+.2g}{of}",
            f"{scale * self.allowed:.3g}{of}",
            f"`{measured_by}`",
        ]


class Measured:
    """Numbers measured by one test, compared with the stored ones, if given."""

    def __init__(self, test: str, stored: dict[tuple[str, str, str, str], Row] | None) -> None:
        self.test, self.stored = test, stored
        self.rows: list[Row] = []

    def close(self, table: str, quantity: str, ours: float, reference: float, *, mesh: str,
              rel: float | None = None, abs: float | None = None, unit: str = "",
              source: str = "") -> None:  # fmt: skip
        """Assert that ours is the reference to a relative or an absolute difference.

        It must also be what the page says of it.
        """
        allowed, relative = (abs, False) if rel is None else (rel, True)
        row = Row(
            table, quantity, mesh, source, ours, reference, unit, allowed, relative, self.test
        )
        # Digits that mean nothing here would change the store with each processor.
        decimals = 4 - math.floor(math.log10(row.limit))
        ours, reference = (round(float(value), decimals) + 0.0 for value in (ours, reference))
        row = dataclasses.replace(row, ours=ours, reference=reference)
        self.rows.append(row)
        assert row.holds, f"farther from its reference than allowed: {row}"
        if self.stored is not None:
            assert row.key in self.stored, f"not on docs/validation.md: {row}"
            said = self.stored[row.key]
            assert row.repeats(said), f"docs/validation.md says {said.ours}: {row}"

    def complete(self) -> None:
        """Assert that the page has no more of this test than it measured."""
        keys = {row.key for row in self.rows}
        gone = [key for key, row in (self.stored or {}).items()
                if row.test == self.test and key not in keys]  # fmt: skip
        assert not gone, f"on docs/validation.md, but no longer measured: {gone}"


def typeset(text: str) -> str:
    """Text with its symbols as inline mathematics."""
    for plain, mathematics in SYMBOLS.items():
        text = text.replace(plain, mathematics)
    return text


def load() -> dict[tuple[str, str, str, str], Row]:
    rows = [Row(**row) for row in json.loads(STORE.read_text(encoding="utf-8"))]
    return {row.key: row for row in rows}


def table(rows: list[Row]) -> str:
    """Return the Markdown table; meshes of one quantity are adjacent."""
    quantities = list(dict.fromkeys(row.quantity for row in rows))
    rows = sorted(rows, key=lambda row: quantities.index(row.quantity))
    heads = ["quantity", "mesh", "samcontact", "reference", "difference", "allowed", "test"]
    lines = [f"| {' | '.join(cells)} |" for cells in (heads, *(row.cells() for row in rows))]
    lines.insert(1, "|---" * len(heads) + "|")
    return "\n".join(lines)


def page(rows: list[Row]) -> str:
    """Return the page: the template with its tables."""
    tables: dict[str, list[Row]] = {}
    for row in rows:
        tables.setdefault(row.table, []).append(row)

    def place(name: str) -> str:
        if name not in tables:
            raise ValueError(f"no numbers for {name!r}: the page needs all of tests/validation")
        return table(tables.pop(name))

    template = jinja2.Template(TEXT.read_text(encoding="utf-8"), keep_trailing_newline=True)
    text = template.render(table=place)
    if tables:
        raise ValueError(f"docs/validation.md.jinja has no place for: {', '.join(tables)}")
    return text


def write(rows: list[Row]) -> None:
    """Store the measured numbers, and write the page."""
    keys = [row.key for row in rows]
    twice = {key for key in keys if keys.count(key) > 1}
    if twice:
        raise ValueError(f"measured twice: {sorted(twice)}")
    text = page(rows)
    lines = [json.dumps(dataclasses.asdict(row), ensure_ascii=False) for row in rows]
    STORE.write_text("[\n" + ",\n".join(lines) + "\n]\n", encoding="utf-8")
    PAGE.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    write(list(load().values()))
