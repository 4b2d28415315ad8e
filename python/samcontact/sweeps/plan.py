# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases of a parameter study, made from a base case and lists of values, and validated."""

from __future__ import annotations

import copy
import difflib
import itertools
import json
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from pydantic import BaseModel

from .._util.checks import choice
from .._util.short_text import in_short
from ..cases.base import CaseError, CaseFile
from ..cases.errors import SHORT_FORMS
from ..cases.field_units import field_unit
from ..cases.rolling_parts import short_places

MODES = ("product", "zip")
MAX_LINES = 10  # maximum number of lines of an error message
MAX_CASES = 100_000

_DOTTED = re.compile(r"[A-Za-z_]\w*(\[\d+\])*(\.[A-Za-z_]\w*(\[\d+\])*)*")
Keys = list[str | int]


@dataclass(frozen=True)
class Plan:
    """All cases of a parameter study, and the dimensions along which they are arranged."""

    dims: dict[str, int]
    """Name and size of each dimension, the slowest-varying first."""
    cases: list[CaseFile]
    """All cases, ordered along the dimensions; the last dimension varies fastest."""
    coordinates: dict[str, tuple[str, Any, dict[str, str]]]
    """Dimension, values and attributes of each parameter."""


class _UnknownField(ValueError):
    pass


def make_plan(case: CaseFile, parameters: Mapping[str, Sequence[Any]], mode: str) -> Plan:
    """Return a plan with a validated case for each combination of values.

    Raises the errors of `samcontact.sweep` for invalid cases and parameters.
    """
    choice("mode", mode, MODES)
    if not isinstance(parameters, Mapping) or not parameters:
        raise ValueError(
            f"parameters must map at least one field to values, got {in_short(parameters)}"
        )
    values = {name: _values(name, given) for name, given in parameters.items()}
    keys = {name: _keys(case, name) for name in values}
    counts = {name: len(column) for name, column in values.items()}
    if mode == "zip" and len(set(counts.values())) > 1:
        listed = ", ".join(f"{name} {count}" for name, count in counts.items())
        raise ValueError(
            f"parameters must have equal numbers of values in mode 'zip', got {listed}"
        )
    count = math.prod(counts.values()) if mode == "product" else max(counts.values())
    if count > MAX_CASES:
        listed = ", ".join(f"{name} {count}" for name, count in counts.items())
        raise ValueError(
            f"a sweep must have at most {MAX_CASES} cases, got {count} (values of {listed} in "
            f"mode {in_short(mode)}): use fewer values, or mode 'zip' to combine them pairwise"
        )
    combine: Any = itertools.product if mode == "product" else zip
    cases = _validated(case, keys, list(combine(*values.values())))
    if mode == "zip":
        columns = {name: _labels(cases, path) for name, path in keys.items()}
        return Plan(
            {"case": len(cases)}, cases, {n: _coordinate(n, "case", c) for n, c in columns.items()}
        )
    places = np.arange(len(cases)).reshape(tuple(counts.values()))
    coordinates = {}
    for axis, name in enumerate(values):
        # cases that differ in this parameter only
        line = np.moveaxis(places, axis, 0).reshape(counts[name], -1)[:, 0]
        labels = _labels([cases[place] for place in line], keys[name])
        _require_different(name, labels)
        coordinates[name] = _coordinate(name, name, labels)
    return Plan(counts, cases, coordinates)


def _coordinate(name: str, dim: str, labels: Any) -> tuple[str, Any, dict[str, str]]:
    unit = field_unit(name) if labels.dtype.kind in "if" else ""
    if not unit and labels.dtype.kind == "f" and not name.endswith(".start"):
        unit = "1"  # except a start, whose unit depends on its segment
    return dim, labels, {"units": unit} if unit else {}


def _values(name: str, given: Any) -> list[Any]:
    """Return the values of a parameter as plain Python values; case models refuse NumPy numbers."""
    if isinstance(given, np.ndarray) and given.ndim > 0:
        given = given.tolist()
    if isinstance(given, (str, bytes, Mapping)) or not isinstance(given, Sequence):
        raise TypeError(f"{name} must have a sequence of values, got {in_short(given)}")
    if len(given) == 0:
        raise ValueError(f"{name} must have at least one value, got none")
    return [v.tolist() if isinstance(v, (np.generic, np.ndarray)) else v for v in given]


def _keys(case: CaseFile, name: Any) -> Keys:
    """Split a dotted name such as "path[0].load" into the keys of nested dictionaries and lists."""
    if not isinstance(name, str) or not _DOTTED.fullmatch(name):
        example = "'body2.yield_stress' or 'path[0].load'"
        raise ValueError(f"parameter names must be like {example}, got {in_short(name)}")
    parts = re.findall(r"[A-Za-z_]\w*|\d+", name)
    keys: Keys = [int(part) if part[0].isdigit() else part for part in parts]
    return ["surface", *keys[1:]] if keys[0] == _short_form(case) else keys


