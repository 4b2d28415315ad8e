# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic contact against Hertz theory (Johnson 1985, chapter 4), on refined grids.

The truth is closed-form. Uniform cells resolve the smooth part of the pressure to second order;
at the edge, where it falls like a square root, to first order in the L2 norm. Measured, rigid and
elastic ball alike (the contact modulus is all that counts), a point on the axis / between points:

    cells per a        8               16              32              64
    p0 error       2.6e-3/1.3e-3   6.5e-4/...      (printed by `python tests/validation/...`)
"""

import numpy as np
import pytest

import samcontact as sc
from samcontact import hertz, surfaces
