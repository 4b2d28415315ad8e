# SPDX-License-Identifier: GPL-3.0-or-later
"""Protocol of a part of the gallery, and output of its page.

A part is a module with a TITLE, an INTRODUCTION (Markdown), and three functions:
`compute(quick)` solves its cases, on coarse grids when quick; `stated(results)` lists what the
thesis states and the computed values; `figures(results)` lists the figures.
"""

from __future__ import annotations

from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any, Protocol

from matplotlib.figure import Figure
from PIL import Image

from . import moves
from .stated import Number, Statement

_IMAGE: dict[str, Any] = {
    "dpi": 80, "metadata": {"Software": None}, "bbox_inches": "tight", "pad_inches": 0.08
}  # fmt: skip

UNSTATED = ("not stated", "not compared")
"""Texts for values on which the thesis makes no statement."""


@dataclass(frozen=True)
class Picture:
    """Figure with file name and caption; the caption starts with the thesis's figure number."""

    name: str
    caption: str
    figure: Figure

    def save(self, folder: Path) -> None:
        """Write NAME.png with a colour palette, which takes a third of the bytes of full colour."""
        drawn = BytesIO()
        self.figure.savefig(drawn, **_IMAGE)
        with Image.open(drawn) as image:
            few = image.convert("RGB").quantize(256)
        few.save(folder / f"{self.name}.png", optimize=True, dpi=(_IMAGE["dpi"], _IMAGE["dpi"]))


class Part(Protocol):
    """Module of a gallery part; each part defines the type of its results."""

    TITLE: str
    INTRODUCTION: str

    def compute(self, quick: bool) -> Any: ...

    def stated(self, results: Any) -> list[Number | Statement]: ...

    def figures(self, results: Any) -> list[Picture]: ...


def digits(value: float) -> str:
    """Return a number with four digits, or rounded to an integer if it has more integer digits."""
    return f"{value:.4g}" if abs(value) < 1e4 else f"{value:.0f}"


def table(entries: list[Number | Statement], moved: list[moves.Moves]) -> str:
    """Return the Markdown table of values from the thesis, computed values and sensitivities."""
    largest = moves.column(moved)
    heads = ["quantity", "thesis", "samcontact", "difference", "mesh"]
    heads += ["sensitivity"] * bool(moved)
    lines = [f"| {' | '.join(heads)} |", "|---" * len(heads) + "|"]
    remarks = []
    for entry in entries:
        note = ""
        if entry.remark:
            remarks.append(entry.remark)
            note = f" [{len(remarks)}]"
        if isinstance(entry, Number):
            unit = f" {entry.unit}" if entry.unit else ""
            off = f"{100 * entry.difference:+.1f} %"
            cells = (
                f"{digits(entry.thesis)}{unit}",
                f"{digits(entry.ours)}{unit}",
                off if off[1:] != "0.0 %" else off[1:],  # zero has no sign
            )
        else:
            agrees = "" if entry.thesis in UNSTATED else "agrees"
            agreement = agrees if entry.holds and not entry.contradicted else "differs"
            cells = (entry.thesis, entry.ours, agreement)
        moves_by = [largest.get(moves.words(entry.quantity), "")] * bool(moved)
        lines.append(f"| {' | '.join([entry.quantity + note, *cells, entry.mesh, *moves_by])} |")
    text = "\n".join(lines) + "\n" + ("\n" + moves.note(moved)) * bool(moved)
    if remarks:
        text += "\n" + "\n".join(f"{n}. {remark}" for n, remark in enumerate(remarks, 1)) + "\n"
    return text


def write(name: str, part: Part, results: Any, folder: Path) -> list[Number | Statement]:
    """Write page and figures of a part; return the values of the thesis with computed values."""
    folder.mkdir(parents=True, exist_ok=True)
    entries = part.stated(results)
    text = [
        "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->",
        f"<!-- Written by: python -m gallery {name} -->",
        f"# {part.TITLE}\n",
        part.INTRODUCTION.strip() + "\n",
        table(entries, moves.of_part(name, moves.kept())),
    ]
    for picture in part.figures(results):
        picture.save(folder)
        text.append(f"![{picture.caption}]({picture.name}.png)\n\n{picture.caption}\n")
    (folder / f"{name}.md").write_text("\n".join(text), encoding="utf-8")
    return entries
