# SPDX-License-Identifier: GPL-3.0-or-later
"""Variables of the results dataset for moving bodies: travel and tracks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import xarray as xr

from .._util.quantities import CONTACT, TRACK

if TYPE_CHECKING:
    from ..solutions.state import State


def moving_bodies(states: Sequence[State]) -> list[int]:
    """Return the numbers of the bodies that have moved along x through the contact."""
    return [body for body in (1, 2) if any(state.travel[body - 1] for state in states)]


def add(dataset: xr.Dataset, name: str, dims: Any, data: Any, body: int | None = None) -> None:
    """Add a variable to the dataset, with unit and long name from `CONTACT`.

    body: number of the body, which is appended to the name of the variable.
    """
    suffix = "" if body is None else f"_body{body}"
    dataset[name + suffix] = CONTACT[name].variable(dims, data, body)


def add_motion(
    dataset: xr.Dataset, states: Sequence[State], inelastic: Sequence[int], volume: bool
) -> None:
    """Add the travel of the bodies, and the tracks of moving elastic-plastic bodies.

    Nothing is added if no body moved. A track contains the fields of a body along its whole path,
    after the last increment. It is added if the body has moved along x and, after the last
    increment, is not displaced along y. If `volume` is False, the track contains only the
    residual imprint.

    inelastic: numbers of the elastic-plastic bodies.
    """
    moved = moving_bodies(states)
    if any(any(state.lateral_travel) for state in states):
        for body in (1, 2):
            lateral = [state.lateral_travel[body - 1] for state in states]
            add(dataset, "lateral_travel", "increment", lateral, body)
    if not moved:
        return
    for body in (1, 2):
        add(dataset, "travel", "increment", [state.travel[body - 1] for state in states], body)
    add(dataset, "contact_origin", "increment", [state.origin for state in states])
    for body in inelastic:
        offset = [state.offset(body=body) for state in states]
        if any(offset):
            add(dataset, "offset", "increment", offset, body)
        if body in moved and states[-1].lateral_travel[body - 1] == 0.0:
            track = states[-1].track(body=body).to_dataset(volume=volume)
            names = {n: stored for n, stored in _stored_names(body).items() if n in track.variables}
            dataset.update(track.rename(names))


def _stored_names(body: int) -> dict[str, str]:
    """Return the name in results files of each variable of a track dataset."""
    return {name: f"track_{'position' if name == 'x' else name}_body{body}" for name in TRACK}


def track_of(dataset: xr.Dataset, body: int) -> xr.Dataset | None:
    """Return the stored track of a body, named as in `Track.to_dataset`, or None if not stored."""
    names = _stored_names(body)
    if names["x"] not in dataset.coords:
        return None
    stored = {stored: name for name, stored in names.items()}
    short = {name: own for name, own in stored.items() if name in dataset.variables}
    track: xr.Dataset = dataset[[name for name in short if name in dataset.data_vars]].rename(short)
    sizes = {name: dataset.attrs[name] for name in ("dx", "dy", "dz") if name in dataset.attrs}
    track.attrs = {"body": body, **sizes}
    return track
