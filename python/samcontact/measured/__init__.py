# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured surfaces, from the files of instruments or plain arrays of heights.

SurfaceTopography, an optional dependency, knows the formats of some forty instruments and
programs, and their units.
"""

from .files import read
from .surface import MeasuredSurface

__all__ = ["MeasuredSurface", "read"]
