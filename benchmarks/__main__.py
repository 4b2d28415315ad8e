# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks: measure, and write tables and diagrams. See docs/benchmarks.md."""

from __future__ import annotations

import argparse
import importlib
import os
import sys
import time
from pathlib import Path

from .harness import ROOT, run_tasks

PARTS = (
    "elastic_smooth",
    "elastic_rough",
    "slip",
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
    "fatigue",
    "scaling",
    "counts",
    "threads",
)
# Only where they are asked for.
LARGE = ("plastic_zones_large",)


def arguments(given: list[str] | None = None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    usual = [name for name in PARTS if name not in LARGE]
    parser.add_argument(
        "parts", nargs="*", help=f"default: {', '.join(usual)}; also: {', '.join(LARGE)}"
    )
    parser.add_argument("--quick", action="store_true", help="small sizes, about two minutes")
    parser.add_argument("--threads", type=int, default=1, help="OMP_NUM_THREADS (1)")
    parser.add_argument("--output", type=Path, default=ROOT / "results" / "benchmarks")
    parser.add_argument(
        "--docs", action="store_true", help="also put their tables into docs/benchmarks.md"
    )
    parser.add_argument(
        "--notes", action="store_true", help="only make the sentences below its tables anew"
    )
    chosen = parser.parse_args(given)
    unknown = set(chosen.parts) - set(PARTS)
    if unknown:
        parser.error(f"unknown part {', '.join(sorted(unknown))}: choose from {', '.join(PARTS)}")
    chosen.parts = chosen.parts or usual
    return chosen


def main(given: list[str] | None = None) -> int:
    chosen = arguments(given)
    os.environ["OMP_NUM_THREADS"] = str(chosen.threads)
    os.environ.setdefault("MPLBACKEND", "Agg")
    # Only now: matplotlib reads its backend when it is imported.
    from . import plots, tables

    page = ROOT / "docs" / "benchmarks.md"
    if chosen.notes:
        every = [importlib.import_module(f"benchmarks.{name}") for name in PARTS]
        page.write_text(tables.noted(page.read_text(encoding="utf-8"), every), encoding="utf-8")
        return 0
    folder = chosen.output.resolve()
    (folder / "data").mkdir(parents=True, exist_ok=True)
    parts = [importlib.import_module(f"benchmarks.{name}") for name in chosen.parts]
    rows = []
    start = time.perf_counter()
    for part in parts:
        rows += run_tasks(part.tasks(chosen.quick, folder / "data"), report=print_now)
        table = tables.frame(rows)
        table.to_csv(folder / "work_precision.csv", index=False)
        (folder / "work_precision.md").write_text(tables.report(table, parts), encoding="utf-8")
        plots.write(table[table["part"] == part.NAME], part, folder)
    if chosen.docs:
        old = page.read_text(encoding="utf-8")
        text = tables.report(table, parts, times=False)
        titles = [importlib.import_module(f"benchmarks.{name}").TITLE for name in PARTS]
        text = tables.with_sections(tables.inside_markers(old), text, titles)
        # Sentences of the table as it is read, with the digits that it has.
        made = tables.noted(tables.between_markers(old, text), parts)
        page.write_text(made, encoding="utf-8")
    failed = [row for row in rows if "failed" in row]
    print(f"{len(rows)} measurements in {time.perf_counter() - start:.0f} s: {folder}")
    for row in failed:
        print(f"failed: {row['part']}, {row['case']}, {row['options']}: {row['failed']}")
    return 1 if failed else 0


def print_now(line: str) -> None:
    print(line, flush=True)


if __name__ == "__main__":
    sys.exit(main())
