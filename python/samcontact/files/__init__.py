# SPDX-License-Identifier: GPL-3.0-or-later
"""Atomic writing of files, and their identification as files of this package."""
