# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are written completely or not at all, and marked as written by this package."""
