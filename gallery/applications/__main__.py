# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m gallery.applications: run the commands of the applications, write pages and pictures.

Records of the runs are stored in gallery/applications/results.json. With --page, pages are written
from the stored records, without runs and pictures.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from importlib import import_module
from pathlib import Path
from typing import Any

from .application import Application
from .page import index, page, save
from .running import run

NAMES = (
    "bearing_overload", "dented_raceway", "misaligned_roller", "case_depth", "coated_gear",
    "running_in", "blade_root", "rail_traction", "coated_indentation",
)  # fmt: skip
DOCS = Path(__file__).resolve().parents[2] / "docs" / "applications"
RECORDS = Path(__file__).with_name("results.json")


def find(name: str) -> Application:
    """Return the application with this name."""
    found: Application = import_module(f"gallery.applications.{name}").APPLICATION
    return found


def records() -> dict[str, Any]:
    """Return the stored records by name."""
    stored: dict[str, Any] = {}
    if RECORDS.exists():
        stored = json.loads(RECORDS.read_text(encoding="utf-8"))
    return stored


def texts(stored: dict[str, Any]) -> dict[str, str]:
    """Return the text of each page with a stored record, by file name."""
    found = [find(name) for name in NAMES if name in stored]
    pages = {f"{one.name}.md": page(one, stored[one.name]) for one in found}
    return pages | {"index.md": index(found, stored)}


def main(given: list[str] | None = None) -> None:
    """Run the commands of the chosen applications, and write all pages."""
    parser = argparse.ArgumentParser(prog="python -m gallery.applications", description=__doc__)
    parser.add_argument("names", nargs="*", choices=[[], *NAMES], metavar="NAME")
    parser.add_argument("--page", action="store_true", help="only write the pages")
    chosen = parser.parse_args(given)
    DOCS.mkdir(parents=True, exist_ok=True)
    stored = records()
    for name in () if chosen.page else chosen.names or NAMES:
        application = find(name)
        with tempfile.TemporaryDirectory() as folder:
            work, record = run(application, Path(folder))
            save(application.picture(work), DOCS / f"{name}.png")
        print(name, *(f"{a['key']} {a['value']:.5g}" for a in record["answers"]), flush=True)
        stored = records() | {name: record}  # another process may have stored records
        ordered = {one: stored[one] for one in NAMES if one in stored}
        text = json.dumps(ordered, ensure_ascii=False, indent=1)
        RECORDS.write_text(text + "\n", encoding="utf-8")
    for file, text in texts(stored).items():
        (DOCS / file).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
