# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files: TOML descriptions of simulations; every field is validated."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from .._util.short_text import in_short
from .base import CaseError
from .case import Case
from .kinds import CLASSES, kind_of
from .reading import load_case, parse_case

if TYPE_CHECKING:
    from .asperities import AsperityCase
    from .films import FilmCase
    from .kinds import ALL_KINDS, AnyCase
    from .sliding import SlidingCase

__all__ = [
    "ALL_KINDS",
    "AnyCase",
    "AsperityCase",
    "Case",
    "CaseError",
    "FilmCase",
    "SlidingCase",
    "kind_of",
    "load_case",
    "parse_case",
]

_PLACES = {name: module for module, name in CLASSES.items()} | {
    "ALL_KINDS": "kinds", "AnyCase": "kinds",
}  # fmt: skip
"""Module that defines each public name; it is imported when the name is first used."""


def __getattr__(name: str) -> Any:
    if name not in _PLACES:
        raise AttributeError(f"module {__name__!r} has no attribute {in_short(name)}")
    return getattr(importlib.import_module(f".{_PLACES[name]}", __name__), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
