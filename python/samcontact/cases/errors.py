# SPDX-License-Identifier: GPL-3.0-or-later
"""Error messages for a case file, with the field, the allowed values and the given value."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from datetime import date, time
from typing import Any, NamedTuple, get_args, get_origin

from pydantic import BaseModel, ValidationError

from .._util.likely_names import LIKELY, SYNONYMS, nearest
from .._util.short_text import escaped, in_short
from .allowed import described, discriminated, is_model, members, models_in, opened, tags, unit_of
from .converted import require_magnitude

MAX_LINES = 20
"""Maximum number of errors reported for one case."""
SHORT_FORMS = ("roller", "bearing")
"""Shapes that users may write as a section: [roller] for [surface] with shape = "roller"."""
_NUMBER = re.compile(r"\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\s*")
_NAME = re.compile(r"[\w-]{1,60}")


def explained(root: type[BaseModel], error: ValidationError, content: Any) -> list[str]:
    """Return each error of a case once, as "field: must be ALLOWED, got VALUE"."""
    return _first_lines(_explain(root, item, content) for item in error.errors())


def refused_values(content: Any) -> list[str]:
    """Return an error for each text or number that no field of a case allows.

    Texts are written to terminals and file names, so that control characters are rejected. Numbers
    are rejected if they are so large that their products could overflow.
    """
    return _first_lines(_refused_values(content, ()))


def _refused_values(content: Any, names: tuple[str | int, ...]) -> Iterator[str]:
    if isinstance(content, Mapping):
        for name, value in content.items():
            yield from _refused_values(value, (*names, name))
    elif isinstance(content, list):
        for index, item in enumerate(content):
            place = (*names, index) if isinstance(item, Mapping) else names
            yield from _refused_values(item, place)
    elif isinstance(content, str) and escaped(content) != content:
        yield f"{_dotted(names)}: must be text without control characters, got {in_short(content)}"
    elif isinstance(content, (int, float)):
        try:
            require_magnitude(content)
        except ValueError as error:
            yield f"{_dotted(names)}: {error}"


def _first_lines(errors: Iterable[str]) -> list[str]:
    lines = list(dict.fromkeys(errors))
    if len(lines) > MAX_LINES:
        return [*lines[:MAX_LINES], f"and {len(lines) - MAX_LINES} more errors"]
    return lines


def _explain(root: type[BaseModel], item: Any, content: Any) -> str:
    place = _resolve(root, item["loc"])
    where, kind = _dotted(place.names), item["type"]
    if kind == "extra_forbidden":
        hint = _hint(root, place)
        return f"{where}: unknown field; allowed here: {', '.join(place.fields)}{hint}"
    if kind == "missing":
        return f"{where}: required field is missing"
    if kind == "value_error":
        message = str(item["ctx"]["error"])
        return f"{where}: {message}" if where else message
    given = _value_at(content, place.names, item["input"])
    if kind in ("union_tag_not_found", "union_tag_invalid") and isinstance(given, Mapping):
        key = item["ctx"]["discriminator"].strip("'")
        if key not in given:
            return f"{where}.{key}: required field is missing"
        several = members(opened(place.annotation, place.marks)[0])
        known = [repr(tag) for one in several for tag in tags(one, key)]
        return f"{where}.{key}: must be one of {', '.join(known)}, got {in_short(given[key])}"
    table = re.sub(r"\[\d+\]", "", where)
    inner = opened(place.annotation, place.marks)[0]
    if _holds_tables(inner):
        if isinstance(given, Mapping):
            return f"{where}: must be a list of tables: write [[{table}]] instead of [{table}]"
        if given == []:
            return f"{where}: must contain at least one table [[{table}]], got []"
    elif all(is_model(opened(one)[0]) for one in members(inner)):
        if isinstance(given, list) and table == where:
            return f"{where}: must be a single table: write [{table}] instead of [[{table}]]"
        return f"{where}: must be a table, got {in_short(given)}"
    allowed = described(place.annotation, place.marks)
    return f"{where}: must be {allowed}, got {in_short(given)}{_remedy(allowed, given)}"


def _hint(root: type[BaseModel], place: _FieldLocation) -> str:
    """Return a hint at the field that an unknown name probably means; "" if none is similar."""
    name = str(place.names[-1])
    if likely := nearest(name, place.fields, LIKELY):
        return f"; did you mean {likely}?"
    for key in ("law", "shape", "kind"):
        forms = [one for one in place.forms if is_model(one) and name in one.model_fields]
        if words := [repr(word) for one in forms for word in tags(one, key)]:
            return f"; {name} belongs to {key} = {' or '.join(words)}"
    near = _elsewhere(root, name) or nearest(name, place.fields)
    return f"; did you mean {near}?" if near else ""


def _holds_tables(annotation: Any) -> bool:
    """Whether an annotation is a list of sections (TOML tables)."""
    if get_origin(annotation) is not list:
        return False
    return all(is_model(opened(one)[0]) for one in members(opened(get_args(annotation)[0])[0]))


def _remedy(allowed: str, given: Any) -> str:
    """Return a remedy for a value of the wrong type; "" if no remedy is obvious."""
    if isinstance(given, (date, time)):
        return ": this is a date or a time; write text in quotes"
    if allowed.startswith("true or false"):
        return ": write true or false without quotes"
    if "number" in allowed and isinstance(given, str) and _NUMBER.fullmatch(given):
        return ": write it without quotes"
    if allowed == "a table" and isinstance(given, list) and len(given) == 1:
        return ": write one pair of brackets"
    if "whole number" in allowed and isinstance(given, float) and given.is_integer():
        return ": write it without a decimal point or an exponent"
    return ""


def _value_at(content: Any, names: Sequence[str | int], otherwise: Any) -> Any:
    """Return the value at a location as written in the file; `otherwise` if there is none."""
    for name in names:
        try:
            content = content[name]
        except (KeyError, IndexError, TypeError):
            return otherwise
    return content


def _elsewhere(root: type[BaseModel], name: str) -> str | None:
    """Return "section.field" of another section that has a field of this name, or None."""
    word = re.sub(r"[^a-z]", "", name.lower())
    for suggestions in ((name,), SYNONYMS.get(word, ())):
        for section, field in root.model_fields.items():
            for model in models_in(field.annotation):
                for suggestion in (*suggestions, name.removeprefix(f"{section}_")):
                    if suggestion in model.model_fields:
                        return f"{_short_form(section, model)}.{suggestion}"
    return None


def _short_form(section: str, model: type[BaseModel]) -> str:
    """Return the name of a section as users write it: "bearing" for a [surface] of this shape."""
    words = tags(model, "shape")
    return words[0] if section == "surface" and set(words) & set(SHORT_FORMS) else section


def _dotted(names: Sequence[str | int]) -> str:
    text = ""
    for name in names:
        shown = name if isinstance(name, int) or _NAME.fullmatch(name) else in_short(name)
        text += f"[{shown}]" if isinstance(name, int) else f".{shown}" if text else str(shown)
    return text


class _FieldLocation(NamedTuple):
    """Location of an error: fields allowed there; path, type and metadata of the wrong field."""

    fields: list[str]
    names: list[str | int]
    annotation: Any
    marks: Sequence[Any]
    forms: Sequence[Any] = ()
    """Alternatives of the section in which a field is unknown, e.g. the sections of all shapes."""


def _resolve(root: type[BaseModel], loc: tuple[Any, ...]) -> _FieldLocation:
    """Return the field at the location `loc` of a pydantic error; `loc` may contain union tags.

    If a field allows several types, pydantic reports an error for each type and appends the type to
    `loc`. The location in the returned value ends at the field.
    """
    place = _FieldLocation([], [], root, ())
    forms: list[Any] = []
    for element in loc:
        kind, marks = opened(place.annotation, place.marks)
        several = members(kind)
        if len(several) > 1 and discriminated(marks):
            chosen, forms = [one for one in several if element in tags(one)], several
            place = place._replace(annotation=chosen[0] if chosen else None, marks=())
        elif is_model(kind):
            names, fields = [*place.names, element], kind.model_fields
            if element not in fields:
                return _FieldLocation(list(fields), names, None, (), forms)
            marks = [*fields[element].metadata, fields[element]]
            place = _FieldLocation(list(fields), names, fields[element].annotation, marks)
            forms = []
        elif get_origin(kind) in (list, dict) and isinstance(element, (int, str)):
            inherited = [mark for mark in marks if unit_of(None, [mark])]
            names = [*place.names, element]
            place = place._replace(names=names, annotation=get_args(kind)[-1], marks=inherited)
        else:
            return place
    return place
