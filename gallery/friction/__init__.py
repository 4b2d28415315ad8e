# SPDX-License-Identifier: GPL-3.0-or-later
"""A ball that slides over a half-space of steel M50: Boucly (2008), section 2.3.3."""

from .pictures import figures
from .setups import compute
from .statements import stated

TITLE = "Normal load and friction"
INTRODUCTION = """
This page shows how friction changes the stress, plastic strain and residual stress below a sliding
ball, and compares the results with section 2.3.3 of Boucly's thesis (2008). A ball of 10 mm radius
is in full sliding on a half-space of steel M50. The friction coefficient is µ, and the shear
traction µp acts on the half-space along +x, where p is the pressure. In the first part a rigid ball
is loaded with 800 N, in the second part an elastic ball is loaded with up to 5000 N. For the second
part the thesis gives a ball radius of 20 mm. However, the Hertz pressure of 5.05 GPa stated for it
requires 10 mm, the radius given at the start of section 2.3.3. a is the Hertz contact radius at the
maximum load of each part, ω the rigid-body approach (interference in the thesis), and γ the
equivalent plastic strain. The index c marks values at the onset of yield, and the index c0 values
at the onset of yield without friction.
"""

__all__ = ["INTRODUCTION", "TITLE", "compute", "figures", "stated"]
