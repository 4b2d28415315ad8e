# SPDX-License-Identifier: GPL-3.0-or-later
"""The documentation site: python -m sphinx -W docs build/site."""

import sys
from pathlib import Path

import samcontact

sys.path.insert(0, str(Path(__file__).parent / "_ext"))

project = "samcontact"
author = copyright = "The samcontact developers"
version = release = samcontact.__version__

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.mathjax",
    "sphinx.ext.napoleon",
    "sphinx.ext.viewcode",
    "case_schema",
]
exclude_patterns = ["_ext"]
nitpicky = False  # units in numpydoc types are no references

myst_enable_extensions = ["dollarmath", "colon_fence"]
myst_heading_anchors = 3

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_default_options = {"members": True, "show-inheritance": True}
napoleon_google_docstring = False
napoleon_use_rtype = False

html_theme = "furo"
html_title = f"samcontact {release}"
html_copy_source = False


def _link_to_pages(app, relative_path, parent_docname, content):
    """Files of the root that pages include link to each other, and to pages in docs."""
    content[0] = content[0].replace("](CHANGELOG.md)", "](changes.md)").replace("](docs/", "](")


def setup(app):
    app.connect("include-read", _link_to_pages)
