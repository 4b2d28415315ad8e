# SPDX-License-Identifier: GPL-3.0-or-later
"""Shakedown: does a body that is loaded again and again stop to flow?"""

from .limits import Limit, elliptic, first_yield, line, line_kinematic, point, point_kinematic

__all__ = [
    "Limit", "elliptic", "first_yield", "line", "line_kinematic", "point", "point_kinematic",
]  # fmt: skip
