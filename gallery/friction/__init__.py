# SPDX-License-Identifier: GPL-3.0-or-later
"""A ball that slides over a half-space of steel M50: Boucly (2008), section 2.3.3."""

from .pictures import figures
from .setups import compute
from .statements import stated

TITLE = "Normal load and friction"
INTRODUCTION = """
This page shows how friction changes the stress, plastic strain and residual stress below a sliding
ball, and compares with section 2.3.3 of Boucly's thesis (2008). A ball of 10 mm radius is in full
sliding on a half-space of steel M50. The friction coefficient is µ, and the shear traction µp acts
on the half-space along +x, where p is the pressure. The first part has a rigid ball under 800 N,
the second an elastic ball under up to 5000 N. For the second part the thesis gives the radius as 20
mm, but its Hertz pressure of 5.05 GPa requires 10 mm, the radius stated at the start of the
section. a is the Hertz contact radius at the maximum load of each part, ω the rigid-body approach
(interference in the thesis), and γ the equivalent plastic strain. The index c marks values at the
onset of yield, and c0 those without friction.
"""

__all__ = ["INTRODUCTION", "TITLE", "compute", "figures", "stated"]
