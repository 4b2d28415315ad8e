# SPDX-License-Identifier: GPL-3.0-or-later
"""A heated contact of two balls, one of them of steel 52100: section 2.3.2."""

from .pictures import figures
from .setups import compute
from .statements import stated

TITLE = "Frictional heat"
INTRODUCTION = """
Section 2.3.2 of the thesis: two balls of 15 mm radius, 1500 N, one elastic and adiabatic, the
other of steel AISI 52100 and heated by the flux Q_f p. It is at rest and in the steady state. The
coefficient of friction is so small that the shear is left out. a is the Hertz contact radius.
Conductivity 50.2 W/(m K), thermal expansion 11.7e-6 /K; the diffusivity has no influence here. All
constants are independent of the temperature, which rises by far more than steel can bear.
Unloading takes the heat away with the pressure, in one increment; the residual stress is that of
the cold body.
"""

__all__ = ["INTRODUCTION", "TITLE", "compute", "figures", "stated"]
