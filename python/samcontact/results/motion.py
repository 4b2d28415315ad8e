# SPDX-License-Identifier: GPL-3.0-or-later
"""Part of the results dataset that only a moving contact has: ways, and tracks on the bodies."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

if TYPE_CHECKING:
    from ..state import State

COMPONENTS = ("xx", "yy", "zz", "yz", "xz", "xy")


def moving_bodies(states: Sequence[State]) -> list[int]:
    """The bodies that moved through the contact."""
    return [body for body in (1, 2) if any(state.travel[body - 1] for state in states)]


def variable(dims: Any, data: Any, units: str, long_name: str) -> xr.Variable:
    """A variable with the attributes that each has."""
    return xr.Variable(dims, data, {"units": units, "long_name": long_name})


def add_motion(
    dataset: xr.Dataset, states: Sequence[State], inelastic: Sequence[int], volume: bool
) -> None:
    """Add the ways of the bodies and, for inelastic ones that moved, their tracks at the end.

    Without `volume` a track is its print only. Nothing is added where no body moved.
    """
    moved = moving_bodies(states)
    if not moved:
        return
    for body in (1, 2):
        travel = [state.travel[body - 1] for state in states]
        text = f"way of the surface of body {body} through the contact, towards +x"
        dataset[f"travel_body{body}"] = variable("increment", travel, "m", text)
    origin = [state.origin for state in states]
    text = "place of the contact's x = 0 in the grid"
    dataset["contact_origin"] = variable("increment", origin, "m", text)
    for body in inelastic:
        offset = [state.offset(body=body) for state in states]
        if any(offset):
            text = f"place of volume fields of body {body} past the cells of the grid, along x"
            dataset[f"offset_body{body}"] = variable("increment", offset, "m", text)
        # the largest may have left the grid
        largest = [state.max_equivalent_plastic_strain(body=body) for state in states]
        dataset[f"max_equivalent_plastic_strain_body{body}"].values[:] = largest
        if body in moved:
            _add_track(dataset, states[-1], body, volume)


def _add_track(dataset: xr.Dataset, last: State, body: int, volume: bool) -> None:
    track, x = last.track(body=body), f"track_x_body{body}"
    text = f"cell centres along x on body {body}, 0 where the contact stood at the start"
    dataset.coords[x] = variable(x, track.x, "m", text)

    def add(name: str, dims: tuple[str, ...], data: Any, units: str, text: str) -> None:
        long_name = f"{text} along the track, body {body}, unloaded"
        dataset[f"track_{name}_body{body}"] = variable(dims, data, units, long_name)

    depth = "normal surface displacement by plastic strain, into the body,"
    add("residual_displacement", (x, "y"), track.residual_displacement(), "m", depth)
    if not volume:
        return
    if "component" not in dataset.coords:
        dataset.coords["component"] = ("component", list(COMPONENTS))
    field, tensor = (x, "y", "z"), ("component", x, "y", "z")
    stress = track.residual_stress()
    mean = np.mean(stress[:3], axis=0)
    add("residual_stress", tensor, stress, "Pa", "stress due to plastic strain")
    add("residual_von_mises", field, track.residual_von_mises(), "Pa", "von Mises stress")
    add("residual_hydrostatic", field, mean, "Pa", "mean normal stress")
    strain = track.equivalent_plastic_strain()
    add("plastic_strain", tensor, track.plastic_strain(), "1", "plastic strain tensor")
    add("equivalent_plastic_strain", field, strain, "1", "equivalent plastic strain")
