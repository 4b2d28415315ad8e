# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m gallery: compute the figures and stated values of the thesis. See docs/gallery.md."""

from __future__ import annotations

import argparse
import importlib
import os
import sys
import time
from pathlib import Path

from . import page

ROOT = Path(__file__).resolve().parents[1]
PARTS = (
    "nano_indentation",
    "flattening",
    "two_plastic_bodies",
    "friction",
    "heat",
    "transient_heat",
    "rolling",
    "rolling_ellipticity",
    "rolling_load",
    "rolling_two_bodies",
    "tugging",
    "wear",
    "running_in",
)


def arguments(given: list[str] | None = None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m gallery", description=__doc__)
    parser.add_argument("parts", nargs="*", help=f"default: all of {', '.join(PARTS)}")
    parser.add_argument("--quick", action="store_true", help="coarse grids")
    parser.add_argument("--output", type=Path, default=ROOT / "docs" / "gallery")
    chosen = parser.parse_args(given)
    unknown = set(chosen.parts) - set(PARTS)
    if unknown:
        parser.error(f"unknown part {', '.join(sorted(unknown))}: choose from {', '.join(PARTS)}")
    chosen.parts = chosen.parts or list(PARTS)
    return chosen


def main(given: list[str] | None = None) -> int:
    chosen = arguments(given)
    os.environ.setdefault("MPLBACKEND", "Agg")
    failed = 0
    for name in chosen.parts:
        start = time.perf_counter()
        part = importlib.import_module(f"gallery.{name}")
        entries = page.write(name, part, part.compute(chosen.quick), chosen.output.resolve())
        wrong = [entry for entry in entries if not entry.holds]
        failed += len(wrong)
        seconds = time.perf_counter() - start
        print(f"{name}: {len(entries)} stated values, {len(wrong)} differ, {seconds:.0f} s")
        for entry in wrong:
            print(f"  {entry.quantity}: thesis {entry.thesis}, computed {entry.ours}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
