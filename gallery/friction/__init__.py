# SPDX-License-Identifier: GPL-3.0-or-later
"""A ball that slides over a half-space of steel M50: Boucly (2008), section 2.3.3."""

from .pictures import figures
from .setups import compute
from .statements import stated

TITLE = "Normal load and friction"
INTRODUCTION = """
This page shows how friction changes stress, plastic strain and residual stress below a sliding
ball, and compares with section 2.3.3 of the thesis. A ball of 10 mm radius is in full sliding on a
half-space of steel M50 with the friction coefficient µ; the shear traction µp acts on the
half-space along +x. The first part is a rigid ball with 800 N, the second an elastic ball with up
to 5000 N. For the second part the text states 20 mm, but its Hertz pressure of 5.05 GPa requires 10
mm, as stated at the start of the section. a is the Hertz contact radius at the largest load.
"""

__all__ = ["INTRODUCTION", "TITLE", "compute", "figures", "stated"]
