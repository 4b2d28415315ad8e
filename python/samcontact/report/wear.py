# SPDX-License-Identifier: GPL-3.0-or-later
"""Report of wear: removed volume of each cycle, and worn surfaces."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import plotting
from .._util.check import Check
from .._util.wear_quantities import WEAR
from ..plotting.parts import new_figure
from ..wear.coating import MAX_WORN_SHARE
from .figures import ReportFigure, embedded
from .quality_checks import cells_across_contact, layers_across_plastic_zone
from .tables import maxima_table, values_table

if TYPE_CHECKING:
    import xarray as xr

REQUIRED_VARIABLES = ("volume", "lost_volume", "depth", "wear_rate")
MAX_VOLUME_DIFFERENCE = 1e-9
"""Limit of the difference between the removed volume and the decrease of the volume below the
surface in a cycle, relative to the maximum removed volume of a cycle."""
MAX_PROFILES = 10  # maximum number of profiles in a figure
_CYCLE_VARIABLES = (
    "volume", "depth", "surface_strain", "max_equivalent_plastic_strain", "max_pressure",
    "max_von_mises", "contact_area", "cells_across_contact", "layers_across_plastic_zone",
    "friction_work", "slip_distance", "stick_area", "plastic_flow", "coating_worn_share",
)  # fmt: skip


def content(dataset: xr.Dataset) -> dict[str, Any]:
    """Return the variables of the page template for wear."""
    return {
        "file": "wear.nc",
        "answers": [("results", "Results", maxima_table(dataset, "cycle", WEAR, _CYCLE_VARIABLES))],
        "values": [("cycles", "Cycles", values_table(dataset, "cycle", WEAR, _CYCLE_VARIABLES))],
        "figures": list(_figures(dataset)),
    }


def checks(dataset: xr.Dataset) -> Iterator[Check]:
    removed = float(dataset["volume"].max())
    difference = float(np.abs(dataset["volume"] - dataset["lost_volume"]).max())
    name = "volume balance: relative difference between surface and removed volume"
    yield Check(name, difference / removed if removed > 0 else difference, MAX_VOLUME_DIFFERENCE)
    # of the initial surface: a worn surface touches at its edges
    yield cells_across_contact(float(dataset["cells_across_contact"][0]), " of the first cycle")
    if "coating_worn_share" in dataset:
        share = float(dataset["coating_worn_share"].max())
        yield Check("maximum worn share of a top layer", share, MAX_WORN_SHARE)
    for body in dataset["body"].values.tolist() if "layers_across_plastic_zone" in dataset else ():
        yield from layers_across_plastic_zone(
            dataset["layers_across_plastic_zone"].sel(body=body), body
        )


def _figures(dataset: xr.Dataset) -> Iterator[ReportFigure]:
    figure = new_figure()
    plotting.wear.wear_rate(dataset, figure.subplots())
    stopped = "has ceased" if dataset.attrs.get("stopped") else "has not ceased"
    count = dataset.sizes["cycle"]
    text = f"Volume worn in each cycle. Wear {stopped} after {count} cycles."
    yield embedded("Worn volume of each cycle", text, figure)
    step = -(-count // MAX_PROFILES)
    shown = sorted({0, *range(count, 0, -step)})
    for body in dataset["body"].values.tolist():
        heights = dataset[f"heights_body{body}"].values
        deepest = heights[0] - heights[-1]
        text = f"at most {deepest.max() * 1e6:.4g} µm below the initial surface."
        for axis in ("x", "y"):
            figure = new_figure()
            options: dict[str, Any] = {"body": body, "axis": axis, "cycles": shown}
            where = plotting.wear.worn_profile(dataset, figure.subplots(), **options).get_title()
            caption = f"Heights of body {body} along {axis}, after several cycles"
            yield embedded(caption, f"Heights of the worn surface at {where}, {text}", figure)
        figure = new_figure()
        plotting.wear.surface_map(dataset, figure.subplots(), body=body)
        caption = f"Heights of body {body} after cycle {count}"
        yield embedded(caption, f"Map of the worn surface, {text}", figure)
