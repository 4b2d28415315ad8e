# SPDX-License-Identifier: GPL-3.0-or-later
"""The documentation site: python -m sphinx -W docs build/site."""

import re
import sys
from importlib.util import find_spec
from pathlib import Path

from docutils import nodes
from PIL import Image
from pydantic import BaseModel
from sphinx.addnodes import pending_xref, toctree
from sphinx.util.inspect import TypeAliasForwardRef

import samcontact

sys.path.insert(0, str(Path(__file__).parent / "_ext"))

project = "samcontact"
author = copyright = "The samcontact developers"
version = release = samcontact.__version__

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.mathjax",
    "sphinx.ext.napoleon",
    "cards",
    "case_schema",
    "code_links",
    "executed",
    "figures",
    "materials",
    "modules",
    "units",
]
exclude_patterns = ["_ext", "notebooks/.ipynb_checkpoints"]
nitpicky = False  # units in numpydoc types are not references

myst_enable_extensions = ["dollarmath", "colon_fence"]
myst_heading_anchors = 4
executed_pages = ["index", "tutorial"]
nb_execution_mode = "off"  # notebooks come with outputs
nb_merge_streams = True

python_maximum_signature_line_length = 72  # then a line for each parameter
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_type_aliases = {name: name for name in ("ArrayLike", "FloatArray")}
# Aliases by name also within unions, and as types of properties.
TypeAliasForwardRef.__repr__ = lambda self: self.name
autodoc_default_options = {
    "members": True,
    "show-inheritance": True,
    "exclude-members": "model_config, model_post_init",  # pydantic's own
}
napoleon_google_docstring = False
napoleon_use_rtype = False

# One file, fonts included: formulas need no network.
_mathjax = Path(find_spec("sphinx-mathjax-offline").origin).parent / "static" / "mathjax"
mathjax_path = "tex-svg.js"
mathjax3_config = {"svg": {"scale": 0.88}}

html_theme = "furo"
html_static_path = ["_static", str(_mathjax / mathjax_path)]
html_css_files = ["site.css"]
html_title = f"samcontact {release}"
html_copy_source = False


def _titles(toc):
    """Return a table of contents with the titles of pages alone, as `titles_only` leaves it."""
    short = toc.deepcopy()
    for entry in short:
        if len(entry) > 1:
            if inner := list(entry.findall(toctree)):
                entry[1][:] = inner
            else:
                entry.pop(1)
    return short


def _short_navigation(app, pagename, templatename, context, doctree):
    """Make the navigation tree of a page from titles.

    Copies of all headings of the site, which the theme drops again, would take half of a build.
    """
    env, tree = app.env, context.get("toctree")
    if app.tags.has("brief") and pagename != "index":
        context.pop("toctree", None)
        return
    if not hasattr(app, "titles"):
        app.titles = {name: _titles(toc) for name, toc in env.tocs.items()}

    def titles_tree(**options):
        whole, env.tocs = env.tocs, app.titles if options.get("titles_only") else env.tocs
        try:
            return tree(**options)
        finally:
            env.tocs = whole

    if tree is not None:
        context["toctree"] = titles_tree


def _link_to_pages(app, relative_path, parent_docname, content):
    """Change the links in files included from the root folder to links between pages."""
    content[0] = content[0].replace("](CHANGELOG.md)", "](changes.md)").replace("](docs/", "](")


def _link_to_notebooks(app, docname, content):
    """Change links to notebook files outside docs to links to pages of the site."""
    link = r"\[([^]]+)\]\((?:\.\./)+notebooks/(\w+)\.ipynb\)"
    content[0] = re.sub(link, r"{doc}`\1 </notebooks/\2>`", content[0])


def _no_fields_of_cases(app, what, name, obj, options, signature, returns):
    if isinstance(obj, type) and issubclass(obj, BaseModel):
        return "", None
    return signature, returns


def _bases(app, name, obj, options, bases):
    """Keep only public base classes."""
    bases[:] = [base for base in bases if _is_public(base)] or [object]


