# SPDX-License-Identifier: GPL-3.0-or-later
"""Cost and accuracy of extreme cases: units, cycles, materials, cells, friction, coatings."""
