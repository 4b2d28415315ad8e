# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks: measure, and write tables and diagrams. See docs/benchmarks.md."""

from __future__ import annotations

import importlib
import os
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from types import ModuleType

import click

from .harness import ROOT, run_tasks

PARTS = (
    "elastic_smooth",
    "elastic_rough",
    "slip",
    "viscous",
    "plastic_smooth",
    "plastic_rough",
    "plastic_zones",
    "plastic_zones_large",
    "operators",
    "images",
    "layers",
    "nano_indentation",
    "heat",
    "rolling",
    "inclusions",
    "fatigue",
    "scaling",
    "counts",
    "threads",
    "busy",
    "small_contacts",
)
OPTIONAL_PARTS = ("plastic_zones_large",)  # measured on request only
DEFAULT_PARTS = tuple(name for name in PARTS if name not in OPTIONAL_PARTS)
PAGE = ROOT / "docs" / "benchmarks.md"


@click.command(help=__doc__)
@click.argument("parts", nargs=-1, metavar="[PART]...", type=click.Choice(PARTS))
@click.option("--quick", is_flag=True, help="Small sizes, about two minutes.")
@click.option("--threads", default=1, help="OMP_NUM_THREADS (1).")
@click.option("--output", type=Path, default=ROOT / "results" / "benchmarks", help="Folder.")
@click.option("--docs", is_flag=True, help="Also write the tables into docs/benchmarks.md.")
@click.option("--notes", is_flag=True, help="Only rewrite the sentences below the tables.")
def main(
    parts: tuple[str, ...], quick: bool, threads: int, output: Path, docs: bool, notes: bool
) -> None:
    """Measure the given parts (default: all but the large parts); exit code 1 if a part fails."""
    if notes:
        write_notes()
    else:
        sys.exit(measure(parts or DEFAULT_PARTS, quick, threads, output.resolve(), docs))


def module(name: str) -> ModuleType:
    return importlib.import_module(f"benchmarks.{name}")


def write_notes() -> None:
    """Rewrite the sentences on the page of benchmarks from the numbers in its tables."""
    from . import tables

    text = tables.noted(PAGE.read_text(encoding="utf-8"), [module(name) for name in PARTS])
    PAGE.write_text(text, encoding="utf-8")


def measure(names: Sequence[str], quick: bool, threads: int, folder: Path, docs: bool) -> int:
    """Measure parts and write their tables and diagrams."""
    os.environ["OMP_NUM_THREADS"] = str(threads)
    os.environ.setdefault("MPLBACKEND", "Agg")
    # Imported late: matplotlib reads its backend at import.
    from . import plots, tables

    (folder / "data").mkdir(parents=True, exist_ok=True)
    parts = [module(name) for name in names]
    rows = []
    start = time.perf_counter()
    for part in parts:
        rows += run_tasks(part.tasks(quick, folder / "data"), report=click.echo)
        table = tables.frame(rows)
        table.to_csv(folder / "work_precision.csv", index=False)
        (folder / "work_precision.md").write_text(tables.report(table, parts), encoding="utf-8")
        plots.write(table[table["part"] == part.NAME], part, folder)
    if docs:
        old = PAGE.read_text(encoding="utf-8")
        text = tables.report(table, parts, times=False)
        titles = [module(name).TITLE for name in PARTS]
        text = tables.with_sections(tables.inside_markers(old), text, titles)
        # Sentences follow the table as read back, with its digits.
        made = tables.noted(tables.between_markers(old, text), parts)
        PAGE.write_text(made, encoding="utf-8")
    failed = [row for row in rows if "failed" in row]
    click.echo(f"{len(rows)} measurements in {time.perf_counter() - start:.0f} s: {folder}")
    for row in failed:
        click.echo(f"failed: {row['part']}, {row['case']}, {row['options']}: {row['failed']}")
    return 1 if failed else 0


if __name__ == "__main__":
    main(prog_name="python -m benchmarks")
