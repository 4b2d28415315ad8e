# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear and running-in: removal of surface material by plastic strain, or by slip.

`run` simulates wear as in Boucly (2008), part 5: after each load cycle, material with too much
accumulated plastic strain is removed at the surface, and the next cycle starts from the worn
surface with the remaining plastic strain. `fretting` simulates wear under oscillating slip, in
proportion to the frictional work or to pressure times slip distance. See docs/theory/wear.md.
"""

from .by_slip import fretting
from .checks import YIELD_STRAIN
from .cycles import run
from .results import Cycle, FrettingCycle, FrettingResult, WearResult
from .steps import below_worn_surface, depth, smooth

__all__ = [
    "YIELD_STRAIN",
    "Cycle",
    "FrettingCycle",
    "FrettingResult",
    "WearResult",
    "below_worn_surface",
    "depth",
    "fretting",
    "run",
    "smooth",
]  # fmt: skip
