# SPDX-License-Identifier: GPL-3.0-or-later
"""Solver for one elastic contact without loading history."""
