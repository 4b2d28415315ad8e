# SPDX-License-Identifier: GPL-3.0-or-later
"""Units of the fields of a case file, from the marks of its models."""

from __future__ import annotations

import re
from functools import cache, partial
from typing import Any, get_args

from pydantic import BaseModel

from .._laws import LAWS
from .case import Case
from .tugging import TuggingCase

# Those of laws are not all units for the conversion: microstrain is a number there.
_OF_LAWS = {name: one.unit for law in LAWS.values() for name, one in law.constants.items()}
# The marks are for the conversion, these for the reader.
_WRITTEN = {"m**2/s": "m²/s", "W/(m*K)": "W/(m K)", "N*m": "N m"}


def unit_of(annotation: Any, metadata: Any = ()) -> str:
    """SI unit that marks a field, "" for none."""
    for part in (*metadata, *get_args(annotation)):
        convert = getattr(part, "func", None)
        if isinstance(convert, partial) and "unit" in convert.keywords:
            unit: str = convert.keywords["unit"]
            return _WRITTEN.get(unit, unit)
        if found := unit_of(part):
            return found
    return ""


def models_in(annotation: Any) -> list[type[BaseModel]]:
    """The sections that an annotation may hold."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    return [model for part in get_args(annotation) for model in models_in(part)]


def all_models(*roots: type[BaseModel]) -> list[type[BaseModel]]:
    """The sections below these, each once, outermost first."""
    found: list[type[BaseModel]] = []
    waiting = list(roots)
    while waiting:
        model = waiting.pop(0)
        if model not in found:
            found.append(model)
            for field in model.model_fields.values():
                waiting += models_in(field.annotation)
    return found


@cache
def _units(section: str) -> dict[str, str]:
    """Units by field, below the section of this name at the top of a file."""
    roots = [
        model
        for kind in (Case, TuggingCase)
        if section in kind.model_fields
        for model in models_in(kind.model_fields[section].annotation)
    ]
    units: dict[str, str] = {}
    for model in all_models(*roots):
        for name, field in model.model_fields.items():
            units[name] = _OF_LAWS.get(name) or unit_of(field.annotation, field.metadata)
    return units


def field_unit(name: str) -> str:
    """Unit of a dotted field, e.g. "Pa" of "body2.yield_stress"; "" for counts and words."""
    plain = re.sub(r"\[\d+\]", "", name)
    section, _, field = plain.partition(".")
    return _units(section).get(field.rpartition(".")[2], "")
