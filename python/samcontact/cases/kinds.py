# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinds of case files, by the sections that they contain."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .asperities import AsperityCase
from .case import Case
from .films import FilmCase

AnyCase = Case | AsperityCase | FilmCase
ALL_KINDS: tuple[type[AnyCase], ...] = (Case, AsperityCase, FilmCase)
"""Classes of all kinds of case files."""
_BY_SECTION: dict[str, type[AnyCase]] = {
    "asperities": AsperityCase, "film": FilmCase, "lubricant": FilmCase,
}  # fmt: skip


def kind_of(content: Mapping[str, Any]) -> type[AnyCase]:
    """Return the class of a case with these sections."""
    return next((kind for name, kind in _BY_SECTION.items() if name in content), Case)
