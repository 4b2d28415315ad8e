# SPDX-License-Identifier: GPL-3.0-or-later
"""Restart of interrupted runs: checkpoint files, identity of a run, and locks of folders."""
