# SPDX-License-Identifier: GPL-3.0-or-later
"""Time of the main jobs over the least time that the machine needs for their data and sums."""