def _short_form(case: CaseFile) -> str:
    """Return the section that a case has instead of [surface], e.g. "roller"; otherwise ""."""
    shape = getattr(getattr(case, "surface", None), "shape", "")
    return shape if shape in SHORT_FORMS else ""


def _set(content: Any, keys: Keys, value: Any) -> None:
    """Set a value in nested dictionaries and lists; missing sections are created."""
    for key in keys[:-1]:
        content = _step(content, key)
    last = keys[-1]
    named = isinstance(content, dict) and isinstance(last, str)
    if not named and not _is_place(content, last):
        raise _UnknownField
    content[last] = copy.deepcopy(value)


def _is_place(content: Any, key: str | int) -> bool:
    return isinstance(content, list) and isinstance(key, int) and key < len(content)


def _step(content: Any, key: str | int) -> Any:
    if isinstance(content, dict) and isinstance(key, str):
        if content.get(key) is None:
            content[key] = {}
        return content[key]
    if _is_place(content, key):
        return content[key]
    raise _UnknownField


def _validated(
    case: CaseFile, keys: Mapping[str, Keys], combinations: list[tuple[Any, ...]]
) -> list[CaseFile]:
    """Return the case of each combination of values.

    Raises one CaseError that lists the errors of all combinations.
    """
    base = case.model_dump(exclude_unset=True)
    cases: list[CaseFile] = []
    problems: dict[str, str] = {}  # error: first combination with this error
    for values in combinations:
        content = copy.deepcopy(base)
        try:
            for name, value in zip(keys, values, strict=True):
                try:
                    _set(content, keys[name], value)
                except _UnknownField:
                    raise _UnknownField(f"{name}: unknown field{_nearest(case, name)}") from None
            made = type(case).model_validate(content)
        except CaseError as error:
            text = short_places(str(error), {name.partition(".")[0]: None for name in keys})
            lines = [_renamed(case, line, list(keys)) for line in text.split("\n")]
        except _UnknownField as error:
            lines = [str(error)]
        else:
            cases.append(made.written_in(case.source, case.text))
            continue
        where = ", ".join(f"{n} = {in_short(v)}" for n, v in zip(keys, values, strict=True))
        for line in lines:
            problems.setdefault(line, where)
    if problems:
        raise CaseError(_listed(problems))
    return cases


def _listed(problems: Mapping[str, str]) -> str:
    lines = [f"{line} (sweep: {where})" for line, where in problems.items()]
    if len(lines) > MAX_LINES:
        lines[MAX_LINES:] = [f"and {len(lines) - MAX_LINES} more"]
    return "\n".join(lines)


def _renamed(case: CaseFile, line: str, names: Sequence[str]) -> str:
    """Return a line of the error text of a case, rewritten if a parameter is an unknown field.

    The rewritten line contains the full name of the parameter and suggests a similar field. names:
    names of the parameters.
    """
    where, _, reason = line.partition(": ")
    if reason.startswith("unknown field;"):
        for name in names:
            if name == where or name.startswith((f"{where}.", f"{where}[")):
                return f"{name}: unknown field{_nearest(case, name)}; {line.split('; ')[1]}"
    return line


def _nearest(case: CaseFile, name: str) -> str:
    known, short = list(field_names(case)), _short_form(case)
    if short:
        known += [f"{short}.{one[8:]}" for one in known if one.startswith("surface.")]
    found = difflib.get_close_matches(name, known, n=1, cutoff=0.4)
    return f"; did you mean {found[0]}?" if found else ""


def field_names(model: BaseModel, prefix: str = "") -> Iterator[str]:
    """Iterate over the dotted names of all fields of a case, including those in its sections."""
    for name in type(model).model_fields:
        yield prefix + name
        value = getattr(model, name)
        if isinstance(value, BaseModel):
            yield from field_names(value, f"{prefix}{name}.")
        elif isinstance(value, list):
            for index, part in enumerate(value):
                if isinstance(part, BaseModel):
                    yield from field_names(part, f"{prefix}{name}[{index}].")


def _labels(cases: Sequence[CaseFile], keys: Keys) -> Any:
    """Return the validated values of a field in all cases.

    Lists, sections and values of different types are returned as JSON text.
    """
    values = []
    for case in cases:
        value: Any = case.model_dump(exclude_unset=True)
        for key in keys:
            value = value[key]
        values.append(value)
    for kind in (bool, int, float, str):
        if all(type(value) is kind for value in values):
            return np.array(values, dtype=object if kind is str else kind)
    return np.array([json.dumps(value, sort_keys=True) for value in values], dtype=object)


def _require_different(name: str, labels: Any) -> None:
    seen = set()
    for label in labels.tolist():
        if label in seen:
            raise ValueError(
                f"values of {name} must be different, because mode is 'product', "
                f"got {label!r} twice"
            )
        seen.add(label)
