# SPDX-License-Identifier: GPL-3.0-or-later
"""Solution of a case to a prescribed accuracy, with automatic grids and increments."""

from .._util.errors import AccuracyWarning
from .outcome import AccuracyResult
from .prescribed import to_accuracy
from .refinable_case import RefinableCase

__all__ = ["AccuracyResult", "AccuracyWarning", "RefinableCase", "to_accuracy"]
