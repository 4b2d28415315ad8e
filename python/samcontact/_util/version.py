# SPDX-License-Identifier: GPL-3.0-or-later
"""Version of the package."""

from .._core import version

__all__ = ["version"]
