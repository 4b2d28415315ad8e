# SPDX-License-Identifier: GPL-3.0-or-later
"""Static capacity of rolling bearings: ISO 76's question asked of bodies that yield."""
