# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of the gallery, the thesis figures of each part, and their computation."""

from __future__ import annotations

import difflib
import importlib
import time
from collections.abc import Sequence
from pathlib import Path

from . import page

# by part: numbers of thesis figures, single numbers or (first, last)
PARTS: dict[str, tuple[str | tuple[str, str], ...]] = {
    "nano_indentation": ("2.9", "2.14", "2.15"),
    "flattening": (("2.10", "2.13"),),
    "two_plastic_bodies": (("2.16", "2.20"),),
    "friction": (("2.35", "2.59"),),
    "heat": (("2.21", "2.34"),),
    "transient_heat": (("3.34", "3.36"),),
    "rolling": (("3.8", "3.17"),),
    "rolling_ellipticity": (("3.18", "3.24"),),
    "rolling_load": (("3.25", "3.28"),),
    "rolling_two_bodies": (("3.29", "3.33"),),
    "asperities": (("4.7", "4.11"),),
    "wear": (("5.9", "5.11"),),
    "running_in": (("5.12", "5.15"),),
}


def _number(figure: str) -> tuple[int, int]:
    part, number = figure.split(".")
    return int(part), int(number)


def figures_of(part: str) -> str:
    """Return the figure numbers of a part as text, e.g. "2.10 to 2.13"."""
    return ", ".join(f if isinstance(f, str) else f"{f[0]} to {f[1]}" for f in PARTS[part])


def part_of(name: str) -> str:
    """Return the part with this name, or with this figure of the thesis, e.g. "3.12".

    Raises a ValueError that lists the available parts.
    """
    if name in PARTS:
        return name
    if name.replace(".", "", 1).isdigit() and "." in name:
        number = _number(name)
        for part, figures in PARTS.items():
            for figure in figures:
                first, last = (figure, figure) if isinstance(figure, str) else figure
                if _number(first) <= number <= _number(last):
                    return part
        raise ValueError(f"figure {name} is not in the gallery: see `python -m gallery --list`")
    near = difflib.get_close_matches(name, PARTS, 1)
    hint = f"did you mean {near[0]}?" if near else f"choose from {', '.join(PARTS)}"
    raise ValueError(f"unknown part {name!r} of the gallery: {hint}")


def make(parts: Sequence[str], folder: Path, quick: bool = False) -> int:
    """Write pages and figures of parts; return how many values differ from the thesis."""
    failed = 0
    for name in parts:
        start = time.perf_counter()
        part = importlib.import_module(f"{__package__}.{name}")
        entries = page.write(name, part, part.compute(quick), folder.resolve())
        wrong = [entry for entry in entries if not entry.holds]
        failed += len(wrong)
        seconds = time.perf_counter() - start
        print(f"{name}: {len(entries)} stated values, {len(wrong)} differ, {seconds:.0f} s")
        print(f"  {folder / name}.md", flush=True)
        for entry in wrong:
            print(f"  {entry.quantity}: thesis {entry.thesis}, computed {entry.ours}")
    return failed
