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


def contact_columns(body: int) -> list[tuple[str, str, float, str]]:
    """Variables of a contact that its tables show: name, heading, factor to its unit, format."""
    return [
        ("load", "load\n[N]", 1.0, ".6g"),
        ("approach", "approach\n[µm]", 1e6, ".4f"),
        ("max_pressure", "p_max\n[MPa]", 1e-6, ".1f"),
        (f"max_von_mises_body{body}", "von Mises\n[MPa]", 1e-6, ".1f"),
        (f"max_equivalent_plastic_strain_body{body}", "plastic\nstrain [%]", 1e2, ".4f"),
        (f"max_temperature_body{body}", "heating\n[K]", 1.0, ".1f"),
    ]
