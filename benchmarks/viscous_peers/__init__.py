# SPDX-License-Identifier: GPL-3.0-or-later
"""Creep of viscoelastic rough surfaces: comparison with tamaas."""
