# SPDX-License-Identifier: GPL-3.0-or-later
"""Fatigue criteria over a stress cycle, to locate crack initiation.

Each criterion takes a sequence of states of a simulation (of a rolling pass or a fretting loop), a
`Cycle`, or a stress array from any source. It returns a `FatigueField` with the value in each cell
of the body, the maximum value and the position of the maximum. For steady rolling, one state is
enough: see `steady_cycle`.

From states, the criteria use the total stress, i.e. the stress due to tractions, heat and plastic
strain plus the initial residual stress. Determine the limits of a material by fatigue tests, see
the theory page "Fatigue".
"""

from .criteria import (
    crossland,
    dang_van,
    fatemi_socie,
    findley,
    max_von_mises,
    orthogonal_shear,
)
from .cycle import Cycle, cycle, steady_cycle
from .exposure import Exposure, exposure
from .field import FatigueField
from .hertz_cycle import hertz_cycle
from .life import Life, life

__all__ = [
    "Cycle",
    "Exposure",
    "FatigueField",
    "Life",
    "crossland",
    "cycle",
    "dang_van",
    "exposure",
    "fatemi_socie",
    "findley",
    "hertz_cycle",
    "life",
    "max_von_mises",
    "orthogonal_shear",
    "steady_cycle",
]
