# SPDX-License-Identifier: GPL-3.0-or-later
"""Solver for a single elastic contact."""
