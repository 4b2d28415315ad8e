# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinds of case files, by the sections that they contain."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .asperities import AsperityCase
from .case import Case
from .films import FilmCase
from .sliding import SlidingCase

AnyCase = Case | AsperityCase | FilmCase | SlidingCase
KINDS: dict[str, type[AnyCase]] = {
    "asperities": AsperityCase,
    "film": FilmCase,
    "sliding": SlidingCase,
}
"""Kinds of files other than those of one contact, by the section that only they have."""
ALL_KINDS: tuple[type[AnyCase], ...] = (Case, *KINDS.values())
"""Classes of all kinds of case files."""


def kind_of(content: Mapping[str, Any]) -> type[AnyCase]:
    """Return the class of a case with these sections."""
    if "lubricant" in content:
        return FilmCase
    return next((kind for name, kind in KINDS.items() if name in content), Case)
