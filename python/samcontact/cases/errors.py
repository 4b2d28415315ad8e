# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of a case file in the user's words: the field, what is wrong, what is allowed."""

from __future__ import annotations

import difflib
import re
from collections.abc import Sequence
from types import UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel, Discriminator

from .._short import in_short

# What users call fields, without signs between words.
_WORDS = {
    "radius": ("R", "Rx", "R1"),
    "radiusx": ("Rx",),
    "radiusy": ("Ry",),
    "r": ("Rx",),
    "young": ("E",),
    "youngsmodulus": ("E",),
    "youngmodulus": ("E",),
    "elasticmodulus": ("E",),
    "modulus": ("E",),
    "poisson": ("nu",),
    "poissonratio": ("nu",),
    "poissonsratio": ("nu",),
    "sigmay": ("yield_stress",),
    "yieldstrength": ("yield_stress",),
    "mu": ("friction", "coulomb"),
    "cof": ("friction", "coulomb"),
    "coefficient": ("coulomb", "friction"),
    "force": ("load", "tangential_load_x"),
    "forcex": ("tangential_load_x",),
    "forcey": ("tangential_load_y",),
    "moment": ("torque",),
    "rotation": ("twist",),
    "creepage": ("slide_to_roll", "advance"),
    "fretting": ("fret",),
    "indentation": ("approach",),
    "displacement": ("approach",),
    "steps": ("increments",),
    "tolerance": ("tol",),
    "material": ("law",),
    "type": ("law", "kind", "shape"),
    "name": ("title",),
    "file": ("path",),
    "filename": ("path",),
    "speed": ("velocity",),
    "folder": ("directory",),
}


def explain(root: type[BaseModel], item: Any) -> str:
    """One validation error as "field: what is wrong, what is allowed"."""
    fields, names = _resolve(root, item["loc"])
    kind, context = item["type"], item.get("ctx", {})
    where = _dotted(names)
    if kind == "extra_forbidden":
        near = nearest(str(names[-1]), fields) or _elsewhere(root, str(names[-1]))
        hint = f"; did you mean {near}?" if near else ""
        return f"{where}: unknown field; allowed here: {', '.join(fields)}{hint}"
    if kind == "missing":
        return f"{where}: required field is missing"
    if kind == "union_tag_not_found":
        key = context["discriminator"].strip("'")
        return f"{where}.{key}: required field is missing"
    if kind == "union_tag_invalid":
        key = context["discriminator"].strip("'")
        return f"{where}.{key}: must be one of {context['expected_tags']}, got '{context['tag']}'"
    if kind == "value_error":
        message = str(context["error"])
        return f"{where}: {message}" if where else message
    if kind == "list_type" and isinstance(item["input"], dict):
        return f"{where}: must be a list of tables: write [[{where}]] instead of [{where}]"
    if kind == "model_type" and isinstance(item["input"], list):
        return f"{where}: must be one table: write [{where}] instead of [[{where}]]"
    message = item["msg"][0].lower() + item["msg"][1:]
    return f"{where}: {message}, got {in_short(item['input'])}"


def nearest(name: str, fields: Sequence[str]) -> str | None:
    """The field that was probably meant: another word for it, or one that is spelled alike."""
    lower = {field.lower(): field for field in reversed(fields)}
    word = re.sub(r"[^a-z]", "", name.lower())
    for meant in _WORDS.get(word, ()):
        if meant in fields:
            return meant
    found = difflib.get_close_matches(name.lower(), lower, 1, cutoff=0.5)
    return lower[found[0]] if found else None


def _elsewhere(root: type[BaseModel], name: str) -> str | None:
    """The field of another section that has this name, with or without that of its section."""
    for section, field in root.model_fields.items():
        known = {inner for model in _models(field.annotation) for inner in model.model_fields}
        for meant in (name, name.removeprefix(f"{section}_")):
            if meant in known:
                return f"{section}.{meant}"
    return None


def _dotted(names: list[str | int]) -> str:
    text = ""
    for name in names:
        text += f"[{name}]" if isinstance(name, int) else f".{name}" if text else name
    return text


def _resolve(root: type[BaseModel], loc: tuple[Any, ...]) -> tuple[list[str], list[str | int]]:
    """Fields allowed where `loc` points, and `loc` as the user wrote it, without union tags."""
    models: list[type[BaseModel]] = [root]
    allowed: list[str] = []
    names: list[str | int] = []
    tagged = False
    for element in loc:
        if tagged:  # by a function: pydantic puts what it returns into the location
            tagged = False
            continue
        if isinstance(element, int):
            names.append(element)
            continue
        if len(models) > 1:  # a tagged union: pydantic puts the tag into the location
            models = [model for model in models if element in _tags(model)] or models
            continue
        if isinstance(element, str) and models:
            allowed = list(models[0].model_fields)
            field = models[0].model_fields.get(element)
            models = _models(field.annotation) if field is not None else []
            metadata = field.metadata if field is not None else ()
            tagged = any(isinstance(part, Discriminator) for part in metadata)
        names.append(element)
    return allowed, names


def _tags(model: type[BaseModel]) -> tuple[Any, ...]:
    return tuple(
        tag
        for field in model.model_fields.values()
        if get_origin(field.annotation) is Literal
        for tag in get_args(field.annotation)
    )


def _models(annotation: Any) -> list[type[BaseModel]]:
    """The section models inside an annotation."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    if get_origin(annotation) in (Annotated, Union, UnionType, list):
        return [model for part in get_args(annotation) for model in _models(part)]
    return []
