# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.scale: what the main jobs cost against their size.

On one thread: OMP_NUM_THREADS must be 1. What was measured is kept in results.json, each size of
each job beside those that are there; --docs writes the page of the documentation.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from typing import Any

from ..harness import ROOT, Task, measure
from .jobs import JOBS
from .page import KEPT, kept, page

PAGE = ROOT / "docs" / "scale.md"


def solve(sizes: slice, functions: list[str]) -> list[dict[str, Any]]:
    """These sizes of these jobs, each in a process of its own."""
    found = []
    for job in (job for job in JOBS if job.function in functions):
        for n in job.sizes[sizes]:
            given = {"job": job.function, "n": n}
            row = measure(Task("scale.jobs", job.function, "", "measure", given))
            if "failed" in row:
                raise RuntimeError(f"{job.name}, {n}: {row['failed']}")
            for name in ("part", "method", "options", "time_s"):
                del row[name]
            found.append(row)
            print(f"{job.name}: {row}", flush=True)
    return found


def main(given: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.scale", description=__doc__)
    names = [job.function for job in JOBS]
    parser.add_argument("jobs", nargs="*", help=f"default: all of {', '.join(names)}")
    parser.add_argument("--smallest", type=int, metavar="K", help="only K sizes of each job")
    parser.add_argument("--largest", type=int, metavar="K", help="only K sizes of each job")
    parser.add_argument("--docs", action="store_true", help="keep them, and write the page")
    parser.add_argument("--page", action="store_true", help="only that, of what is kept")
    chosen = parser.parse_args(given)
    unknown = set(chosen.jobs) - set(names)
    if unknown:
        parser.error(f"unknown job {', '.join(sorted(unknown))}: choose from {', '.join(names)}")
    if not chosen.page:
        if os.environ.get("OMP_NUM_THREADS") != "1":
            parser.error("times are those of one thread: set OMP_NUM_THREADS=1")
        largest = -chosen.largest if chosen.largest else None
        new = solve(slice(largest, chosen.smallest), chosen.jobs or names)
        if chosen.docs:
            rows = {(row["case"], row["n"]): row for row in [*kept(), *new]}
            order = [rows[job.function, n] for job in JOBS for n in job.sizes
                     if (job.function, n) in rows]  # fmt: skip
            lines = ",\n".join(json.dumps(row) for row in order)
            KEPT.write_text(f"[\n{lines}\n]\n", encoding="utf-8")
    if chosen.docs or chosen.page:
        PAGE.write_text(page(kept()), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
