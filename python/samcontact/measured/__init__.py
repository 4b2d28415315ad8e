# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured surfaces from instrument files or plain arrays of heights.

The optional dependency SurfaceTopography reads the files, with units, of about forty instruments
and programs.
"""

from .files import read
from .surface import MeasuredSurface

__all__ = ["MeasuredSurface", "read"]
