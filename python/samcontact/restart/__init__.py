# SPDX-License-Identifier: GPL-3.0-or-later
"""Restart after an interruption: files, identity and lock of a run."""
