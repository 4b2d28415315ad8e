# SPDX-License-Identifier: GPL-3.0-or-later
"""Comparison with experiments: indentation from first yield to the fully plastic range."""
