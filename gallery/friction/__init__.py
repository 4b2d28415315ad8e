# SPDX-License-Identifier: GPL-3.0-or-later
"""A ball that slides over a half-space of steel M50: section 2.3.3."""

from .pictures import figures
from .setups import compute
from .statements import stated

TITLE = "Normal load and friction"
INTRODUCTION = """
Section 2.3.3 of the thesis: a ball of 10 mm radius on a half-space of steel M50, in gross sliding
with the friction coefficient µ; the shear µp acts on the half-space along +x. First a rigid ball
and 800 N, then an elastic ball and up to 5000 N. For the second the text says 20 mm, but its Hertz
pressure of 5.05 GPa needs 10 mm, which is what the start of the section says. a is the Hertz
contact radius at the largest load.
"""

__all__ = ["INTRODUCTION", "TITLE", "compute", "figures", "stated"]
