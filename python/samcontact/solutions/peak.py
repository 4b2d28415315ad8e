# SPDX-License-Identifier: GPL-3.0-or-later
"""Selection of the increment of maximum stress in a run."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

if TYPE_CHECKING:
    import xarray as xr


_STRESS_TOLERANCE = 1e-3
"""Relative tolerance on stress: flow without hardening keeps it at yield, to the tolerance."""
_ROUNDING_ERROR = 1e-9
"""Relative tolerance on pressures and loads, for rounding."""


def peak(stress: ArrayLike | None, pressure: ArrayLike, load: ArrayLike) -> int:
    """Index (from 0) of the increment with the maximum von Mises stress.

    Among increments of equal stress, it is the one with the maximum pressure, then with the maximum
    load, then the first: in rolling contact the load is constant, and a rough spot on the track is
    the most informative.

    Parameters
    ----------
    stress, pressure, load : array_like, shape (increments,)
        Maximum von Mises stress of all bodies [Pa], None without a volume; maximum pressure [Pa];
        load [N]. Increments with NaN are ignored.
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
    """Index (from 0) of the increment with maximum von Mises stress in a results dataset."""
    names = [f"max_von_mises_body{body}" for body in (1, 2)]
    stress = [dataset[name].values for name in names if name in dataset]
    largest = np.max(stress, axis=0) if stress else None
    return peak(largest, dataset["max_pressure"].values, dataset["load"].values)
