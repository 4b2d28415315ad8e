# SPDX-License-Identifier: GPL-3.0-or-later
"""Criteria of fatigue over a cycle of stress: where a crack is likely to begin.

Each takes a sequence of states of a simulation (of a rolling pass, a fretting loop), a `Cycle`, or
an array of stress of any other origin, and returns a `FatigueField`: a value for each cell of the
body, the largest and its place. A contact that rolls steadily needs one state: see `passing`.

Stress is the total one by default: of tractions, heat and plastic strain, and the residual stress
that was there from the start. What is a limit for a material comes from its fatigue tests: see the
theory page, "Fatigue".
"""

from .criteria import crossland, dang_van, fatemi_socie, findley, orthogonal_shear
from .cycle import Cycle, cycle, passing
from .field import FatigueField

__all__ = [
    "Cycle",
    "FatigueField",
    "crossland",
    "cycle",
    "dang_van",
    "fatemi_socie",
    "findley",
    "orthogonal_shear",
    "passing",
]
