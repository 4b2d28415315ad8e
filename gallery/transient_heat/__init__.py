# SPDX-License-Identifier: GPL-3.0-or-later
"""A tool that heats a flat of steel 52100, at rest or moving over it: section 3.2.3."""

from .pictures import figures
from .setups import compute
from .statements import stated

TITLE = "Transient frictional heat"
INTRODUCTION = """
Section 3.2.3 of the thesis: an elastic, adiabatic tool on a flat of steel AISI 52100, 1500 N, heat
factor 0.12 m/s. The tool (i) stays where it is and has heated the flat for 23 ms; (ii) the same in
the steady state; (iii) moves along +x at 0.95 m/s, and has done so for 23 ms. In (iii) the
flat moves through the contact with `velocity=(-0.95, 0)`. The thesis shows maps of these cases, its
text has few numbers. Radius: its 15 mm of diameter give 418 µm and 4.10 GPa; its 332 µm and 6.5 GPa
need half of that, which is taken here. It has no diffusivity: 1.367e-5 m²/s is taken (ρc = 3.67
MJ/(m³K)). All constants are independent of the temperature, which rises far beyond melting in (i)
and (ii).

In each increment the heat is that of a contact that has been as it is now for 23 ms. The
elastic-plastic flat is loaded once; in (iii) its plastic strain stays below the tool, where the
real one would be left behind.
"""

__all__ = ["INTRODUCTION", "TITLE", "compute", "figures", "stated"]
