# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.experiments: indentation beside what experiments found, as a page.

With --docs all is solved anew, some ten minutes on one thread; the page and its figure are made.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from pathlib import Path
from typing import Any

from ..harness import ROOT

KEPT = Path(__file__).with_name("results.json")
PAGE = ROOT / "docs" / "experiments.md"
FIGURE = ROOT / "docs" / "figures" / "experiments.png"
STIFFNESSES = (2.0, 2.5, 3.0, 4.0, 6.0, 9.0, 13.0, 20.0, 30.0, 45.0, 65.0, 100.0)
CELLS = (10, 14, 20)
SLOW = 60.0  # from which on the finest grid is left out
EXPONENTS = (0.1, 0.2, 0.3)
RADII = (0.02, 0.04)


def solve() -> dict[str, list[Any]]:
    from .indentation import hardening, perfect

    found: dict[str, list[Any]] = {"perfect": [], "hardening": []}
    for stiffness in STIFFNESSES:
        for cells in CELLS if stiffness < SLOW else CELLS[:2]:
            found["perfect"].append([stiffness, *perfect(stiffness, cells)])
            print(found["perfect"][-1], flush=True)
    for exponent in EXPONENTS:
        for radius in RADII:
            found["hardening"].append([exponent, *hardening(exponent, radius, CELLS[0])])
            print(found["hardening"][-1], flush=True)
    return found


def main(given: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.experiments")
    parser.add_argument("--docs", action="store_true", help="solve, and write page and figure")
    parser.add_argument("--page", action="store_true", help="page and figure of what is stored")
    chosen = parser.parse_args(given)
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    os.environ.setdefault("MPLBACKEND", "Agg")
    if not chosen.page:
        found = solve()
        if chosen.docs:
            KEPT.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    if chosen.docs or chosen.page:
        from .page import draw, kept, page

        PAGE.write_text(page(kept()), encoding="utf-8")
        draw(kept()).savefig(FIGURE, dpi=150)
    return 0


if __name__ == "__main__":
    sys.exit(main())
