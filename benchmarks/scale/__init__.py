# SPDX-License-Identifier: GPL-3.0-or-later
"""Time and memory of the main jobs against their size, and needs of a much larger one."""
