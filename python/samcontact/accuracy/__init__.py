# SPDX-License-Identifier: GPL-3.0-or-later
"""A case solved to an accuracy: grids and increments are chosen, and every value has an error."""

from .._util.errors import AccuracyWarning
from .asked import to_accuracy
from .outcome import Accurate
from .scene import Refinable

__all__ = ["AccuracyWarning", "Accurate", "Refinable", "to_accuracy"]
