# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of measurements: CSV with all columns, Markdown for reading."""

from __future__ import annotations

import os
import platform
import re
from types import ModuleType
from typing import Any

import pandas as pd

import samcontact as sc

from . import study

BEGIN, END = "<!-- measured: begin -->", "<!-- measured: end -->"
# Order of columns that have values; errors follow "across", others come at the end.
FIRST_COLUMNS = ("part", "case", "method", "options", "cells", "across")
WORK = (
    "time_s",
    "time_ratio",
    "memory_MB",
    "contact_iterations",
    "surface_applications",
    "volume_applications",
)
# Columns that are comparable on one machine only.
TIMES = ("time_s", "us_per_cell_and_application", "ms_per_iteration")


def frame(rows: list[dict[str, Any]]) -> pd.DataFrame:
    """Return a table of all rows, with columns in a fixed order."""
    table = pd.DataFrame(rows)
    errors = [c for c in table if c.startswith("error: ")]
    others = [c for c in table if c not in (*FIRST_COLUMNS, *errors, *WORK)]
    columns = [*FIRST_COLUMNS, *errors, *WORK, *others]
    return table[[c for c in columns if c in table]]


def cell(value: Any) -> str:
    """Return a value as text: numbers with three digits, counts in full, "" for a missing value."""
    if isinstance(value, str):
        return value
    if pd.isna(value):
        return ""
    if float(value).is_integer() and abs(value) < 1e15:
        return f"{int(value)}"
    return f"{value:.3g}"


def markdown(table: pd.DataFrame) -> str:
    """Return the Markdown table without its empty columns."""
    kept = table.dropna(axis="columns", how="all")
    return study.table(
        list(kept.columns), [list(map(cell, row)) for row in kept.itertuples(index=False)]
    )


def report(table: pd.DataFrame, parts: list[ModuleType], *, times: bool = True) -> str:
    """Return Markdown with one section per part; `times` includes machine-dependent columns."""
    sections = []
    for part in parts:
        rows = table[table["part"] == part.NAME]
        if rows.empty:
            continue
        hidden = ["part", "options", *getattr(part, "HIDDEN_COLUMNS", ())]
        hidden += () if times else TIMES
        lines = [f"### {part.TITLE}", markdown(rows.drop(columns=hidden, errors="ignore"))]
        lines += part.notes(rows.to_dict("records")) if hasattr(part, "notes") else []
        sections.append("\n\n".join(lines))
    return "\n\n".join([environment(), *sections]) + "\n"


def rows_of(section: str) -> list[dict[str, Any]]:
    """Return the rows of the table in a section, with numbers as printed, without empty cells."""
    lines = [line for line in section.splitlines() if line.startswith("|")]
    head, _, *rest = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]
    return [
        {name: _value(text) for name, text in zip(head, cells, strict=True) if text}
        for cells in rest
    ]


def _value(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text


def section_of(page: str, part: ModuleType) -> str:
    """Return the section of a part on the page; empty if it has not been measured."""
    return dict(map(_titled, _sections(inside_markers(page))[1:])).get(part.TITLE, "")


def noted(page: str, parts: list[ModuleType]) -> str:
    """Return the page with sentences rewritten from the tables, except sentences on times."""
    for part in parts:
        section = section_of(page, part)
        if section and hasattr(part, "notes") and not getattr(part, "NOTES_NEED_TIMES", False):
            table = section[: section.rindex("|") + 1]
            page = page.replace(section, "\n\n".join([table, *part.notes(rows_of(section))]))
    return page


def environment() -> str:
    """Return version, processor and threads of the measurements."""
    threads = os.environ.get("OMP_NUM_THREADS", "all")
    return f"samcontact {sc.__version__}, {platform.machine()}, {threads} thread(s)."


def with_sections(old: str, text: str, titles: list[str]) -> str:
    """Return the text between the markers, with sections replaced by new ones of equal title.

    The text before the first section is taken from the new text.
    """
    head, *new = _sections(text)
    kept = dict(map(_titled, _sections(old)[1:])) | dict(map(_titled, new))
    order = [title for title in titles if title in kept]
    return "\n\n".join([head, *(kept[title] for title in order)]) + "\n"


def _sections(text: str) -> list[str]:
    return [part.strip() for part in re.split(r"^(?=### )", text, flags=re.MULTILINE)]


def _titled(section: str) -> tuple[str, str]:
    return section.splitlines()[0].removeprefix("### "), section


def inside_markers(page: str) -> str:
    """Return the text between the markers of the measured tables."""
    return _split(page)[1]


def between_markers(page: str, text: str) -> str:
    """Return the page with this text between the markers of the measured tables."""
    head, _, tail = _split(page)
    return f"{head}{BEGIN}\n\n{text.strip()}\n\n{END}{tail}"


def _split(page: str) -> tuple[str, str, str]:
    head, _, rest = page.partition(BEGIN)
    text, found, tail = rest.partition(END)
    if not found:
        raise ValueError(f"the page must contain the markers {BEGIN} ... {END}")
    return head, text.strip(), tail
