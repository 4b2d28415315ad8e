# SPDX-License-Identifier: GPL-3.0-or-later
"""Rigid sphere on an elastic, perfectly plastic half-space: Boucly (2008), section 2.3.1.2."""

from .pictures import figures
from .setups import compute
from .statements import stated

TITLE = "Flattening of a perfectly plastic half-space"
INTRODUCTION = """
This page shows the flattening of an elastic, perfectly plastic half-space by a rigid sphere, and
compares it with section 2.3.1.2 of Boucly's thesis (2008) and with two empirical models. The sphere
is pressed without friction up to 110 times the critical interference ω_c, at which yield begins.
The thesis compares its results with the finite element model of Kogut and Etsion (2002,
[doi:10.1115/1.1490373](https://doi.org/10.1115/1.1490373)). The model of Jackson and Green (2005,
[doi:10.1115/1.1866166](https://doi.org/10.1115/1.1866166)) is shown here as well. Both models are
in `samcontact.flattening`.

The thesis does not state the material. Here ν is 0.3, as in Kogut and Etsion. In half-space theory
no other property matters. Four ratios depend on ω/ω_c alone: load to critical load, area to
critical area, dimensions of the plastic zone to the critical contact radius a_c, and plastic strain
to Y/E (yield stress over Young's modulus). Y/E is 10⁻⁴ here; the contact radius is then much
smaller than the radius of the sphere, and the empirical models have reached their limit for small
Y/E.

Four grids cover the range of interferences, so that every contact radius is resolved by enough
cells. The plastic zone is considered to reach a depth when the first cell at this depth yields. The
first layer of cells has its centre half a layer below the surface. The interference at which the
surface itself yields is therefore extrapolated from the first two layers.
"""

__all__ = ["INTRODUCTION", "TITLE", "compute", "figures", "stated"]
