# SPDX-License-Identifier: GPL-3.0-or-later
"""Atomic writing of files, and identification of files that this package has written."""
