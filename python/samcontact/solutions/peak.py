# SPDX-License-Identifier: GPL-3.0-or-later
"""Which increment of a run is its peak."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

if TYPE_CHECKING:
    import xarray as xr


_SAME_STRESS = 1e-3
"""Relative: flow without hardening holds the stress at the yield stress, to its tolerance."""
_SAME = 1e-9
"""Relative, of pressures and loads: they differ by rounding."""


def peak(stress: ArrayLike | None, pressure: ArrayLike, load: ArrayLike) -> int:
    """Position of the increment with the largest von Mises stress.

    Of those with the same the one with the largest pressure, then the largest load, then the
    first: a rolling contact has the same load all the way, and a rough spot of the way tells most.

    Parameters
    ----------
    stress, pressure, load : array_like, shape (increments,)
        Largest von Mises stress of all bodies [Pa], None where there is no volume; largest
        pressure [Pa]; load [N]. Increments with NaN are left out.
    """
    pressures = np.asarray(pressure, dtype=np.float64)
    left = np.isfinite(pressures)
    values = [(pressures, _SAME), (np.asarray(load, dtype=np.float64), _SAME)]
    if stress is not None:
        values.insert(0, (np.asarray(stress, dtype=np.float64), _SAME_STRESS))
    for value, same in values:
        if np.any(np.isfinite(value[left])):
            largest = np.nanmax(value[left])
            left &= value >= largest - same * abs(largest)
    return int(np.argmax(left))


def peak_of_dataset(dataset: xr.Dataset) -> int:
    """The same of a results dataset."""
    names = [f"max_von_mises_body{body}" for body in (1, 2)]
    stress = [dataset[name].values for name in names if name in dataset]
    largest = np.max(stress, axis=0) if stress else None
    return peak(largest, dataset["max_pressure"].values, dataset["load"].values)
