# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m gallery: compute figures and stated values of Boucly's thesis. See docs/gallery.md."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from . import parts

OUTPUT = Path(__file__).resolve().parents[1] / "results" / "gallery"


def main(given: list[str] | None = None) -> int:
    """Return 1 if a computed value differs from the thesis, else 0; invalid input exits with 2."""
    parser = argparse.ArgumentParser(prog="python -m gallery", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="PART | FIGURE", help="default: all parts")
    parser.add_argument("--quick", action="store_true", help="coarse grids")
    parser.add_argument("--list", action="store_true", help="print the parts and their figures")
    parser.add_argument("--output", type=Path, default=OUTPUT, help="folder of the pages")
    chosen = parser.parse_args(given)
    if chosen.list:
        for name in parts.PARTS:
            print(f"{name:<22}{parts.figures_of(name)}")
        return 0
    try:
        names = dict.fromkeys(map(parts.part_of, chosen.names)) or parts.PARTS
    except ValueError as error:
        parser.error(str(error))
    return int(parts.make(list(names), chosen.output, chosen.quick) > 0)


if __name__ == "__main__":
    sys.exit(main())
