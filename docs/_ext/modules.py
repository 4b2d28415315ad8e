# SPDX-License-Identifier: GPL-3.0-or-later
"""Directives ``python-rooms`` and ``module-table``: tables of the first lines of the sources.

``python-rooms`` is a table of the rooms of the Python package. ``module-table cpp`` and
``module-table python`` are tables of all headers and of all modules, one for each folder.
"""

from __future__ import annotations

import ast
import re
from collections import defaultdict
from pathlib import Path

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "python" / "samcontact"
INCLUDE = ROOT / "cpp" / "include" / "samcontact"


def first_sentence(text: str) -> str:
    """First sentence of the first paragraph of a text, on one line."""
    line = " ".join(text.strip().partition("\n\n")[0].split())
    return re.split(r"(?<=\w[.:)`\"])\s+(?=[A-Z`])", line)[0].rstrip(":").replace("|", r"\|")


def says(file: Path) -> str:
    """First sentence of a module's docstring, or of the comment at the top of a header."""
    text = file.read_text(encoding="utf-8")
    if file.suffix == ".py":
        return first_sentence(ast.get_docstring(ast.parse(text)) or "")
    lines = text.partition("#pragma once")[0].splitlines()[1:]
    return first_sentence("\n".join(line.removeprefix("//").strip() for line in lines))


def folders(language: str) -> dict[str, dict[str, str]]:
    """Return the first sentence of each file, by folder and file name; "" is the top folder."""
    top, pattern = (INCLUDE, "*.hpp") if language == "cpp" else (PACKAGE, "*.py")
    found: dict[str, dict[str, str]] = defaultdict(dict)
    for file in sorted(top.rglob(pattern)):
        if not file.stem.startswith("__"):
            found[file.parent.relative_to(top).as_posix()][file.stem] = says(file)
    return {"" if folder == "." else folder: files for folder, files in sorted(found.items())}


def table(heading: str, rows: dict[str, str]) -> list[str]:
    """Return a table of names with their descriptions, as lines of Markdown."""
    lines = ["", f"| {heading} | |", "|---|---|"]
    return [*lines, *(f"| `{name}` | {text} |" for name, text in rows.items()), ""]


class _OfSources(SphinxDirective):
    """Base class of tables made from source files; a changed file rebuilds their pages."""

    def depend_on(self, folder: Path) -> None:
        for file in folder.rglob("*.?p*"):
            self.env.note_dependency(str(file))


class PythonRooms(_OfSources):
    """Directive that shows a table of the folders and public modules of the package."""

    def run(self) -> list[nodes.Node]:
        self.depend_on(PACKAGE)
        rooms = {file.parent.name: says(file) for file in PACKAGE.glob("*/__init__.py")}
        rooms |= folders("python")[""]
        return self.parse_text_to_nodes("\n".join(table("room", dict(sorted(rooms.items())))))


class ModuleTable(_OfSources):
    """Directive that shows one table of headers or modules for each folder."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        language, lines = self.arguments[0], []
        top, kind = (INCLUDE, "header") if language == "cpp" else (PACKAGE, "module")
        self.depend_on(top)
        for folder, files in folders(language).items():
            start = top / folder / "__init__.py"
            said = f": {says(start)}" if start.exists() else ""
            lines += ["", f"**{folder or top.name}**{said}", *table(kind, files)]
        return [
            nodes.container(
                "", *self.parse_text_to_nodes("\n".join(lines)), classes=["files", "modules"]
            )
        ]


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_directive("python-rooms", PythonRooms)
    app.add_directive("module-table", ModuleTable)
    return {"parallel_read_safe": True}
