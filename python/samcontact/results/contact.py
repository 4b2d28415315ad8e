# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact pressure and repulsion in the results dataset."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..problem.contact_law import rubbing_pressure

if TYPE_CHECKING:
    import xarray as xr

    from .._util.checks import FloatArray


def repulsion_of(dataset: xr.Dataset) -> xr.DataArray:
    """Return the repulsion [Pa] in each increment; without adhesion, it equals the pressure."""
    return dataset["repulsion" if "repulsion" in dataset else "pressure"]


def rubbing_pressure_of(dataset: xr.Dataset) -> FloatArray:
    """Return the pressure [Pa] that determines the friction, in each increment."""
    by_compression = dataset.attrs.get("adhesion_friction_on") == "compression"
    repulsion, pressure = repulsion_of(dataset).values, dataset["pressure"].values
    return rubbing_pressure(repulsion, pressure, by_compression)
