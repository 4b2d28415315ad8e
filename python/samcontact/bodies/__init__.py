# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials, layered bodies, hardening laws and depth profiles."""
