# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of capabilities, each tried in a small contact."""
