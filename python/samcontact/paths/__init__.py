# SPDX-License-Identifier: GPL-3.0-or-later
"""Loading paths: lists of keyword dictionaries for `Simulation.step`."""

from .passes import rolling, sliding
from .ramps import Path, hold, load_unload, ramp

__all__ = ["Path", "hold", "load_unload", "ramp", "rolling", "sliding"]
