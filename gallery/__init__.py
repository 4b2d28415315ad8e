# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulations that reproduce figures and values of V. Boucly's thesis (INSA Lyon, 2008)."""
