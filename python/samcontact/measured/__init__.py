# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured surfaces from instrument files or plain arrays of heights.

The optional dependency SurfaceTopography reads the file formats and units of some forty instruments
and programs.
"""

from .files import read
from .surface import MeasuredSurface

__all__ = ["MeasuredSurface", "read"]
