# SPDX-License-Identifier: GPL-3.0-or-later
"""No line break between a number and its unit."""

from __future__ import annotations

import re

from docutils import nodes
from sphinx.application import Sphinx

UNIT = r"%|°C|[GMk]?Pa|[GMkmµn]?[NmsJW]|[kMGT]?B|K|Hz|HV|HRC|m?rad|min|h|mm²|m²|µm²|µm³|mm³|mJ/m²"
BEFORE_A_UNIT = re.compile(rf"(?<=[\d⁻⁰¹²³⁴⁵⁶⁷⁸⁹]) (?=(?:{UNIT})(?![\w-]))")

LITERAL = (nodes.FixedTextElement, nodes.literal, nodes.math, nodes.math_block, nodes.raw)


def keep_together(app: Sphinx, doctree: nodes.document, docname: str) -> None:
    """Write a no-break space between numbers and units of the text, not of code or formulas."""
    for text in list(doctree.findall(nodes.Text)):
        joined = BEFORE_A_UNIT.sub("\N{NO-BREAK SPACE}", text)
        if joined != text and text.parent is not None and not isinstance(text.parent, LITERAL):
            text.parent.replace(text, nodes.Text(joined))


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("doctree-resolved", keep_together)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
