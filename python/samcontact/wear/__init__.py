# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear and running-in: removal of surface material by plastic strain, or by slip.

`run`: Boucly (2008), part 5. After each load cycle, material with too much accumulated plastic
strain is removed from the surface down; the next cycle starts from the worn surface and the
remaining plastic strain. `fretting`: surfaces of elastic bodies under oscillating slip recede in
proportion to the frictional work, or to pressure times slip. See docs/theory/wear.md.
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
