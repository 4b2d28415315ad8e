# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields of a body in two states, extended to the cells of both states."""

from __future__ import annotations

import numpy as np

from .._util.checks import FloatArray
from .track import Track


def on_common_cells(before: Track, after: Track, field: str) -> tuple[FloatArray, FloatArray]:
    """Return a field of two tracks, both on all cells of the two; 0 in cells that a track lacks.

    A `Track` covers the part of a body with plastic strain, which may differ between two states.
    """
    tracks, corner, size = (before, after), [], []
    for axis in "xy":
        places = np.concatenate([getattr(track, axis) for track in tracks])
        step = getattr(after.grid, f"d{axis}")
        corner.append(places.min())
        size.append(round(np.ptp(places) / step) + 1)
    fields = []
    for track in tracks:
        values: FloatArray = getattr(track, field)()
        whole = np.zeros((*values.shape[:-3], *size, max(t.grid.nz for t in tracks)))
        i = round((track.x[0] - corner[0]) / track.grid.dx)
        j = round((track.y[0] - corner[1]) / track.grid.dy)
        nx, ny, nz = track.grid.volume_shape
        whole[..., i : i + nx, j : j + ny, :nz] = values
        fields.append(whole)
    return fields[0], fields[1]
