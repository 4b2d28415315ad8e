# SPDX-License-Identifier: GPL-3.0-or-later
"""Wear and running-in: material whose plastic strain is too large leaves the surface.

Boucly (2008), part 5. Each cycle loads and unloads; then what has too much accumulated plastic
strain, from the surface down, is removed, and the next cycle starts from the worn surface and the
plastic strain that is left. See docs/theory.md.
"""

from .checks import YIELD_STRAIN
from .cycles import run
from .results import Cycle, WearResult
from .steps import depth, shift, smooth

__all__ = ["YIELD_STRAIN", "Cycle", "WearResult", "depth", "run", "shift", "smooth"]
