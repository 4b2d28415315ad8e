# SPDX-License-Identifier: GPL-3.0-or-later
"""Directive ``materials-table``: tables of the library of materials with the sources."""

from __future__ import annotations

from pathlib import Path

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from samcontact import materials

DATA = Path(materials.__file__).with_name("data.py")


def table(entry: materials.MaterialData) -> list[str]:
    """Return the heading and the table of a material, as lines of Markdown."""
    also = f" Also called {', '.join(entry.aliases)}." if entry.aliases else ""
    text = entry.description[0].upper() + entry.description[1:]
    laws = ", ".join(f'"{law}"' for law in entry.laws) or "none, because constants are missing"
    lines = [f"## {entry.name}", "", f"{text}.{also} Laws: {laws}.", ""]
    lines += ["| constant | value | source | condition |", "|---|---|---|---|"]
    for name, known in entry.values.items():
        lines.append(f"| `{name}` | {known} | {known.source} | {known.condition} |")
    return [*lines, ""]


class MaterialsTable(SphinxDirective):
    """Directive that shows one table for each material of the library."""

    def run(self) -> list[nodes.Node]:
        self.env.note_dependency(str(DATA))
        lines = [line for name in materials.names() for line in table(materials.get(name))]
        return self.parse_text_to_nodes("\n".join(lines), allow_section_headings=True)


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_directive("materials-table", MaterialsTable)
    return {"parallel_read_safe": True}
