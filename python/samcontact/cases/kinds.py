# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinds of case files, distinguished by a section."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .asperities import AsperityCase
from .case import Case
from .sliding import SlidingCase

AnyCase = Case | AsperityCase | SlidingCase
KINDS: dict[str, type[AnyCase]] = {
    "asperities": AsperityCase,
    "sliding": SlidingCase,
}
"""Kinds of files other than those of one contact, by the section that only they have."""


def kind_of(content: Mapping[str, Any]) -> type[AnyCase]:
    """Return the kind of a case file with these sections."""
    return next((KINDS[name] for name in KINDS if name in content), Case)
