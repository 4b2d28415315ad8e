# SPDX-License-Identifier: GPL-3.0-or-later
"""Units of the fields of a case file, from the metadata of the pydantic models."""

from __future__ import annotations

import re
from functools import cache

from pydantic import BaseModel

from ..bodies.hardening_laws import LAWS
from .allowed import models_in, unit_of
from .case import Case
from .errors import SHORT_FORMS
from .kinds import KINDS

# Units of law constants; microstrain is not converted, as it is stored as a plain number.
_LAW_UNITS = {name: one.unit for law in LAWS.values() for name, one in law.constants.items()}


def all_models(*roots: type[BaseModel]) -> list[type[BaseModel]]:
    """Return the given models and the models of all nested sections, outermost first."""
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
    """Return the units of all fields within a top-level section, by field name."""
    roots = [
        model
        for kind in (Case, *KINDS.values())
        if section in kind.model_fields
        for model in models_in(kind.model_fields[section].annotation)
    ]
    units: dict[str, str] = {}
    for model in all_models(*roots):
        for name, field in model.model_fields.items():
            units[name] = _LAW_UNITS.get(name) or unit_of(field.annotation, field.metadata)
    return units


def field_unit(name: str) -> str:
    """Return the unit of a dotted field, e.g. "Pa" for "body2.yield_stress"; "" without a unit."""
    plain = re.sub(r"\[\d+\]", "", name)
    section, _, field = plain.partition(".")
    section = "surface" if section in SHORT_FORMS else section
    return _units(section).get(field.rpartition(".")[2], "")
