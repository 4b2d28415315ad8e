# SPDX-License-Identifier: GPL-3.0-or-later
"""Yield stress of steel from its hardness, e.g. for a profile of hardness over depth.

    material.with_yield_profile(depth, hardness.yield_from_vickers(HV) / yield_stress)

Both functions of this module are estimates from the bulk hardness. Hardness profiles of nitrided
and carburised steel are not provided, because they depend on the treatment: use measured profiles.
"""

from __future__ import annotations

import warnings

import numpy as np
from numpy.typing import ArrayLike

from ._util.checks import FloatArray, real_array

__all__ = ["HardnessRangeWarning", "flow_stress_from_vickers", "yield_from_vickers"]

STANDARD_GRAVITY = 9.80665
"""Standard gravity [m/s^2], to convert Vickers numbers in kgf/mm^2."""
FITTED_RANGE = (129.0, 632.0)
"""Range of Vickers numbers of the steels to which the yield stress was fitted."""
PLAUSIBLE_RANGE = (20.0, 3000.0)
"""Range of Vickers numbers of metals and hard carbides; numbers in MPa or GPa are outside."""


class HardnessRangeWarning(UserWarning):
    """Warning that a hardness is outside the range of the data to which the relation was fitted."""


def _vickers(HV: ArrayLike) -> FloatArray:
    hardness = real_array("HV", HV)
    wrong = hardness[~((hardness >= PLAUSIBLE_RANGE[0]) & (hardness <= PLAUSIBLE_RANGE[1]))]
    if wrong.size:
        raise ValueError(
            f"HV must be Vickers numbers (kgf/mm^2) from {PLAUSIBLE_RANGE[0]:g} to "
            f"{PLAUSIBLE_RANGE[1]:g}, got {wrong.flat[0]:g}: convert GPa, e.g. 7 GPa is HV 714"
        )
    return hardness


def yield_from_vickers(HV: ArrayLike) -> FloatArray:
    """Yield stress of steel [Pa] by the regression -90.7 MPa + 2.876 MPa * HV.

    The data are from 165 non-austenitic, hypoeutectoid steels of HV 129 to 632; the standard error
    is 102 MPa. E. J. Pavlina, C. J. Van Tyne, J. Mater. Eng. Perform. 17 (2008) 888-893, table 1,
    doi:10.1007/s11665-008-9225-5.

    Parameters
    ----------
    HV : array_like
        Vickers hardness [kgf/mm^2], of any shape.

    Returns
    -------
    ndarray
        0.2 % yield stress [Pa], in the shape of `HV`.

    Raises
    ------
    ValueError
        A value is not a Vickers number of a metal.

    Warns
    -----
    HardnessRangeWarning
        A hardness is outside the range of the data; the linear relation is extrapolated.
    """
    hardness = _vickers(HV)
    beyond = hardness[(hardness < FITTED_RANGE[0]) | (hardness > FITTED_RANGE[1])]
    if beyond.size:
        warnings.warn(
            f"HV = {beyond.flat[0]:g} is outside the range of the data, {FITTED_RANGE[0]:g} to "
            f"{FITTED_RANGE[1]:g}: the linear relation is extrapolated",
            HardnessRangeWarning,
            stacklevel=2,
        )
    return np.asarray(-90.7e6 + 2.876e6 * hardness)


def flow_stress_from_vickers(HV: ArrayLike) -> FloatArray:
    """Flow stress at about 8 % plastic strain [Pa], a third of the hardness.

    The relation holds for metals that harden little further: D. Tabor, *The Hardness of Metals*
    (1951), chapter 7.
    This stress is a point on the hardening curve, not the yield stress.

    Parameters
    ----------
    HV : array_like
        Vickers hardness [kgf/mm^2], of any shape.

    Returns
    -------
    ndarray
        Flow stress [Pa], in the shape of `HV`.

    Raises
    ------
    ValueError
        A value is not a Vickers number of a metal.
    """
    return np.asarray(_vickers(HV) * STANDARD_GRAVITY * 1e6 / 3.0)
