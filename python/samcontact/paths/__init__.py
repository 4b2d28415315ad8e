# SPDX-License-Identifier: GPL-3.0-or-later
"""Loading paths: lists of dictionaries with the arguments of `Simulation.step`."""

from .fretting import fretting_loop, tangential
from .passes import rolling, sliding
from .pull_off import PullOff, Retraction, pull_off
from .ramps import Path, hold, load_unload, ramp
from .times import creep, oscillation, stress_relaxation
from .traverse import traverse

__all__ = [
    "Path", "PullOff", "Retraction", "creep", "fretting_loop", "hold", "load_unload", "oscillation",
    "pull_off", "ramp", "rolling", "sliding", "stress_relaxation", "tangential", "traverse",
]  # fmt: skip
