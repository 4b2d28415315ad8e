# SPDX-License-Identifier: GPL-3.0-or-later
"""Adhesion of rough surfaces: comparison with tamaas and with Adhesion of ContactEngineering."""
