# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.static_capacity: which load leaves 1e-4 of the diameter, as a page.

With --docs all is solved anew, some five minutes on one thread; the page and its figure are made.
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
PAGE = ROOT / "docs" / "static_capacity.md"
FIGURE = ROOT / "docs" / "figures" / "static_capacity.png"
FINE = 20
GROOVE = "deep groove, inner race"


def solve() -> dict[str, Any]:
    from .scenes import CONTACTS, PRESSURES, STEEL, STEELS, press

    found: dict[str, Any] = {"contacts": {}, "steels": {}, "fine": {}}
    for name, contact in CONTACTS.items():
        pressures = sorted({*PRESSURES, contact.pressure})
        found["contacts"][name] = [press(contact, STEELS[STEEL], p0) for p0 in pressures]
        found["fine"][name] = press(contact, STEELS[STEEL], contact.pressure, FINE)
        print(name, found["fine"][name], flush=True)
    for name, steel in STEELS.items():
        found["steels"][name] = [press(CONTACTS[GROOVE], steel, p0) for p0 in PRESSURES]
        print(name, found["steels"][name][3], flush=True)
    return found


def main(given: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.static_capacity")
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
