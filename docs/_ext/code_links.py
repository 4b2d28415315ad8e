# SPDX-License-Identifier: GPL-3.0-or-later
"""Links from code in the text of pages, such as `sc.hertz.point(...)`, to the reference."""

from __future__ import annotations

import re

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.nodes import make_refnode

NAME = re.compile(r"(?:sc|samcontact)\.([A-Za-z_][\w.]*\w)(?:\(.*\))?")


def target(app: Sphinx, code: str) -> tuple[str, str] | None:
    """Page and anchor of a public object in the API reference; None if there is none."""
    found = NAME.fullmatch(code)
    if not found:
        return None
    known = app.env.get_domain("py").objects
    entry = known.get(f"samcontact.{found[1]}")
    return (entry.docname, entry.node_id) if entry else None


def link(app: Sphinx, doctree: nodes.document, docname: str) -> None:
    """Turn each code literal that names a public object into a link, except inside links."""
    for node in list(doctree.findall(nodes.literal)):
        place = None if isinstance(node.parent, nodes.reference) else target(app, node.astext())
        if place and place[0] != docname:
            made = make_refnode(app.builder, docname, place[0], place[1], node.deepcopy())
            node.replace_self(made)


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("doctree-resolved", link)
    return {"parallel_read_safe": True}
