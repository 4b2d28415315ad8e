# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinds of case files, by the sections that they contain.

The module of a kind is loaded with its first case: each takes longer than a small contact.
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
"""Names of the classes of all kinds of files other than those of one contact, by module."""
SECTIONS = {"AsperityCase": "asperities", "FilmCase": "film", "SlidingCase": "sliding"}
"""Section that only files of the kind have, by class."""


def kind_of(content: Mapping[str, Any]) -> type[AnyCase]:
    """Return the class of a case with these sections."""
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
    """Load all kinds for `AnyCase`, their union, and `ALL_KINDS`, a tuple of their classes."""
    if name not in ("AnyCase", "ALL_KINDS"):
        raise AttributeError(f"module {__name__!r} has no attribute {in_short(name)}")
    asperities, films, sliding = map(_class_in, CLASSES)
    if name == "AnyCase":
        return Case | asperities | films | sliding
    return Case, asperities, films, sliding
