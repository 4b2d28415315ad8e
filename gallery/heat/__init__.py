# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact of two balls, one of steel 52100, with frictional heat: Boucly (2008), section 2.3.2."""

from .pictures import figures
from .setups import compute
from .statements import stated

TITLE = "Frictional heat"
INTRODUCTION = """
This page shows how frictional heat changes pressure, stress and the onset of yield, and compares
with section 2.3.2 of the thesis. Two balls of 15 mm radius are loaded by 1500 N. One is elastic and
adiabatic, the other of steel AISI 52100 and heated by the flux Q_f p, at rest and in the steady
state. The coefficient of friction is so small that the shear traction is neglected. a is the Hertz
contact radius. The conductivity is 50.2 W/(m K), the thermal expansion 11.7e-6 /K; the diffusivity
has no influence here. All constants are independent of temperature, although the temperature rise
is far beyond the limits of steel. Unloading removes the heat together with the pressure, in one
increment; the residual stress is that of the cold body.
"""

__all__ = ["INTRODUCTION", "TITLE", "compute", "figures", "stated"]
