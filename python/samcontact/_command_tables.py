# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables that the commands print."""

from __future__ import annotations

from rich.table import Table
from rich.text import Text


def new_table(title: str, *columns: str) -> Table:
    """Numbers on the right of their columns; the first column names them."""
    table = Table(title=title, title_justify="left")
    for index, column in enumerate(columns):
        # Text: "[mm²]" in a plain string would be read as markup
        table.add_column(Text(column), justify="right" if index else "left")
    return table
