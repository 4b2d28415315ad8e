# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are written whole or not at all, and known as written by this package."""
