# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinds of case files, recognised by the sections that they contain.

The module of a kind is imported on first use, because importing all modules takes a long time.
"""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from .._util.short_text import in_short
from .case import Case

if TYPE_CHECKING:
    from .asperities import AsperityCase
    from .films import FilmCase
    from .sliding import SlidingCase

    AnyCase = Case | AsperityCase | FilmCase | SlidingCase
    ALL_KINDS: tuple[type[AnyCase], ...]

CLASSES = {"asperities": "AsperityCase", "films": "FilmCase", "sliding": "SlidingCase"}
"""Class of each kind of case file except `Case`, by the name of its module."""
SECTIONS = {"AsperityCase": "asperities", "FilmCase": "film", "SlidingCase": "sliding"}
"""Section that identifies a kind of case file, by the name of its class."""


def kind_of(content: Mapping[str, Any]) -> type[AnyCase]:
    """Return the class for a case file with the sections in `content`."""
    if "lubricant" in content:
        return _class_in("films")
    for module, name in CLASSES.items():
        if SECTIONS[name] in content:
            return _class_in(module)
    return Case


def _class_in(module: str) -> type[AnyCase]:
    found: type[AnyCase] = getattr(
        importlib.import_module(f".{module}", __package__), CLASSES[module]
    )
    return found


def __getattr__(name: str) -> Any:
    """Return `AnyCase` (union of all kinds) or `ALL_KINDS` (tuple), after importing all kinds."""
    if name not in ("AnyCase", "ALL_KINDS"):
        raise AttributeError(f"module {__name__!r} has no attribute {in_short(name)}")
    asperities, films, sliding = map(_class_in, CLASSES)
    if name == "AnyCase":
        return Case | asperities | films | sliding
    return Case, asperities, films, sliding
