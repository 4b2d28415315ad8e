# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures and stated values of V. Boucly's thesis (INSA Lyon, 2008), computed: docs/gallery."""
