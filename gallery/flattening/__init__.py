# SPDX-License-Identifier: GPL-3.0-or-later
"""Rigid sphere on an elastic, perfectly plastic half-space: Boucly (2008), section 2.3.1.2."""

from .pictures import figures
from .setups import compute
from .statements import stated

TITLE = "Flattening of a perfectly plastic half-space"
INTRODUCTION = """
This page compares the flattening of an elastic, perfectly plastic half-space with section 2.3.1.2
of the thesis and with models. A rigid sphere is pressed without friction to 110 critical
interferences. The thesis compares with the finite elements of Kogut and Etsion (2002,
[doi:10.1115/1.1490373](https://doi.org/10.1115/1.1490373)). Here the model of Jackson and Green
(2005, [doi:10.1115/1.1866166](https://doi.org/10.1115/1.1866166)) is shown as well; both models are
in `samcontact.flattening`.

The thesis does not state the material. ν is 0.3 here, as in Kogut and Etsion. In the half-space
theory no other property matters: load over critical load, area over critical area, the shape of the
plastic zone over the critical contact radius a_c, and plastic strain over Y/E (yield stress over
Young's modulus) are functions of ω/ω_c alone. Y/E is 10⁻⁴, for which the empirical models are at
their limit of small a/R.

Four grids cover the range, so that the contact radius always has a sufficient number of cells. The
plastic zone has reached a depth when the first cell at this depth yields. The first layer of cells
has its centre half a layer below the surface; the value at the surface is extrapolated from the
first two layers.
"""

__all__ = ["INTRODUCTION", "TITLE", "compute", "figures", "stated"]
