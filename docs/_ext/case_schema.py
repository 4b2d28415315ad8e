# SPDX-License-Identifier: GPL-3.0-or-later
"""The directive ``case-schema``: tables of the fields of a case file, from its models."""

from __future__ import annotations

from types import UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from docutils import nodes
from pydantic import BaseModel
from pydantic_core import PydanticUndefined
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from samcontact import cases
from samcontact.cases.field_units import all_models, unit_of

SIGNS = (("gt", ">"), ("ge", "≥"), ("lt", "<"), ("le", "≤"))
PLAIN = {float: "number", int: "integer", bool: "true or false", str: "text", list: "list"}


def kind(annotation: Any) -> str:
    """A type in words."""
    origin, parts = get_origin(annotation), get_args(annotation)
    if origin is Annotated:
        return kind(parts[0]) + limits(parts[1:])
    if origin in (Union, UnionType):
        named = [kind(part) for part in parts if part is not type(None)]
        return " or ".join(dict.fromkeys(named))
    if origin is Literal:
        return ", ".join(f'"{value}"' if isinstance(value, str) else str(value) for value in parts)
    if origin is list:
        return f"list of {kind(parts[0])}"
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return f"section {annotation.__name__}"
    return PLAIN.get(annotation, str(annotation))


def limits(metadata: Any) -> str:
    """The bounds among the constraints of a field, in words."""
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
    return f"`{str(value).lower() if isinstance(value, bool) else value!r}`"


def table(model: type[BaseModel]) -> list[str]:
    """Markdown of one model."""
    first = (model.__doc__ or "").strip().splitlines()[0]
    lines = [f"## {model.__name__}", "", first, "", "| field | unit | kind | default |"]
    lines.append("|---|---|---|---|")
    for name, field in model.model_fields.items():
        said = kind(field.annotation) + limits(field.metadata)
        unit = unit_of(field.annotation, field.metadata)
        lines.append(f"| {name} | {unit} | {said} | {default(field)} |")
    return [*lines, ""]


class CaseSchema(SphinxDirective):
    """Tables of all sections of a case file."""

    def run(self) -> list[nodes.Node]:
        models = all_models(cases.Case, cases.TuggingCase)
        lines = [line for model in models for line in table(model)]
        return self.parse_text_to_nodes("\n".join(lines), allow_section_headings=True)


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_directive("case-schema", CaseSchema)
    return {"parallel_read_safe": True}
