# SPDX-License-Identifier: GPL-3.0-or-later
"""Description of the values that each field of a case file allows, from its pydantic model."""

from __future__ import annotations

import re
from collections.abc import Sequence
from types import UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel, Discriminator, Tag
from pydantic.fields import FieldInfo

from .._util.checks import MAX_COUNT
from .converted import Unit

# Units as written for readers, by their spelling in the annotations.
_UNIT_SPELLINGS = {
    "m**2/s": "m²/s", "W/(m*K)": "W/(m K)", "N*m": "N m", "Pa*s": "Pa s",
    "kg/m**3": "kg/m³", "1/m**2": "1/m²", "J/m^2": "J/m²",
}  # fmt: skip
_CONSTRAINTS = ("gt", "ge", "lt", "le", "min_length", "max_length", "allow_inf_nan")
_TYPE_NAMES = {bool: "true or false", str: "text"}


def opened(annotation: Any, metadata: Sequence[Any] = ()) -> tuple[Any, list[Any]]:
    """Strip `Annotated` and None from an annotation; return the bare type and all metadata."""
    marks = list(metadata)
    while True:
        origin, parts = get_origin(annotation), get_args(annotation)
        if origin is Annotated:
            annotation = parts[0]
            for part in parts[1:]:
                marks += [part, *part.metadata] if isinstance(part, FieldInfo) else [part]
            continue
        options = members(annotation)
        if len(options) != 1 or options[0] is annotation:
            return annotation, marks
        annotation = options[0]


def members(annotation: Any) -> list[Any]:
    """Return the alternatives of a union type without None; [annotation] for any other type."""
    if get_origin(annotation) not in (Union, UnionType):
        return [annotation]
    return [part for part in get_args(annotation) if part is not type(None)]


def unit_of(annotation: Any, metadata: Any = ()) -> str:
    """Return the SI unit of a field; "" if the field has no unit."""
    for part in (*metadata, *get_args(annotation)):
        if isinstance(part, Unit):
            return _UNIT_SPELLINGS.get(part.name, part.name)
        if found := unit_of(part):
            return found
    return ""


def models_in(annotation: Any) -> list[type[BaseModel]]:
    """Return all pydantic models (sections) that occur in an annotation."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    return [model for part in get_args(annotation) for model in models_in(part)]


def is_model(annotation: Any) -> bool:
    """Whether an annotation is a pydantic model, i.e. a section."""
    return isinstance(annotation, type) and issubclass(annotation, BaseModel)


def discriminated(marks: Sequence[Any]) -> bool:
    """Whether the metadata contain a discriminator, which selects one of several sections."""
    return any(
        isinstance(mark, Discriminator) or getattr(mark, "discriminator", None) for mark in marks
    )


def tags(annotation: Any, key: str | None = None) -> tuple[Any, ...]:
    """Return the words (pydantic tags) that select a section in a union, e.g. "sphere".

    key: name of the field that selects the section; default: any field.
    """
    model, marks = opened(annotation)
    named = tuple(mark.tag for mark in marks if isinstance(mark, Tag))
    if named or not is_model(model):
        return named
    words = (
        opened(field.annotation)[0]
        for name, field in model.model_fields.items()
        if key in (None, name)
    )
    return tuple(tag for kind in words if get_origin(kind) is Literal for tag in get_args(kind))


def described(annotation: Any, metadata: Sequence[Any] = ()) -> str:
    """Describe the allowed values of an annotation, e.g. "a finite number > 0 [m]"."""
    kind, marks = opened(annotation, metadata)
    unit = unit_of(None, marks)
    limits = {
        name: getattr(mark, name)
        for mark in marks
        if not isinstance(mark, FieldInfo)
        for name in _CONSTRAINTS
        if getattr(mark, name, None) is not None
    }
    several = members(kind)
    if len(several) > 1:
        text = " or ".join(dict.fromkeys(map(described, several)))
    elif is_model(kind):
        text = "a table"
    elif get_origin(kind) is list:
        text = f"a list of {_counted(limits, described(get_args(kind)[0]))}"
    elif get_origin(kind) is dict:
        text = f"a table of {_several(described(get_args(kind)[1]))}"
    elif get_origin(kind) is Literal:
        text = " or ".join(f'"{w}"' if isinstance(w, str) else str(w) for w in get_args(kind))
        text = text if len(get_args(kind)) < 2 else f"one of {text.replace(' or ', ', ')}"
    elif kind in _TYPE_NAMES:
        text = _TYPE_NAMES[kind] + (" (not empty)" if limits.get("min_length") else "")
    else:
        text = _number(kind, limits)
    return f"{text} [{unit}]" if unit and f"[{unit}]" not in text else text


def _counted(limits: dict[str, Any], one: str) -> str:
    """Describe the elements of a list, e.g. "2 to 4 numbers"; `one` describes a single element."""
    min_count, max_count = limits.get("min_length"), limits.get("max_length")
    if max_count is None:
        count = f"at least {min_count} " if min_count else ""
        return count + (one.removeprefix("a ") if min_count == 1 else _several(one))
    count = f"{max_count}" if min_count == max_count else f"{min_count or 0} to {max_count}"
    return f"{count} {_several(one)}"


def _several(text: str) -> str:
    """Return the plural of a description, e.g. "numbers" from "a number"."""
    return re.sub(r"\b(number|table|text|list)\b", r"\1s", text.removeprefix("a "), count=1)


def _number(kind: Any, limits: dict[str, Any]) -> str:
    name = "whole number" if kind is int else "number"
    low, high = (
        next((limits[key] for key in keys if key in limits), None)
        for keys in (("gt", "ge"), ("lt", "le"))
    )
    if kind is float and limits.get("allow_inf_nan") is False and high is None:
        name = f"finite {name}"
    if kind is int and high == MAX_COUNT:
        high = None  # a technical limit that exceeds any available memory
    if low is not None and high is not None:
        if kind is int:
            if high == low + 1:
                return f"{low} or {high}"
            return f"a {name} from {low} to {high}"
        ends = "(" if "gt" in limits else "[", ")" if "lt" in limits else "]"
        return f"a {name} in {ends[0]}{low:g}, {high:g}{ends[1]}"
    bounds = ((low, ">", "gt", ">="), (high, "<", "lt", "<="))
    signs = [f" {a if key in limits else b} {v:g}" for v, a, key, b in bounds if v is not None]
    return f"a {name}{''.join(signs)}"
