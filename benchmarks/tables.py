# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of measurements as tables: CSV with everything, Markdown to read."""

from __future__ import annotations

import os
import platform
from types import ModuleType
from typing import Any

import pandas as pd

import samcontact as sc

# Columns in this order, where they have values; errors come after "across", others at the end.
FIRST = ("part", "case", "method", "options", "cells", "across")
WORK = (
    "time_s",
    "time_ratio",
    "memory_MB",
    "contact_iterations",
    "surface_applications",
    "volume_applications",
)
TIMES = ("time_s", "us_per_cell_and_application")  # mean something on one machine only


def frame(rows: list[dict[str, Any]]) -> pd.DataFrame:
    """All rows, columns in a fixed order."""
    table = pd.DataFrame(rows)
    errors = [c for c in table if c.startswith("error: ")]
    others = [c for c in table if c not in (*FIRST, *errors, *WORK)]
    wanted = [*FIRST, *errors, *WORK, *others]
    return table[[c for c in wanted if c in table]]


def cell(value: Any) -> str:
    """A number with three digits, a count in full, nothing for what is missing."""
    if isinstance(value, str):
        return value
    if pd.isna(value):
        return ""
    if float(value).is_integer() and abs(value) < 1e15:
        return f"{int(value)}"
    return f"{value:.3g}"


def markdown(table: pd.DataFrame) -> str:
    """A table without its empty columns."""
    kept = table.dropna(axis="columns", how="all")
    lines = [list(kept.columns), ["---"] * len(kept.columns)]
    lines += [[cell(value) for value in row] for row in kept.itertuples(index=False)]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def report(table: pd.DataFrame, parts: list[ModuleType], *, times: bool = True) -> str:
    """Markdown with a section for each part; without times it fits into the documentation."""
    sections = []
    for part in parts:
        rows = table[table["part"] == part.NAME]
        if rows.empty:
            continue
        hidden = ["part", "options", *(() if times else TIMES)]
        lines = [f"### {part.TITLE}", markdown(rows.drop(columns=hidden, errors="ignore"))]
        lines += part.notes(rows.to_dict("records")) if hasattr(part, "notes") else []
        sections.append("\n\n".join(lines))
    return "\n\n".join([environment(), *sections]) + "\n"


def environment() -> str:
    """What the measurements ran on."""
    threads = os.environ.get("OMP_NUM_THREADS", "all")
    return f"samcontact {sc.__version__}, {platform.machine()}, {threads} thread(s)."


def between_markers(page: str, text: str) -> str:
    """The page with the text between the markers of the measured tables."""
    begin, end = "<!-- measured: begin -->", "<!-- measured: end -->"
    head, _, rest = page.partition(begin)
    _, found, tail = rest.partition(end)
    if not found:
        raise ValueError(f"the page has no {begin} ... {end}")
    return f"{head}{begin}\n\n{text.strip()}\n\n{end}{tail}"
