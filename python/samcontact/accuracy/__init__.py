# SPDX-License-Identifier: GPL-3.0-or-later
"""A case solved to an accuracy: grids and increments are chosen, and every value has an error."""

from .outcome import AccuracyWarning, Accurate
from .run import to_accuracy
from .scene import Refinable

__all__ = ["AccuracyWarning", "Accurate", "Refinable", "to_accuracy"]
