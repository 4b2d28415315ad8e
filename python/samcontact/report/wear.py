# SPDX-License-Identifier: GPL-3.0-or-later
"""What the page of wear has: what each cycle removed, worn surfaces."""

from __future__ import annotations

from collections.abc import Iterator
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import plotting
from .._verdict import Verdict
from ..plotting.parts import new_figure
from ..results.vtk import cell_size
from .figures import ReportFigure, embedded
from .tables import study_table
from .verdicts import contact_cells, plastic_layers

if TYPE_CHECKING:
    import xarray as xr

NEEDED = ("volume", "lost", "depth", "wear_rate")
VOLUME = 1e-9
"""Part of the removed volume by which that lost by the surface may differ."""
MOST_PROFILES = 10  # in a figure
# variable: (heading, unit shown, factor)
_CYCLES = {
    "volume": ("removed volume", "µm³", 1e18),
    "depth": ("wear depth", "µm", 1e6),
    "surface_strain": ("plastic strain of the first layer", "%", 1e2),
    "max_plastic_strain": ("largest plastic strain", "%", 1e2),
    "max_pressure": ("maximum pressure", "MPa", 1e-6),
    "max_von_mises": ("maximum von Mises stress", "MPa", 1e-6),
    "contact_area": ("contact area", "µm²", 1e12),
    "contact_cells": ("across the contact", "cells", 1.0),
    "plastic_layers": ("plastic zone", "layers", 1.0),
}


def content(dataset: xr.Dataset) -> dict[str, Any]:
    """Its part of what the template names."""
    return {
        "file": "wear.nc",
        "checks": list(_checks(dataset)),
        "values": [("cycles", "Cycles", study_table(dataset, "cycle", _CYCLES))],
        "figures": list(_figures(dataset)),
    }


def _checks(dataset: xr.Dataset) -> Iterator[Verdict]:
    removed = float(dataset["volume"].max())
    difference = float(np.abs(dataset["volume"] - dataset["lost"]).max())
    name = "volume lost by the surface against that removed, relative"
    yield Verdict(name, difference / removed if removed > 0 else difference, VOLUME)
    # of the surface that the user gave: a worn one touches on its edges
    yield contact_cells(float(dataset["contact_cells"][0]), " of the first cycle")
    for body in dataset["body"].values.tolist():
        yield from plastic_layers(dataset["plastic_layers"].sel(body=body), body)


def _figures(dataset: xr.Dataset) -> Iterator[ReportFigure]:
    figure = new_figure()
    stored = _stored(dataset)
    plotting.wear.wear_rate(stored, figure.subplots())
    stopped = "Nothing wears any more" if dataset.attrs.get("stopped") else "It still wears"
    count = dataset.sizes["cycle"]
    text = f"Volume worn in each cycle. {stopped} after {count} cycles."
    yield embedded("Worn volume of each cycle", text, figure)
    step = -(-count // MOST_PROFILES)
    shown = sorted({0, *range(count, 0, -step)})
    for body in stored.worn:
        deepest = stored.profile(0, body) - stored.profile(-1, body)
        text = f"at most {deepest.max() * 1e6:.4g} µm lower than at the start."
        for axis in ("x", "y"):
            figure = new_figure()
            options: dict[str, Any] = {"body": body, "axis": axis, "cycles": shown}
            plotting.wear.worn_profile(stored, figure.subplots(), **options)
            caption = f"Heights of body {body} along {axis}, after several cycles"
            yield embedded(
                caption, f"Heights through the middle of the worn surface, {text}", figure
            )
        figure = new_figure()
        plotting.wear.surface_map(stored, figure.subplots(), body=body)
        caption = f"Heights of body {body} after cycle {count}"
        yield embedded(caption, f"Map of the worn surface, {text}", figure)


def _stored(dataset: xr.Dataset) -> Any:
    """What the figures ask of a WearResult, from its dataset."""
    worn = tuple(dataset["body"].values.tolist())
    x = {body: dataset[f"x_body{body}"].values for body in worn}
    heights = {body: dataset[f"heights_body{body}"].values for body in worn}
    grid = SimpleNamespace(
        y=dataset["y"].values, dy=cell_size(dataset, "y"), dx=cell_size(dataset, f"x_body{worn[0]}")
    )
    return SimpleNamespace(
        worn=worn,
        grid=grid,
        rate=dataset["wear_rate"].values,
        cycles=[SimpleNamespace(number=number) for number in dataset["cycle"].values.tolist()],
        x=lambda body=None: x[worn[-1] if body is None else body],
        profile=lambda cycle=-1, body=None: heights[worn[-1] if body is None else body][cycle],
    )
