# SPDX-License-Identifier: GPL-3.0-or-later
"""Report of a run: one self-contained HTML file, for reading, printing and archiving."""

from .page import checks, write

__all__ = ["checks", "write"]
