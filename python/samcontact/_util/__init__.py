# SPDX-License-Identifier: GPL-3.0-or-later
"""Argument checks, display, memory estimates and other tools without contact mechanics."""
