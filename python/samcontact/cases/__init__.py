# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files: TOML descriptions of simulations; every field is validated."""

from .asperities import AsperityCase
from .base import CaseError
from .case import Case
from .reading import load_case, parse_case
from .sliding import SlidingCase

__all__ = ["AsperityCase", "Case", "CaseError", "SlidingCase", "load_case", "parse_case"]
