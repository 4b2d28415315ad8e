# SPDX-License-Identifier: GPL-3.0-or-later
"""Report of an asperity collision: energy of each pass, and forces versus offset."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from .._util.check import Check
from .._util.display import quantity
from .._util.quantities import ASPERITIES
from ..asperities.series import cells_under_load, pass_results
from ..plotting.asperities import over_passes
from ..plotting.parts import counted, finish, new_figure
from .figures import ReportFigure, embedded
from .quality_checks import cells_across_contact, layers_across_plastic_zone
from .tables import maxima_table, values_table

if TYPE_CHECKING:
    import xarray as xr

REQUIRED_VARIABLES = ("force_x", "force_z", "work", "net_energy", "energy_imbalance")
MAX_MISSING_ENERGY = 0.05
"""Limit of the unaccounted energy of a pass, relative to the maximum energy of any pass (a later
pass may need almost no energy). With more increments, the unaccounted energy decreases."""
MAX_MISSING_WORK = 0.02
"""Limit of the unaccounted energy of a pass, relative to the maximum work during the pass. Most of
this work is recovered by the end of the pass."""
MAX_FINAL_FORCE = 1e-6
"""Limit of the force at the end of a pass, relative to the maximum force."""
_PASS_VARIABLES = (
    "net_energy", "dissipation", "residual_energy", "energy_imbalance", "residual_displacement",
    "max_force_x", "min_force_x", "max_force_z", "max_pressure", "cells_across_contact",
    "layers_across_plastic_zone",
)  # fmt: skip


def content(dataset: xr.Dataset) -> dict[str, Any]:
    """Return the variables of the page template for an asperity collision."""
    passes = pass_results(dataset)
    table = values_table(passes, "pass", ASPERITIES, _PASS_VARIABLES)
    maxima = maxima_table(passes, "pass", ASPERITIES, _PASS_VARIABLES[:9])
    return {
        "file": "series.nc",
        "answers": [("results", "Results", maxima)],
        "values": [("passes", "Passes", table)],
        "figures": list(_figures(dataset)),
    }


def checks(dataset: xr.Dataset) -> Iterator[Check]:
    missing = np.abs(dataset["energy_imbalance"].values)
    taken = max(
        float(np.abs(dataset[name]).max())
        for name in ("net_energy", "dissipation", "residual_energy")
    )
    if float(dataset["dissipation"].max()) > 0:  # elastic passes dissipate no energy
        name = "energy balance: unaccounted energy, relative to the maximum energy of a pass"
        yield Check(name, float(missing.max()) / taken, MAX_MISSING_ENERGY)
    exchanged = np.nanmax(np.abs(dataset["work"].values), axis=1)
    met = exchanged > 0
    if met.any():
        name = "energy balance: unaccounted energy, relative to the maximum work within the pass"
        yield Check(name, float(np.max(missing[met] / exchanged[met])), MAX_MISSING_WORK)
    force = dataset["normal_force"]
    end = np.array([row[np.isfinite(row)][-1] for row in force.values])
    largest = float(force.max())
    if largest > 0:
        name = "normal force at the end of a pass, relative to the maximum force"
        yield Check(name, float(np.max(end)) / largest, MAX_FINAL_FORCE)
        yield cells_across_contact(float(cells_under_load(dataset).min()))
    for body in (1, 2):
        yield from layers_across_plastic_zone(
            dataset["layers_across_plastic_zone"].sel(body=body), body
        )


def _figures(dataset: xr.Dataset) -> Iterator[ReportFigure]:
    names = {
        "force_x": "Tangential force",
        "force_z": "Normal force",
        "load_ratio": "Ratio of tangential to normal force",
    }
    for name, heading in names.items():
        figure = new_figure()
        over_passes(dataset, figure.subplots(), quantity=name)
        unit = "" if name == "load_ratio" else "N"
        ends = dataset[name].min(), dataset[name].max()
        low, high = (quantity(float(value), unit) for value in ends)
        yield embedded(
            f"{heading} versus offset of the spheres",
            f"{heading} versus offset of the spheres in each pass, from {low} to {high}.",
            figure,
        )
    if dataset.sizes["pass"] > 1:
        figure = new_figure()
        ax = figure.subplots()
        ax.plot(dataset["pass"], dataset["net_energy"], "o-", markersize=3, label="net energy")
        label = "energy of the residual stress"
        ax.plot(dataset["pass"], dataset["residual_energy"], "s--", markersize=3, label=label)
        ax.set_xlabel("pass")
        ax.set_ylabel("energy [J]")
        ax.legend(frameon=False)
        finish(counted(ax))
        yield embedded("Energy of the passes", "Net and stored energy of each pass.", figure)
