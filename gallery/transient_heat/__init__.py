# SPDX-License-Identifier: GPL-3.0-or-later
"""A hot tool at rest on or moving over a flat of steel 52100: Boucly (2008), section 3.2.3."""

from .pictures import figures
from .setups import compute
from .statements import stated

TITLE = "Transient frictional heat"
INTRODUCTION = """
This page shows the temperature and stress below a hot contact, at rest and in motion, and compares
the results with section 3.2.3 of Boucly's thesis (2008). An elastic, adiabatic tool is pressed with
1500 N on a flat of steel AISI 52100. The heat flux per unit pressure is 0.12 m/s. In case (i) the
tool is at rest and has heated the flat for 23 ms. In case (ii) it is at rest in the steady state.
In case (iii) it has moved along +x at 0.95 m/s for 23 ms; here the flat moves through the contact
with `velocity=(-0.95, 0)`. The thesis shows maps of these cases and states few numbers. The tool
diameter of 15 mm given in the thesis leads to a contact radius of 418 µm and a Hertz pressure of
4.10 GPa. The contact radius of 332 µm and the Hertz pressure of 6.5 GPa stated in the thesis
require half this diameter, which is used here. The thesis states no diffusivity: 1.367e-5 m²/s is
assumed (ρc = 3.67 MJ/(m³K)). All constants are independent of temperature, although the temperature
rises far beyond melting in (i) and (ii). a is the Hertz contact radius.

In cases (i) and (iii) the temperature in each increment is computed as if the contact had been in
its present state for 23 ms. The elastic-plastic flat is loaded once. In case (iii) the plastic
strain of the flat stays below the tool, whereas in reality it would be left behind.
"""

__all__ = ["INTRODUCTION", "TITLE", "compute", "figures", "stated"]
