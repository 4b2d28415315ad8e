# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files: TOML descriptions of simulations, validated field by field."""

from .base import CaseError
from .case import Case, load_case, parse_case
from .tugging import TuggingCase

__all__ = ["Case", "CaseError", "TuggingCase", "load_case", "parse_case"]
