# SPDX-License-Identifier: GPL-3.0-or-later
"""The directive ``notebook-cards``: all notebooks, each with its most colourful picture."""

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
"""Pixels of a picture at most: twice those of a card, for fine screens."""


def pictures(notebook: Any) -> Iterator[Image.Image]:
    """All that the cells of an executed notebook draw."""
    for cell in notebook.cells:
        for output in cell.get("outputs", ()):
            if encoded := output.get("data", {}).get("image/png"):
                yield Image.open(io.BytesIO(base64.b64decode(encoded))).convert("RGB")


def colour(picture: Image.Image) -> float:
    """The part of a picture that is neither grey nor white."""
    small = np.asarray(picture.resize((90, 60), Image.Resampling.BOX), dtype=int)
    return float(np.mean(np.ptp(small, axis=2) > 40))


def card(name: str, notebook: Any) -> str:
    """A row of the table: picture and title, both links."""
    title = re.search(r"^# (.+)$", notebook.cells[0].source, re.MULTILINE)[1]
    picture = max(pictures(notebook), key=colour)
    picture.thumbnail(SIZE, Image.Resampling.LANCZOS)
    buffer = io.BytesIO()
    picture.quantize(128).save(buffer, "PNG", optimize=True)
    source = f"data:image/png;base64,{base64.b64encode(buffer.getvalue()).decode()}"
    # The folder of notebooks is a link, which paths of files are followed through.
    shown = f'<a href="notebooks/{name}.html"><img alt="{title}" src="{source}"></a>'
    return f"| {shown} | {{doc}}`{title} </notebooks/{name}>` |"


class NotebookCards(SphinxDirective):
    """A table of the notebooks, which the style sheet shows as cards."""

    def run(self) -> list[nodes.Node]:
        files = sorted(Path(self.env.srcdir, "notebooks").glob("*.ipynb"))
        rows = [card(file.stem, executed(nbformat.read(file, as_version=4))) for file in files]
        return self.parse_text_to_nodes("\n".join(["| | |", "|---|---|", *rows]))


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_directive("notebook-cards", NotebookCards)
    return {"parallel_read_safe": True}
