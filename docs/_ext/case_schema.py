# SPDX-License-Identifier: GPL-3.0-or-later
"""Directive ``case-schema``: tables of the fields of a case file, from its models.

Names, units, ranges and defaults are those of the models; meanings are in field_meanings.toml.
"""

from __future__ import annotations

import json
import re
import sys
from functools import cache
from pathlib import Path
from types import UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from docutils import nodes
from pydantic import BaseModel
from pydantic_core import PydanticUndefined
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from samcontact import cases
from samcontact.cases.field_units import models_in, unit_of
from samcontact.cases.kinds import SECTIONS as KIND_SECTIONS

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

MEANINGS = Path(__file__).with_name("field_meanings.toml")
SIGNS = (("gt", ">"), ("ge", "≥"), ("lt", "<"), ("le", "≤"))
SECTIONS = {getattr(cases, kind): f"a file with `[{name}]`" for kind, name in KIND_SECTIONS.items()}
ROOTS = {
    cases.Case: "Top of the file",
    **{kind: f"Top of {where}" for kind, where in SECTIONS.items()},
}
TYPE_NAMES = {float: "number", int: "integer", bool: "true or false", str: "text", list: "list"}


def kind(annotation: Any) -> str:
    """Return the type of a field in words, e.g. "list of numbers"."""
    origin, parts = get_origin(annotation), get_args(annotation)
    if origin is Annotated:
        return kind(parts[0]) + limits(parts[1:])
    if origin in (Union, UnionType):
        named = [kind(part) for part in parts if part is not type(None)]
        return " or ".join(dict.fromkeys(named))
    if origin is Literal:
        return ", ".join(f'"{value}"' if isinstance(value, str) else str(value) for value in parts)
    if origin is dict:
        return f"table of {several(kind(parts[1]))}, each by a name"
    if origin is list:
        return f"list of {several(kind(parts[0]))}"
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return "section"
    return TYPE_NAMES.get(annotation, str(annotation))


def several(what: str) -> str:
    """Return the plural of a type in words; a list of allowed values is not changed."""
    return re.sub(r"^(number|integer|section|list)\b", r"\1s", what)


def limits(metadata: Any) -> str:
    """Bounds among the constraints of a field, in words."""
    found = []
    for item in metadata:
        for part in (item, *getattr(item, "metadata", ())):
            found += [f"{sign} {getattr(part, name)}" for name, sign in SIGNS
                      if getattr(part, name, None) is not None]  # fmt: skip
    return " " + ", ".join(dict.fromkeys(found)) if found else ""


def default(field: Any) -> str:
    if field.is_required():
        return "required"
    value = field.get_default(call_default_factory=True)
    if value is None or value is PydanticUndefined:
        return "optional"
    if isinstance(value, BaseModel):
        return "its own defaults"
    # JSON writes numbers, texts and lists as TOML does
    return f"`{json.dumps(value)}`"


@cache
def places(root: type[BaseModel]) -> dict[type[BaseModel], list[str]]:
    """Return the sections of a kind of file, outermost first, each with all its headings."""
    found: dict[type[BaseModel], list[str]] = {}
    waiting = [(root, "")]
    while waiting:
        model, above = waiting.pop(0)
        for name, field in model.model_fields.items():
            heading = f"[{above}{name}]"
            if get_origin(field.annotation) is list:
                heading = f"[{heading}]"
            for inner in models_in(field.annotation):
                headings = found.setdefault(inner, [])
                if heading not in headings:
                    headings.append(heading)
                    waiting.append((inner, f"{above}{name}."))
    return found


def word(model: type[BaseModel]) -> str:
    """Return the field that distinguishes sections of equal name, e.g. ``law = "swift"``, or ""."""
    for name, field in model.model_fields.items():
        if field.is_required() and get_origin(field.annotation) is Literal:
            return f'{name} = "{get_args(field.annotation)[0]}"'
    return ""


def titled() -> dict[type[BaseModel], str]:
    """Return the title of each section, made of its headings in a case file."""
    titles: dict[type[BaseModel], str] = dict(ROOTS)
    for root in ROOTS:
        for model, headings in places(root).items():
            title = ", ".join(f"`{heading}`" for heading in headings)
            title += f" with `{word(model)}`" if word(model) else ""
            if model not in titles and title in titles.values():
                title += f", in {SECTIONS[root]}"
            titles.setdefault(model, title)
    return titles


def place_of(model: type[BaseModel]) -> str:
    """Name of a section in field_meanings.toml: its innermost heading, without body numbers."""
    if model in ROOTS:
        return "case"
    headings = [found for root in ROOTS for found in places(root).get(model, [])]
    return re.sub(r"[][]|(?<=body)\d|(?<=relief)\d", "", min(headings, key=len))


def meanings() -> dict[type[BaseModel], dict[str, str]]:
    """Return the description of each field, by section; a missing description is a KeyError."""
    tables = tomllib.loads(MEANINGS.read_text(encoding="utf-8"))
    found: dict[type[BaseModel], dict[str, str]] = {}
    for model in titled():
        place = place_of(model)
        # layers and inclusions have the fields of a body
        above = re.sub(r"\.(layers|inclusions|random_inclusions)$", "", place)
        known = tables["any"] | tables.get(above, {}) | tables.get(place, {})
        found[model] = {name: known[name] for name in model.model_fields}
    return found


def table(model: type[BaseModel], title: str, meaning: dict[str, str]) -> list[str]:
    """Return the table of the fields of a section, as lines of Markdown."""
    first = "" if model in ROOTS else (model.__doc__ or "").strip().splitlines()[0]
    first = re.sub(r"^\[+\w+\]+: (.)", lambda found: found[1].upper(), first)
    lines = [f"## {title}", "", first, "", "| field | meaning | unit | values | default |"]
    lines.append("|---|---|---|---|---|")
    for name, field in model.model_fields.items():
        said = kind(field.annotation) + limits(field.metadata)
        unit = unit_of(field.annotation, field.metadata)
        lines.append(f"| `{name}` | {meaning[name]} | {unit} | {said} | {default(field)} |")
    return [*lines, ""]


class CaseSchema(SphinxDirective):
    """Directive that shows one table for each section of a case file."""

    def run(self) -> list[nodes.Node]:
        self.env.note_dependency(str(MEANINGS))
        said = meanings()
        parts = [table(model, title, said[model]) for model, title in titled().items()]
        lines = [line for part in parts for line in part]
        return self.parse_text_to_nodes("\n".join(lines), allow_section_headings=True)


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_directive("case-schema", CaseSchema)
    return {"parallel_read_safe": True}
