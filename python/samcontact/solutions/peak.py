# SPDX-License-Identifier: GPL-3.0-or-later
"""Selection of the increment with the maximum stress in a run."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

if TYPE_CHECKING:
    import xarray as xr


_STRESS_TOLERANCE = 1e-3
"""Relative difference up to which stresses count as equal. Without hardening, many increments have
the yield stress as maximum stress."""
_ROUNDING_ERROR = 1e-9
"""Relative difference up to which pressures or loads count as equal, due to rounding errors."""


def peak(stress: ArrayLike | None, pressure: ArrayLike, load: ArrayLike) -> int:
    """Return the index (from 0) of the increment with the maximum von Mises stress.

    If several increments have the same maximum stress, the increment with the largest pressure is
    chosen; if their pressures are equal too, the increment with the largest load; if their loads
    are equal too, the first increment. In rolling contact with a constant load, the chosen
    increment is thus one with a high pressure, e.g. on a rough spot of the track.

    Parameters
    ----------
    stress, pressure, load : array_like, shape (increments,)
        Maximum von Mises stress of all bodies [Pa], or None if there is no volume; maximum pressure
        [Pa]; load [N]. Increments with NaN are ignored.
    """
    pressures = np.asarray(pressure, dtype=np.float64)
    left = np.isfinite(pressures)
    values = [(pressures, _ROUNDING_ERROR), (np.asarray(load, dtype=np.float64), _ROUNDING_ERROR)]
    if stress is not None:
        values.insert(0, (np.asarray(stress, dtype=np.float64), _STRESS_TOLERANCE))
    for value, same in values:
        if np.any(np.isfinite(value[left])):
            largest = np.nanmax(value[left])
            left &= value >= largest - same * abs(largest)
    return int(np.argmax(left))


def peak_of_dataset(dataset: xr.Dataset) -> int:
    """Return the index (from 0) of the increment with maximum von Mises stress in a dataset."""
    names = [f"max_von_mises_body{body}" for body in (1, 2)]
    stress = [dataset[name].values for name in names if name in dataset]
    largest = np.max(stress, axis=0) if stress else None
    return peak(largest, dataset["max_pressure"].values, dataset["load"].values)
