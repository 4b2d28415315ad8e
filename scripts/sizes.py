#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines of the sources by room, and of their unit tests: python scripts/sizes.py [--since REV].

The rooms of the core that consist of rooms are listed by these. With --since, the lines of an
earlier revision and the growth are added.
"""

from __future__ import annotations

import argparse
import subprocess
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
MAX_LINES = 6000
"""Largest number of lines of a room; a room above it is divided, or its reason is stated."""
DIVIDED = ("contact", "operators", "simulation")
"""Rooms of the core that consist of rooms."""
FOLDERS = ("python/samcontact", "cpp/src", "cpp/include", "cpp/bindings", "cpp/tests", "tests/unit")
SUFFIXES = (".py", ".cpp", ".hpp")


def lines_of_files(revision: str = "") -> dict[str, int]:
    """Return the number of lines of each file under version control, by path."""
    words = ["git", "grep", "-c", "", *([revision] if revision else []), "--", *FOLDERS]
    found = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=True).stdout
    counts = {}
    for line in found.splitlines():
        path, _, count = line.removeprefix(f"{revision}:" if revision else "").rpartition(":")
        if path.endswith(SUFFIXES):
            counts[path] = int(count)
    return counts


def room_of(path: str) -> tuple[str, bool] | None:
    """Return the room of a file, and whether it is a test; None for files of no room."""
    parts = Path(path).parts
    inner = parts[2:]
    if parts[:2] == ("python", "samcontact"):
        return f"samcontact.{Path(inner[0]).stem}", False
    if parts[:2] == ("tests", "unit"):
        return (f"samcontact.{inner[0]}", True) if len(inner) > 1 else None
    if parts[:2] == ("cpp", "bindings"):
        return "cpp/bindings", False
    if parts[:2] == ("cpp", "tests"):
        return "cpp/tests", True
    inner = inner[1:] if parts[:2] == ("cpp", "include") else inner
    if inner[0] in DIVIDED:
        return f"cpp/{inner[0]}/{inner[1] if len(inner) > 2 else ''}".rstrip("/"), False
    return f"cpp/{inner[0]}", False


def by_room(counts: dict[str, int]) -> dict[str, list[int]]:
    """Return the lines of source and of unit tests of each room, by name."""
    found: dict[str, list[int]] = defaultdict(lambda: [0, 0])
    for path, count in counts.items():
        room = room_of(path)
        if room is not None:
            found[room[0]][room[1]] += count
    return dict(sorted(found.items()))


def table(now: dict[str, list[int]], before: dict[str, list[int]] | None = None) -> str:
    """Return the Markdown table of rooms, with a last line of sums."""
    more = ["lines before", "growth"] if before is not None else []
    rows = [["room", "lines", "lines of unit tests", *more]]
    rows.append(["---"] * len(rows[0]))
    for room in sorted({*now, *(before or {})}):
        source, tests = now.get(room, [0, 0])
        past = [] if before is None else [sum(before.get(room, [0, 0]))]
        grown = [] if before is None else [source + tests - past[0]]
        rows.append([f"`{room}`", str(source), str(tests), *map(str, past), *map(str, grown)])
    sums = [sum(int(row[k]) for row in rows[2:]) for k in range(1, len(rows[0]))]
    rows.append(["all", *map(str, sums)])
    return "\n".join(f"| {' | '.join(row)} |" for row in rows)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--since", metavar="REV", help="Revision to compare with.")
    revision = parser.parse_args().since
    print(table(by_room(lines_of_files()), by_room(lines_of_files(revision)) if revision else None))


if __name__ == "__main__":
    main()