def _is_public(base):
    package, _, path = base.__module__.partition(".")
    names = samcontact.__all__
    return package != "samcontact" or base.__name__ in names or path.partition(".")[0] in names


def _whole_formulas(app, doctree):
    """Write formulas of several rows without `split`, in which rows cannot be numbered."""
    for node in doctree.findall(nodes.math_block):
        if r"\\" in node.astext() and not node.get("nowrap"):
            node["nowrap"] = True
            node.children = [nodes.Text(rf"\[{node.astext()}\]")]


def _no_bases(app, doctree):
    """Remove the base class `object`."""
    for node in list(doctree.findall(nodes.paragraph)):
        if node.astext() == "Bases: object":
            node.parent.remove(node)


def _wide_pictures(app, doctree, docname):
    """Mark pictures wider than 6.5 inches, whose labels a phone would shrink: they scroll."""
    for node in doctree.findall(nodes.image):
        file = Path(app.srcdir, node["candidates"].get("*", ""))
        if file.suffix == ".png" and file.exists():
            with Image.open(file) as picture:
                if picture.width / picture.info["dpi"][0] > 6.5:
                    node["classes"].append("wide")


_LABEL = re.compile(r"""(?:set_[xy]label\(|set_title\(|[xy]label=|title=)\s*f?(["'])(.+?)\1""")


def _figures_are_described(app, doctree):
    """Describe each figure of a notebook by its section and by the labels in the code."""
    for node in doctree.findall(nodes.image):
        cell = section = node
        while cell is not None and "cell" not in cell.get("classes", ()):
            cell = cell.parent
        if cell is None or node.get("alt"):
            continue
        while not isinstance(section, nodes.section):
            section = section.parent
        labels = dict.fromkeys(found[2] for found in _LABEL.finditer(cell[0].astext()))
        node["alt"] = ": ".join(filter(None, [section[0].astext(), ", ".join(labels)]))


def _whole_numbers(app, doctree):
    """Keep numbers such as 1.2e-05 in tables on one line."""
    for entry in doctree.findall(nodes.entry):
        for text in list(entry.findall(nodes.Text)):
            parts = re.split(r"(\d[\d.]*e-\d+)", text)
            if len(parts) > 1 and not isinstance(text.parent, nodes.literal):
                pieces = [nodes.Text(part) for part in parts]
                for index in range(1, len(parts), 2):
                    pieces[index] = nodes.inline(parts[index], parts[index], classes=["number"])
                text.parent.replace(text, [piece for piece in pieces if piece.astext()])


def _words_are_no_links(app, doctree):
    """Remove the links of plain words in types like "array_like, shape (n,)"."""
    for node in list(doctree.findall(pending_xref)):
        last = node.get("reftarget", "").rpartition(".")[2]
        is_type = node.get("refdomain") == "py" and node.get("reftype") in ("class", "obj")
        if is_type and last.islower():
            node.replace_self(node.children)


def _no_search(app):
    app.builder.search = False


def _plain_quotation_marks(app, config):
    config.smartquotes = False


def setup(app):
    # With `-t brief`, for tests: no pages of source code, no index for searches, plain quotation
    # marks, and navigation on the home page only.
    if app.tags.has("brief"):
        app.connect("builder-inited", _no_search)
        app.connect("config-inited", _plain_quotation_marks)
    else:
        app.setup_extension("sphinx.ext.viewcode")
    app.connect("html-page-context", _short_navigation, priority=400)  # before the theme
    app.connect("doctree-resolved", _wide_pictures)
    app.connect("doctree-read", _whole_formulas)
    app.connect("doctree-read", _no_bases)
    app.connect("doctree-read", _figures_are_described)
    app.connect("doctree-read", _whole_numbers)
    app.connect("doctree-read", _words_are_no_links)
    app.connect("autodoc-process-signature", _no_fields_of_cases)
    app.connect("autodoc-process-bases", _bases)
    app.connect("include-read", _link_to_pages)
    app.connect("source-read", _link_to_notebooks)
