# SPDX-License-Identifier: GPL-3.0-or-later
"""Solution of a case to a prescribed accuracy, with automatic grids and increments."""
