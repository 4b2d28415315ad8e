# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameter studies: combinations of field values, in one or several processes or on a cluster."""

from .run import SweepInterrupted, sweep

__all__ = ["SweepInterrupted", "sweep"]
