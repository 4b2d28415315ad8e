# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.peers: samcontact beside other open codes. See docs/peers.md."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

from ..harness import ROOT
from .running import ONE_THREAD

STORED = Path(__file__).with_name("results.json")


def arguments(given: list[str] | None = None) -> argparse.Namespace:
    from .schedule import PROBLEMS

    parser = argparse.ArgumentParser(prog="python -m benchmarks.peers", description=__doc__)
    parser.add_argument("problems", nargs="*", help=f"default: all of {', '.join(PROBLEMS)}")
    parser.add_argument("--quick", action="store_true", help="small grids; the page is left alone")
    parser.add_argument("--rounds", type=int, default=3, help="measurements of each (3)")
    parser.add_argument("--limit", type=float, default=60.0, help="s for one measurement (60)")
    parser.add_argument("--fresh", action="store_true", help="forget what is measured already")
    parser.add_argument("--page", action="store_true", help="only write the page and figures")
    parser.add_argument(
        "--processor-time", action="store_true", help="where other work runs beside; no wall clock"
    )
    parser.add_argument("--folder", type=Path, default=ROOT / "results" / "benchmarks" / "peers")
    chosen = parser.parse_args(given)
    unknown = set(chosen.problems) - set(PROBLEMS)
    if unknown:
        parser.error(f"unknown {', '.join(sorted(unknown))}: choose from {', '.join(PROBLEMS)}")
    chosen.problems = chosen.problems or list(PROBLEMS)
    return chosen


def main(given: list[str] | None = None) -> int:
    os.environ.update(ONE_THREAD)
    os.environ.setdefault("MPLBACKEND", "Agg")
    # Only now: the codes read their number of threads when they are imported.
    from . import figures, page
    from .schedule import Results, measure_all

    chosen = arguments(given)
    folder = chosen.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "quick.json" if chosen.quick else STORED
    if chosen.fresh:
        file.unlink(missing_ok=True)
    results = Results(file)
    if not chosen.page:
        measure_all(
            chosen.problems,
            results,
            folder,
            quick=chosen.quick,
            rounds=chosen.rounds,
            limit=chosen.limit,
            clock="process_time" if chosen.processor_time else "perf_counter",
            report=lambda line: print(line, flush=True),
        )
    if chosen.quick:
        print(page.tables_of(results.data))
    else:
        page.write(results.data)
        figures.write(results.data)
    return 0


if __name__ == "__main__":
    sys.exit(main())
