# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear and running-in: material leaves the surface where strain is too large, or where it slips.

`run`: Boucly (2008), part 5. Each cycle loads and unloads; then what has too much accumulated
plastic strain, from the surface down, is removed, and the next cycle starts from the worn surface
and the plastic strain that is left. `fretting`: elastic bodies slip to and fro, and lose depth in
proportion to the work of friction, or to pressure times slip. See docs/theory/wear.md.
"""

from .by_slip import fretting
from .checks import YIELD_STRAIN
from .cycles import run
from .results import Cycle, FrettingCycle, FrettingResult, WearResult
from .steps import depth, shift, smooth

__all__ = [
    "YIELD_STRAIN", "Cycle", "FrettingCycle", "FrettingResult", "WearResult", "depth", "fretting",
    "run", "shift", "smooth",
]  # fmt: skip
