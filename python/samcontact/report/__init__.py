# SPDX-License-Identifier: GPL-3.0-or-later
"""A report of a run: one HTML file that needs nothing else, for reading, printing and filing."""

from .page import checks, write

__all__ = ["checks", "write"]
