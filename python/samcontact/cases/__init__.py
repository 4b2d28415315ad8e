# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files: TOML descriptions of simulations; every field is validated."""

from .asperities import AsperityCase
from .base import CaseError
from .case import Case
from .films import FilmCase
from .kinds import ALL_KINDS, AnyCase, kind_of
from .reading import load_case, parse_case
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
