# SPDX-License-Identifier: GPL-3.0-or-later
"""Time and memory of the main jobs against size, and estimates for a much larger surface."""
