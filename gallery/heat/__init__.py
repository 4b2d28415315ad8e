# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact of two balls, one of steel 52100, with frictional heat: Boucly (2008), section 2.3.2."""

from .pictures import figures
from .setups import compute
from .statements import stated

TITLE = "Frictional heat"
INTRODUCTION = """
This page shows how frictional heat changes the pressure, the stress and the onset of yield, and
compares the results with section 2.3.2 of Boucly's thesis (2008). Two balls of 15 mm radius are
loaded with 1500 N. One ball is elastic and adiabatic. The other ball is made of steel AISI 52100
and is heated by the flux Q_f p, where p is the pressure. Both balls are at rest, and the
temperature is steady. The friction coefficient is assumed to be so small that the shear traction is
negligible. a is the Hertz contact radius and γ the equivalent plastic strain. The conductivity is
50.2 W/(m K) and the thermal expansion 11.7e-6 /K; the diffusivity has no influence here. All
constants are independent of temperature, although the temperature rise is far beyond the limits of
steel. Unloading removes the heat together with the pressure, in one increment, so the residual
stress is the stress in the cold body.
"""

__all__ = ["INTRODUCTION", "TITLE", "compute", "figures", "stated"]
