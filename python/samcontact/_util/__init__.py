# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of arguments, display, memory and other tools that know nothing of contact."""
