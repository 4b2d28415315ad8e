# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact solutions, states of a simulation, and quantities derived from their fields."""
