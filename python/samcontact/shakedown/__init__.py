# SPDX-License-Identifier: GPL-3.0-or-later
"""Shakedown: does a body that is loaded again and again stop to flow?

Closed limits of the pressure of rolling and sliding contacts: `line` exactly, by Melan's theorem,
`point` and `elliptic` from above, `point_safe` from below; `line_kinematic` and `point_kinematic`
of linear kinematic hardening. And any cycle of a `Simulation`: `run` repeats it until flow has come
to rest, closes in each cycle, or goes on, and tells which. See docs/theory/shakedown.md.
"""

from .cycling import run
from .limits import (
    Limit,
    elliptic,
    first_yield,
    line,
    line_kinematic,
    point,
    point_kinematic,
    point_safe,
)
from .passes import passes
from .results import Cycle, NotSteadyWarning, ShakedownResult

__all__ = [
    "Cycle", "Limit", "NotSteadyWarning", "ShakedownResult", "elliptic", "first_yield", "line",
    "line_kinematic", "passes", "point", "point_kinematic", "point_safe",
    "run",
]  # fmt: skip
