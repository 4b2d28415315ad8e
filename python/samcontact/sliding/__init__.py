# SPDX-License-Identifier: GPL-3.0-or-later
"""Steady sliding over viscoelastic bodies: pressure, contact area and hysteretic friction."""

from .curve import FrictionCurve
from .speeds import over_speed
from .steady import steady

__all__ = ["FrictionCurve", "over_speed", "steady"]
