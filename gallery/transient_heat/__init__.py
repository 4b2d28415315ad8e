# SPDX-License-Identifier: GPL-3.0-or-later
"""A hot tool at rest on or moving over a flat of steel 52100: Boucly (2008), section 3.2.3."""

from .pictures import figures
from .setups import compute
from .statements import stated

TITLE = "Transient frictional heat"
INTRODUCTION = """
This page shows temperature and stress below a hot contact at rest and in motion, and compares with
section 3.2.3 of the thesis. An elastic, adiabatic tool is pressed on a flat of steel AISI 52100
with 1500 N and a heat factor of 0.12 m/s. The tool (i) is at rest and has heated the flat for 23
ms; (ii) is at rest in the steady state; (iii) has moved along +x at 0.95 m/s for 23 ms. In (iii)
the flat moves through the contact with `velocity=(-0.95, 0)`. The thesis shows maps of these cases
and states few numbers. Its diameter of 15 mm gives a contact radius of 418 µm and 4.10 GPa; the 332
µm and 6.5 GPa that it states require half this diameter, which is used here. The thesis states no
diffusivity: 1.367e-5 m²/s is assumed (ρc = 3.67 MJ/(m³K)). All constants are independent of
temperature, which rises far beyond melting in (i) and (ii).

In each increment the heat is that of a contact that has been in its present state for 23 ms. The
elastic-plastic flat is loaded once. In (iii) its plastic strain stays below the tool, whereas the
real one would be left behind.
"""

__all__ = ["INTRODUCTION", "TITLE", "compute", "figures", "stated"]
