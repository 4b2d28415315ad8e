# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic-plastic contact along a path of increments, with checkpoints."""
