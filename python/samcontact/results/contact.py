# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact in the results dataset."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import xarray as xr


def repulsion_of(dataset: xr.Dataset) -> xr.DataArray:
    """Return the repulsion of each increment [Pa]; in hard contact it is the pressure."""
    return dataset["repulsion" if "repulsion" in dataset else "pressure"]
