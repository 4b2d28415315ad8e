# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of an asperity collision as a labelled dataset, by pass and increment."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._util.checks import FloatArray
from .._util.quantities import ASPERITIES
from .._util.version import version

if TYPE_CHECKING:
    import xarray as xr

    from .collision import Collision

BY_INCREMENT = (
    "offset", "angle", "approach", "normal_force", "force_x", "force_y", "force_z", "load_ratio",
    "work", "plastic_work", "max_pressure", "contact_area", "max_equivalent_plastic_strain",
    "cells_across_contact", "layers_across_plastic_zone",
)  # fmt: skip
BY_PASS = (
    "net_energy", "dissipation", "residual_energy", "energy_imbalance", "residual_displacement",
)  # fmt: skip


@dataclass
class IncrementRow:
    """Results of one increment.

    `work` is the work since the start of the pass. `residual_energy` and `residual_displacement`
    are values after the pass; they are stored for the last increment of a complete pass only, and
    are NaN for all others.
    """

    offset: float
    angle: float
    approach: float
    normal_force: float
    force_x: float
    force_y: float
    force_z: float
    plastic_work: float
    max_pressure: float
    contact_area: float
    max_equivalent_plastic_strain: tuple[float, float]
    cells_across_contact: float
    layers_across_plastic_zone: tuple[float, float]
    work: float = 0.0
    residual_energy: float = math.nan
    residual_displacement: tuple[float, float] = (math.nan, math.nan)


def _table(passes: Sequence[Sequence[IncrementRow]], name: str) -> FloatArray:
    """Array of a quantity with the axes (pass, increment) or (pass, increment, body).

    Values after the end of shorter passes are NaN.
    """
    values = [np.array([getattr(row, name) for row in rows]) for rows in passes]
    longest = max(len(column) for column in values)
    table = np.full((len(values), longest, *values[0].shape[1:]), np.nan)
    for row, column in zip(table, values, strict=True):
        row[: len(column)] = column
    return table


def to_dataset(collision: Collision, passes: Sequence[Sequence[IncrementRow]]) -> xr.Dataset:
    """Convert the results of all passes to a labelled dataset with units."""
    import xarray as xr

    data = {name: _table(passes, name) for name in BY_INCREMENT if name != "load_ratio"}
    with np.errstate(invalid="ignore", divide="ignore"):
        ratio = data["force_x"] / data["force_z"]
    data["load_ratio"] = np.where(data["normal_force"] > 0, ratio, np.nan)
    last = [rows[-1] for rows in passes]
    stored = np.array([row.residual_energy for row in last])
    ended = np.isfinite(stored)
    net, plastic = (np.array([getattr(row, n) for row in last]) for n in ("work", "plastic_work"))
    data["net_energy"] = np.where(ended, net, np.nan)
    data["dissipation"] = np.where(ended, np.diff(plastic, prepend=0.0), np.nan)
    data["residual_energy"] = stored
    rest = data["net_energy"] - data["dissipation"] - np.diff(stored, prepend=0.0)
    data["energy_imbalance"] = rest
    data["residual_displacement"] = np.array([row.residual_displacement for row in last])

    def dims(name: str) -> tuple[str, ...]:
        by_pass = ("pass",) if name in BY_PASS else ("pass", "increment")
        return (*by_pass, "body") if data[name].ndim > len(by_pass) else by_pass

    names = (*BY_INCREMENT, *BY_PASS)
    return xr.Dataset(
        {name: ASPERITIES[name].variable(dims(name), data[name]) for name in names},
        coords={"pass": np.arange(1, len(passes) + 1), "body": [1, 2]},
        attrs={
            "title": "asperity collision of two spheres",
            "samcontact_version": version,
            **asdict(collision),
        },
    )


def cells_under_load(series: xr.Dataset) -> xr.DataArray:
    """Number of cells across the contact at the maximum load of each pass; NaN without contact."""
    where = series["normal_force"].fillna(0.0).argmax("increment")
    cells: xr.DataArray = series["cells_across_contact"].isel(increment=where)
    return cells


def pass_results(series: xr.Dataset) -> xr.Dataset:
    """Results of each pass: values at the end, extreme forces, maximum pressure and resolution."""
    passes: xr.Dataset = series[list(BY_PASS)].assign(
        max_force_x=series["force_x"].max("increment"),
        min_force_x=series["force_x"].min("increment"),
        max_force_z=series["force_z"].max("increment"),
        max_pressure=series["max_pressure"].max("increment"),
        cells_across_contact=cells_under_load(series),
        layers_across_plastic_zone=series["layers_across_plastic_zone"].max("increment"),
    )
    return passes
