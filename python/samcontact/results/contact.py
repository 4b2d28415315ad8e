# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact pressure and repulsion in the results dataset."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import xarray as xr


def repulsion_of(dataset: xr.Dataset) -> xr.DataArray:
    """Return the repulsion [Pa] in each increment; in hard contact it equals the pressure."""
    return dataset["repulsion" if "repulsion" in dataset else "pressure"]
