# SPDX-License-Identifier: GPL-3.0-or-later
"""Table of estimated errors for the terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..accuracy.error_rows import error_rows
from .tables import Sheet

if TYPE_CHECKING:
    import xarray as xr


def errors_sheet(dataset: xr.Dataset) -> Sheet | None:
    """Return the table of maximum values and estimated errors, or None without error estimates."""
    rows = error_rows(dataset)
    if not rows:
        return None
    targets = [row.target for row in rows if row.target is not None]
    title = "Estimated errors" if targets else "Estimated grid errors (from a grid coarsened by 2)"
    sheet = Sheet(title)
    sheet.add("", [row.label for row in rows])
    sheet.add(
        "cycle" if "cycle" in dataset.dims else "increment", [str(row.increment) for row in rows]
    )
    sheet.add("value", [row.shown for row in rows])
    sheet.add("error\n[%]" if targets else "grid error\n[%]", [row.percent for row in rows])
    if any(row.by_increments is not None for row in rows):
        shares = ["" if r.by_increments is None else f"{100 * r.by_increments:.2g}" for r in rows]
        sheet.add("increment\nerror [%]", shares)
    if targets:
        sheet.add("target\n[%]", [f"{100 * accuracy:.3g}" for accuracy in targets])
    return sheet
