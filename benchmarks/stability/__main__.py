# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.stability: what extreme scenes cost and lose.

What was found is kept in results.json, each row beside those that are there; --docs writes the page
of the documentation.
"""

from __future__ import annotations

import argparse
import sys
import time
import warnings

from ..harness import ROOT
from .page import TABLES, keep, kept, page

PAGE = ROOT / "docs" / "stability.md"


def main(given: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.stability", description=__doc__)
    names = [known.name for known in TABLES]
    parser.add_argument("tables", nargs="*", help=f"default: all of {', '.join(names)}")
    parser.add_argument("--rows", metavar="TEXT", default="", help="only those that contain it")
    parser.add_argument("--docs", action="store_true", help="keep them, and write the page")
    parser.add_argument("--page", action="store_true", help="only that, of what is kept")
    chosen = parser.parse_args(given)
    unknown = set(chosen.tables) - set(names)
    if unknown:
        parser.error(f"unknown table {', '.join(sorted(unknown))}: choose from {', '.join(names)}")
    results = kept()
    for known in TABLES:
        if chosen.page or known.name not in (chosen.tables or names):
            continue
        for row in (row for row in known.rows if chosen.rows in row):
            begin = time.process_time()
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # grids are small, and loads any
                solved = known.solve(row)
            found = {
                name: value if value is None else float(f"{value:.6g}")
                for name, value in solved.items()
            }
            results = kept()  # another run may have added to it
            results.setdefault(known.name, {})[row] = found
            took = time.process_time() - begin
            print(f"{known.name}, {row}: {found}, {took:.1f} s", flush=True)
            if chosen.docs:
                keep(results)
    missing = [known.name for known in TABLES if known.name not in results]
    if missing and (chosen.docs or chosen.page):
        print(f"no page without {', '.join(missing)}", file=sys.stderr)
    elif chosen.docs or chosen.page:
        PAGE.write_text(page(results), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
