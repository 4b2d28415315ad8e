# SPDX-License-Identifier: GPL-3.0-or-later
"""Time and memory of the main contact problems versus size, with estimates for larger surfaces."""
