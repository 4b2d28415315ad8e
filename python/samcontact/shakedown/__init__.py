# SPDX-License-Identifier: GPL-3.0-or-later
"""Shakedown limits and cyclic simulation: does plastic flow cease under repeated loading?

Functions that return a limit of the Hertz pressure in closed form, for rolling and sliding: `line`
is exact by Melan's theorem; `point` and `elliptic` are upper bounds; `point_lower_bound` is a lower
bound; `line_kinematic` and `point_kinematic` are for bodies with linear kinematic hardening. `run`
repeats any load cycle in a `Simulation` until plastic flow ceases, cancels over each cycle, or adds
strain in each cycle. See docs/theory/shakedown.md.
"""

from .cycling import run
from .limits import (
    ShakedownLimit,
    elliptic,
    first_yield,
    line,
    line_kinematic,
    point,
    point_kinematic,
    point_lower_bound,
)
from .passes import passes
from .results import Cycle, NotSteadyWarning, ShakedownResult

__all__ = [
    "Cycle",
    "NotSteadyWarning",
    "ShakedownLimit",
    "ShakedownResult",
    "elliptic",
    "first_yield",
    "line",
    "line_kinematic",
    "passes",
    "point",
    "point_kinematic",
    "point_lower_bound",
    "run",
]  # fmt: skip
