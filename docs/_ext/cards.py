# SPDX-License-Identifier: GPL-3.0-or-later
"""Directives for tables of linked pictures, which the style sheet shows as cards.

``notebook-cards`` shows all notebooks. ``page-cards`` shows one page for each line of its content.
A line has the form "picture | page | title | text". The picture is a file of the repository, or
"notebook 12", which stands for the most colourful picture of notebook 12.
"""

from __future__ import annotations

import base64
import io
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import nbformat
import numpy as np
from docutils import nodes
from executed import executed
from PIL import Image
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

SIZE = 480, 320
"""Maximum size of a picture in pixels: twice the size of a card, for high-resolution screens."""


def pictures(notebook: Any) -> Iterator[Image.Image]:
    """Yield all pictures in the outputs of an executed notebook."""
    for cell in notebook.cells:
        for output in cell.get("outputs", ()):
            if encoded := output.get("data", {}).get("image/png"):
                yield Image.open(io.BytesIO(base64.b64decode(encoded))).convert("RGB")


def colour(picture: Image.Image) -> float:
    """Fraction of the pixels of a picture that are neither grey nor white."""
    small = np.asarray(picture.resize((90, 60), Image.Resampling.BOX), dtype=int)
    return float(np.mean(np.ptp(small, axis=2) > 40))


def encoded(picture: Image.Image) -> str:
    """Return a picture, reduced to `SIZE`, as a data URL with a PNG image."""
    picture.thumbnail(SIZE, Image.Resampling.LANCZOS)
    buffer = io.BytesIO()
    picture.quantize(128).save(buffer, "PNG", optimize=True)
    return f"data:image/png;base64,{base64.b64encode(buffer.getvalue()).decode()}"


def card(page: str, title: str, picture: Image.Image, text: str = "") -> str:
    """Table row with the picture and the title, which link to the page, and a line of text."""
    # HTML and a role, because Sphinx follows the link of the folder of notebooks in file paths.
    shown = f'<a href="{page}.html"><img alt="{title}" src="{encoded(picture)}"></a>'
    return f"| {shown} | {{doc}}`{title} </{page}>` | {text} |"


class _Cards(SphinxDirective):
    """Base class of the directives that show a table of cards."""

    def show(self, cards: list[str]) -> list[nodes.Node]:
        return self.parse_text_to_nodes("\n".join(["| | | |", "|---|---|---|", *cards]))

    def notebooks(self, pattern: str = "*") -> list[Path]:
        return sorted(Path(self.env.srcdir, "notebooks").glob(f"{pattern}.ipynb"))

    def notebook_picture(self, file: Path) -> Image.Image:
        """Most colourful picture of a notebook; white if the notebook is not executed."""
        if file.stem in self.config.unexecuted_notebooks:
            return Image.new("RGB", SIZE, "white")
        return max(pictures(executed(nbformat.read(file, as_version=4))), key=colour)


class NotebookCards(_Cards):
    """Directive that shows all notebooks, each with its most colourful picture."""

    def run(self) -> list[nodes.Node]:
        cards = []
        for file in self.notebooks():
            first = nbformat.read(file, as_version=4).cells[0].source
            title = re.search(r"^# (.+)$", first, re.MULTILINE)[1]
            cards.append(card(f"notebooks/{file.stem}", title, self.notebook_picture(file)))
        return self.show(cards)


class PageCards(_Cards):
    """Directive that shows given pages, each with a picture and a line of text."""

    has_content = True

    def run(self) -> list[nodes.Node]:
        cards = []
        for line in self.content:
            source, page, title, text = (part.strip() for part in line.split("|"))
            if source.startswith("notebook "):
                (file,) = self.notebooks(f"{source.removeprefix('notebook ')}_*")
                picture = self.notebook_picture(file)
            else:
                file = Path(self.env.srcdir).parent / source
                self.env.note_dependency(str(file))
                picture = Image.open(file).convert("RGB")
            cards.append(card(page, title, picture, text))
        return self.show(cards)


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_directive("notebook-cards", NotebookCards)
    app.add_directive("page-cards", PageCards)
    return {"parallel_read_safe": True}
