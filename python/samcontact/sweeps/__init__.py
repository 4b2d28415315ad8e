# SPDX-License-Identifier: GPL-3.0-or-later
"""Many cases: values of some fields in all combinations, in one process, many, or on a cluster."""

from .run import SweepInterrupted, sweep

__all__ = ["SweepInterrupted", "sweep"]
