# SPDX-License-Identifier: GPL-3.0-or-later
"""Selection of the figures of a run with partial slip."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from .._util.quantities import CONTACT
from ..problem.contact_law import in_contact
from ..results.contact import repulsion_of
from ..results.slipping import moved_along
from ..solutions.tangential_quantities import ROUNDING_ERROR
from .contact_results import ContactResults
from .parts import new_figure
from .slipping import (
    FORCE_AND_MOTION,
    creep_curve,
    creepages,
    fretting_loop,
    largest_force,
    partial_slip_map,
    rolling_force,
)

if TYPE_CHECKING:
    import xarray as xr


def slip_figures(results: ContactResults) -> dict[str, Figure]:
    """Return the figures of partial slip by name; none with full sliding or without contact."""
    data = results.dataset
    if "friction_work" not in data or not np.any(
        in_contact(repulsion_of(data).values[chosen(data)])
    ):
        return {}
    across, size = results.map_look
    figures = {"partial_slip": new_figure(*size)}
    slip = np.stack([data[f"slip_{axis}"].values[chosen(data)] for axis in "xy"])
    repulsion = repulsion_of(data).values[chosen(data)]
    options: Any = {"unit": "m", "across": across}
    partial_slip_map(repulsion, slip, results.grid, figures["partial_slip"].subplots(), **options)
    along = driven(data)
    if along and "travel_body1" in data:
        if along[0] != "z":
            figures |= _rolling_figures(data, along[0])
    elif along:
        figures["fretting_loop"] = new_figure()
        fretting_loop(data, figures["fretting_loop"].subplots(), direction=along[0])
    return figures


def _rolling_figures(dataset: xr.Dataset, direction: str) -> dict[str, Figure]:
    """Return a figure of force versus distance rolled and, if creepage varies, a creep curve."""
    figures = {"rolling_force": new_figure()}
    rolling_force(dataset, figures["rolling_force"].subplots(), direction=direction)
    xi, force = creepages(dataset, direction)
    if np.ptp(xi) > 1e-3 * np.abs(xi).max():
        figures["creep_curve"] = new_figure()
        ax = figures["creep_curve"].subplots()
        ax.plot(100 * xi, force, "o", markersize=2, color="0.7", label="increments")
        ends = np.append(np.abs(np.diff(xi)) > 1e-3 * np.abs(xi).max(), True)
        creep_curve(
            xi[ends],
            force[ends],
            ax,
            largest=largest_force(dataset),
            label="last increment at each creepage",
        )
        ax.set_ylabel(CONTACT[FORCE_AND_MOTION[direction][0]].label)
    return figures


def chosen(dataset: xr.Dataset) -> int:
    """Return the index of the increment that the slip map shows.

    This is the last increment with the maximum tangential force. If there is no tangential force,
    it is the last increment with the maximum torque. If there is no torque either, it is the last
    increment with the maximum load.
    """
    pulls = np.hypot(*(dataset[f"tangential_load_{axis}"].values for axis in "xy"))
    if not pulls.max() > ROUNDING_ERROR * float(dataset["load"].max()):
        pulls = np.abs(dataset["torque"].values)
    if not pulls.any():
        pulls = dataset["load"].values
    return int(np.flatnonzero(pulls >= (1 - 1e-3) * pulls.max())[-1])


def driven(dataset: xr.Dataset) -> list[str]:
    """Return the directions, "x", "y" or "z", of tangential loading with displacement.

    In these directions, both force and displacement exceed rounding errors. Of x and y, the
    direction with the larger force comes first; "z", for torque and twist, comes last.
    """
    moved = moved_along(dataset)
    found = [
        name
        for name, (force, motion) in FORCE_AND_MOTION.items()
        if force in moved and motion in moved
    ]
    plain = [name for name in found if name != "z"]
    plain.sort(key=lambda name: -float(np.abs(dataset[FORCE_AND_MOTION[name][0]]).max()))
    return [*plain, *(name for name in found if name == "z")]
